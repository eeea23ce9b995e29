// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "reading/frame_files.h"

#include <iostream>
#include <string>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// A picture of a run: draws it into a file, false if the run did not write what it shows.
struct RunPicture {
  std::string name;  ///< of the file, before the run's id
  bool (*draw)(const fs::path& file, const CaseRun& run);
  std::string shows, takes;
  bool encased_only;
};

bool specimen(const fs::path& file, const CaseRun& run)
{
  const auto grains = last_grain_file(run.folder);
  if (grains) draw_specimen(file, grains->file, run.title);
  return grains.has_value();
}

bool shear_band(const fs::path& file, const CaseRun& run)
{
  const auto grains = last_grain_file(run.folder);
  return grains && draw_shear_band(file, grains->file, run.title);
}

bool sleeve(const fs::path& file, const CaseRun& run)
{
  const auto frame = last_frame_with_grains(run.folder, "sleeve");
  if (frame) draw_sleeve(file, *frame, run.title);
  return frame.has_value();
}

bool force_chains(const fs::path& file, const CaseRun& run)
{
  const auto frame = last_frame_with_grains(run.folder, "contacts");
  return frame && draw_force_chains(file, *frame, run.title);
}

const std::vector<RunPicture> run_pictures{
    {"specimen_", specimen, "the specimen", "grains/grains.pvd", false},
    {"shear_band_", shear_band, "shear bands", "deviatoric strains with its grains", false},
    {"force_chains_", force_chains, "force chains",
     "contacts/contacts.pvd with grains at the same time, or no contact bears 5 N", false},
    {"hoop_tension_", sleeve, "the sleeve", "sleeve/sleeve.pvd with grains at the same time", true},
};

}  // namespace

void draw_run_pictures(const fs::path& folder, const std::vector<SetResult>& sets)
{
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const RunPicture& picture : run_pictures) {
        const CaseRun& run = *test.run;
        if (picture.encased_only && !run.encased()) continue;
        if (!picture.draw(folder / (picture.name + run.id), run))
          std::cerr << "note: no picture of " << picture.shows << " of '" << run.id
                    << "': its run wrote no " << picture.takes << '\n';
      }
}

}  // namespace encased_column
