// SPDX-License-Identifier: GPL-2.0-only
#include "output/fix_output_collection.h"

#include "core/input_error.h"
#include "files/atomic_file.h"
#include "host/find_fix.h"
#include "host/messages.h"

#include <filesystem>

namespace encased_column {

namespace fs = std::filesystem;

const KeywordTable FixOutputCollection::keywords{
    {"part", 1, "-", "ID of a fix that writes a series, defined before (may be repeated)", true},
    {"file", 1, "-", "the collection (default all.pvd)"},
};

FixOutputCollection::FixOutputCollection(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this)
{
  try {
    const Options options = keywords.read(narg, arg);
    for (const auto& words : options.all("part")) ids_.push_back(words.front());
    const std::string file = options.word("file", "all.pvd");
    if (fs::path(file).extension() != ".pvd")
      throw InputError("'file' must end in .pvd, by which ParaView knows it, found '" + file +
                       "', write for example 'all.pvd'");
    find_parts();
    file_ = files_.file(options, "file", "all.pvd");
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  nevery = 1;  // to look whether a part has a new file costs nothing
}

void FixOutputCollection::init()
{
  try {
    find_parts();
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixOutputCollection::find_parts()
{
  parts_.clear();
  for (const std::string& id : ids_) {
    const auto* owner = find_fix<SeriesOwner>(lmp, "part", id, "fix that writes a series");
    if (!owner->series())
      throw InputError("'part' must name a fix that writes a series, found '" + id +
                       "', which writes no VTK files, add 'folder ...' to it");
    parts_.push_back(owner->series());
  }
}

std::size_t FixOutputCollection::listed() const
{
  std::size_t files = 0;
  for (const VtkSeries* part : parts_) files += part->entries().size();
  return files;
}

void FixOutputCollection::end_of_step()
{
  if (listed() != written_) write();
}

// The first rank alone knows what is listed.
void FixOutputCollection::write()
{
  written_ = listed();
  if (comm->me != 0) return;
  const fs::path here = fs::path(file_).parent_path();
  std::vector<PvdPart> parts;
  for (const VtkSeries* part : parts_)
    parts.push_back({part->name(), fs::proximate(part->folder(), here).string(), part->entries()});
  if (!write_whole_file(file_, pvd_text(parts_together(parts)))) files_.stop(file_);
}

}  // namespace encased_column
