#include "deck/record_variables_command.h"

#include "core/input_error.h"
#include "files/atomic_file.h"
#include "host/output_files.h"
#include "host/variable_names.h"

#include "input.h"
#include "variable.h"

namespace encased_column {

const KeywordTable RecordVariablesCommand::keywords{
    {"file", 1, "-", "CSV file with a row for each variable"},
};

namespace {

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
