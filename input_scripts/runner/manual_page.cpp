// SPDX-License-Identifier: GPL-2.0-only
#include "runner/manual_page.h"

#include "core/program_options.h"
#include "runner/visible_commands.h"

#include <CLI/CLI.hpp>

namespace encased_column {

namespace {

/// `text` as roff reads it: its own signs are kept from it.
std::string as_roff(const std::string& text)
{
  std::string roff;
  for (const char c : text) {
    const bool at_start = roff.empty() || roff.back() == '\n';
    if (at_start && (c == '.' || c == '\'')) roff += "\\&";
    if (c == '\\')
      roff += "\\e";
    else if (c == '-')
      roff += "\\-";
    else
      roff += c;
  }
  return roff;
}

std::string upper(std::string text)
{
  for (char& c : text) c = c == ' ' ? '-' : static_cast<char>(std::toupper(c));
  return text;
}

std::string opening(const std::string& title, const std::string& what, const std::string& version)
{
  std::string name = title;
  for (char& c : name) c = c == ' ' ? '-' : c;
  return ".TH " + as_roff(upper(title)) + " 1 \"\" \"" + as_roff(version) +
         "\" \"Encased columns for LIGGGHTS\"\n.SH NAME\n" + as_roff(name + " - " + what) + "\n";
}

std::string paragraph(const std::string& head, const std::string& text)
{
  return ".TP\n" + head + "\n" + as_roff(text) + "\n";
}

std::string bold(const std::string& text)
{
  return "\\fB" + as_roff(text) + "\\fR";
}

/// "--case ID", the type in italics.
std::string option_head(const CLI::Option& option)
{
  std::string head;
  for (const std::string& name : option.get_snames())
    head += (head.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames())
    head += (head.empty() ? "" : ", ") + bold("--" + name);
  if (head.empty()) return "\\fI" + as_roff(option.get_single_name()) + "\\fR";
  const bool takes_value = option.get_items_expected_max() > 0;
  return head + (takes_value ? " \\fI" + as_roff(option.get_type_name()) + "\\fR" : "");
}

std::string usage(const CLI::App& command, const std::string& name)
{
  const bool has_commands = !visible_commands(command).empty();
  std::string text =
      bold(name) + (has_commands ? " \\fICOMMAND\\fR" : "") + " [\\fIOPTION\\fR ...]";
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) {
      const bool several = option->get_items_expected_max() > 1;
      text += " \\fI" + as_roff(option->get_single_name()) + "\\fR" + (several ? " ..." : "");
    }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& command, const std::string& name,
                        const std::string& version)
{
  std::string text = opening(name, command.get_description(), version);
  text += ".SH SYNOPSIS\n" + usage(command, name) + "\n.SH OPTIONS\n";
  for (const CLI::Option* option : command.get_options())
    text += paragraph(option_head(*option), option->get_description());
  const auto commands = visible_commands(command);
  if (!commands.empty()) text += ".SH COMMANDS\n";
  for (const CLI::App* one : commands)
    text += paragraph(bold(one->get_name()),
                      one->get_description() + ": see " + name + "-" + one->get_name() + "(1)");
  if (!command.get_footer().empty()) text += ".SH NOTES\n" + as_roff(command.get_footer()) + "\n";
  const bool of_program = !commands.empty();
  return text + ".SH SEE ALSO\n" + (of_program ? bold("liggghts-encase") : bold("encase")) +
         "(1)\n";
}

std::string manual_page_of_host(const std::vector<PageStart>& styles, const std::string& version)
{
  std::string text =
      opening("liggghts-encase", "LIGGGHTS with the plugin for encased columns", version);
  text += ".SH SYNOPSIS\n" + bold("liggghts-encase -in") + " \\fIDECK\\fR [\\fIOPTION\\fR ...]\n" +
          ".SH OPTIONS\nThose of LIGGGHTS, and:\n";
  for (const ProgramOption& option : program_options)
    text += paragraph(bold(option.name), option.meaning);
  text += ".SH STYLES\n";
  for (const PageStart& style : styles) text += paragraph(bold(style.name), style.summary);
  return text + ".SH SEE ALSO\n" + bold("encase") + "(1)\n";
}

}  // namespace encased_column
