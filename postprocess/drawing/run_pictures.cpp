// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "analysis/sampled_curve.h"
#include "files/column_names.h"
#include "reading/frame_files.h"
#include "tables/text_layout.h"

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

/// With the axial strain at its step.
NamedFrame named(const FrameWithGrains& frame, const CaseRun& run)
{
  const SampledCurve strain(run.history.numbers(history_column::step),
                            run.history.numbers(history_column::axial_strain));
  return {frame, "axial strain " + fixed(100.0 * strain.value(frame.time), 1) + " %"};
}

bool force_chains(const fs::path& file, const CaseRun& run)
{
  const auto first = first_frame_with_grains(run.folder, "contacts");
  const auto last = last_frame_with_grains(run.folder, "contacts");
  if (!last) return false;
  if (!run.encased() || first->time == last->time) return draw_force_chains(file, *last, run.title);
  return draw_force_chains(file, named(*first, run), named(*last, run), run.title);
}

/// What the run's files of contacts start from is a variable of the decks.
bool force_levels(const fs::path& file, const CaseRun& run)
{
  const auto frame = last_frame_with_grains(run.folder, "contacts");
  return frame && draw_force_levels(file, *frame, run.title, run.number("chains"));
}

const std::vector<RunPicture> run_pictures{
    {"specimen_", specimen, "the specimen", "grains/grains.pvd", false},
    {"shear_band_", shear_band, "shear bands", "deviatoric strains with its grains", false},
    {"force_chains_", force_chains, "force chains",
     "contacts/contacts.pvd with grains at the same time, or no contact bears 5 N", false},
    {"force_levels_", force_levels, "force chains of 20, 40 and 60 N",
     "contacts/contacts.pvd with grains at the same time, or leaves out forces of 60 N", true},
    {"hoop_tension_", sleeve, "the sleeve", "sleeve/sleeve.pvd with grains at the same time", true},
};

}  // namespace

std::vector<std::function<void()>> run_picture_tasks(const fs::path& folder,
                                                     const std::vector<SetResult>& sets)
{
  std::vector<std::function<void()>> tasks;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const RunPicture& picture : run_pictures) {
        const CaseRun& run = *test.run;
        if (picture.encased_only && !run.encased()) continue;
        tasks.emplace_back([&run, &picture, file = folder / (picture.name + run.id)] {
          if (!picture.draw(file, run))
            std::cerr << "note: no picture of " + picture.shows + " of '" + run.id +
                             "': its run wrote no " + picture.takes + '\n';
        });
      }
  return tasks;
}

}  // namespace encased_column
