#pragma once

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {
class Variable;
}

namespace encased_column {

/// Name and style ("index", "string", "equal") of each variable of those styles, in the order in
/// which they were made.
std::vector<std::pair<std::string, std::string>> variable_names(const LAMMPS_NS::Variable& all);

}  // namespace encased_column
