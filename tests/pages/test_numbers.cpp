// SPDX-License-Identifier: GPL-2.0-only
// The numbers of the result pages are those of the committed tables and histories: each row of
// postprocess/results/numbers.csv is found again in its file and on its page.
#include "pages/listed_number.h"
#include "pages/word_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;
const std::string mark = "<!-- every number of this table is in numbers.csv -->";

const std::vector<ListedNumber>& all_numbers()
{
  static const auto numbers = read_listed_numbers(source / "postprocess/results/numbers.csv");
  return numbers;
}

const std::string& text_of(const std::string& page)
{
  static std::map<std::string, std::string> texts;
  if (!texts.count(page)) {
    std::ifstream stream(source / page);
    texts[page] = {std::istreambuf_iterator<char>(stream), {}};
  }
  return texts[page];
}

std::string name_of(const ListedNumber& listed)
{
  return listed.number + " of '" + listed.text + "' in " + listed.page + ", " + listed.section;
}

ListedNumber from(const std::string& file, const std::string& row, const std::string& column,
                  const std::string& pick)
{
  return {"", "", "", "", file, row, column, pick, 1};
}

class NumbersOfAFile : public ::testing::Test {
 protected:
  NumbersOfAFile()
  {
    folder_ = fs::temp_directory_path() / ("encase_numbers_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    std::ofstream(folder_ / "history.csv") << "strain [-],top [Pa],bottom [Pa]\n"
                                              "0,1,3\n0.1,7,9\n0.2,4,4\n";
    std::ofstream(folder_ / "table.txt") << "Heading\n\n"
                                            "test  quantity     found  to [%]  to [%]\n"
                                            "----  -----------  -----  ------  ------\n"
                                            "a_1   peak, large    1.5      -2       8\n"
                                            "a_2   peak, large    2.5       -       9\n"
                                            "A note below.\n";
  }
  ~NumbersOfAFile() override { fs::remove_all(folder_); }

  double value(const ListedNumber& listed) { return value_in_file(listed, folder_); }
  fs::path folder_;
};

}  // namespace

TEST(Numbers, AreThoseOfTheirFiles)
{
  for (const ListedNumber& listed : all_numbers()) try {
      const double value = value_in_file(listed, source);
      EXPECT_TRUE(prints(listed.number, value))
          << name_of(listed) << ": " << listed.file << " says " << value;
    } catch (const std::exception& problem) {
      ADD_FAILURE() << name_of(listed) << ": " << listed.file << ", row '" << listed.row
                    << "': " << problem.what();
    }
}

TEST(Numbers, StandOnTheirPagesOnce)
{
  for (const ListedNumber& listed : all_numbers()) try {
      EXPECT_EQ(places_on(text_of(listed.page), listed).size(), 1u) << name_of(listed);
    } catch (const std::exception& problem) {
      ADD_FAILURE() << name_of(listed) << ": " << problem.what();
    }
}

TEST(Numbers, OfMarkedTablesAreAllListed)
{
  const std::string page = "postprocess/results/README.md";
  std::set<std::size_t> listed_places;
  for (const ListedNumber& listed : all_numbers())
    if (listed.page == page)
      for (const std::size_t place : places_on(text_of(page), listed)) listed_places.insert(place);
  const std::vector<std::size_t> in_tables = places_in_tables(text_of(page), mark);
  EXPECT_GT(in_tables.size(), 100u);
  for (const std::size_t place : in_tables)
    EXPECT_TRUE(listed_places.count(place))
        << "not in numbers.csv: '" << text_of(page).substr(place, 8) << "...' of line "
        << 1 + std::count(text_of(page).begin(), text_of(page).begin() + long(place), '\n');
}

TEST_F(NumbersOfAFile, ArePickedFromHistories)
{
  EXPECT_EQ(value(from("history.csv", "", "top [Pa]", "max")), 7);
  EXPECT_EQ(value(from("history.csv", "", "top [Pa]", "min")), 1);
  EXPECT_EQ(value(from("history.csv", "", "bottom [Pa]", "first")), 3);
  EXPECT_EQ(value(from("history.csv", "", "bottom [Pa]", "last")), 4);
  EXPECT_EQ(
      value(from("history.csv", "", "0.5 * top [Pa] + 0.5 * bottom [Pa] - strain [-]", "max")),
      7.9);
  EXPECT_EQ(value(from("history.csv", "", "top [Pa]", "last over max")), 4.0 / 7.0);
  EXPECT_NEAR(value(from("history.csv", "", "top [Pa]", "at strain [-] 0.15")), 5.5, 1e-12);
}

TEST_F(NumbersOfAFile, ArePickedFromTables)
{
  EXPECT_EQ(value(from("table.txt", "a_2; peak, large", "found", "")), 2.5);
  EXPECT_EQ(value(from("table.txt", "a_*; peak, large", "found", "min")), 1.5);
  EXPECT_EQ(value(from("table.txt", "a_*", "to [%]", "")), -2) << "a cell without value counts";
  EXPECT_EQ(value(from("table.txt", "a_*", "2nd to [%]", "max")), 9);
}

TEST_F(NumbersOfAFile, AreRefusedWhereTheyAreNotClear)
{
  EXPECT_THROW(value(from("table.txt", "a_*", "found", "")), std::runtime_error) << "two rows";
  EXPECT_THROW(value(from("table.txt", "a_3", "found", "max")), std::runtime_error);
  EXPECT_THROW(value(from("table.txt", "a_1", "lost", "")), std::runtime_error);
  EXPECT_THROW(value(from("none.txt", "a_1", "found", "")), std::runtime_error);
  EXPECT_THROW(value(from("history.csv", "", "top [Pa]", "mean")), std::runtime_error);
}

TEST(PrintedNumber, IsTheValueToHalfOfItsLastDigit)
{
  EXPECT_TRUE(prints("147.4", 147.44));
  EXPECT_FALSE(prints("147.4", 147.46));
  EXPECT_FALSE(prints("147.4", 147.34));
  EXPECT_TRUE(prints("9.9e-6", 9.94e-6));
  EXPECT_FALSE(prints("9.9e-6", 9.96e-6));
  EXPECT_TRUE(prints("54 412", 54412));
  EXPECT_FALSE(prints("54 412", 54413));
  EXPECT_FALSE(prints("2.0", 2.06));
  EXPECT_TRUE(prints("-7.36", -7.363));
}

TEST(PlacesOnAPage, AreThoseOfTheWholeNumberInItsSection)
{
  const std::string page = "# One\n\n| q | 1.5 / 2.5 |\n\n## Two\n\n| q | 1.5 /\n 2.55 |\n";
  ListedNumber listed;
  listed.section = "One";
  listed.text = "| q | # / @";
  listed.number = "2.5";
  EXPECT_EQ(places_on(page, listed), std::vector<std::size_t>{page.find("2.5")});
  listed.section = "Two";
  EXPECT_TRUE(places_on(page, listed).empty()) << "2.55 is another number";
  listed.number = "2.55";
  EXPECT_EQ(places_on(page, listed), std::vector<std::size_t>{page.find("2.55")});
  listed.section = "Three";
  EXPECT_THROW(places_on(page, listed), std::runtime_error);
}
