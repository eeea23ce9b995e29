// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/pvd_collection.h"

#include <memory>
#include <string>

namespace encased_column {

/// A time series of VTK files in a folder, with the collection that ParaView opens.
class VtkSeries {
 public:
  VtkSeries(std::string folder, std::string name)
      : folder_(std::move(folder)),
        name_(std::move(name))
  {
  }

  /// Makes the folder and an empty collection now, rather than a run that cannot be saved hours
  /// later; false when it cannot be written.
  bool prepare() const;
  /// Path of the file of a step.
  std::string path_of_step(long step) const { return folder_ + "/" + file_of_step(step); }
  /// Lists the file of `step` at `time` [s] and writes the collection; false when that is
  /// impossible.
  bool list(double time, long step);

  const std::string& folder() const { return folder_; }
  const std::string& name() const { return name_; }
  /// What is listed so far; files are relative to the folder.
  const std::vector<PvdEntry>& entries() const { return collection_.entries(); }

  /// The series as text, for a restart file.
  std::string saved() const;
  /// Goes on with a series saved, as far as its files are still in the folder: files that the run
  /// wrote after its restart file are listed no more, they come again. False when the collection
  /// cannot be written.
  bool restore(const std::string& saved);

 private:
  std::string file_of_step(long step) const;
  bool write_collection() const;

  std::string folder_, name_;
  PvdCollection collection_;
};

/// The series that the keywords `folder` and `name` ask for. Throws InputError where `name` is a
/// path.
VtkSeries read_series(const Options& options, const std::string& usual_name);

/// The same, its collection claimed from `files` (OutputFiles of host/) and made with its folder.
template <typename Files>
std::unique_ptr<VtkSeries> make_series(Files& files, const Options& options,
                                       const std::string& usual_name)
{
  auto series = std::make_unique<VtkSeries>(read_series(options, usual_name));
  files.collection(options.word("folder"), series->name(), [&] { return series->prepare(); });
  return series;
}

/// A fix that writes such a series.
class SeriesOwner {
 public:
  virtual ~SeriesOwner() = default;
  /// None where the deck did not ask for files.
  virtual const VtkSeries* series() const = 0;
};

}  // namespace encased_column
