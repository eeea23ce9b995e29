// SPDX-License-Identifier: GPL-2.0-only
// The reports of a plain and an encased test of some hundred grains, opened in a browser.
#include "browser.h"
#include "support/child_program.h"
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <thread>

using namespace encased_column::testing;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int variables_of_a_case = 5;

/// A run folder as ./input_scripts/run makes it.
void make_case(const fs::path& folder, const std::string& kind)
{
  const std::string deck = "triaxial_" + kind;
  const fs::path inputs = fs::path(ENCASE_SOURCE) / "input_scripts";
  fs::create_directories(folder);
  const Outcome outcome = run_small_triaxial(folder, 1, read_text(inputs / deck / (deck + ".lmp")));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  fs::create_directories(folder / "input");
  fs::copy_file(inputs / deck / (deck + ".lmp"), folder / "input" / (deck + ".lmp"));
  fs::copy(inputs / "common", folder / "input/common");
  std::ofstream(folder / "case.json")
      << "{\"id\": \"" << kind << "\", \"deck\": \"" << deck
      << "\", \"title\": \"A <small> test at 7 kPa, " << kind << "\", \"reproduces\": \"Table 2\", "
      << "\"variables\": {\"resolution\": \"small\", "
         "\"parameters\": \"study\", \"sigma3\": 50000, "
      << "\"modulus\": 7000000, \"radius\": 0.03}}\n";
  std::ofstream(folder / "command.txt")
      << "/opt/liggghts-encase -in input/x.lmp -var common input/common -var sigma3 50e3\n";
  std::ofstream(folder / "finished") << "2026-01-01T00:00:00Z\nwall time 4000 s\n";
  std::ofstream(folder / "versions.txt") << "encased columns v9\ncores 2, ranks 1, Linux\n";
}

/// Statistics of contacts at the first and the last step of the history.
void write_contacts(const fs::path& folder)
{
  const std::vector<double> steps = CsvTable(folder / "history.csv").column("step [-]");
  std::ofstream contacts(folder / "contacts.csv");
  contacts << "step [-],contacts [-],mean_force [N],largest_force [N]";
  for (const char* level : {"2.5", "20", "40", "100"})  // not those that the fix starts from
    contacts << ",contacts_above_" << level << "N [-],share_above_" << level << "N [-]";
  for (const double step : {steps.front(), steps.back()})
    contacts << '\n' << step << ",321,4.5,98.7,100,0.3,50,0.15,20,0.06,5,0.0155";
  contacts << '\n';
}

/// One series and one visit for all tests.
class ReportTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const fs::path series = folder_->path();
    make_case(series / "plain", "plain");
    make_case(series / "encased", "encased");
    fs::remove(series / "plain/contacts.csv");  // as a deck of its own may do without them
    write_contacts(series / "encased");
    outcome_ = run_program({ENCASE_COMMAND, "report", "--draft", series}, series);
    ASSERT_EQ(outcome_.exit_code, 0) << outcome_.output;
    visit_ = visit(series, pages);
    at_desk_ = visit(series, pages, desk);
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(visit_.pages.size(), pages.size()) << outcome_.output; }

  static const fs::path& folder() { return folder_->path(); }
  static std::string text(const std::string& file) { return read_text(folder_->path() / file); }
  static const json& page(const std::string& name) { return visit_.pages.at(name); }
  static int rows(const std::string& name, const std::string& table)
  {
    return page(name).at("tables").at(table).at("rows").get<int>();
  }
  /// How many lines of `file` start with `start`.
  static int lines(const std::string& file, const std::string& start)
  {
    std::istringstream stream(text(file));
    int count = 0;
    for (std::string line; std::getline(stream, line);) count += line.rfind(start, 0) == 0;
    return count;
  }

  inline static const std::vector<std::string> pages{"report.html", "plain/report.html",
                                                     "encased/report.html"};
  inline static BrowserVisit visit_, at_desk_;

 private:
  inline static TemporaryFolder* folder_ = nullptr;
  inline static Outcome outcome_;
};

}  // namespace

TEST_F(ReportTest, OpensWithoutAWordInTheConsole)
{
  EXPECT_EQ(visit_.console, std::vector<std::string>{});
}

TEST_F(ReportTest, TakesNothingFromElsewhere)
{
  for (const std::string& name : pages) {
    const std::string html = text(name);
    for (const char* outside :
         {"src=\"http", "href=\"http", "url(", "<link", "<script ", "import(", "fetch(", "@import"})
      EXPECT_EQ(html.find(outside), std::string::npos) << name << ": " << outside;
  }
}

TEST_F(ReportTest, LinksOnlyToWhatIsThere)
{
  for (const std::string& name : pages) {
    const std::string html = text(name);
    const fs::path here = (folder() / name).parent_path();
    const std::regex address("href=\"([^\"#:]+)[\"#]");
    int links = 0;
    for (std::sregex_iterator found(html.begin(), html.end(), address), end; found != end;
         ++found, ++links)
      EXPECT_TRUE(fs::exists(here / found->str(1))) << name << ": " << found->str(1);
    EXPECT_GE(links, name == "report.html" ? 2 : 0) << "the pages of both tests";
  }
}

