// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

#include <functional>
#include <string>
#include <vector>

namespace encased_column {

/// The files a fix or a command writes. Their paths are absolute from the moment the deck names
/// them, so that a later `shell cd` changes nothing, and belong to one writer alone.
class OutputFiles {
 public:
  /// Of a fix: they are free again when this object goes with it.
  OutputFiles(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix& fix);
  /// Of a command, which is gone at once: its files stay its own until the deck makes a new box.
  OutputFiles(LAMMPS_NS::LAMMPS* lmp, const std::string& command);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Absolute path of `file`, which `keyword` names. Throws InputError on all ranks where the file
  /// belongs to another writer.
  std::string claim(const std::string& keyword, const std::string& file);
  /// The same for the file of a keyword that the deck may leave out; `ending` is what its name has
  /// while it is written. Throws InputError too where the first rank cannot write it.
  std::string file(const Options& options, const std::string& keyword, const std::string& usual,
                   const std::string& ending = "");
  /// The same for the collection `name`.pvd of a series of files in `folder`. `prepare` makes both,
  /// on the first rank, and says whether it could.
  void collection(const std::string& folder, const std::string& name,
                  const std::function<bool()>& prepare);

  /// Throws InputError where a command of the host, perhaps a later one, writes one of the files:
  /// to be asked before a run.
  void check_host() const;

  /// Ends the run, from the first rank, because `path` cannot be written.
  void stop(const std::string& path) const;

 private:
  struct Claimed {
    std::string keyword, file, path;
  };
  std::string host_writer(const std::string& path) const;
  void check_host(const Claimed& claimed) const;

  LAMMPS_NS::LAMMPS* lmp_;
  std::string owner_, style_;
  bool of_command_;
  std::vector<Claimed> claimed_;
};

/// A new box begins a new run: what commands wrote before it may be written again.
void forget_files_of_commands();

}  // namespace encased_column
