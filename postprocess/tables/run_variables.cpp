// SPDX-License-Identifier: GPL-2.0-only
#include "tables/run_variables.h"

#include "core/input_error.h"
#include "tables/text_layout.h"

#include <algorithm>

namespace encased_column {

namespace {

/// How a deck's number is called and written.
struct ShownVariable {
  std::string name, symbol, unit;
  double factor;  ///< from SI to `unit`
};

const std::vector<ShownVariable> shown_variables{
    {"sigma3", "σ₃", " kPa", 1e-3},
    {"modulus", "E*", " MPa", 1e-6},
    {"kappa", "κ*", "", 1.0},
    {"mu", "μ", "", 1.0},
    {"mu_r", "μr", "", 1.0},
    {"porosity", "porosity", "", 1.0},
    {"radius", "radius", " mm", 1e3},
    {"height", "height", " mm", 1e3},
    {"rate", "rate", " mm per 1000 steps", 1e6},
    {"seed", "seed", "", 1.0},
};

/// What `run` took for the deck's variable `name`: a rate of 0 stands for that of its resolution,
/// and a resolution packs looser than the porosity that was asked for.
std::optional<double> resolved(const CaseRun& run, const std::string& name)
{
  const std::optional<double> asked = run.number(name);
  if (!asked) return std::nullopt;
  std::optional<double> used;
  if (name == "rate" && *asked == 0.0) used = run.number("rate_here");
  if (name == "porosity") used = run.number("generation");
  return used ? used : asked;
}

void add_word(std::vector<std::string>& words, const std::string& word)
{
  if (!word.empty() && std::find(words.begin(), words.end(), word) == words.end())
    words.push_back(word);
}

/// "σ₃ 50 / 100 kPa" behind `text`, unless there are no `words`.
void add_variable(std::string& text, const std::string& symbol,
                  const std::vector<std::string>& words, const std::string& unit)
{
  if (words.empty()) return;
  text += (text.empty() ? "" : ", ") + symbol + ' ';
  for (const std::string& word : words) text += (&word == &words.front() ? "" : " / ") + word;
  text += unit;
}

}  // namespace

std::string run_variables(const std::vector<const CaseRun*>& runs)
{
  std::string text;
  for (const ShownVariable& variable : shown_variables) {
    std::vector<std::string> words;
    for (const CaseRun* run : runs)
      if (const std::optional<double> value = resolved(*run, variable.name))
        add_word(words, in_words(variable.factor * *value));
    add_variable(text, variable.symbol, words, variable.unit);
  }
  for (const auto& [symbol, member] :
       {std::pair("gradation", &CaseRun::gradation), std::pair("set", &CaseRun::parameters),
        std::pair("resolution", &CaseRun::resolution)}) {
    std::vector<std::string> words;
    for (const CaseRun* run : runs) add_word(words, run->*member);
    add_variable(text, symbol, words, "");
  }
  return text;
}

}  // namespace encased_column
