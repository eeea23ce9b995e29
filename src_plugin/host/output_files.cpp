// SPDX-License-Identifier: GPL-2.0-only
#include "host/output_files.h"

#include "core/input_error.h"
#include "host/messages.h"
#include "host/output_paths.h"
#include "host/ranks.h"

#include "dump.h"
#include "output.h"

#include <filesystem>
#include <fstream>
#include <set>

namespace encased_column {

namespace {

/// Of this process; used on the first rank, which alone writes.
OutputPaths& paths()
{
  static OutputPaths all;
  return all;
}

std::set<std::string>& commands_that_wrote()
{
  static std::set<std::string> names;
  return names;
}

/// Leaves nothing behind under an unfinished name: perhaps no run follows that would finish it.
bool can_be_written(const std::string& path, const std::string& ending)
{
  const std::string tried = path + ending;
  const bool is_new = !std::filesystem::exists(tried);
  if (!std::ofstream(tried, std::ios::app)) return false;
  if (is_new && !ending.empty()) std::filesystem::remove(tried);
  return true;
}

/// The name of a dump's file is protected in the host.
struct DumpFile : LAMMPS_NS::Dump {
  static std::string of(const LAMMPS_NS::Dump* dump) { return dump->*(&DumpFile::filename); }
};

}  // namespace

OutputFiles::OutputFiles(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix& fix)
    : lmp_(lmp),
      owner_("fix '" + std::string(fix.id) + "' of style " + fix.style),
      style_("fix " + std::string(fix.style)),
      of_command_(false)
{
}

OutputFiles::OutputFiles(LAMMPS_NS::LAMMPS* lmp, const std::string& command)
    : lmp_(lmp),
      owner_(command),
      style_(command),
      of_command_(true)
{
  commands_that_wrote().insert(command);
}

OutputFiles::~OutputFiles()
{
  if (!of_command_) paths().release(owner_);
}

void forget_files_of_commands()
{
  for (const std::string& command : commands_that_wrote()) paths().release(command);
  commands_that_wrote().clear();
}

std::string OutputFiles::claim(const std::string& keyword, const std::string& file)
{
  claimed_.push_back({keyword, file, absolute_path(file)});
  const std::string& path = claimed_.back().path;
  const std::string owner =
      of_first_rank(lmp_, lmp_->comm->me == 0 ? paths().claim(path, owner_, of_command_) : "");
  if (!owner.empty())
    throw InputError("'" + keyword + "' must be a file that nothing else writes, found '" + file +
                     "', which " + owner + " writes, give " + owner_ + " another name");
  check_host(claimed_.back());
  return path;
}

std::string OutputFiles::file(const Options& options, const std::string& keyword,
                              const std::string& usual, const std::string& ending)
{
  const std::string file = usual.empty() ? options.word(keyword) : options.word(keyword, usual);
  const std::string path = claim(keyword, file);
  if (!on_first_rank_too(lmp_, lmp_->comm->me != 0 || can_be_written(path, ending)))
    throw InputError("'" + keyword + "' must be a file that can be written, found '" + file +
                     "', create its folder or give another name");
  return path;
}

void OutputFiles::collection(const std::string& folder, const std::string& name,
                             const std::function<bool()>& prepare)
{
  claim("name", folder + "/" + name + ".pvd");
  if (!on_first_rank_too(lmp_, lmp_->comm->me != 0 || prepare()))
    throw InputError("'folder' must be a folder that can be written, found '" + folder +
                     "', write another path or mend its rights");
}

/// Dumps open their files only when a run begins; what is open already, such as the log and the
/// file of `fix print` or `fix ave/time`, is known by its descriptor.
std::string OutputFiles::host_writer(const std::string& path) const
{
  const LAMMPS_NS::Output* output = lmp_->output;
  for (int n = 0; n < output->ndump; ++n)
    if (is_same_file(absolute_path(DumpFile::of(output->dump[n])), path))
      return "dump '" + std::string(output->dump[n]->id) + "'";
  return is_open_for_writing(path) ? "the log or another command of the host" : "";
}

void OutputFiles::check_host(const Claimed& claimed) const
{
  const std::string writer =
      of_first_rank(lmp_, lmp_->comm->me == 0 ? host_writer(claimed.path) : "");
  if (!writer.empty())
    throw InputError("'" + claimed.keyword + "' must be a file that nothing else writes, found '" +
                     claimed.file + "', which " + writer + " writes, give " + owner_ +
                     " another name");
}

void OutputFiles::check_host() const
{
  for (const Claimed& claimed : claimed_) check_host(claimed);
}

void OutputFiles::stop(const std::string& path) const
{
  stop_from_one_rank(
      lmp_, style_ + " cannot write '" + path + "', free some space or mend the folder's rights");
}

}  // namespace encased_column
