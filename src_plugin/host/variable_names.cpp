#include "host/variable_names.h"

#include "host/host_types.h"

#include "variable.h"

namespace encased_column {

namespace {

// The host keeps its list of variables to itself; see plugin_entry.cpp.
template <typename Tag, typename Tag::type member>
struct Reveal {
  friend typename Tag::type reveal(Tag) { return member; }
};

struct Count {
  using type = int LAMMPS_NS::Variable::*;
  friend type reveal(Count);
};
template struct Reveal<Count, &LAMMPS_NS::Variable::nvar>;

struct Names {
  using type = char** LAMMPS_NS::Variable::*;
  friend type reveal(Names);
};
template struct Reveal<Names, &LAMMPS_NS::Variable::names>;

struct Styles {
  using type = int* LAMMPS_NS::Variable::*;
  friend type reveal(Styles);
};
template struct Reveal<Styles, &LAMMPS_NS::Variable::style>;

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
  for (int n = 0; n < all.*reveal(Count()); ++n)
    if (const char* style = style_name((all.*reveal(Styles()))[n]))
      found.emplace_back((all.*reveal(Names()))[n], style);
  return found;
}

}  // namespace encased_column
