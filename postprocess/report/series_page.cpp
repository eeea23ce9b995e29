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
#include "tables/set_comparison.h"
#include "tables/target_table.h"
#include "tables/theory_table.h"

#include <algorithm>
#include <cctype>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

constexpr int small_picture_width = 400;  // px

const std::string parameters_heading = "parameters";

std::string three_digits(const std::optional<double>& value)
{
  return value ? fixed(*value, 3) : "-";
}

std::string percent_or_dash(const std::optional<double>& share)
{
  return share ? fixed(100.0 * *share, 0) : "-";
}

std::vector<std::string> as_words(const TestResult& test, const RunRecord& record)
{
  const CaseRun& run = *test.run;
  const CheckCount count = count_checks({{run.set(), {test}, {}}});
  return {run.id,
          run.parameters.empty() ? "-" : run.parameters,
          in_words(run.confining_stress / 1e3),
          run.resolution.empty() ? "-" : run.resolution,
          test.grains ? std::to_string(*test.grains) : "-",
          percent_or_dash(test.density.relative_density),
          three_digits(test.density.laboratory_porosity),
          three_digits(run.generation_porosity),
          fixed(run.history.numbers(history_column::porosity_less_overlap).front(), 3),
          fixed(test.peak.reported / 1e3, 0),
          test.secant_modulus ? fixed(*test.secant_modulus / 1e6, 1) : "-",
          fixed(100.0 * test.axial_strain.back(), 1),
          std::to_string(count.passed()) + " of " + std::to_string(count.required),
          std::to_string(record.warnings.size()),
          time_of(record)};
}

/// "Plain and encased triaxial tests, encased columns", as far as `sets` hold them.
std::string kinds_of(const std::vector<SetResult>& sets)
{
  const auto have = [&](const std::string& name) {
    return std::any_of(sets.begin(), sets.end(),
                       [&](const SetResult& set) { return set.set == name; });
  };
  std::vector<std::string> kinds;
  if (have("plain_triaxial") && have("encased_triaxial"))
    kinds.push_back("plain and encased triaxial tests");
  else if (have("plain_triaxial") || have("encased_triaxial"))
    kinds.push_back(have("plain_triaxial") ? "plain triaxial tests" : "encased triaxial tests");
  if (have("column")) kinds.push_back("encased columns");
  std::string text = kinds.size() > 1 ? kinds[0] + ", " + kinds[1] : kinds[0];
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::vector<const CaseRun*> runs_of(const std::vector<SetResult>& sets)
{
  std::vector<const CaseRun*> runs;
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests) runs.push_back(test.run);
  return runs;
}

void set_tests(PageData& page, const std::vector<SetResult>& sets, const fs::path& folder)
{
  Rows rows{{"test", parameters_heading, "σ₃ [kPa]", "resolution", "grains [-]", "Dr [%]",
             "n, laboratory [-]", "n at generation [-]", "n at start [-]", "peak q [kPa]",
             "E50 [MPa]", "strain reached [%]", "checks passed", "warnings [-]", "time"}};
  PageData pages{PageData::type::list}, repeats{PageData::type::list};
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests) {
      const RunRecord record = read_run_record(test.run->folder);
      rows.push_back(as_words(test, record));
      PageData link{"name", test.run->id};
      link.set("address", fs::relative(test.run->folder / "report.html", folder).string());
      pages << link;
      repeats << PageData{"arguments", repeat_arguments(*test.run, record.commands.empty()
                                                                       ? std::string()
                                                                       : record.commands.front())};
    }
  if (!name_parameters(sets)) rows = without(rows, parameters_heading);
  page.set("tests", table_data("tests_table", "Tests of this series", rows));
  page.set("pages", pages);
  page.set("repeats", repeats);
}

void set_results(PageData& page, const std::vector<SetResult>& sets, const Targets& targets)
{
  PageData tables{PageData::type::list}, notes{PageData::type::list};
  for (const SetComparison& comparison : set_comparisons(sets, targets))
    tables << table_data("sets_" + comparison.set, comparison.caption, comparison.rows);
  for (const SetResult& set : sets) {
    Rows rows{result_headings};
    for (const ResultRow& row : result_rows(set, targets)) {
      rows.push_back(as_words(row));
      rows.back()[1] += row.unit == "-" ? "" : " [" + row.unit + "]";
    }
    tables << table_data(
        "results_" + set.set + (set.parameters().empty() ? "" : "_" + set.parameters()),
        tests_heading(set) + (set.parameters().empty() ? "" : ", parameters " + set.parameters()) +
            ", q from the " + platen_name(set.tests.front().platen),
        without(rows, "unit"), "quantity");
    for (const std::string& note : result_notes(set)) notes << PageData{"sentence", note};
  }
  page.set("results", tables);
  page.set("notes", notes);
  const Rows theory = theory_rows(sets);
  if (theory.size() > 1)
    page.set("theory", table_data("theory", "Encased tests beside the closed form", theory));
}

std::vector<Figure> series_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  std::vector<Figure> figures = triaxial_figures(sets, targets);
  for (const Figure& figure : load_figures(sets, targets)) figures.push_back(figure);
  for (const Figure& figure : column_series_figures(sets, targets)) figures.push_back(figure);
  for (const Figure& figure : sleeve_figures(sets, targets)) figures.push_back(figure);
  figures.push_back(check_figure(sets));
  return figures;
}

}  // namespace

std::string series_page(const std::vector<SetResult>& sets, const Targets& targets,
                        const fs::path& folder, const std::vector<std::string>& left_out)
{
  PageData page;
  std::size_t tests = 0;
  std::vector<Picture> pictures;
  for (const SetResult& set : sets) {
    tests += set.tests.size();
    for (const TestResult& test : set.tests)
      for (Picture& picture : pictures_of(*test.run, folder / "figures", small_picture_width))
        pictures.push_back(std::move(picture));
  }
  page.set("title", kinds_of(sets) + ": series " + fs::canonical(folder).filename().string());
  const std::vector<const CaseRun*> runs = runs_of(sets);
  const bool own = std::all_of(runs.begin(), runs.end(),
                               [](const CaseRun* run) { return run->reproduces.empty(); });
  page.set("subtitle", std::to_string(tests) + (tests == 1 ? " test" : " tests") +
                           (own ? "."
                                : " of cinder gravel beside the laboratory and the numerical model "
                                  "of the study."));
  const std::string variables = run_variables(runs);
  set_agreement(page, sets, targets, variables);
  set_tests(page, sets, folder);
  page.set("left_out", list_of("sentence", left_out));
  page.set("study",
           table_data("beside_study",
                      "All values of the study; ratio: to the laboratory's, to the model's where "
                      "there is none",
                      target_rows(sets, targets), "set"));
  set_results(page, sets, targets);
  page.set("figures", figures_data(series_figures(sets, targets), variables));
  page.set("has_pictures",
           pictures.empty() ? PageData::type::bool_false : PageData::type::bool_true);
  page.set("picture_list", pictures_data(pictures));
  const CheckCount count = count_checks(sets);
  page.set("check_sentence", count.sentence());
  page.set("failed", count.failed ? PageData::type::bool_true : PageData::type::bool_false);
  page.set("checks", table_data("checks_table", "Checks of all tests", check_rows(sets), "check"));
  return filled(page_templates::series_page, page);
}

}  // namespace encased_column
