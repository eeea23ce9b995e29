#include "host/variable_names.h"

#include "host/host_types.h"
#include "host/reveal.h"

#include "variable.h"

namespace encased_column {

// The host keeps its list of variables to itself.
struct VariableCount {
  using type = int LAMMPS_NS::Variable::*;
  friend type reveal(VariableCount);
};
template struct Reveal<VariableCount, &LAMMPS_NS::Variable::nvar>;

struct VariableNames {
  using type = char** LAMMPS_NS::Variable::*;
  friend type reveal(VariableNames);
};
template struct Reveal<VariableNames, &LAMMPS_NS::Variable::names>;

struct VariableStyles {
  using type = int* LAMMPS_NS::Variable::*;
  friend type reveal(VariableStyles);
};
template struct Reveal<VariableStyles, &LAMMPS_NS::Variable::style>;

namespace {

/// The host's numbers of its styles; nullptr for those that have no one value.
const char* style_name(int style)
{
  switch (style) {
    case 0:
      return "index";
    case 5:
      return "string";
    case 9:
      return "equal";
    default:
      return nullptr;
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> variable_names(const LAMMPS_NS::Variable& all)
{
  std::vector<std::pair<std::string, std::string>> found;
  for (int n = 0; n < all.*reveal(VariableCount()); ++n)
    if (const char* style = style_name((all.*reveal(VariableStyles()))[n]))
      found.emplace_back((all.*reveal(VariableNames()))[n], style);
  return found;
}

}  // namespace encased_column
