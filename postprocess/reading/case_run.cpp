// SPDX-License-Identifier: GPL-2.0-only
#include "reading/case_run.h"

#include "core/input_error.h"
#include "runner/case_record.h"
#include "runner/case_variables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <regex>
#include <tuple>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// The line `# porosity at full size [-],0.29` that create_packing writes below its classes.
std::optional<double> reported_porosity(const fs::path& file)
{
  const std::string name = "# porosity at full size [-],";
  std::ifstream report(file);
  for (std::string line; std::getline(report, line);)
    if (line.rfind(name, 0) == 0) return read_number("porosity", line.substr(name.size()));
  return std::nullopt;
}

bool is_case(const fs::path& folder)
{
  return fs::is_regular_file(folder / "case.json");
}

std::optional<double> finite_number(const std::string& text)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && !*end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

CaseRun read_description(const fs::path& folder)
{
  const CaseRecord record = read_case_record(folder / "case.json");
  CaseRun run;
  run.folder = folder;
  run.id = record.id;
  run.deck = record.deck;
  run.title = record.title;
  run.reproduces = record.reproduces;
  run.has_sleeve = fs::exists(folder / "sleeve.csv") || fs::is_directory(folder / "sleeve");
  for (const auto& [name, value] : record.used) {
    if (const std::optional<double> number = finite_number(value)) run.variables[name] = *number;
    run.inputs.emplace_back(name, value);
    if (name == "resolution") run.resolution = value;
    if (name == "parameters") run.parameters = value;
    if (name == "gradation") run.gradation = gradation_name(value);
  }
  // And what the deck made of them, as the rate of its resolution.
  if (fs::exists(folder / variables_file))
    for (const auto& [name, value] : read_used_variables(folder / variables_file))
      if (const std::optional<double> number = finite_number(value))
        run.variables.emplace(name, *number);
  return run;
}

/// The title of `run` with the stress, the parameters and the resolution it was made with: the one
/// given is that of its row in series.csv, whatever was set besides.
std::string own_title(const CaseRun& run)
{
  static const std::regex stress(R"(\bat \S+ kPa\b)");
  const std::string own = "at " + in_words(run.confining_stress / 1e3) + " kPa";
  std::string title = std::regex_replace(run.title, stress, own);
  if (!run.parameters.empty()) {
    static const std::regex parameters(R"(, parameters [^, ]+)");
    title = std::regex_replace(title, parameters, "") + ", parameters " + run.parameters;
  }
  return run.resolution.empty() ? title : title + ", resolution " + run.resolution;
}

void read_results(CaseRun& run)
{
  const std::optional<double> sigma3 = run.number("sigma3");
  if (!sigma3 || !(*sigma3 > 0.0))
    throw InputError("variable 'sigma3' in '" + (run.folder / "case.json").string() +
                     "' must be a stress above zero [Pa], found none, write for example "
                     "\"sigma3\": 50000");
  run.confining_stress = *sigma3;
  run.title = own_title(run);
  run.history = TextTable(run.folder / "history.csv");
  run.generation_porosity = reported_porosity(run.folder / "gradation.csv");
}

std::vector<fs::path> cases_of(const fs::path& folder)
{
  if (!fs::is_directory(folder))
    throw InputError("a folder of runs must be a folder, found '" + folder.string() +
                     "', write for example 'encase report runs/default'");
  if (is_case(folder)) return {folder};
  std::vector<fs::path> cases;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_case(entry.path())) cases.push_back(entry.path());
  if (cases.empty())
    throw InputError("a folder of runs must hold case folders with a case.json, found none in '" +
                     folder.string() + "', make the runs with './input_scripts/run' first");
  std::sort(cases.begin(), cases.end());
  return cases;
}

}  // namespace

std::optional<double> CaseRun::number(const std::string& name) const
{
  const auto found = variables.find(name);
  return found == variables.end() ? std::nullopt : std::optional(found->second);
}

bool CaseRun::column() const
{
  constexpr double most_of_a_triaxial_specimen = 3.0;  // heights over diameters
  const std::optional<double> height = number("height"), radius = number("radius");
  return encased() && height && radius && *height > most_of_a_triaxial_specimen * 2.0 * *radius;
}

std::string gradation_name(const fs::path& file)
{
  std::string name = file.stem();
  for (const std::string start : {"gradation_", "column_"})
    if (name.size() > start.size() && name.rfind(start, 0) == 0) name.erase(0, start.size());
  return name;
}

CaseRuns read_case_runs(const std::vector<fs::path>& folders)
{
  CaseRuns found;
  for (const fs::path& given : folders)
    for (const fs::path& folder : cases_of(given)) {
      CaseRun run = read_description(folder);
      if (folder != given && !fs::exists(folder / "history.csv"))
        found.left_out.push_back("'" + run.id + "' is left out: no history.csv, it did not get " +
                                 "as far as its shear stage");
      else if (folder != given && run.inputs.empty())
        found.left_out.push_back("'" + run.id + "' is left out: it has not said which variables " +
                                 "it used");
      else {
        read_results(run);
        found.runs.push_back(std::move(run));
      }
    }
  if (found.runs.empty())
    throw InputError("figures take one triaxial run that reached shear at least, found none in '" +
                     folders.front().string() + "', see the log.liggghts of the cases");
  std::stable_sort(found.runs.begin(), found.runs.end(), [](const CaseRun& a, const CaseRun& b) {
    return std::make_tuple(a.encased(), a.column(), std::cref(a.parameters), a.confining_stress) <
           std::make_tuple(b.encased(), b.column(), std::cref(b.parameters), b.confining_stress);
  });
  return found;
}

}  // namespace encased_column
