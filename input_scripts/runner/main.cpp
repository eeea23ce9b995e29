// SPDX-License-Identifier: GPL-2.0-only
// The program `encase`: what a user types. Each subcommand reads its options here and does its work
// elsewhere.
#include "core/input_error.h"
#include "report_command.h"
#include "runner/calibrate_call.h"
#include "runner/command_line.h"
#include "runner/doctor_command.h"
#include "runner/explain_command.h"
#include "runner/places.h"
#include "runner/run_command.h"
#include "runner/shell_texts.h"
#include "runner/version.h"

#include <iostream>

using namespace encased_column;

namespace {

int complain(const std::string& command, const std::string& sentence)
{
  std::cerr << "encase" << (command.empty() ? "" : " " + command) << ": " << sentence << '\n';
  return 1;
}

int carry_out(const CommandLine& line, const std::vector<std::string>& words)
{
  const std::string command = line.command();
  if (command == "texts") return write_shell_texts(line, line.folder), 0;
  if (command == "calibrate") call_calibrate(line.app.get_subcommands().front()->remaining());
  const Places places = find_places();
  if (command == "report") return report_command(line.report, places, words);
  if (command == "styles") return styles_command(places);
  if (command == "explain") return explain_command(places, joined(line.word));
  if (command == "doctor") return doctor_command(places);
  return command == "list" || line.run.list ? list_command(places, line.run)
                                            : run_command(places, line.run);
}

}  // namespace

int main(int count, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + count);
  CommandLine line;
  line.add_version([] { return versions(find_places()); });
  const std::string command = !words.empty() && words.front()[0] != '-' ? words.front() : "";
  try {
    line.app.parse(count, argv);
  } catch (const CLI::Success& wish) {
    return line.app.exit(wish);
  } catch (const CLI::ParseError& problem) {
    return complain(command, in_one_sentence(problem, line.app, words));
  } catch (const std::exception& problem) {
    return complain(command, problem.what());
  }
  try {
    return carry_out(line, words);
  } catch (const std::exception& problem) {
    return complain(command, problem.what());
  }
}
