// SPDX-License-Identifier: GPL-2.0-only
#include "output/contact_columns.h"

#include "core/input_error.h"
#include "core/keyword_table.h"
#include "files/column_names.h"

namespace encased_column {

namespace {

template <int kind>
double of_kind(const ContactStatistics& s)
{
  return s.forces.of_kind(kind);
}

}  // namespace

const std::vector<Column<ContactStatistics>>& contact_columns()
{
  namespace of = contact_column;
  using Sample = ContactStatistics;
  static const std::vector<Column<Sample>> columns{
      {of::step, "of the row", [](const Sample& s) { return s.step; }},
      {of::contacts, "all of them", [](const Sample& s) { return s.forces.contacts(); }},
      {of::grain_contacts, "between two grains", of_kind<0>},
      {of::wall_contacts, "with rigid walls", of_kind<1>},
      {of::sleeve_contacts, "with sleeves", of_kind<2>},
      {of::sliding_fraction, "of all, where friction is used up",
       [](const Sample& s) { return s.forces.sliding_fraction(); }},
      {of::mean_force, "magnitude", [](const Sample& s) { return s.forces.mean(); }},
      {of::largest_force, "magnitude", [](const Sample& s) { return s.forces.largest(); }},
  };
  return columns;
}

std::vector<double> contact_levels(const Options& options)
{
  /// Of the study's Figure 13 [N].
  static const std::vector<double> usual{5.0, 20.0, 40.0, 60.0};
  std::vector<double> levels;
  if (options.has("level"))
    for (const auto& words : options.all("level")) {
      levels.push_back(read_number("level", words.front()));
      if (!(levels.back() > 0.0))
        throw InputError("'level' must be larger than zero, found " + in_words(levels.back()) +
                         ", write a force in N");
    }
  if (levels.empty()) levels = usual;
  std::vector<std::string> words;
  for (const double level : levels) words.push_back(in_words(level));
  options.assume("level", joined(words));
  return levels;
}

std::vector<std::string> contact_headings(const std::vector<double>& levels)
{
  std::vector<std::string> headings = headings_of(contact_columns());
  for (const double level : levels)
    for (const std::string& name : {contact_column::contacts_above, contact_column::share_above})
      headings.push_back(name + in_words(level) + contact_column::level_end);
  return headings;
}

std::vector<double> contact_numbers(const ContactStatistics& sample)
{
  std::vector<double> numbers;
  add_numbers(contact_columns(), sample, numbers);
  for (std::size_t n = 0; n < sample.forces.levels().size(); ++n)
    numbers.insert(numbers.end(), {sample.forces.above(n), sample.forces.share_above(n)});
  return numbers;
}

std::vector<ColumnText> contact_texts()
{
  std::vector<ColumnText> texts = texts_of(contact_columns());
  texts.push_back({contact_column::contacts_above + "LN", "-",
                   "that bear the level L or more, for each level"});
  texts.push_back({contact_column::share_above + "LN", "-", "of all contacts, for each level"});
  return texts;
}

}  // namespace encased_column
