#include "runner/used_variables.h"

#include "core/input_error.h"
#include "runner/case_variables.h"
#include "runner/csv_rows.h"
#include "runner/text_file.h"

#include <algorithm>

namespace encased_column {

Settings read_used_variables(const std::filesystem::path& file)
{
  const std::string name = shown(file);
  const auto rows = csv_rows(read_text_file(file, "'" + name + "'"), name);
  if (rows.empty() || rows.front() != std::vector<std::string>{"name", "style", "value"})
    throw InputError("'" + name + "' must begin with 'name,style,value', found something else, " +
                     "run the case again");
  Settings used;
  for (std::size_t n = 1; n < rows.size(); ++n) used.emplace_back(rows[n][0], rows[n][2]);
  return used;
}

Settings confirmed_variables(const std::string& id, const Settings& asked, const Settings& used)
{
  Settings confirmed;
  for (const auto& [name, value] : asked) {
    const auto found =
        std::find_if(used.begin(), used.end(), [&](const Setting& s) { return s.first == name; });
    if (found == used.end())
      throw InputError("variable '" + name + "' of case '" + id +
                       "' must be used as it was asked " +
                       "for, found that the run does not know it, write 'record_variables file " +
                       variables_file + "' behind the last variable of its deck");
    if (!same_value(found->second, value))
      throw InputError("variable '" + name + "' of case '" + id +
                       "' must be used as it was asked " + "for, found " + found->second +
                       " in the run and " + value +
                       " asked for, look in its deck where the variable is set besides");
    confirmed.push_back(*found);
  }
  return confirmed;
}

}  // namespace encased_column
