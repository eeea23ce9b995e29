#include "drawing/figures.h"

#include "core/input_error.h"
#include "drawing/labels.h"
#include "tables/text_layout.h"

#include <utility>

namespace encased_column {

namespace {

const Axis strain_axis{axial_strain_title, false, 0.0, {}};
constexpr double sample_tolerance = 0.01;  // of axial strain: how far a sample may be off

std::string sphere_name(const TestResult& test, std::size_t sphere)
{
  const double height = test.spheres[sphere].front().height;
  return "sphere at " + fixed(1e3 * height, 0) + " mm";
}

/// The quantity along the height at the start of shear and at round axial strains.
Panel along_height(const TestResult& test, const std::string& title, const std::string& axis,
                   double SphereSample::*quantity, double factor)
{
  const Axis height{"height of the sphere [mm]", false, 0.0, 1e3 * initial_height(test)};
  Panel panel{title, {axis}, height, {}};
  const std::vector<double> strains = over_time(test.spheres.front(), &SphereSample::axial_strain);
  std::size_t color = 0;
  for (const std::size_t i :
       nearest_places(strains, {0.0, 0.05, 0.10, 0.15, 0.20}, sample_tolerance)) {
    const std::string displacement = fixed(1e3 * strains[i] * initial_height(test), 1) + " mm";
    panel.series.push_back({"ε₁ = " + fixed(100.0 * strains[i], 1) + " %, " + displacement,
                            scaled(along_column(test.spheres, i, quantity), factor),
                            scaled(along_column(test.spheres, i, &SphereSample::height), 1e3),
                            palette(color++), Stroke::solid, true});
  }
  return panel;
}

/// The quantity of each sphere over the displacement of the platens.
Panel over_displacement(const TestResult& test, const std::string& title, const std::string& axis,
                        double SphereSample::*quantity)
{
  Panel panel{title, {"vertical displacement [mm]", false, 0.0, {}}, {axis}, {}};
  for (std::size_t s = 0; s < test.spheres.size(); ++s)
    panel.series.push_back({sphere_name(test, s),
                            scaled(over_time(test.spheres[s], &SphereSample::axial_strain),
                                   1e3 * initial_height(test)),
                            over_time(test.spheres[s], quantity), palette(s)});
  return panel;
}

Panel sphere_forces(const TestResult& test, const std::string& title,
                    double SphereSample::*quantity)
{
  Panel panel{title, strain_axis, {"contact force [N]", false, 0.0, {}}, {}};
  for (std::size_t s = 0; s < test.spheres.size(); ++s)
    panel.series.push_back({sphere_name(test, s),
                            percent(over_time(test.spheres[s], &SphereSample::axial_strain)),
                            over_time(test.spheres[s], quantity), palette(s)});
  return panel;
}

std::vector<double> values_of(const TestResult& test, double ContactSample::*quantity)
{
  std::vector<double> values;
  for (const ContactSample& sample : test.contacts) values.push_back(sample.*quantity);
  return values;
}

Panel strong_shares(const TestResult& test)
{
  Panel panel{"Share of the contacts that bear a force level",
              strain_axis,
              {"share [%]", false, 0.0, {}},
              {}};
  const std::vector<double> strain = percent(values_of(test, &ContactSample::axial_strain));
  for (const auto& [level, first] : test.contacts.front().share) {
    std::vector<double> shares;
    for (const ContactSample& sample : test.contacts) shares.push_back(sample.share.at(level));
    panel.series.push_back(
        {in_words(level) + " N", strain, percent(shares), palette(panel.series.size())});
  }
  return panel;
}

Figure contact_force(const TestResult& test, const std::string& name)
{
  std::vector<Panel> panels;
  if (!test.spheres.empty())
    panels = {sphere_forces(test, "Largest contact force, " + name, &SphereSample::largest_force),
              sphere_forces(test, "Mean contact force, " + name, &SphereSample::mean_force)};
  if (!test.contacts.empty()) {
    if (panels.empty())
      panels = {Panel{"Largest contact force, " + name, strain_axis, {"contact force [N]"}, {}},
                Panel{"Mean contact force, " + name, strain_axis, {"contact force [N]"}, {}}};
    const std::vector<double> strain = percent(values_of(test, &ContactSample::axial_strain));
    panels[0].series.push_back({"whole specimen", strain,
                                values_of(test, &ContactSample::largest_force), black,
                                Stroke::dashed});
    panels[1].series.push_back({"whole specimen", strain,
                                values_of(test, &ContactSample::mean_force), black,
                                Stroke::dashed});
    if (!test.contacts.front().share.empty()) panels.push_back(strong_shares(test));
  }
  return {"contact_force_" + test.run->id, "Contact forces",
          "Statistics to the study's Figure 13; grains are larger than its column's where the "
          "resolution is not paper, and so are the forces.",
          panels};
}

void add_sphere_figures(std::vector<Figure>& figures, const TestResult& test,
                        const std::string& name)
{
  const std::string id = "_" + test.run->id;
  figures.push_back(
      {"column_stress" + id,
       "Stress along the column",
       "Counterpart of the study's Figure 12; compression positive, each point the mean of one "
       "measuring sphere.",
       {along_height(test, "Axial stress, " + name, "axial stress [kPa]",
                     &SphereSample::axial_stress, 1e-3),
        along_height(test, "Radial stress, " + name, "radial stress [kPa]",
                     &SphereSample::radial_stress, 1e-3)}});
  figures.push_back({"column_porosity" + id,
                     "Porosity along the column",
                     "Counterpart of the study's Figure 14; overlaps counted once.",
                     {over_displacement(test, "Porosity of the spheres, " + name, "porosity n [-]",
                                        &SphereSample::porosity_less_overlap),
                      along_height(test, "Porosity along the height, " + name, "porosity n [-]",
                                   &SphereSample::porosity_less_overlap, 1.0)}});
  figures.push_back(
      {"column_coordination" + id,
       "Coordination number along the column",
       "Counterpart of the study's Figure 15; all grains and contacts count.",
       {over_displacement(test, "Coordination number of the spheres, " + name,
                          "coordination number [-]", &SphereSample::coordination_number),
        along_height(test, "Coordination number along the height, " + name,
                     "coordination number [-]", &SphereSample::coordination_number, 1.0)}});
}

}  // namespace

std::vector<Figure> column_figures(const std::vector<SetResult>& sets)
{
  std::vector<Figure> figures;
  const auto labels = test_labels(sets);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t t = 0; t < sets[s].tests.size(); ++t) {
      const TestResult& test = sets[s].tests[t];
      if (!test.spheres.empty()) add_sphere_figures(figures, test, labels[s][t]);
      if (!test.spheres.empty() || !test.contacts.empty())
        figures.push_back(contact_force(test, labels[s][t]));
    }
  return figures;
}

}  // namespace encased_column
