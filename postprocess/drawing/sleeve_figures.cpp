// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "files/column_names.h"
#include "tables/text_layout.h"
#include "tables/theory_table.h"

namespace encased_column {

namespace {

const Axis strain_axis{axial_strain_title, false, 0.0, {}};
constexpr double end_of_study = 20.0;  // % axial strain (section 2.1.3)

struct NamedTest {
  const TestResult* test;
  std::string name;
};

/// The tests with a sleeve, called by their confining stress.
std::vector<NamedTest> encased_tests(const std::vector<SetResult>& sets)
{
  std::vector<NamedTest> tests;
  const auto labels = test_labels(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t)
      if (sets[s].tests[t].run->encased()) tests.push_back({&sets[s].tests[t], labels[s][t]});
  return tests;
}

Panel radial_strain(const NamedTest& named, const Targets& targets)
{
  const CaseRun& run = *named.test->run;
  Panel panel{"Radial expansion at heights from the bottom, " + named.name,
              {axial_strain_title, false, 0.0, end_of_study + 0.5},  // room for the marks
              {"radial strain [%]", false, {}, 20.0},
              {}};
  std::vector<Series> marks;
  std::size_t color = 0;
  for (const auto& [height, column] : {std::pair("75", history_column::radial_strain_75),
                                       std::pair("50", history_column::radial_strain_50),
                                       std::pair("25", history_column::radial_strain_25)}) {
    const std::string name = std::string("0.") + height + " H";
    const auto shortening = run.history.numbers(column);
    panel.series.push_back(
        {name, percent(named.test->axial_strain), scaled(shortening, -100.0), palette(color)});
    const auto published = published_of(
        run, targets, std::string("radial strain at 0.") + height + "H at the end of the test",
        confining_condition(run.confining_stress));
    if (published.model)
      marks.push_back({"study's model, " + name,
                       {end_of_study},
                       {*published.model},
                       palette(color),
                       Stroke::none,
                       true});
    ++color;
  }
  panel.series.insert(panel.series.end(), marks.begin(), marks.end());
  return panel;
}

Panel platens(const NamedTest& named)
{
  const TestResult& test = *named.test;
  Panel panel{
      "Deviatoric stress at both platens, " + named.name, strain_axis, {"q [kPa]", false, 0.0}, {}};
  const std::vector<double> strain = percent(test.axial_strain);
  const TextTable& history = test.run->history;
  panel.series.push_back({"top platen", strain,
                          scaled(history.numbers(history_column::deviatoric_stress_top), 1e-3),
                          palette(1)});
  panel.series.push_back({"bottom platen", strain,
                          scaled(history.numbers(history_column::deviatoric_stress_bottom), 1e-3),
                          palette(0)});
  Series theory{"Kp (σ₃ + T/r) − σ₃", {}, {}, black, Stroke::dashed};
  for (int i = 1; 0.005 * i < test.axial_strain.back() + 1e-3; ++i) {
    const double at = 0.005 * i;
    const auto state = sleeve_state(test, at);
    if (!state || !state->q_theory) continue;
    theory.x.push_back(100.0 * at);
    theory.y.push_back(*state->q_theory / 1e3);
  }
  if (theory.x.size() > 1) panel.series.push_back(theory);
  return panel;
}

Panel radial_profile(const NamedTest& named)
{
  Panel panel{"Radial displacement along the height, " + named.name,
              {"radial displacement [mm], expansion positive"},
              {"height [mm]", false, 0.0},
              {}};
  std::vector<double> strains;
  for (const SleeveProfile& profile : named.test->profiles) strains.push_back(profile.axial_strain);
  std::vector<double> shown = shown_strains(*named.test);
  shown.erase(shown.begin());  // no displacement yet
  std::size_t color = 0;
  for (const std::size_t i : nearest_places(strains, shown, shown_tolerance(*named.test))) {
    const SleeveProfile& profile = named.test->profiles[i];
    panel.series.push_back({"ε₁ = " + fixed(100.0 * profile.axial_strain, 1) + " %",
                            scaled(profile.radial_displacement, 1e3), scaled(profile.height, 1e3),
                            palette(color++)});
  }
  return panel;
}

Panel hoop_tension(const NamedTest& named, const std::optional<StripLimit>& limit)
{
  const SleeveRecord& sleeve = *named.test->sleeve;
  const std::vector<double> strain = percent(sleeve.axial_strain);
  Panel panel{"Hoop tension of the sleeve, " + named.name,
              strain_axis,
              {"hoop tension [kN/m]", false, 0.0},
              {}};
  panel.series.push_back({"largest", strain, scaled(sleeve.hoop_tension_max, 1e-3), palette(1)});
  panel.series.push_back({"mean", strain, scaled(sleeve.hoop_tension_mean, 1e-3), palette(0)});
  if (limit)
    panel.series.push_back({"strip test, " + fixed(100.0 * limit->strain, 0) + " %",
                            {0.0, strain.back()},
                            {limit->tension / 1e3, limit->tension / 1e3},
                            grey,
                            Stroke::dash_dotted});
  return panel;
}

/// The sleeves of all tests where the platens have come closer by `displacement` [m].
Panel radial_expansion(const std::vector<NamedTest>& tests, double displacement)
{
  Panel panel{"Radial displacement along the height at " + fixed(1e3 * displacement, 0) +
                  " mm of vertical displacement",
              {"radial displacement [mm], expansion positive"},
              {"height [mm]", false, 0.0},
              {}};
  std::size_t color = 0;
  for (const NamedTest& named : tests) {
    const auto profile =
        profile_at(named.test->profiles, displacement / initial_height(*named.test));
    if (profile)
      panel.series.push_back({named.name, scaled(profile->radial_displacement, 1e3),
                              scaled(profile->height, 1e3), palette(color),
                              stroke_of_number(color)});
    ++color;
  }
  return panel;
}

/// `figures` with one more, unless it has no panel.
void add(std::vector<Figure>& figures, Figure figure)
{
  if (!figure.panels.empty()) figures.push_back(std::move(figure));
}

std::vector<Figure> sleeve_figures_of_set(const std::vector<SetResult>& sets,
                                          const Targets& targets)
{
  std::vector<Panel> strains, stresses, profiles, tensions, expansions;
  const std::vector<NamedTest> tests = encased_tests(sets);
  const bool columns = sets.front().set == "column";  // column_series_figures() has their shape
  for (const NamedTest& named : tests) {
    stresses.push_back(platens(named));
    if (named.test->sleeve) tensions.push_back(hoop_tension(named, targets.strip_limit()));
    if (columns) continue;
    strains.push_back(radial_strain(named, targets));
    const Panel profile = radial_profile(named);
    if (!profile.series.empty()) profiles.push_back(profile);
  }
  if (!columns)
    for (const double displacement : {0.012, 0.024}) {
      const Panel panel = radial_expansion(tests, displacement);
      if (!panel.series.empty()) expansions.push_back(panel);
    }
  std::vector<Figure> figures;
  add(figures, {"radial_strain", "Radial strain at three heights",
                "Counterpart of the study's Figure 8; its values at the end of the tests are "
                "drawn as discs at 20 %.",
                strains});
  add(figures, {"platens", "Deviatoric stress at both platens",
                "The sleeve takes load between them; dashed: the closed form with the run's own "
                "hoop tension and friction angle.",
                stresses});
  add(figures, {"radial_profile", "Radial displacement along the height",
                "Counterpart of the study's Figure 11b, for the triaxial specimen.", profiles});
  add(figures, {"radial_expansion", "Radial displacement at 12 and 24 mm of displacement",
                "Counterpart of the study's Figures 17 and 19, for the triaxial specimen; straight "
                "between the profiles before and after.",
                expansions});
  add(figures, {"hoop_tension", "Hoop tension of the sleeve",
                "Grey: the last step of the study's strip test (Table 3).", tensions});
  return figures;
}

}  // namespace

std::vector<Figure> sleeve_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  return drawn_by_parameters(
      sets, [&](const auto& group) { return sleeve_figures_of_set(group, targets); });
}

}  // namespace encased_column
