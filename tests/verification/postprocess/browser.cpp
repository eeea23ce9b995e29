// SPDX-License-Identifier: GPL-2.0-only
#include "browser.h"

#include "support/child_program.h"

#include <stdexcept>

namespace encased_column::testing {

namespace fs = std::filesystem;

BrowserVisit visit(const fs::path& folder, const std::vector<std::string>& pages, WindowSize window)
{
  fs::copy_file(fs::path(ENCASE_SOURCE) / "tests/verification/postprocess/browser_check.html",
                folder / "browser_check.html", fs::copy_options::overwrite_existing);
  std::string address = "file://" + (folder / "browser_check.html").string() + '#' +
                        std::to_string(window.width) + 'x' + std::to_string(window.height);
  for (const std::string& page : pages) address += '|' + page;
  // No sandbox: tests run as root in containers. Files may be read by files: the check reads pages.
  const Outcome outcome = run_program(
      {ENCASE_BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
       "--allow-file-access-from-files", "--host-resolver-rules=MAP * ~NOTFOUND",
       "--user-data-dir=" + (folder / "browser").string(), "--enable-logging=stderr",
       "--timeout=240000", "--dump-dom", address},
      folder);

  BrowserVisit visit;
  for (const std::string& line : outcome.lines())
    if (line.find(":CONSOLE:") != std::string::npos || line.find(":CONSOLE(") != std::string::npos)
      visit.console.push_back(line);
  const std::string start = "<pre id=\"result\">";
  const std::size_t from = outcome.output.find(start), to = outcome.output.find("</pre>", from);
  if (from == std::string::npos || to == std::string::npos)
    throw std::runtime_error("the browser told nothing: " + outcome.output);
  visit.pages =
      nlohmann::json::parse(outcome.output.substr(from + start.size(), to - from - start.size()));
  return visit;
}

}  // namespace encased_column::testing
