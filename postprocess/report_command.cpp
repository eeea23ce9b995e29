// SPDX-License-Identifier: GPL-2.0-only
#include "report_command.h"

#include "core/input_error.h"
#include "drawing/display.h"
#include "drawing/figures.h"
#include "drawing/parallel_tasks.h"
#include "drawing/pictures.h"
#include "drawing/scene.h"
#include "report/pages.h"
#include "tables/check_table.h"
#include "tables/result_sentences.h"
#include "tables/result_table.h"
#include "tables/set_comparison.h"
#include "tables/target_table.h"
#include "tables/theory_table.h"

#include <vtkObject.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// A series holds its own results; those of single cases go beside the first of them.
fs::path default_output(const fs::path& first)
{
  if (!fs::exists(first / "case.json")) return first;
  return fs::canonical(first).parent_path();
}

void create_folder(const fs::path& folder)
{
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    throw InputError("results must go where they can be written, found '" + folder.string() +
                     "' refused, write for example '--output results'");
}

void write_tables(const ReportOptions& settings, const std::vector<SetResult>& sets,
                  const Targets& targets)
{
  const std::string table =
      comparison_text(sets, targets) + result_text(sets, targets) + theory_text(sets);
  const std::string checks = check_text(sets), theory = theory_csv(sets);
  create_folder(settings.output);
  write_text(settings.output / "table.csv", result_csv(sets, targets));
  write_text(settings.output / "table.txt", table);
  write_text(settings.output / "beside_study.txt", target_text(sets, targets));
  write_text(settings.output / "beside_study.csv", target_csv(sets, targets));
  if (!theory.empty()) write_text(settings.output / "theory.csv", theory);
  write_text(settings.output / "checks.csv", check_csv(sets));
  write_text(settings.output / "checks.txt", checks);
  write_text(settings.output / "summary.txt", result_sentences(sets, targets));
  if (!settings.brief) std::cout << table << '\n' << checks << std::flush;
}

using Tasks = std::vector<std::function<void()>>;

void draw_pictures(const ReportOptions& settings, const std::vector<SetResult>& sets,
                   const Targets& targets)
{
  if (settings.draft) draw_drafts();
  const fs::path folder = settings.output / "figures";
  create_folder(folder);
  Tasks tasks = run_picture_tasks(folder, sets);  // longest first
  for (const std::vector<Figure>& figures : {agreement_figures(sets, targets),
                                             triaxial_figures(sets, targets),
                                             load_figures(sets, targets),
                                             {check_figure(sets)},
                                             energy_figures(sets),
                                             sleeve_figures(sets, targets),
                                             column_series_figures(sets, targets),
                                             column_figures(sets, targets)})
    for (const Figure& figure : figures)
      tasks.emplace_back([folder, figure] { draw_figures(folder, {figure}); });
  do_in_processes(tasks, drawing_processes());
  if (!settings.brief) std::cout << "\nPictures: " << folder.string() << '\n';
}

/// One page beside the results of all, one in each case folder.
void write_reports(const ReportOptions& settings, const std::vector<SetResult>& sets,
                   const Targets& targets, const std::vector<std::string>& left_out)
{
  const fs::path report = settings.output / "report.html";
  Tasks tasks{[&] { write_text(report, series_page(sets, targets, settings.output, left_out)); }};
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      tasks.emplace_back([&] {
        try {
          write_text(test.run->folder / "report.html",
                     case_page(test, targets, settings.output / "figures"));
        } catch (const InputError& problem) {  // of a run in a folder for reading only
          std::cerr << "note: no report of '" + test.run->id + "': " + problem.what() + '\n';
        }
      });
  do_in_processes(tasks, drawing_processes());
  if (!settings.brief)
    std::cout << "Report:   " << report.string() << ", and one in the folder of each case\n";
}

constexpr int check_missed = 3;  // exit code

/// The exit code.
int run(const ReportOptions& settings, std::vector<std::string> arguments)
{
  const CaseRuns found = read_case_runs(settings.folders);
  const Targets targets(settings.targets);
  std::optional<Platen> platen;
  if (!settings.platen.empty()) platen = platen_of(settings.platen);
  const std::vector<SetResult> sets = evaluate(found.runs, platen, targets);
  if (!settings.pictures_only) {
    for (const std::string& sentence : found.left_out) std::cerr << "note: " << sentence << '\n';
    write_tables(settings, sets, targets);
  }
  const CheckCount count = count_checks(sets);
  const int code = settings.strict && count.failed > 0 ? check_missed : 0;
  if (settings.no_pictures) {
    if (settings.brief) std::cout << result_sentences(sets, targets);
    return code;
  }
  arguments.emplace_back("--pictures-only");
  provide_display(arguments);
  draw_pictures(settings, sets, targets);
  write_reports(settings, sets, targets, found.left_out);
  // The checks again, as many lines came in between.
  std::cout << (settings.brief ? result_sentences(sets, targets) : count.sentence() + '\n');
  return code;
}

/// The published values where a build, an installation or the sources have them.
fs::path default_targets(const Places& places)
{
  return places.source.empty() ? places.inputs / "targets.csv"
                               : places.source / "postprocess" / "targets.csv";
}

}  // namespace

void add_report_options(CLI::App& command, ReportOptions& options)
{
  command.add_option("folders", options.folders, "a series (runs/default) or several case folders")
      ->required();
  command.add_option("--targets", options.targets,
                     "CSV file of the published values [targets.csv of this project]");
  command.add_option(
      "--output", options.output,
      "folder for the results [the series, or the folder that holds the first case]");
  command
      .add_option("--platen", options.platen,
                  "platen that q is read from [plain: mean, encased: bottom]")
      ->check(CLI::IsMember({"top", "bottom", "mean"}));
  command.add_flag("--no-pictures", options.no_pictures, "tables only");
  command.add_flag("--brief", options.brief,
                   "three sentences on the screen instead of the tables, which stay in files");
  command.add_flag("--draft", options.draft,
                   "3-D pictures with ragged edges, in a third of the time");
  command.add_flag("--strict", options.strict,
                   "exit code 3 if a required check is missed [0: it is told, no more]");
  command.add_flag("--pictures-only", options.pictures_only, "pictures only, no tables");
}

int report_command(ReportOptions options, const Places& places,
                   const std::vector<std::string>& arguments)
{
  vtkObject::GlobalWarningDisplayOff();
  if (options.targets.empty()) options.targets = default_targets(places);
  if (options.output.empty()) options.output = default_output(options.folders.front());
  return run(options, arguments);
}

}  // namespace encased_column
