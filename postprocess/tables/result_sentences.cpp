// SPDX-License-Identifier: GPL-2.0-only
#include "tables/result_sentences.h"

#include "core/input_error.h"
#include "tables/agreement.h"
#include "tables/check_table.h"
#include "tables/text_layout.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

/// A quantity in letters that every terminal has.
std::string in_letters(const std::string& quantity)
{
  return quantity == "φ" ? "phi" : quantity;
}

/// "E50 3 of 4, phi 1 of 2", in the order of the list.
std::string counts_by_quantity(const std::vector<AgreementNumber>& all)
{
  std::vector<std::string> quantities;
  for (const AgreementNumber& one : all)
    if (std::find(quantities.begin(), quantities.end(), one.quantity) == quantities.end())
      quantities.push_back(one.quantity);
  std::string text;
  for (const std::string& quantity : quantities) {
    long met = 0, number = 0;
    for (const AgreementNumber& one : all)
      if (one.quantity == quantity) {
        ++number;
        met += one.near();
      }
    text += (text.empty() ? "" : ", ") + in_letters(quantity) + " " + std::to_string(met) + " of " +
            std::to_string(number);
  }
  return text;
}

/// The first few of `parts`, and how many more there are.
std::string some_of(const std::vector<std::string>& parts, const std::string& file)
{
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t n = 0; n < std::min(parts.size(), most); ++n) text += (n ? "; " : "") + parts[n];
  if (parts.size() > most)
    text += "; and " + std::to_string(parts.size() - most) + " more, in " + file;
  return text;
}

std::string percent(double part)
{
  return (part < 0.0 ? "-" : "+") + fixed(100.0 * std::abs(part), 0) + " %";
}

std::string sentences_of_values(const std::vector<AgreementNumber>& all)
{
  if (all.empty()) return std::string(nothing_to_compare) + "\n";
  std::vector<std::string> missed;
  for (const AgreementNumber& one : all)
    if (!one.near())
      missed.push_back(in_letters(one.quantity) + (one.at.empty() ? "" : " at " + one.at) + " (" +
                       one.tests + ") " + in_three_digits(one.found) + " for " +
                       in_words(one.published) + (one.unit == "-" ? "" : " " + one.unit) + " (" +
                       percent(one.ratio() - 1.0) + ")");
  return met_count(all) + " (" + counts_by_quantity(all) + ").\n" +
         (missed.empty() ? "Not met: none.\n"
                         : "Not met: " + some_of(missed, "beside_study.txt") + ".\n");
}

std::string sentence_of_checks(const std::vector<SetResult>& sets)
{
  const CheckCount count = count_checks(sets);
  std::vector<std::string> missed;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const Check& check : test.checks)
        if (check.required && check.missed()) missed.push_back(test.run->id + " " + check.name);
  const std::string number = std::to_string(count.required);
  std::string text = missed.empty()
                         ? "Checks of the runs: none of " + number + " missed"
                         : "Checks of the runs: " + std::to_string(missed.size()) + " of " +
                               number + " missed (" + some_of(missed, "checks.txt") + ")";
  if (count.not_made) text += ", " + std::to_string(count.not_made) + " not made";
  return text + ".\n";
}

}  // namespace

std::string result_sentences(const std::vector<SetResult>& sets, const Targets& targets)
{
  return sentences_of_values(agreement_numbers(sets, targets)) + sentence_of_checks(sets);
}

}  // namespace encased_column
