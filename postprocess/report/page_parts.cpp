// SPDX-License-Identifier: GPL-2.0-only
#include "report/page_parts.h"

#include "core/input_error.h"
#include "drawing/figures.h"
#include "page_templates.h"
#include "tables/agreement.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <stdexcept>

namespace encased_column {

namespace {

using kainjow::mustache::mustache;

/// A number, or what stands for one that is not there.
bool is_numeric(const std::string& word)
{
  return word == "-" || word.find_first_not_of("+-.0123456789e") == std::string::npos;
}

std::vector<bool> numeric_columns(const Rows& rows)
{
  std::vector<bool> numeric(rows.front().size(), rows.size() > 1);
  for (std::size_t row = 1; row < rows.size(); ++row)
    for (std::size_t i = 0; i < numeric.size(); ++i)
      numeric[i] = numeric[i] && is_numeric(rows[row][i]);
  for (std::size_t i = 0; i < numeric.size(); ++i)
    if (rows.front()[i] == "unit") numeric[i] = false;
  return numeric;
}

PageData cell(const std::string& word, bool numeric)
{
  PageData data{"text", word == "-" ? "–" : word};
  if (numeric) data.set("kind", "number");
  if (word.size() > 25) data.set("kind", "long");
  if (word == "pass") data.set("kind", "good");
  if (word == "FAIL") data.set("kind", "bad");
  if (word == "not required" || word == "not made") data.set("kind", "info");
  return data;
}

PageData line(const std::vector<std::string>& row, const std::vector<bool>& numeric)
{
  PageData cells{PageData::type::list};
  for (std::size_t i = 0; i < row.size(); ++i) cells << cell(row[i], numeric[i]);
  return {"cells", cells};
}

std::size_t column_of(const Rows& rows, const std::string& heading)
{
  const auto& headings = rows.front();
  return static_cast<std::size_t>(std::find(headings.begin(), headings.end(), heading) -
                                  headings.begin());
}

/// The words of a column, each once, in the order they come in.
std::vector<std::string> words_of(const Rows& rows, std::size_t column)
{
  std::vector<std::string> words;
  for (std::size_t row = 1; row < rows.size(); ++row)
    if (std::find(words.begin(), words.end(), rows[row][column]) == words.end())
      words.push_back(rows[row][column]);
  return words;
}

PageData key_of(const Series& series)
{
  static const std::array<const char*, 4> dashes{"", "none", "8 5", "9 4 2 4"};
  char color[8];
  std::snprintf(color, sizeof color, "#%02x%02x%02x", series.color[0], series.color[1],
                series.color[2]);
  PageData key{"label", series.label};
  key.set("color", color);
  if (series.stroke != Stroke::none)
    key.set("dashes", dashes[static_cast<std::size_t>(series.stroke)]);
  if (series.marks) key.set("disc", PageData::type::bool_true);
  return key;
}

std::string axes_of(const Panel& panel)
{
  return panel.y.title + " over " + panel.x.title;
}

/// The panel without its legend.
PageData chart_data(const Panel& panel, int height)
{
  PageData data{"panel_title", panel.title};
  data.set("width", std::to_string(chart_width));
  data.set("top", std::to_string(chart_top));
  data.set("height", std::to_string(height - chart_top));
  data.set("alternative", panel.title + ": " + axes_of(panel));
  data.set("drawing", chart_svg(panel, height));
  return data;
}

/// The legend of `panels`, each label once.
PageData keys_of(const std::vector<Panel>& panels)
{
  PageData keys{PageData::type::list};
  std::set<std::string> known{""};
  for (const Panel& panel : panels)
    for (const Series& series : panel.series)
      if (known.insert(series.label).second) keys << key_of(series);
  return keys;
}

PageData panel_data(const Panel& panel)
{
  PageData data = chart_data(panel, chart_height);
  data.set("keys", keys_of({panel}));
  return data;
}

/// What the axes of `figure` show, with units.
std::string axes_of(const Figure& figure)
{
  std::string text;
  std::set<std::string> known;
  for (const Panel& panel : figure.panels)
    if (known.insert(axes_of(panel)).second) text += (text.empty() ? "" : "; ") + axes_of(panel);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

PageData table_data(const std::string& id, const std::string& caption, const Rows& all,
                    const std::string& group)
{
  const std::size_t column = column_of(all, group);
  const Rows rows = without(all, group);
  const std::vector<bool> numeric = numeric_columns(rows);
  PageData data{"caption", caption};
  data.set("table_id", id);
  data.set("columns", std::to_string(rows.front().size()));

  PageData headings{PageData::type::list};
  for (std::size_t i = 0; i < numeric.size(); ++i) {
    PageData heading{"text", rows.front()[i]};
    heading.set("numeric", numeric[i] ? PageData::type::bool_true : PageData::type::bool_false);
    headings << heading;
  }
  data.set("headings", headings);

  PageData bodies{PageData::type::list};
  const bool grouped = column < all.front().size();
  for (const std::string& word : grouped ? words_of(all, column) : std::vector<std::string>{""}) {
    PageData lines{PageData::type::list};
    for (std::size_t row = 1; row < rows.size(); ++row)
      if (!grouped || all[row][column] == word) lines << line(rows[row], numeric);
    PageData body{"lines", lines};
    if (grouped) body.set("group", word);
    bodies << body;
  }
  data.set("bodies", bodies);
  return data;
}

Rows without(const Rows& rows, const std::string& heading)
{
  Rows rest = rows;
  const std::size_t column = column_of(rows, heading);
  if (column < rows.front().size())
    for (std::vector<std::string>& row : rest)
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  return rest;
}

PageData figures_data(const std::vector<Figure>& figures, const std::string& variables)
{
  PageData list{PageData::type::list};
  for (const Figure& figure : figures) {
    PageData data{"figure_title", figure.title};
    data.set("figure_id", figure.name);
    data.set("figure_caption", figure.caption);
    data.set("figure_axes", axes_of(figure));
    data.set("figure_variables", variables);
    PageData panels{PageData::type::list};
    for (const Panel& panel : figure.panels) panels << panel_data(panel);
    data.set("panels", panels);
    data.set("wide",
             figure.panels.size() > 1 ? PageData::type::bool_true : PageData::type::bool_false);
    list << data;
  }
  return list;
}

void set_agreement(PageData& page, const std::vector<SetResult>& sets, const Targets& targets,
                   const std::string& variables)
{
  const std::vector<AgreementNumber> found = agreement_numbers(sets, targets);
  page.set("agreement_sentence", agreement_sentence(found));
  PageData numbers{PageData::type::list};
  for (const AgreementNumber& number : found) {
    PageData tile{"tests", number.tests};
    tile.set("quantity", number.name());
    tile.set("found", in_three_digits(number.found));
    tile.set("unit", number.unit);
    tile.set("published", in_words(number.published));
    tile.set("whose", number.of_laboratory ? "lab" : "study");
    tile.set("ratio", fixed(number.ratio(), 2));
    tile.set("near", number.near() ? PageData::type::bool_true : PageData::type::bool_false);
    numbers << tile;
  }
  page.set("has_numbers", found.empty() ? PageData::type::bool_false : PageData::type::bool_true);
  page.set("numbers", numbers);

  constexpr int height = 340;  // so that two of them stand in the first screen of a telephone
  PageData figures{PageData::type::list};
  for (const Figure& figure : agreement_figures(sets, targets)) {
    PageData data{"figure_title", figure.title};
    data.set("figure_caption", figure.caption);
    data.set("figure_axes", axes_of(figure));
    data.set("figure_variables", variables);
    PageData panels{PageData::type::list};
    for (const Panel& panel : figure.panels) panels << chart_data(panel, height);
    data.set("panels", panels);
    data.set("keys", keys_of(figure.panels));
    figures << data;
  }
  page.set("agreement_figure", figures);
}

PageData pictures_data(const std::vector<Picture>& pictures)
{
  PageData list{PageData::type::list};
  for (const Picture& picture : pictures) {
    PageData data{"png", picture.image.base64};
    data.set("picture_width", std::to_string(picture.image.width));
    data.set("picture_height", std::to_string(picture.image.height));
    data.set("picture_caption", picture.caption);
    data.set("picture_alternative", picture.alternative);
    data.set("wide_picture", picture.wide ? PageData::type::bool_true : PageData::type::bool_false);
    list << data;
  }
  return list;
}

PageData list_of(const std::string& name, const std::vector<std::string>& texts)
{
  PageData list{PageData::type::list};
  for (const std::string& text : texts) list << PageData{name, text};
  return list;
}

std::string filled(const char* page, PageData data)
{
  const auto part = [&data](const std::string& name, const char* text) {
    data.set(name, PageData{kainjow::mustache::partial{[text] { return std::string(text); }}});
  };
  part("opening", page_templates::opening);
  part("table", page_templates::table);
  part("figure", page_templates::figure);
  part("pictures", page_templates::pictures);
  part("legend", page_templates::legend);
  part("agreement", page_templates::agreement);
  data.set("script", page_templates::sort_script);
  data.set("style", page_templates::style);
  mustache form{std::string(page)};
  if (!form.is_valid()) throw std::logic_error("template of a page: " + form.error_message());
  const std::string text = form.render(data);
  if (!form.is_valid()) throw std::logic_error("template of a page: " + form.error_message());
  return text;
}

}  // namespace encased_column
