// SPDX-License-Identifier: GPL-2.0-only
#include "deck/record_variables_command.h"

#include "core/input_error.h"
#include "files/atomic_file.h"
#include "host/output_files.h"
#include "host/reveal.h"

#include "input.h"
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

const KeywordTable RecordVariablesCommand::keywords{
    {"file", 1, "-", "CSV file with a row for each variable"},
};

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

/// Name and style ("index", "string", "equal") of each variable of those styles, in the order in
/// which they were made.
std::vector<std::pair<std::string, std::string>> variable_names(const LAMMPS_NS::Variable& all)
{
  std::vector<std::pair<std::string, std::string>> found;
  for (int n = 0; n < all.*reveal(VariableCount()); ++n)
    if (const char* style = style_name((all.*reveal(VariableStyles()))[n]))
      found.emplace_back((all.*reveal(VariableNames()))[n], style);
  return found;
}

std::string in_quotes(const std::string& value)
{
  std::string quoted = "\"";
  for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

// An equal-style variable may sum over all ranks, so each rank asks for each value.
void RecordVariablesCommand::command(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    const std::string file =
        OutputFiles(lmp, "record_variables").file(options, "file", "", unfinished(""));
    std::string rows = "name,style,value\n";
    for (const auto& [name, style] : variable_names(*input->variable)) {
      const char* value = input->variable->retrieve(const_cast<char*>(name.c_str()));
      rows += name + "," + style + "," + in_quotes(value ? value : "") + "\n";
    }
    int written = 1;
    if (comm->me == 0) written = write_whole_file(file, rows) ? 1 : 0;
    MPI_Bcast(&written, 1, MPI_INT, 0, world);
    if (!written)
      throw InputError("'file' must be a file that can be written, found '" + file +
                       "', free some space or mend the folder's rights");
  } catch (const InputError& problem) {
    error->all(FLERR, problem.what());
  }
}

}  // namespace encased_column
