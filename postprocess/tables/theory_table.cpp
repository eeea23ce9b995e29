#include "tables/theory_table.h"

#include "core/constants.h"
#include "tables/sleeve_theory.h"
#include "tables/text_layout.h"

namespace encased_column {

namespace {

std::string difference(double value, double theory)
{
  const double percent = 100.0 * (value / theory - 1.0);
  return (percent >= 0.0 ? "+" : "") + fixed(percent, 1);
}

std::vector<std::string> as_words(const std::string& id, const SleeveState& state)
{
  const auto kilo = [](double value, int decimals) { return fixed(value / 1e3, decimals); };
  std::vector<std::string> words{id,
                                 fixed(100.0 * state.axial_strain, 0),
                                 kilo(state.hoop_tension, 3),
                                 fixed(1e3 * state.radius, 2),
                                 kilo(state.extra_confinement, 1),
                                 "-",
                                 "-",
                                 kilo(state.q_top, 1),
                                 "-",
                                 kilo(state.q_bottom, 1),
                                 "-",
                                 fixed(100.0 * state.friction_share, 1)};
  if (state.q_theory) {
    words[5] = fixed(*state.friction_angle * 180.0 / pi, 2);
    words[6] = kilo(*state.q_theory, 1);
    words[8] = difference(state.q_top, *state.q_theory);
    words[10] = difference(state.q_bottom, *state.q_theory);
  }
  return words;
}

const std::vector<std::string> headings{
    "test",           "axial strain [%]",     "T [kN/m]",
    "r [mm]",         "dsigma3 [kPa]",        "phi [deg]",
    "q theory [kPa]", "q top [kPa]",          "top to theory [%]",
    "q bottom [kPa]", "bottom to theory [%]", "friction share [%]"};

}  // namespace

Rows theory_rows(const std::vector<SetResult>& sets)
{
  Rows rows{headings};
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const double strain : {0.05, 0.10, 0.15, 0.20})
        if (const auto state = sleeve_state(test, strain))
          rows.push_back(as_words(test.run->id, *state));
  return rows;
}

std::string theory_text(const std::vector<SetResult>& sets)
{
  const Rows rows = theory_rows(sets);
  if (rows.size() == 1) return {};
  std::vector<bool> right(headings.size(), true);
  right.front() = false;
  return "\nEncased tests beside q = Kp (sigma3 + dsigma3) - sigma3, dsigma3 = T / r\n\n" +
         aligned(rows, right) +
         "T: mean hoop tension; r: radius from the mean hoop strain; phi: mobilised by the "
         "grains of the middle third;\nfriction share: of the larger platen force, taken by the "
         "sleeve "
         "along its axis.\n";
}

std::string theory_csv(const std::vector<SetResult>& sets)
{
  Rows rows = theory_rows(sets);
  if (rows.size() == 1) return {};
  for (std::vector<std::string>& row : rows)
    for (std::string& word : row)
      if (word == "-") word.clear();
  return comma_separated(rows);
}

}  // namespace encased_column
