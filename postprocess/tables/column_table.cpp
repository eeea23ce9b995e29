// SPDX-License-Identifier: GPL-2.0-only
#include "tables/page_tables.h"

namespace encased_column {

namespace {

const Rows headings{{"when", "where", "grains [-]", "porosity n [-]", "n less overlap [-]",
                     "coordination number [-]", "axial stress [kPa]", "radial stress [kPa]",
                     "mean force [N]", "largest force [N]"}};

std::vector<std::string> as_words(const std::string& when, const std::string& where,
                                  const SphereSample& sample)
{
  return {when,
          where,
          fixed(sample.grains, 0),
          fixed(sample.porosity, 4),
          fixed(sample.porosity_less_overlap, 4),
          fixed(sample.coordination_number, 2),
          fixed(sample.axial_stress / 1e3, 1),
          fixed(sample.radial_stress / 1e3, 1),
          fixed(sample.mean_force, 2),
          fixed(sample.largest_force, 1)};
}

/// The walls at the sample of the history that lies next to `strain`.
std::vector<std::string> of_walls(const TestResult& test, const std::string& when, double strain)
{
  const ShearRecord& record = test.record;
  const std::size_t at = nearest_places(record.axial_strain, {strain}, 1.0).front();
  return {when,
          "platens (mean) and side",
          "-",
          "-",
          "-",
          "-",
          fixed(0.5 * (record.stress_top[at] + record.stress_bottom[at]) / 1e3, 1),
          fixed(record.confining_stress[at] / 1e3, 1),
          "-",
          "-"};
}

void add_rows(Rows& rows, const TestResult& test, const std::string& when, std::size_t i)
{
  for (const SphereSeries& sphere : test.spheres)
    rows.push_back(
        as_words(when, "sphere at " + fixed(1e3 * sphere[i].height, 0) + " mm", sphere[i]));
  SphereSample mean{};
  for (double SphereSample::*quantity :
       {&SphereSample::grains, &SphereSample::porosity, &SphereSample::porosity_less_overlap,
        &SphereSample::coordination_number, &SphereSample::axial_stress,
        &SphereSample::radial_stress, &SphereSample::mean_force, &SphereSample::largest_force})
    mean.*quantity = mean_of_spheres(test.spheres, i, quantity);
  rows.push_back(as_words(when, "mean of the spheres", mean));
  rows.push_back(of_walls(test, when, test.spheres.front()[i].axial_strain));
}

}  // namespace

Rows column_rows(const TestResult& test)
{
  Rows rows = headings;
  if (test.spheres.empty()) return rows;
  const SphereSeries& first = test.spheres.front();
  add_rows(rows, test, "before shear", 0);
  if (first.size() > 1)
    add_rows(rows, test, "at " + fixed(100.0 * first.back().axial_strain, 1) + " % axial strain",
             first.size() - 1);
  return rows;
}

}  // namespace encased_column
