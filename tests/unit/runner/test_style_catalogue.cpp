// SPDX-License-Identifier: GPL-2.0-only
// What the plugin says of its styles, for the terminal.
#include "runner/style_catalogue.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const char* const printed =
    "fix servo/platen\n"
    "| `position` | 1 | - | top or bottom |\n"
    "| `z` | 2 | m | of its level |\n"
    "fix measure/sphere\n"
    "| `every` | 1 | steps | between samples |\n"
    "table spheres.csv\n"
    "| `step` | - | of the sample |\n"
    "| `z` | m | of its center |\n"
    "command solve\n"
    "| `quiet` | 0 | - | says nothing |\n";

const std::vector<PageStart> pages{{"fix servo/platen", "A flat platen.", "servo/platen.md"},
                                   {"pair_style law", "Springs.", "contact/law.md"}};

}  // namespace

TEST(StyleCatalogue, ListsStylesWithTheStartOfTheirPages)
{
  EXPECT_EQ(list_of_styles(read_styles(printed, pages)),
            "fix servo/platen    A flat platen.\n"
            "fix measure/sphere\n"
            "solve\n"
            "pair_style law      Springs.\n");
}

TEST(StyleCatalogue, DescribesAStyleByItsKeywordsAndTables)
{
  const std::vector<StyleText> styles = read_styles(printed, pages);
  EXPECT_EQ(description(*find_style(styles, "servo/platen")),
            "fix servo/platen\n"
            "A flat platen.\n\n"
            "Keywords:\n"
            "  position  1 value   [-]  top or bottom\n"
            "  z         2 values  [m]  of its level\n\n"
            "Page with examples: servo/platen.md\n");
  EXPECT_EQ(description(*find_style(styles, "fix measure/sphere")),
            "fix measure/sphere\n\n"
            "Keywords:\n"
            "  every  1 value  [steps]  between samples\n\n"
            "Columns of spheres.csv:\n"
            "  step  [-]  of the sample\n"
            "  z     [m]  of its center\n");
  EXPECT_EQ(description(*find_style(styles, "solve")),
            "solve\n\nKeywords:\n  quiet  no value  [-]  says nothing\n");
  EXPECT_EQ(find_style(styles, "platen"), nullptr);
}

TEST(StyleCatalogue, FindsAWordAsKeywordAndAsColumn)
{
  const std::vector<StyleText> styles = read_styles(printed, pages);
  EXPECT_EQ(uses_of(styles, "z"),
            "keyword of fix servo/platen                2 values  [m]  of its level\n"
            "column of spheres.csv, fix measure/sphere            [m]  of its center\n");
  EXPECT_EQ(uses_of(styles, "zz"), "");
  EXPECT_EQ(words_of(styles),
            (std::vector<std::string>{"fix servo/platen", "servo/platen", "position", "z",
                                      "fix measure/sphere", "measure/sphere", "every", "step", "z",
                                      "solve", "quiet", "pair_style law"}));
}

// The pages are read when the program is built: each has a name and a sentence.
TEST(StyleCatalogue, HasTheStartOfEveryPage)
{
  EXPECT_GE(style_pages().size(), 18u);
  for (const PageStart& page : style_pages()) {
    EXPECT_GT(std::string(page.summary).size(), 10u) << page.name;
    EXPECT_EQ(std::string(page.summary).back(), '.') << page.name;
    EXPECT_NE(std::string(page.file).find(".md"), std::string::npos) << page.name;
  }
}
