// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_shape.h"

#include "core/input_error.h"
#include "packing/gradation_file.h"
#include "packing/packing_limits.h"
#include "runner/deck_text.h"
#include "runner/text_file.h"
#include "shell/cylinder_mesh.h"

#include <algorithm>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// The word `place` words behind `keyword`; empty without.
std::string word_behind(const Words& words, const std::string& keyword, std::size_t place = 1)
{
  const auto found = std::find(words.begin(), words.end(), keyword);
  if (static_cast<std::size_t>(words.end() - found) <= place) return "";
  return found[static_cast<std::ptrdiff_t>(place)];
}

std::optional<double> number_behind(const Words& words, const std::string& keyword,
                                    std::size_t place = 1)
{
  return formula_value(word_behind(words, keyword, place));
}

std::istringstream table(const Deck& deck, const std::string& name)
{
  return std::istringstream(read_text_file(deck.file.parent_path() / name, "'" + name + "'"));
}

std::optional<double> packed_porosity(const Words& packing, const CaseShape& shape, double finest,
                                      const Deck& deck)
{
  const auto density = number_behind(packing, "relative_density");
  if (!density) return number_behind(packing, "porosity");
  const std::string file = word_behind(packing, "limits");
  const auto friction = number_behind(packing, "limits", 2);
  const auto rolling = number_behind(packing, "limits", 3);
  if (!friction || !rolling) return std::nullopt;
  const fs::path gradation = word_behind(packing, "gradation");
  std::istringstream limits = table(deck, file);
  return read_packing_limits(limits, file,
                             {gradation.filename(), word_behind(packing, "distribution"), finest,
                              shape.radius, shape.height, *friction, *rolling})
      .porosity_at(*density);
}

double facets_of(const Words& sleeve)
{
  const auto radius = number_behind(sleeve, "cylinder"), low = number_behind(sleeve, "cylinder", 2),
             high = number_behind(sleeve, "cylinder", 3), edge = number_behind(sleeve, "edge");
  if (!radius || !low || !high || !edge) return 0.0;
  const CylinderCounts counts = cylinder_counts({*radius, *low, *high - *low, *edge});
  return 2.0 * counts.around * (counts.rings - 1);
}

}  // namespace

std::optional<CaseShape> case_shape(const CasePlan& plan)
{
  const DeckText deck(*plan.deck, plan.asked);
  const bool by_density = deck.number("relative_density", -1.0) >= 0.0;
  const Words packing = deck.words("create_packing", by_density ? "relative_density" : "porosity");
  const auto radius = number_behind(packing, "cylinder"),
             low = number_behind(packing, "cylinder", 2),
             high = number_behind(packing, "cylinder", 3), rate = deck.number("approach"),
             strain_end = deck.number("strain_end");
  const std::string gradation = word_behind(packing, "gradation");
  if (!radius || !low || !high || !rate || !strain_end || gradation.empty()) return std::nullopt;

  CaseShape shape;
  shape.radius = *radius;
  shape.height = *high - *low;
  const std::string distribution = word_behind(packing, "distribution");
  if (!distribution.empty()) shape.distribution = class_distribution(distribution);
  const double finest = number_behind(packing, "finest").value_or(0.0);
  std::istringstream classes = table(*plan.deck, gradation);
  shape.gradation = without_finer(read_gradation(classes, gradation), shape.distribution, finest);
  const auto porosity = packed_porosity(packing, shape, finest, *plan.deck);
  if (!porosity) return std::nullopt;
  shape.porosity = *porosity;
  const Words sleeve = deck.words("mesh/surface/shell", "");
  shape.facets = facets_of(sleeve);
  shape.friction_packing = deck.number("mu_packing", 0.0) > 0.0;
  shape.growth_minds_stress = deck.number("stress_packing", 0.0) > 0.0;
  shape.platens_follow = sleeve.empty() || deck.number("axial_servo", 0.0) > 0.0;
  shape.preload = deck.number("preload", 0.0) > 0.0;
  shape.limit = deck.number("limit", 1e-5);
  shape.strain_end = *strain_end;
  shape.rate = *rate;
  shape.frames = deck.number("frames", 20.0);
  return shape;
}

std::optional<CaseSize> expected_size(const CasePlan& plan)
{
  const auto shape = case_shape(plan);
  if (!shape || !(shape->rate > 0.0) || !(shape->limit > 0.0)) return std::nullopt;
  return case_size(*shape);
}

}  // namespace encased_column
