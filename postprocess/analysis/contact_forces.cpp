#include "analysis/contact_forces.h"

#include "core/input_error.h"
#include "files/column_names.h"

namespace encased_column {

std::optional<double> level_of_share(const std::string& heading)
{
  const std::string &before = contact_column::share_above, &after = contact_column::level_end;
  const std::size_t around = before.size() + after.size();
  if (heading.size() <= around || heading.compare(0, before.size(), before) != 0 ||
      heading.compare(heading.size() - after.size(), after.size(), after) != 0)
    return std::nullopt;
  return read_number(heading, heading.substr(before.size(), heading.size() - around));
}

}  // namespace encased_column
