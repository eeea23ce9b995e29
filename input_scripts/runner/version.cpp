// SPDX-License-Identifier: GPL-2.0-only
#include "runner/version.h"

#include "commit.h"
#include "runner/processes.h"

namespace encased_column {

std::string project_version()
{
  return std::string(ENCASE_VERSION) + ", commit " + ENCASE_COMMIT;
}

std::string versions(const Places& places)
{
  std::string of_host = output_of({places.host, "-version"});
  if (of_host.empty())
    of_host = "host: '" + places.host.string() + "' does not start, write 'encase doctor'\n";
  while (!of_host.empty() && of_host.back() == '\n') of_host.pop_back();
  return "encase " + project_version() + "\n" + of_host;
}

}  // namespace encased_column
