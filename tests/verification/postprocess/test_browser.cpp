// SPDX-License-Identifier: GPL-2.0-only
#include "browser.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column::testing;
using nlohmann::json;

// What the checks of the reports would say of a page that is wrong in each of their ways.
TEST(BrowserVisit, SeesWhatIsWrong)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "wrong.html")
      << "<!DOCTYPE html><html><body><a href='#nowhere'>x</a><img src='gone.png'>"
         "<div style='width: 500px'>wide</div><div class='numbers' style='height: 900px'></div>"
         "<figure><figcaption>bare</figcaption></figure><div class='panel'><svg></svg></div>"
         "<table "
         "id='t'><thead><tr><th><button>a</button></th><th><button>b</button></th></tr></"
         "thead><tbody><tr><td>1</td><td></td>"
         "</tr><tr><td>2</td></tr></tbody></table>"
         "<script>console.error('oh')</script></body></html>";
  const BrowserVisit seen = visit(folder.path(), {"wrong.html"});
  const json& page = seen.pages.at("wrong.html");
  EXPECT_EQ(page.at("images"), json::array({0}));
  EXPECT_EQ(page.at("charts"), json::array({false}));
  EXPECT_EQ(page.at("nameless"), 2);
  EXPECT_EQ(page.at("dead"), 1);
  EXPECT_GT(page.at("width").get<int>(), 390);
  EXPECT_EQ(page.at("tables").at("t"), json({{"rows", 2}, {"uneven", 1}, {"empty", 1}}));
  EXPECT_EQ(page.at("captions"), json::array({"bare"}));
  EXPECT_GT(page.at("first").at(0).get<double>(), 844.0);
  EXPECT_EQ(seen.console.size(), 1u);
}
