// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/figures.h"

#include "core/constants.h"
#include "drawing/by_parameters.h"
#include "drawing/labels.h"
#include "tables/text_layout.h"

#include <algorithm>

namespace encased_column {

namespace {

std::string kind(const SetResult& set)
{
  return set.tests.front().run->encased() ? "encased" : "plain";
}

/// What q is read from, for the titles of figures.
std::string platen_title(const std::vector<SetResult>& sets)
{
  const Platen first = sets.front().tests.front().platen;
  const Platen last = sets.back().tests.front().platen;
  if (first == last) return "q: " + platen_name(first);
  const auto name = [](Platen p) { return p == Platen::mean ? "mean of both" : platen_name(p); };
  return "q: " + name(first) + " (" + kind(sets.front()) + "), " + name(last) + " (" +
         kind(sets.back()) + ")";  // short enough to stand above its chart
}

/// One curve for each test: `factor` times the values `member` over axial strain [%].
Panel curves(const std::vector<SetResult>& sets, std::vector<double> TestResult::*member,
             double factor)
{
  Panel panel;
  panel.x = {axial_strain_title, false, 0.0, {}};
  const auto labels = test_labels(sets);
  const auto colors = color_numbers(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t) {
      const TestResult& test = sets[s].tests[t];
      panel.series.push_back({labels[s][t], percent(test.axial_strain),
                              scaled(test.*member, factor), palette(colors[s][t]),
                              stroke_of(sets[s], sets.size(), colors[s][t])});
    }
  return panel;
}

Series failure_line(const FailureLine& line, double highest_p, const std::string& label,
                    Color color, Stroke stroke)
{
  return {label,
          {0.0, highest_p / 1e3},
          {line.intercept / 1e3, line.deviatoric_stress(highest_p) / 1e3},
          color,
          stroke};
}

std::string in_legend(const std::string& who, const Strength& strength)
{
  return who + ": φ " + fixed(strength.friction_angle * 180.0 / pi, 1) + "°, c " +
         fixed(strength.cohesion / 1e3, 1) + " kPa";
}

void add_set(Panel& panel, const SetResult& set, std::size_t first_color, const Targets& targets,
             bool name_set)
{
  const std::string name = name_set ? kind(set) + ", " : "";
  const Color color = palette(first_color);
  Series peaks{name + "peaks", {}, {}, color, Stroke::none, true};
  double highest = 0.0;
  for (const TestResult& test : set.tests) {
    peaks.x.push_back(test.peak_stress.mean_stress / 1e3);
    peaks.y.push_back(test.peak_stress.deviatoric_stress / 1e3);
    highest = std::max(highest, test.peak_stress.mean_stress);
  }
  highest *= 1.1;
  if (set.line)
    panel.series.push_back(failure_line(*set.line, highest,
                                        in_legend(name + "here", strength_of(*set.line)), color,
                                        Stroke::solid));
  const auto published = [&](bool laboratory) {
    return of_study(set) ? targets.strength(set.set, laboratory) : std::nullopt;
  };
  if (const auto strength = published(true))
    panel.series.push_back(failure_line(failure_line_of(*strength), highest,
                                        in_legend(name + "laboratory", *strength), black,
                                        name_set ? stroke_of(set, 2, 0) : Stroke::dashed));
  if (const auto strength = published(false))
    panel.series.push_back(failure_line(failure_line_of(*strength), highest,
                                        in_legend(name + "model", *strength), grey,
                                        Stroke::dash_dotted));
  panel.series.push_back(peaks);
}

std::vector<Figure> triaxial_figures_of_set(const std::vector<SetResult>& sets,
                                            const Targets& targets)
{
  Panel stress = curves(sets, &TestResult::deviatoric_stress, 1e-3);
  stress.title = platen_title(sets);
  stress.y = {"deviatoric stress q [kPa]", false, 0.0, {}};

  Panel volume = curves(sets, &TestResult::volumetric_strain, 100.0);
  volume.title = "Volumetric strain, compression positive";
  volume.y = {"volumetric strain εᵥ [%]"};

  Panel strength;
  strength.title = platen_title(sets);
  strength.x = {"mean stress p = (σ₁ + 2 σ₃) / 3 [kPa]", false, 0.0, {}};
  strength.y = {"deviatoric stress q [kPa]", false, 0.0, {}};
  for (std::size_t s = 0; s < sets.size(); ++s)
    add_set(strength, sets[s], s, targets, sets.size() > 1);
  std::vector<Figure> figures{{"deviatoric_stress",
                               "Deviatoric stress over axial strain",
                               "The study has it in Figures 3 (plain) and 7a (encased).",
                               {stress}},
                              {"volumetric_strain",
                               "Volumetric strain over axial strain",
                               "Of the volume between the platens; compression positive.",
                               {volume}}};
  if (sets.front().set != "column")  // all of them at one confining stress
    figures.push_back({"p_q",
                       "Failure lines in the p-q plane",
                       "Through the peaks; the study has it in Figure 7b (encased).",
                       {strength}});
  return figures;
}

}  // namespace

std::vector<Figure> triaxial_figures(const std::vector<SetResult>& sets, const Targets& targets)
{
  return drawn_by_parameters(
      sets, [&](const auto& group) { return triaxial_figures_of_set(group, targets); });
}

}  // namespace encased_column
