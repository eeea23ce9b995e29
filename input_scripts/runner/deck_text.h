// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_record.h"
#include "runner/deck.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// The value of a formula of numbers as decks write them, computed by muParser; nothing where the
/// text is none, has a name in it that the host knows and muParser does not, or is not finite.
std::optional<double> formula_value(const std::string& text);

/// The lines of a deck and of what it includes, as far as they can be known without the host: what
/// depends on a condition is taken as it stands.
class DeckText {
 public:
  /// `asked` are the values of the deck's own variables.
  DeckText(const Deck& deck, const Settings& asked);

  /// `text` with the variables in it replaced by their values; nothing if one is not known.
  std::optional<std::string> replaced(const std::string& text) const;
  /// The number that a variable is.
  std::optional<double> number(const std::string& variable) const;
  double number(const std::string& variable, double otherwise) const
  {
    return number(variable).value_or(otherwise);
  }
  /// The words behind `command` of the first line that has it and, unless that is empty, `keyword`;
  /// with variables replaced. Empty where there is none.
  std::vector<std::string> words(const std::string& command, const std::string& keyword) const;

 private:
  void read(const std::filesystem::path& file, int depth);
  void take(const std::string& line, int depth);
  void include(const std::string& name, int depth);
  std::optional<std::string> replaced(const std::string& text, int depth) const;

  const Deck& deck_;
  std::map<std::string, std::string> values_;
  std::vector<std::string> lines_;
};

}  // namespace encased_column
