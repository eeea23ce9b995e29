// SPDX-License-Identifier: GPL-2.0-only
#include "runner/explain_command.h"

#include "core/input_error.h"
#include "runner/aligned_text.h"
#include "runner/case_list.h"
#include "runner/nearest_words.h"
#include "runner/processes.h"
#include "runner/style_catalogue.h"

#include <iostream>

namespace encased_column {

namespace {

std::vector<StyleText> styles_of(const Places& places)
{
  const std::string printed = output_of({places.host, "-styles"});
  if (printed.empty())
    throw InputError("the program 'liggghts-encase' must start to tell its styles, found that '" +
                     places.host.string() + "' does not, write 'encase doctor' to see why");
  return read_styles(printed, style_pages());
}

/// A line for each of our decks that has the variable `name`; empty where none has.
std::string uses_in_decks(DeckCatalogue& decks, const std::string& name)
{
  std::vector<std::vector<std::string>> rows;
  for (const std::string& deck_name : decks.names()) {
    const Deck& deck = decks.find(deck_name, "", "deck");
    if (!deck.find(name)) continue;
    const DeckVariable& variable = *deck.find(name);
    rows.push_back({"variable of deck " + deck_name + ", --set " + name + "=VALUE",
                    values_by_set(decks, deck, name), variable.unit, variable.meaning});
  }
  return rows.empty() ? "" : aligned(rows);
}

std::vector<std::string> variables_of(DeckCatalogue& decks)
{
  std::vector<std::string> names;
  for (const std::string& deck : decks.names())
    for (const std::string& name : decks.find(deck, "", "deck").names()) names.push_back(name);
  return names;
}

}  // namespace

int styles_command(const Places& places)
{
  std::cout << list_of_styles(styles_of(places))
            << "\n'encase explain STYLE' lists its keywords, 'encase explain KEYWORD' where it is "
               "used.\n";
  return 0;
}

int explain_command(const Places& places, const std::string& word)
{
  const std::vector<StyleText> styles = styles_of(places);
  DeckCatalogue decks(places.inputs);
  const StyleText* style = find_style(styles, word);
  std::string text = style ? description(*style) : "";
  const std::string uses = uses_of(styles, word) + uses_in_decks(decks, word);
  if (!uses.empty()) text += (text.empty() ? "" : "\n") + word + "\n" + uses;
  if (text.empty()) {
    std::vector<std::string> known = words_of(styles);
    for (const std::string& name : variables_of(decks)) known.push_back(name);
    throw InputError(
        "the word must be a style, a keyword, a column or a variable of a deck, found '" + word +
        "'" + nearest_clause(word, known) + ", write 'encase styles' to see all styles");
  }
  std::cout << text;
  return 0;
}

}  // namespace encased_column
