// SPDX-License-Identifier: GPL-2.0-only
#include "runner/deck_text.h"

#include "core/input_error.h"
#include "runner/case_variables.h"
#include "runner/text_file.h"

#include <muParser.h>

#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// With the functions and the constant that formulas of the host have and muParser has not.
mu::Parser formula_parser()
{
  mu::Parser parser;
  parser.DefineFun("floor", [](double x) { return std::floor(x); });
  parser.DefineFun("ceil", [](double x) { return std::ceil(x); });
  parser.DefineConst("PI", std::acos(-1.0));
  return parser;
}

/// v_NAME of a formula as ${NAME}.
std::string with_braces(const std::string& formula)
{
  static const std::regex variable(R"(\bv_(\w+))");
  return std::regex_replace(formula, variable, "$${$1}");
}

std::string number_text(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

}  // namespace

std::optional<double> formula_value(const std::string& text)
{
  static const mu::Parser empty = formula_parser();
  mu::Parser parser = empty;
  try {
    parser.SetExpr(text);
    const double value = parser.Eval();
    if (std::isfinite(value)) return value;
  } catch (const mu::Parser::exception_type&) {
  }
  return std::nullopt;
}

DeckText::DeckText(const Deck& deck, const Settings& asked) : deck_(deck)
{
  values_["common"] = deck.common.string();
  values_["resume"] = "0";
  const std::string of_case = std::string(common_of_case) + "/";
  for (const auto& [name, value] : asked)
    values_.emplace(name, value.rfind(of_case, 0) == 0
                              ? (deck.common / value.substr(of_case.size())).string()
                              : value);
  read(deck.file, 0);
}

void DeckText::read(const fs::path& file, int depth)
{
  std::istringstream stream(read_text_file(file, "a deck"));
  std::string whole;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t last = line.find_last_not_of(" \t\r");
    if (last != std::string::npos && line[last] == '&') {
      whole += line.substr(0, last) + " ";
      continue;
    }
    take(whole + line, depth);
    whole.clear();
  }
}

// A value of a command line counts before those of index variables in the file; what is given
// again counts last.
void DeckText::take(const std::string& line, int depth)
{
  std::istringstream words(line);
  std::string command, name, style, value;
  words >> command >> name >> style >> value;
  if (command == "variable" && style == "index") values_.emplace(name, value);
  if (command == "variable" && style == "equal") values_[name] = with_braces(value);
  if (command == "include" && depth < 10) include(name, depth);
  lines_.push_back(line);
}

void DeckText::include(const std::string& name, int depth)
{
  const auto known = replaced(name);
  if (!known) return;
  for (const fs::path& folder : {deck_.file.parent_path(), deck_.common})
    if (fs::is_regular_file(folder / *known)) return read(folder / *known, depth + 1);
}

std::optional<std::string> DeckText::replaced(const std::string& text) const
{
  return replaced(text, 0);
}

std::optional<std::string> DeckText::replaced(const std::string& text, int depth) const
{
  std::string result = text;
  for (std::size_t at = 0; (at = result.find("${", at)) != std::string::npos;) {
    const std::size_t end = result.find('}', at);
    if (end == std::string::npos || depth > 20) return std::nullopt;
    const auto found = values_.find(result.substr(at + 2, end - at - 2));
    if (found == values_.end()) return std::nullopt;
    auto value = replaced(found->second, depth + 1);
    if (!value) return std::nullopt;
    if (const auto number = formula_value(*value)) value = number_text(*number);
    result.replace(at, end + 1 - at, *value);
    at += value->size();
  }
  return result;
}

std::optional<double> DeckText::number(const std::string& variable) const
{
  const auto text = replaced("${" + variable + "}");
  return text ? formula_value(*text) : std::nullopt;
}

std::vector<std::string> DeckText::words(const std::string& command,
                                         const std::string& keyword) const
{
  for (const std::string& line : lines_) {
    std::string plain;
    for (const char c : line.substr(0, line.find('#'))) plain += c == '"' ? ' ' : c;
    std::istringstream stream(plain);
    std::vector<std::string> found;
    bool has_command = false, has_keyword = keyword.empty();
    for (std::string word; stream >> word;) {
      if (has_command) found.push_back(replaced(word).value_or(word));
      has_command = has_command || word == command;
      has_keyword = has_keyword || (has_command && word == keyword);
    }
    if (has_command && has_keyword) return found;
  }
  return {};
}

}  // namespace encased_column
