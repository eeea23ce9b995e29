// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cloth_input.h"

#include "core/constants.h"
#include "files/number_table.h"

namespace encased_column {

namespace {

const std::string strip_header = "strain [-],hoop_tension [N/m],axial_tension [N/m]";

std::array<std::vector<StripPoint>, 2> read_strip(const std::string& path)
{
  std::array<std::vector<StripPoint>, 2> strip;
  for (const auto& row : read_number_table("strip", path, strip_header))
    for (int i = 0; i < 2; ++i) strip[i].push_back({row[0], row[1 + i]});
  check_strip(strip[0], "hoop");
  check_strip(strip[1], "axial");
  return strip;
}

/// Refuses a keyword that means nothing without another.
void require_with(const Options& options, const std::string& keyword, bool other,
                  const std::string& rule)
{
  if (options.has(keyword) && !other)
    throw InputError("'" + keyword + "' goes with " + rule + ", found '" + keyword + " " +
                     joined(options.all(keyword).front()) + "' without it, give both or neither");
}

}  // namespace

const std::vector<Keyword>& cloth_keywords()
{
  static const std::vector<Keyword> keywords{
      {"strip", 1, "-",
       "CSV file of strip tests: strain, hoop and axial tension; `none` (default): elastic"},
      {"strength", 2, "N/m", "hoop and axial tension that it bears (default: any)"},
      {"after_strength", 1, "-", "`warn` (default), `yield` or `tear`"},
      {"hardening", 1, "N/m",
       "with `yield`: slope of tension over strain past the strength (default 0: none)"},
      {"fracture_energy", 1, "N",
       "needed with `tear`: work to part a unit of width, larger than zero"},
      {"seam", 1, "-",
       "share of the hoop strength that a line of facets along the axis keeps (default 1: no "
       "seam)"},
      {"seam_angle", 1, "deg", "with `seam`: where it stands, counted from x; 0 if left out"},
      {"when_torn", 1, "-",
       "`stop` (default): the run ends at the first facet torn through; or `go_on`"},
  };
  return keywords;
}

ClothConstants read_cloth(const Options& options)
{
  ClothConstants cloth;
  if (const std::string file = options.word("strip", "none"); file != "none")
    cloth.strip = read_strip(file);
  if (options.has("strength")) {
    const auto& words = options.all("strength").front();
    for (int i = 0; i < 2; ++i) {
      cloth.strength[i] = read_number("strength", words[i]);
      if (!(cloth.strength[i] > 0.0))
        throw InputError("'strength' must be larger than zero in both directions, found " +
                         in_words(cloth.strength[i]) +
                         ", write for example 'strength 9.2e3 9.2e3' or leave it out");
    }
  }
  const std::string after = options.choice("after_strength", {"warn", "yield", "tear"}, "warn");
  cloth.after = after == "tear"    ? AfterStrength::tear
                : after == "yield" ? AfterStrength::yield
                                   : AfterStrength::warn;
  const bool has_strength = options.has("strength");
  require_with(options, "after_strength", has_strength, "'strength'");
  if (options.has("hardening")) {
    cloth.hardening = options.not_negative("hardening", 0.0);
    require_with(options, "hardening", after == "yield" || cloth.hardening == 0.0,
                 "'after_strength yield'");
  }
  require_with(options, "seam", has_strength, "'strength'");
  require_with(options, "seam_angle", options.has("seam"), "'seam'");
  if (options.has("fracture_energy") || after == "tear")
    cloth.fracture_energy = options.positive("fracture_energy");
  if (options.has("seam")) {
    cloth.seam = options.number("seam");
    if (!(cloth.seam > 0.0 && cloth.seam <= 1.0))
      throw InputError("'seam' must be larger than 0 and at most 1, found " + in_words(cloth.seam) +
                       ", write for example 'seam 0.7'");
    cloth.seam_angle = options.number("seam_angle", 0.0) * pi / 180.0;
  }
  return cloth;
}

void take_moduli_of_strip(ShellConstants& constants)
{
  double stiffness[2];
  for (int i = 0; i < 2; ++i) {
    const StripPoint& first = constants.cloth.strip[i].at(1);
    stiffness[i] = first.tension / first.strain;
  }
  constants.modulus_hoop = stiffness[0] / constants.thickness;
  // Alike but for the digits of a file: isotropic, shear and all.
  if (std::abs(stiffness[1] - stiffness[0]) > 1e-6 * stiffness[0])
    constants.modulus_axial = stiffness[1] / constants.thickness;
}

}  // namespace encased_column