TEST_F(ReportTest, ShowsItsPicturesAndCharts)
{
  EXPECT_EQ(page("plain/report.html").at("images").size(), 3u);
  EXPECT_EQ(page("encased/report.html").at("images").size(), 5u);
  EXPECT_EQ(page("report.html").at("images").size(), 8u);
  // Both platens 1, curves 4, paths 2, spheres 8, run 3, energy 1; the sleeve adds 3 and its
  // contacts 1, and its platens are not compared. Profiles are drawn from 5 % strain on.
  EXPECT_EQ(page("plain/report.html").at("charts").size(), 19u);
  EXPECT_EQ(page("encased/report.html").at("charts").size(), 22u);
  for (const std::string& name : pages) {
    for (const json& width : page(name).at("images")) EXPECT_GT(width.get<int>(), 0) << name;
    for (const json& drawn : page(name).at("charts")) EXPECT_TRUE(drawn.get<bool>()) << name;
    EXPECT_EQ(page(name).at("nameless"), 0) << name;
  }
}

TEST_F(ReportTest, FitsATelephoneAndADesk)
{
  for (const auto& [visit, window] : {std::pair(&visit_, telephone), std::pair(&at_desk_, desk)})
    for (const std::string& name : pages) {
      EXPECT_EQ(visit->pages.at(name).at("window"), window.width) << name;
      EXPECT_LE(visit->pages.at(name).at("width").get<int>(), window.width) << name;
    }
}

// Without scrolling: the numbers and every chart of the first figure.
TEST_F(ReportTest, AnswersInItsFirstScreenWhetherItAgrees)
{
  for (const auto& [visit, window] : {std::pair(&visit_, telephone), std::pair(&at_desk_, desk)})
    for (const std::string& name : pages) {
      const json& first = visit->pages.at(name).at("first");
      EXPECT_EQ(first.size(), name == "report.html" ? 3u : 2u) << name;
      for (const json& bottom : first)
        EXPECT_LE(bottom.get<double>(), window.height)
            << name << ", " << window.width << " px wide";
    }
  EXPECT_TRUE(std::regex_search(
      text("report.html"), std::regex("Met within 15 % of the laboratory: \\d of \\d values?")));
}

// For readers who do not see red from green, and on paper.
TEST_F(ReportTest, SaysInWordsWhichNumbersAreMet)
{
  for (const std::string& name : pages) {
    const std::string html = text(name);
    const std::regex ratio("class=\"ratio\""), near("<div class=\"near\">"),
        met("× <small>met</small>"), off("× <small>off</small>");
    const auto count = [&](const std::regex& what) {
      return std::distance(std::sregex_iterator(html.begin(), html.end(), what), {});
    };
    EXPECT_GT(count(ratio), 0) << name;
    EXPECT_EQ(count(met), count(near)) << name;
    EXPECT_EQ(count(off), count(ratio) - count(near)) << name;
  }
}

// Where more is to be computed than there are cores, as when tests run side by side, the browser
// has its share of them only.
TEST_F(ReportTest, OpensInUnderTwoSeconds)
{
  double load = 0.0;
  ASSERT_EQ(getloadavg(&load, 1), 1);
  const double slower = std::max(1.0, load / std::thread::hardware_concurrency());
  for (const std::string& name : pages)
    for (const BrowserVisit& visit : {visit_, at_desk_})
      EXPECT_LT(visit.pages.at(name).at("milliseconds").get<double>(), 2000.0 * slower) << name;
}

TEST_F(ReportTest, SaysUnitsAndTheRunsVariablesBelowEachPicture)
{
  for (const std::string& name : pages) {
    const json& captions = page(name).at("captions");
    EXPECT_GT(captions.size(), 10u) << name;
    for (const json& caption : captions) {
      const std::string words = caption.get<std::string>();
      EXPECT_NE(words.find('['), std::string::npos) << name << ": no unit: " << words;
      EXPECT_NE(words.find("σ₃ 50 kPa, E* 7 MPa"), std::string::npos) << name << ": " << words;
    }
  }
}

