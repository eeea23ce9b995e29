#include "core/input_error.h"
#include "drawing/column_figures.h"
#include "drawing/display.h"
#include "drawing/load_figures.h"
#include "drawing/run_figures.h"
#include "drawing/run_pictures.h"
#include "drawing/scene.h"
#include "drawing/sleeve_figures.h"
#include "drawing/triaxial_figures.h"
#include "page/case_page.h"
#include "page/series_page.h"
#include "report/check_table.h"
#include "report/result_table.h"
#include "report/theory_table.h"

#include <vtkObject.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <optional>

namespace fs = std::filesystem;
using namespace encased_column;

namespace {

struct Settings {
  std::vector<fs::path> folders;
  fs::path targets, output;
  std::optional<Platen> platen;
  bool no_pictures = false;
  bool draft = false;
  bool strict = false;
  bool pictures_only = false;  ///< set when started again under a virtual display
};

/// The published values where a build or an installation puts them.
fs::path default_targets()
{
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path installed = program.parent_path() / "share" / "encased-columns" / "targets.csv";
  return fs::exists(installed) ? installed : program / "targets.csv";
}

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

void write_tables(const Settings& settings, const std::vector<SetResult>& sets,
                  const Targets& targets)
{
  const std::string table = result_text(sets, targets) + theory_text(sets);
  const std::string checks = check_text(sets), theory = theory_csv(sets);
  create_folder(settings.output);
  write_text(settings.output / "table.csv", result_csv(sets, targets));
  write_text(settings.output / "table.txt", table);
  if (!theory.empty()) write_text(settings.output / "theory.csv", theory);
  write_text(settings.output / "checks.csv", check_csv(sets));
  write_text(settings.output / "checks.txt", checks);
  std::cout << table << '\n' << checks << std::flush;
}

void draw_pictures(const Settings& settings, const std::vector<SetResult>& sets,
                   const Targets& targets)
{
  if (settings.draft) draw_drafts();
  const fs::path folder = settings.output / "figures";
  create_folder(folder);
  draw_figures(folder, triaxial_figures(sets, targets));
  draw_figures(folder, load_figures(sets, targets));
  draw_figures(folder, {check_figure(sets)});
  draw_figures(folder, energy_figures(sets));
  draw_figures(folder, sleeve_figures(sets, targets));
  draw_figures(folder, column_figures(sets));
  draw_run_pictures(folder, sets);
  std::cout << "\nPictures: " << folder.string() << '\n';
}

/// One page beside the results of all, one in each case folder.
void write_reports(const Settings& settings, const std::vector<SetResult>& sets,
                   const Targets& targets, const std::vector<std::string>& left_out)
{
  const fs::path report = settings.output / "report.html";
  write_text(report, series_page(sets, targets, settings.output, left_out));
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests) try {
        write_text(test.run->folder / "report.html",
                   case_page(test, targets, settings.output / "figures"));
      } catch (const InputError& problem) {  // of a run in a folder for reading only
        std::cerr << "note: no report of '" << test.run->id << "': " << problem.what() << '\n';
      }
  std::cout << "Report:   " << report.string() << ", and one in the folder of each case\n";
}

constexpr int check_missed = 3;  // exit code

/// The exit code.
int run(const Settings& settings, std::vector<std::string> arguments)
{
  const CaseRuns found = read_case_runs(settings.folders);
  const Targets targets(settings.targets);
  const std::vector<SetResult> sets = evaluate(found.runs, settings.platen, targets.strip_limit());
  if (!settings.pictures_only) {
    for (const std::string& sentence : found.left_out) std::cerr << "note: " << sentence << '\n';
    write_tables(settings, sets, targets);
  }
  const CheckCount count = count_checks(sets);
  const int code = settings.strict && count.failed > 0 ? check_missed : 0;
  if (settings.no_pictures) return code;
  arguments.emplace_back("--pictures-only");
  provide_display(arguments);
  draw_pictures(settings, sets, targets);
  write_reports(settings, sets, targets, found.left_out);
  std::cout << count.sentence() << '\n';  // again, as many lines came in between
  return code;
}

}  // namespace

int main(int count, char** words)
{
  Settings settings;
  CLI::App app{"Curves, tables and pictures of triaxial runs"};
  app.add_option("folders", settings.folders, "a series (runs/default) or several case folders")
      ->required();
  app.add_option("--targets", settings.targets,
                 "CSV file of the published values [targets.csv beside the program]");
  app.add_option("--output", settings.output,
                 "folder for the results [the series, or the folder that holds the first case]");
  std::string platen;
  app.add_option("--platen", platen, "platen that q is read from [plain: mean, encased: bottom]")
      ->check(CLI::IsMember({"top", "bottom", "mean"}));
  app.add_flag("--no-pictures", settings.no_pictures, "tables only");
  app.add_flag("--draft", settings.draft, "3-D pictures with ragged edges, in a third of the time");
  app.add_flag("--strict", settings.strict,
               "exit code 3 if a required check is missed [0: it is told, no more]");
  app.add_flag("--pictures-only", settings.pictures_only, "pictures only, no tables");
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : 1;
  }
  vtkObject::GlobalWarningDisplayOff();
  try {
    if (!platen.empty()) settings.platen = platen_of(platen);
    if (settings.targets.empty()) settings.targets = default_targets();
    if (settings.output.empty()) settings.output = default_output(settings.folders.front());
    return run(settings, {words + 1, words + count});
  } catch (const std::exception& problem) {
    std::cerr << "encase-postprocess: " << problem.what() << '\n';
    return 1;
  }
}
