// The program `encase`: what a user types. Each subcommand reads its options here and does its work
// elsewhere.
#include "core/input_error.h"
#include "report_command.h"
#include "runner/calibrate_call.h"
#include "runner/places.h"
#include "runner/run_command.h"

#include <CLI/CLI.hpp>

#include <iostream>

using namespace encased_column;

namespace {

/// One sentence for what the reader of options found.
std::string in_one_sentence(const CLI::ParseError& problem, const CLI::App& app)
{
  if (dynamic_cast<const CLI::ExtrasError*>(&problem)) {
    std::vector<std::string> rest = app.remaining(true);
    return "unknown option '" + (rest.empty() ? "" : rest.front()) + "', see --help";
  }
  const std::string text = problem.what();
  const std::string name = text.substr(0, text.find_first_of(": "));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&problem) && name.rfind("--", 0) == 0)
    return "option '" + name + "' needs a value, see --help";
  return text + ", see --help";
}

int complain(const std::string& command, const std::string& sentence)
{
  std::cerr << "encase" << (command.empty() ? "" : " " + command) << ": " << sentence << '\n';
  return 1;
}

}  // namespace

int main(int count, char** words)
{
  CLI::App app{"Encased granular columns: runs tests of the study or your own, and reports on them",
               "encase"};
  app.require_subcommand(1);
  RunOptions options;
  ReportOptions report_options;
  CLI::App* const run = app.add_subcommand(
      "run",
      "Runs triaxial tests and leaves tables, pictures and reports in a run folder:\n\n"
      "    ./input_scripts/run [option ...]\n");
  add_run_options(*run, options);
  CLI::App* const list =
      app.add_subcommand("list", "Lists the cases and the variables of their decks");
  list->add_option("--cases", options.cases_file, "cases of your own beside ours")
      ->type_name("FILE");
  list->add_option("--deck", options.deck, "a deck of your own beside ours")->type_name("FILE");
  CLI::App* const report =
      app.add_subcommand("report", "Curves, tables and pictures of triaxial runs");
  add_report_options(*report, report_options);
  CLI::App* const calibration = app.add_subcommand(
      "calibrate", "Parameters of the decks from laboratory results, and how sure they are");
  calibration->prefix_command()->set_help_flag();
  const std::string command = count > 1 && words[1][0] != '-' ? words[1] : "";
  try {
    app.parse(count, words);
  } catch (const CLI::Success& wish) {
    return app.exit(wish);
  } catch (const CLI::ParseError& problem) {
    return complain(command, in_one_sentence(problem, app));
  }
  try {
    if (calibration->parsed()) call_calibrate(calibration->remaining());
    if (report->parsed())
      return report_command(report_options, find_places(), {words + 1, words + count});
    return list->parsed() || options.list ? list_command(find_places(), options)
                                          : run_command(find_places(), options);
  } catch (const std::exception& problem) {
    return complain(command, problem.what());
  }
}