TEST_F(ReportTest, SortsItsTablesByAClickOnAHeading)
{
  // Columns of numbers: those that begin with one go up, then down, the others stay last.
  const auto numbers_of = [](const json& texts) {
    std::vector<double> numbers;
    bool ended = false;
    for (const json& text : texts) {
      char* end = nullptr;
      const std::string word = text.get<std::string>();
      const double number = std::strtod(word.c_str(), &end);
      const bool found = end != word.c_str();
      EXPECT_FALSE(found && ended) << word << " behind what is no number";
      ended = !found;
      if (found) numbers.push_back(number);
    }
    return numbers;
  };
  const auto sorted_words = [](const json& texts) {
    std::vector<std::string> words = texts.get<std::vector<std::string>>();
    std::sort(words.begin(), words.end());
    return words;
  };
  const json& tables = page("report.html").at("sorted");
  int moved = 0;
  for (const auto& [id, column] :
       {std::pair("tests_table", 9), std::pair("beside_study", 3), std::pair("beside_study", 5)}) {
    const json& states = tables.at(id).at(static_cast<std::size_t>(column));
    EXPECT_EQ(states.at(2), "ascending");
    EXPECT_EQ(states.at(4), "descending");
    for (std::size_t body = 0; body < states.at(0).size(); ++body) {
      for (const std::size_t state : {1u, 3u}) {
        EXPECT_EQ(sorted_words(states.at(state).at(body)), sorted_words(states.at(0).at(body)));
        std::vector<double> numbers = numbers_of(states.at(state).at(body));
        if (state == 3) std::reverse(numbers.begin(), numbers.end());
        EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end())) << id << ' ' << column;
        moved += states.at(state) != states.at(0);
      }
    }
  }
  EXPECT_GT(moved, 2);
}

TEST_F(ReportTest, HasNoGapInItsTablesAndNoDeadLink)
{
  for (const std::string& name : pages) {
    EXPECT_EQ(page(name).at("dead"), 0) << name;
    for (const auto& [id, table] : page(name).at("tables").items()) {
      EXPECT_GT(table.at("rows").get<int>(), 0) << name << ' ' << id;
      EXPECT_EQ(table.at("uneven"), 0) << name << ' ' << id;
      EXPECT_EQ(table.at("empty"), 0) << name << ' ' << id;
    }
  }
}

TEST_F(ReportTest, TellsAllThatTheTablesOfTheSeriesTell)
{
  for (const std::string kind : {"plain", "encased"}) {
    const std::string name = kind + "/report.html";
    const int results = lines("table.csv", kind + "_triaxial,study," + kind + ',');
    EXPECT_GT(results, 5);
    EXPECT_EQ(rows(name, "results"), results);
    EXPECT_EQ(rows("report.html", "results_" + kind + "_triaxial_study"), results);
    EXPECT_EQ(rows(name, "checks"), lines("checks.csv", kind + ','));
    EXPECT_EQ(rows(name, "inputs"), variables_of_a_case);
    EXPECT_EQ(rows(name, "gradation"), 1);
    EXPECT_EQ(rows(name, "column"), 10);  // three spheres, their mean, the walls; twice
    EXPECT_EQ(rows(name, "counterparts"), 13);
  }
  EXPECT_EQ(rows("report.html", "tests_table"), 2);
  EXPECT_EQ(rows("report.html", "checks_table"),
            lines("checks.csv", "plain,") + lines("checks.csv", "encased,"));
}

// Two sets lie beside the deck: the meaning is that of the one the run has used.
TEST_F(ReportTest, TellsTheSourcesOfTheSetThatTheRunUsed)
{
  const std::string html = text("plain/report.html");
  EXPECT_NE(html.find("contact modulus E* (Table 1, read as 7 MPa)"), std::string::npos);
  EXPECT_EQ(html.find("found by hand"), std::string::npos);
  EXPECT_NE(html.find("mean of both platens, parameters study</h4>"), std::string::npos)
      << "charts name the set";
}

TEST_F(ReportTest, ShowsTheContactsWhereARunWroteThem)
{
  EXPECT_EQ(rows("encased/report.html", "contacts"), 2);
  const std::string html = text("encased/report.html");
  EXPECT_NE(html.find("above 2.5 N [%]"), std::string::npos);
  EXPECT_NE(html.find(">1.55<"), std::string::npos);  // % above 100 N
  EXPECT_FALSE(page("plain/report.html").at("tables").contains("contacts"));
  EXPECT_NE(text("plain/report.html").find("wrote no contacts.csv"), std::string::npos);
}

TEST_F(ReportTest, NamesThePicturesBesideFiguresOfTheStudy)
{
  const std::string plain = text("plain/report.html"), encased = text("encased/report.html");
  EXPECT_NE(plain.find(">Pictures: displacement, shear band</td>"), std::string::npos);
  EXPECT_NE(encased.find(">Pictures: displacement, shear band, sleeve</td>"), std::string::npos);
  EXPECT_NE(encased.find(">Contact forces; pictures: force chains, chains of 20, 40 and 60 N</td>"),
            std::string::npos);
}

TEST_F(ReportTest, TellsUnitsWarningsAndHowToRepeatTheRun)
{
  const std::string html = text("plain/report.html");
  EXPECT_NE(html.find("A &lt;small&gt; test at 50 kPa, plain, parameters study, resolution small"),
            std::string::npos);
  EXPECT_NE(html.find(">7</td><td>MPa</td>"), std::string::npos);
  EXPECT_NE(html.find(">30</td><td>mm</td>"), std::string::npos);
  EXPECT_NE(html.find("measuring sphere 1 of fix &apos;spheres&apos; holds"), std::string::npos);
  EXPECT_NE(html.find("1 h 7 min"), std::string::npos);
  EXPECT_NE(html.find("./input_scripts/run --case plain --resolution small --set sigma3=50e3 "
                      "--ranks 1"),
            std::string::npos);
}
