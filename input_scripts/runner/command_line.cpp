// SPDX-License-Identifier: GPL-2.0-only
#include "runner/command_line.h"

#include "runner/nearest_words.h"
#include "runner/visible_commands.h"

namespace encased_column {

namespace {

/// The words with two dashes that `command` takes.
std::vector<std::string> long_options(const CLI::App& command)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> subcommand_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::App* command : visible_commands(app)) names.push_back(command->get_name());
  return names;
}

}  // namespace

CommandLine::CommandLine()
    : app("Encased granular columns: runs tests of the study or your own, and reports on them",
          "encase")
{
  app.require_subcommand(1);
  add_run_options(
      *app.add_subcommand("run",
                          "Runs triaxial tests and leaves tables, pictures and reports in a run "
                          "folder (from the sources: ./input_scripts/run [option ...])"),
      run);
  CLI::App* const list =
      app.add_subcommand("list", "Lists the cases and the variables of their decks");
  list->add_option("--cases", run.cases_file, "cases of your own beside ours")->type_name("FILE");
  list->add_option("--deck", run.deck, "a deck of your own beside ours")->type_name("FILE");
  add_report_options(*app.add_subcommand("report", "Curves, tables and pictures of triaxial runs"),
                     report);
  // A program of its own, which reads what stands behind its name.
  app.add_subcommand("calibrate",
                     "Parameters of the decks from laboratory results, and how sure they are")
      ->prefix_command()
      ->set_help_flag();
  app.add_subcommand("styles", "Lists the styles that the plugin adds to LIGGGHTS");
  app.add_subcommand("explain",
                     "Tells what a style, a keyword, a column of its tables or a variable of a "
                     "deck means")
      ->add_option("word", word, "its name, as 'servo/platen', 'porosity' or 'sigma3'")
      ->required();
  app.add_subcommand("texts", "Writes the pages of man and the completions of the shells")
      ->group("")  // not shown
      ->add_option("folder", folder)
      ->required();
  app.add_subcommand("doctor",
                     "Looks whether this machine has what the runs need, and says what to do where "
                     "it has not");
}

void CommandLine::add_version(std::function<std::string()> text)
{
  app.set_version_flag("--version", std::move(text),
                       "print version, commit, host, compiler and MPI");
}

std::string CommandLine::command() const
{
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? "" : given.front()->get_name();
}

std::string in_one_sentence(const CLI::ParseError& problem, const CLI::App& app,
                            const std::vector<std::string>& words)
{
  const CLI::App* command = nullptr;
  if (!words.empty())
    for (const CLI::App* one : visible_commands(app))
      if (one->get_name() == words.front()) command = one;
  if (!command && !words.empty() && words.front().rfind('-', 0) != 0)
    return "unknown command '" + words.front() + "'" +
           nearest_clause(words.front(), subcommand_names(app)) + ", see --help";
  if (dynamic_cast<const CLI::ExtrasError*>(&problem)) {
    const std::vector<std::string> rest = app.remaining(true);
    const std::string found = rest.empty() ? "" : rest.front();
    return "unknown option '" + found + "'" +
           nearest_clause(found, long_options(command ? *command : app)) + ", see --help";
  }
  const std::string text = problem.what();
  const std::string name = text.substr(0, text.find_first_of(": "));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&problem) && name.rfind("--", 0) == 0)
    return "option '" + name + "' needs a value, see --help";
  return text + ", see --help";
}

}  // namespace encased_column
