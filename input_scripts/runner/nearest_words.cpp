// SPDX-License-Identifier: GPL-2.0-only
#include "runner/nearest_words.h"

#include <algorithm>
#include <tuple>

namespace encased_column {

std::size_t letters_apart(const std::string& a, const std::string& b)
{
  // Rows of the table of distances between the starts of both: this one and the two before.
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

std::vector<std::string> nearest_words(const std::string& word,
                                       const std::vector<std::string>& known)
{
  constexpr std::size_t most = 3;
  const auto holds = [](const std::string& whole, const std::string& part) {
    return part.size() >= 3 && whole.find(part) != std::string::npos;
  };
  std::vector<std::tuple<bool, std::size_t, std::string>> candidates;
  for (const std::string& other : known) {
    const std::size_t apart = letters_apart(word, other);
    const bool alike = apart <= std::max<std::size_t>(word.size() / 3, 1);
    if (alike || holds(other, word) || holds(word, other))
      candidates.emplace_back(!alike, apart, other);
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<std::string> nearest;
  for (const auto& [far, apart, other] : candidates)
    if (nearest.size() < most) nearest.push_back(other);
  return nearest;
}

std::string nearest_clause(const std::string& word, const std::vector<std::string>& known)
{
  const std::vector<std::string> nearest = nearest_words(word, known);
  if (nearest.empty()) return "";
  std::string clause = nearest.size() == 1 ? ", nearest is " : ", nearest are ";
  for (std::size_t n = 0; n < nearest.size(); ++n)
    clause += (n == 0 ? "'" : n + 1 < nearest.size() ? ", '" : " and '") + nearest[n] + "'";
  return clause;
}

}  // namespace encased_column
