// SPDX-License-Identifier: GPL-2.0-only
#include "report/pages.h"

#include "core/input_error.h"
#include "drawing/figures.h"
#include "files/column_names.h"
#include "page_templates.h"
#include "report/page_parts.h"
#include "tables/check_table.h"
#include "tables/page_tables.h"
#include "tables/result_notes.h"
#include "tables/result_table.h"
#include "tables/run_variables.h"
#include "tables/theory_table.h"

#include <algorithm>
#include <iterator>

namespace encased_column {

namespace {

constexpr int large_picture_width = 800;  // px

using Sets = std::vector<SetResult>;

PageData fact(const std::string& name, const std::string& value, const std::string& beside)
{
  PageData data{"fact", name};
  data.set("is", value);
  if (!beside.empty()) data.set("beside", beside);
  return data;
}

std::string beside_the_study(const Published& published)
{
  std::string text;
  if (published.laboratory) text = "laboratory " + in_words(*published.laboratory);
  if (published.model) text += (text.empty() ? "" : ", ") + ("model " + in_words(*published.model));
  return text;
}

PageData facts(const TestResult& test, const Targets& targets, const RunRecord& record)
{
  const CaseRun& run = *test.run;
  PageData list{PageData::type::list};
  const auto published = [&](const std::string& quantity) {
    return beside_the_study(
        published_of(run, targets, quantity, confining_condition(run.confining_stress)));
  };
  list << fact("Confining stress σ₃", in_words(run.confining_stress / 1e3) + " kPa", "");
  list << fact("Peak deviatoric stress q", fixed(test.peak.reported / 1e3, 0) + " kPa",
               published("peak deviator q"));
  if (test.secant_modulus)
    list << fact("Secant modulus E50", fixed(*test.secant_modulus / 1e6, 1) + " MPa",
                 published("secant modulus E50"));
  list << fact("Porosity at the start of shear",
               fixed(run.history.numbers(history_column::porosity_less_overlap).front(), 3),
               "overlaps counted once");
  if (test.density.relative_density)
    list << fact(
        "Relative density", fixed(100.0 * *test.density.relative_density, 0) + " %",
        test.density.laboratory_porosity
            ? "porosity " + fixed(*test.density.laboratory_porosity, 3) + " in the laboratory"
            : "");
  if (test.grains) list << fact("Grains", std::to_string(*test.grains), "");
  const CheckCount count = count_checks({{run.set(), {test}, {}}});
  list << fact("Checks passed",
               std::to_string(count.passed()) + " of " + std::to_string(count.required), "");
  list << fact("Warnings", std::to_string(record.warnings.size()), "");
  return list;
}

/// Puts a table into `page`, unless it has headings only.
void set_table(PageData& page, const std::string& id, const std::string& caption, const Rows& rows,
               const std::string& group = {})
{
  if (rows.size() > 1) page.set(id, table_data(id, caption, rows, group));
}

std::vector<Figure> triaxial_curves(const Sets& sets, const Targets& targets)
{
  std::vector<Figure> figures = triaxial_figures(sets, targets);
  const auto line = [](const Figure& figure) { return figure.name == "p_q"; };  // takes several
  figures.erase(std::remove_if(figures.begin(), figures.end(), line), figures.end());
  for (const Figure& figure : load_figures(sets, targets)) figures.push_back(figure);
  return figures;
}

void set_published_column(PageData& page, const Targets& targets)
{
  const auto set = [&](const std::string& name, const std::string& quantity,
                       const std::string& condition) {
    const Published published = targets.find("column", quantity, condition);
    page.set(name, published.model ? in_words(*published.model) : "–");
  };
  set("porosity_low", "initial porosity in measuring spheres", "lowest");
  set("porosity_high", "initial porosity in measuring spheres", "highest");
  set("force_before", "largest contact force before loading", "");
  set("force_after", "largest contact force after loading", "");
}

void set_results(PageData& page, const TestResult& test, const Sets& sets, const Targets& targets)
{
  Rows results{result_headings};
  for (const ResultRow& row : result_rows(sets.front(), targets)) results.push_back(as_words(row));
  set_table(page, "results", "Results of this test beside the study's", without(results, "test"));
  page.set("platen", platen_name(test.platen));
  page.set("notes", list_of("sentence", test_notes(test)));
  set_table(page, "theory", "Both platens beside the closed form",
            without(theory_rows(sets), "test"));
  set_table(page, "column", "Measuring spheres before and after shear", column_rows(test), "when");
  set_published_column(page, targets);
  set_table(page, "contacts", "All contacts before and after shear", contact_batchs(test));
}

void set_run(PageData& page, const TestResult& test, const Sets& sets, const RunRecord& record)
{
  const CaseRun& run = *test.run;
  set_table(page, "checks", "Checks of this run",
            without(without(check_rows(sets), "test"), "parameters"));
  const CheckCount count = count_checks(sets);
  page.set("check_sentence", count.sentence());
  page.set("failed", count.failed ? PageData::type::bool_true : PageData::type::bool_false);
  page.set("warned",
           record.warnings.empty() ? PageData::type::bool_false : PageData::type::bool_true);
  page.set("warnings", list_of("sentence", record.warnings));
  set_table(page, "record", "How the run went", record_rows(test, record));
  set_table(page, "inputs", "Variables of the deck " + run.deck, input_rows(run));
  set_table(page, "gradation", "Gradation at full size", gradation_rows(run));

  page.set("version", version_of(record));
  page.set("repeat", repeat_arguments(run, record.commands.empty() ? "" : record.commands.front()));
  const auto set_lines = [&page](const std::string& name, const std::string& item,
                                 const std::vector<std::string>& lines) {
    page.set("has_" + name, lines.empty() ? PageData::type::bool_false : PageData::type::bool_true);
    page.set(name, list_of(item, lines));
  };
  set_lines("commands", "command", record.commands);
  set_lines("versions", "line", record.versions);
}

}  // namespace

std::string case_page(const TestResult& test, const Targets& targets,
                      const std::filesystem::path& pictures)
{
  const CaseRun& run = *test.run;
  const Sets sets{{run.set(), {test}, {}}};
  const RunRecord record = read_run_record(run.folder);
  const std::vector<Picture> found = pictures_of(run, pictures, large_picture_width);

  PageData page;
  page.set("title", run.title);
  std::string subtitle = "Case " + run.id + ", deck " + run.deck;
  if (!run.reproduces.empty()) subtitle += "; reproduces " + run.reproduces + " of the study";
  page.set("subtitle", subtitle + ".");
  page.set("encased", run.encased() ? PageData::type::bool_true : PageData::type::bool_false);
  set_agreement(page, sets, targets, run_variables({&run}));
  page.set("facts", facts(test, targets, record));
  set_results(page, test, sets, targets);
  set_run(page, test, sets, record);

  std::vector<Figure> all;
  const auto set_figures = [&](const std::string& name, const std::vector<Figure>& figures) {
    page.set(name, figures_data(figures, run_variables({&run})));
    std::copy(figures.begin(), figures.end(), std::back_inserter(all));
  };
  set_figures("load_figures", triaxial_curves(sets, targets));
  std::vector<Figure> sleeve = column_series_figures(sets, targets);
  for (const Figure& figure : sleeve_figures(sets, targets)) sleeve.push_back(figure);
  set_figures("sleeve_figures", sleeve);
  set_figures("column_figures", column_figures(sets, targets));
  std::vector<Figure> run_figures = energy_figures(sets);
  run_figures.insert(run_figures.begin(), check_figure(sets));
  set_figures("run_figures", run_figures);
  page.set("has_pictures", found.empty() ? PageData::type::bool_false : PageData::type::bool_true);
  page.set("picture_list", pictures_data(found));
  set_table(page, "counterparts", "Figures of the study and their counterparts on this page",
            counterpart_rows(test, all, found));
  return filled(page_templates::case_page, page);
}

}  // namespace encased_column
