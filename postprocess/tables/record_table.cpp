// SPDX-License-Identifier: GPL-2.0-only
#include "tables/page_tables.h"

#include "core/input_error.h"
#include "files/column_names.h"

#include <algorithm>
#include <cstdio>

namespace encased_column {

namespace {

std::string largest(const std::vector<double>& values)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", *std::max_element(values.begin(), values.end()));
  return text;
}

std::string time_in_words(double seconds)
{
  const long minutes = static_cast<long>(seconds / 60.0 + 0.5);
  if (seconds < 90.0) return fixed(seconds, 0) + " s";
  if (minutes < 60) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace

std::string time_of(const RunRecord& record)
{
  if (record.wall_time) return time_in_words(static_cast<double>(*record.wall_time));
  return record.loop_time > 0.0 ? time_in_words(record.loop_time) : "-";
}

std::string version_of(const RunRecord& record)
{
  const std::string name = "encased columns ";
  for (const std::string& line : record.versions)
    if (line.rfind(name, 0) == 0 && line.find("unknown") == std::string::npos)
      return line.substr(name.size());
  return "unknown";
}

Rows record_rows(const TestResult& test, const RunRecord& record)
{
  const CaseRun& run = *test.run;
  const TextTable& history = run.history;
  Rows rows{{"quantity", "found"}};
  rows.push_back({"finished (UTC)", record.finished.value_or("not recorded")});
  rows.push_back({record.wall_time || record.loop_time == 0.0
                      ? "wall time since the last start"
                      : "wall time of growth and shear (rest and consolidation not recorded)",
                  time_of(record)});
  if (history.has(history_column::step)) {
    const std::vector<double> steps = history.numbers(history_column::step);
    rows.push_back({"steps in all", fixed(steps.back(), 0)});
    rows.push_back({"steps of shear", fixed(steps.back() - steps.front(), 0)});
  }
  rows.push_back({"axial strain reached [%]", fixed(100.0 * test.axial_strain.back(), 2)});
  rows.push_back({"number of grains", test.grains ? std::to_string(*test.grains) : "not written"});
  if (test.density.relative_density)
    rows.push_back({"relative density of the sample in the laboratory [%]",
                    fixed(100.0 * *test.density.relative_density, 1)});
  if (test.density.laboratory_porosity)
    rows.push_back({"porosity of the sample in the laboratory [-]",
                    fixed(*test.density.laboratory_porosity, 4)});
  if (run.generation_porosity)
    rows.push_back({"porosity at generation [-]", fixed(*run.generation_porosity, 4)});
  rows.push_back({"porosity at the start of shear, overlaps counted twice [-]",
                  fixed(history.numbers(history_column::porosity).front(), 4)});
  rows.push_back({"porosity at the start of shear, less overlaps [-]",
                  fixed(history.numbers(history_column::porosity_less_overlap).front(), 4)});
  rows.push_back({"porosity at the end, less overlaps [-]",
                  fixed(history.numbers(history_column::porosity_less_overlap).back(), 4)});
  rows.push_back({"inertial number, largest [-]", largest(test.record.inertial_number)});
  for (const std::string& line : record.versions)
    if (line.rfind("cores ", 0) == 0) rows.push_back({"machine", line});
  return rows;
}

Rows contact_batchs(const TestResult& test)
{
  Rows rows{{"axial strain [%]", "contacts [-]", "mean force [N]", "largest force [N]"}};
  if (test.contacts.empty()) return rows;
  for (const auto& [level, share] : test.contacts.front().share)
    rows.front().push_back("above " + in_words(level) + " N [%]");
  for (const ContactSample& sample : {test.contacts.front(), test.contacts.back()}) {
    rows.push_back({fixed(100.0 * sample.axial_strain, 1), fixed(sample.contacts, 0),
                    fixed(sample.mean_force, 2), fixed(sample.largest_force, 1)});
    for (const auto& [level, share] : sample.share) rows.back().push_back(fixed(100.0 * share, 2));
  }
  return rows;
}

}  // namespace encased_column
