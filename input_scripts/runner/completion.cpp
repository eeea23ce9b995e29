// SPDX-License-Identifier: GPL-2.0-only
#include "runner/completion.h"

#include "runner/visible_commands.h"

#include <CLI/CLI.hpp>

#include <map>
#include <vector>

namespace encased_column {

namespace {

/// Functions of both shells that print words, one a line.
const char* const word_functions = R"sh(
_encase_cases() { encase list 2>/dev/null | sed -n '2,/^$/s/^[* ] \([^ ][^ ]*\) .*/\1/p'; }
_encase_series() { encase list 2>/dev/null | sed -n 's/^Series, for --series NAME: //p' | tr ' ' '\n'; }
_encase_variables() { encase list 2>/dev/null | sed -n 's/^  \([a-z][a-z0-9_]*\) .*\[.*/\1=/p' | sort -u; }
_encase_words() { encase styles 2>/dev/null | sed '/^$/,$d; s/^fix //; s/  .*//'; }
)sh";

/// What a value is taken from.
struct Source {
  enum class Kind { none, files, folders, function, words } kind = Kind::none;
  std::string text;  ///< name of the function, or the words with blanks between
};

Source source_of(const CLI::Option& option)
{
  using Kind = Source::Kind;
  static const std::map<std::string, Source> by_name{
      {"case", {Kind::function, "_encase_cases"}},
      {"series", {Kind::function, "_encase_series"}},
      {"set", {Kind::function, "_encase_variables"}},
      {"word", {Kind::function, "_encase_words"}},
      {"resolution", {Kind::words, "quick standard paper"}},
      {"folders", {Kind::folders, ""}},
      {"output", {Kind::folders, ""}},
      {"targets", {Kind::files, ""}},
  };
  const std::string name =
      option.get_lnames().empty() ? option.get_single_name() : option.get_lnames().front();
  const auto known = by_name.find(name);
  if (known != by_name.end()) return known->second;
  std::string type = option.get_type_name();
  if (type == "FILE") return {Kind::files, ""};
  if (type == "DIR") return {Kind::folders, ""};
  const auto from = type.find('{'), to = type.find('}');
  if (from == std::string::npos || to == std::string::npos) return {};
  type = type.substr(from + 1, to - from - 1);
  for (char& c : type) c = c == ',' ? ' ' : c;
  return {Kind::words, type};
}

bool takes_value(const CLI::Option& option)
{
  return option.get_items_expected_max() > 0;
}

std::vector<std::string> names_of(const CLI::Option& option)
{
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::string option_names(const CLI::App& command)
{
  std::string names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      names += (names.empty() ? "--" : " --") + name;
  return names;
}

std::string bash_candidates(const Source& source)
{
  using Kind = Source::Kind;
  switch (source.kind) {
    case Kind::files:
      return "compgen -f -- \"$word\"";
    case Kind::folders:
      return "compgen -d -- \"$word\"";
    case Kind::function:
      return "compgen -W \"$(" + source.text + ")\" -- \"$word\"";
    case Kind::words:
      return "compgen -W '" + source.text + "' -- \"$word\"";
    default:
      return ":";
  }
}

/// `text` inside single quotes, for the part of a zsh argument that stands in brackets.
std::string zsh_text(const std::string& text)
{
  std::string quoted;
  for (const char c : text) {
    if (c == '\'')
      quoted += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      quoted += std::string("\\") + c;
    else
      quoted += c == '\n' ? ' ' : c;
  }
  return quoted;
}

std::string zsh_action(const Source& source)
{
  using Kind = Source::Kind;
  switch (source.kind) {
    case Kind::files:
      return "_files";
    case Kind::folders:
      return "_files -/";
    case Kind::function:
      return "{compadd -- ${(f)\"$(" + source.text + ")\"}}";
    case Kind::words:
      return "(" + source.text + ")";
    default:
      return " ";
  }
}

std::string zsh_arguments(const CLI::App& command)
{
  std::string lines;
  for (const CLI::Option* option : command.get_options()) {
    const std::string value =
        takes_value(*option) ? ":value:" + zsh_action(source_of(*option)) : "";
    if (option->get_positional()) lines += " \\\n        '*" + value + "'";
    for (const std::string& name : names_of(*option))
      lines +=
          " \\\n        '*" + name + "[" + zsh_text(option->get_description()) + "]" + value + "'";
  }
  return lines;
}

}  // namespace

std::string bash_completion(const CLI::App& app)
{
  std::string commands, values, options, positionals;
  for (const CLI::App* command : visible_commands(app)) {
    const std::string name = command->get_name();
    commands += name + " ";
    options += "    " + name + ") options='" + option_names(*command) + "' ;;\n";
    for (const CLI::Option* option : command->get_options()) {
      const std::string candidates = bash_candidates(source_of(*option));
      if (option->get_positional())
        positionals += "    " + name + ") " + candidates + " ;;\n";
      else if (takes_value(*option))
        for (const std::string& word : names_of(*option))
          values += "    '" + name + " " + word + "') " + candidates + "; return ;;\n";
    }
  }
  return "# Completion of `encase` for bash, made from its own options when it was built.\n" +
         std::string(word_functions) +
         "\n# Prints the candidates for the word in the making.\n_encase_candidates() {\n"
         "  local command=$1 before=$2 word=$3 options=\n"
         "  case \"$command $before\" in\n" +
         values +
         "  esac\n"
         "  case $command in\n" +
         options +
         "  esac\n"
         "  [[ $word == -* ]] && { compgen -W \"$options\" -- \"$word\"; return; }\n"
         "  case $command in\n" +
         positionals + "    *) compgen -W \"$options\" -- \"$word\" ;;\n" +
         "  esac\n"
         "}\n\n"
         "_encase() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]}\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         commands + option_names(app) +
         "' -- \"$word\")\n"
         "    return\n"
         "  fi\n"
         "  [[ ${COMP_WORDS[COMP_CWORD - 1]} == --set ]] && compopt -o nospace 2>/dev/null\n"
         "  mapfile -t COMPREPLY < <(_encase_candidates \"${COMP_WORDS[1]}\" "
         "\"${COMP_WORDS[COMP_CWORD - 1]}\" \"$word\")\n"
         "}\n\n"
         "complete -o filenames -F _encase encase\n";
}

std::string zsh_completion(const CLI::App& app)
{
  std::string commands, cases;
  for (const CLI::App* command : visible_commands(app)) {
    commands += "    '" + command->get_name() + ":" + zsh_text(command->get_description()) + "'\n";
    cases +=
        "    " + command->get_name() + ")\n      _arguments -s" + zsh_arguments(*command) + " ;;\n";
  }
  return "#compdef encase\n"
         "# Completion of `encase` for zsh, made from its own options when it was built.\n" +
         std::string(word_functions) +
         "\n_encase() {\n"
         "  local -a commands=(\n" +
         commands +
         "  )\n"
         "  if ((CURRENT == 2)); then\n"
         "    _describe command commands\n"
         "    _arguments" +
         zsh_arguments(app) +
         "\n    return\n"
         "  fi\n"
         "  shift words\n"
         "  ((CURRENT--))\n"
         "  case $words[1] in\n" +
         cases +
         "  esac\n"
         "}\n\n"
         "_encase \"$@\"\n";
}

}  // namespace encased_column
