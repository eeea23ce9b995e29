// SPDX-License-Identifier: GPL-2.0-only
#include "report/calibration_report.h"

#include "calibration_page.h"
#include "config/units.h"
#include "core/input_error.h"
#include "report/calibration_tables.h"
#include "report/chart.h"
#include "report/curve_bands.h"
#include "report/page_parts.h"
#include "runner/text_file.h"
#include "tables/text_layout.h"

#include <cmath>

namespace encased_column {

namespace {

const std::string blue = "#0072b2", orange = "#e69f00", black = "#000000";

PageData table_if(const std::string& id, const std::string& caption, const Rows& rows)
{
  PageData list{PageData::type::list};
  if (rows.size() > 1) list << table_data(id, caption, rows);
  return list;
}

PageData drawing(const std::string& name, const std::string& svg)
{
  PageData data{"name", name};
  data.set("drawing", svg);
  return data;
}

PageData bars_of(const CalibrationConfig& config, const Findings& found)
{
  PageData list{PageData::type::list};
  for (std::size_t n = 0; n < found.outputs.size(); ++n) {
    const SobolIndices& sobol = found.sensitivities[n].sobol;
    std::vector<BarRow> rows;
    for (std::size_t i = 0; i < sobol.first.size(); ++i)
      rows.push_back({config.space.parameters()[i].name, sobol.first[i].value, sobol.first[i].error,
                      sobol.total[i].value, sobol.total[i].error});
    PageData data = drawing(found.outputs[n].goal.name,
                            bar_chart("Sobol indices of " + found.outputs[n].goal.name, rows));
    data.set("unexplained", fixed(100.0 * sobol.unexplained, 1));
    list << data;
  }
  return list;
}

PageData foretold_of(const Findings& found)
{
  PageData list{PageData::type::list};
  for (std::size_t n = 0; n < found.outputs.size(); ++n) {
    const FittedOutput& one = found.fitted.outputs[n];
    const Data data = found.table.data_of(found.table.values.col(static_cast<Eigen::Index>(n)));
    const UsualUnit unit = usual_unit(data.values.cwiseAbs().maxCoeff(), found.outputs[n].unit);
    const auto scaled = [&](const Eigen::VectorXd& from) {
      return std::vector<double>(from.data(), from.data() + from.size());
    };
    const std::vector<double> real = scaled(data.values / unit.size);
    const double low = *std::min_element(real.begin(), real.end()),
                 high = *std::max_element(real.begin(), real.end());
    list << drawing(found.outputs[n].goal.name,
                    chart({"Cross-validation of " + found.outputs[n].goal.name,
                           "run [" + unit.name + "]", "foretold [" + unit.name + "]"},
                          {{Mark::Kind::dashed, "", black, {low, high}, {low, high}},
                           {Mark::Kind::dots, name_of(one.kind), blue, real,
                            scaled(better_of(one.validations).foretold / unit.size)}}));
  }
  return list;
}

PageData curves_of(const CalibrationConfig& config, const Findings& found)
{
  PageData list{PageData::type::list};
  for (const CurveBand& band : curve_bands(config, found)) {
    const auto percent = [](std::vector<double> x) {
      for (double& one : x) one *= 100.0;
      return x;
    };
    const auto in_kpa = [](std::vector<double> y) {
      for (double& one : y) one *= 1e-3;
      return y;
    };
    std::vector<Mark> marks;
    if (!band.strain.empty())
      marks.push_back({Mark::Kind::band, "95 % of runs", blue, percent(band.strain),
                       in_kpa(band.low), in_kpa(band.high)});
    std::string label = "runs at the best point";
    for (const auto& [strain, stress] : band.best) {
      marks.push_back({Mark::Kind::line, label, blue, percent(strain), in_kpa(stress)});
      label.clear();
    }
    if (!band.laboratory_strain.empty())
      marks.push_back({Mark::Kind::dashed, "laboratory", black, percent(band.laboratory_strain),
                       in_kpa(band.laboratory_stress)});
    for (std::size_t n = 0; n < found.outputs.size(); ++n)
      if (found.outputs[n].goal.name == "peak_q of " + band.name)
        marks.push_back({Mark::Kind::dashed,
                         "peak q of the laboratory",
                         orange,
                         {0.0, 20.0},
                         std::vector<double>(2, 1e-3 * found.outputs[n].goal.value)});
    list << drawing(
        band.name,
        chart({"Curves of " + band.name, "axial strain [%]", "deviatoric stress [kPa]"}, marks));
  }
  return list;
}

}  // namespace

std::string parameter_text(const CalibrationConfig& config, const Findings& found)
{
  const Rows rows = parameter_rows(config, found);
  return aligned(rows, std::vector<bool>(rows.front().size(), false));
}

std::string calibration_page(const CalibrationConfig& config, const Findings& found,
                             const std::string& files)
{
  PageData page{"title", "Calibration: " + config.title};
  page.set("subtitle", std::to_string(config.space.size()) + " parameters, " +
                           std::to_string(config.targets.size()) + " targets, " +
                           std::to_string(found.runs.size()) + " runs");
  page.set("met", found.met ? PageData::type::bool_true : PageData::type::bool_false);
  page.set("end", found.end);
  page.set("files", files);
  page.set("parameters", table_data("t-parameters", "Parameters", parameter_rows(config, found)));
  std::vector<std::string> sentences = found.not_told;
  if (sentences.empty()) sentences = {"Nothing: the data tell each parameter."};
  if (found.posterior.mixing.maxCoeff() > 1.05)
    sentences.push_back("The chains of the posterior do not agree yet (R " +
                        fixed(found.posterior.mixing.maxCoeff(), 2) +
                        "): take more 'samples' before you rely on the intervals.");
  page.set("not_told", list_of("sentence", sentences));
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns, together;
  const Eigen::MatrixXd correlation = correlations(found.posterior.points);
  for (int i = 0; i < config.space.size(); ++i) {
    const Eigen::VectorXd column = found.posterior.points.col(i),
                          row = correlation.row(i).transpose();
    names.push_back(config.space[i].name);
    columns.emplace_back(column.data(), column.data() + column.size());
    together.emplace_back(row.data(), row.data() + row.size());
  }
  page.set("pairs", pair_plot(names, columns, together));
  page.set("targets", table_data("t-targets", "Targets", target_rows(found)));
  page.set("curves", curves_of(config, found));
  page.set("bars", bars_of(config, found));
  page.set("morris",
           table_if("t-morris", "Effects of the whole range", morris_rows(config, found)));
  page.set("validation",
           table_data("t-validation", "Cross-validation", validation_rows(config, found)));
  page.set("foretold", foretold_of(found));
  page.set("rounds", table_data("t-rounds", "Rounds", round_rows(found)));
  page.set("cost", cost_sentence(found));
  page.set("front",
           table_if("t-front", "Mismatch and time of a run of all cases: none is better in both",
                    front_rows(config, found)));
  page.set("failed", table_if("t-failed", "Failed runs, left out", failed_rows(found)));
  page.set("config", shown(config.file));
  return filled(page_templates::calibration_page, page);
}

}  // namespace encased_column
