// SPDX-License-Identifier: GPL-2.0-only
// Whatever lies in a file that a user writes or may spoil, the answer is one sentence.
#include "core/input_error.h"
#include "files/restart_seal.h"
#include "runner/case_record.h"
#include "runner/case_variables.h"
#include "runner/series.h"
#include "runner/text_file.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

class MalformedFile : public ::testing::Test {
 protected:
  fs::path write(const std::string& text) const
  {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  /// The sentence `read` refuses `text` with; empty if it takes it.
  std::string refusal(const std::string& text,
                      const std::function<void(const fs::path&)>& read) const
  {
    write(text);
    try {
      read(file_);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "";
  }
  static bool is_one_sentence(const std::string& text)
  {
    return text.find('\n') == std::string::npos && text.find("found") != std::string::npos &&
           text.size() < 400;
  }

 private:
  TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "file";
};

struct Bad {
  std::string text, says;
};

const std::string head = "id,deck,default,variables,title,reproduces\n";
const std::string good_series_file =
    "# tests\n" + head +
    "plain_050,triaxial_plain,1,sigma3=50e3;mu=0.5,Plain test,\"Tables 1 and 2, \"\"new\"\"\"\n"
    "own,../decks/trial.lmp,,,,\n";
const std::string good_case_record =
    R"({"id": "plain_050", "deck": "triaxial_plain", "title": "Plain", "reproduces": "",
 "asked": {"sigma3": 50000, "resolution": "quick"}, "variables": {"sigma3": 50000.0, "mu": 1e-3}})";
const std::string good_used_file =
    "name,style,value\nsigma3,index,\"50e3\"\nkind,string,\"a \"\"b\"\"\"\n";

void series(const fs::path& file)
{
  read_series(file, "own.csv");
}
void record(const fs::path& file)
{
  read_case_record(file);
}
void used(const fs::path& file)
{
  read_used_variables(file);
}

}  // namespace

TEST_F(MalformedFile, ReadersTakeGoodOnes)
{
  const std::vector<Case> cases = read_series(write(good_series_file), "own.csv");
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].variables, (Settings{{"sigma3", "50e3"}, {"mu", "0.5"}}));
  EXPECT_EQ(cases[0].reproduces, "Tables 1 and 2, \"new\"");
  EXPECT_TRUE(cases[0].by_default);
  EXPECT_FALSE(cases[1].by_default);
  EXPECT_EQ(cases[1].title, "own");
  EXPECT_EQ(read_case_record(write(good_case_record)).used.front().first, "sigma3");
  EXPECT_EQ(read_used_variables(write(good_used_file)).back().second, "a \"b\"");
}

TEST_F(MalformedFile, CaseBelongsToEverySeriesItNames)
{
  const std::vector<Case> cases =
      read_series(write("id,series,deck,variables\na,x;y,d,c=1\nb,y,d,c=2\nc,,d,c=3\n"), "own.csv");
  EXPECT_EQ(series_names(cases), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(cases_of_series("x", cases).size(), 1u);
  EXPECT_EQ(cases_of_series("y", cases).size(), 2u);
  EXPECT_EQ(cases_of_series("all", cases).size(), 3u);
}

TEST_F(MalformedFile, SeriesIsRefusedWithOneSentence)
{
  const std::vector<Bad> table{
      {"", "must have a first line"},
      {"# nothing but this\n", "must have a first line"},
      {head, "must have one row at least"},
      {"id,deck,variables,colour\na,b,c=1,red\n", "found 'colour'"},
      {"id,deck,deck,variables\n", "found 'deck' twice"},
      {"id,series,deck,variables\na,all,d,c=1\n", "and is not 'all', found 'all'"},
      {"id,series,deck,variables\na,b c,d,c=1\n", "'series' of case 'a' in 'own.csv' takes"},
      {"id,series,deck,variables\na,b;;c,d,c=1\n", "'series' of case 'a' in 'own.csv' takes"},
      {"id,deck\na,b\n", "must have the column 'variables'"},
      {head + "a,b,1,c=1\n", "must have 6 cells"},
      {head + "a,b,1,c=1,t,r,more\n", "must have 6 cells"},
      {head + "a/../b,d,1,c=1,t,r\n", "'id' in 'own.csv' takes letters"},
      {head + ",d,1,c=1,t,r\n", "'id' in 'own.csv' takes letters"},
      {head + "a,d,1,c=1,t,r\na,d,1,c=2,t,r\n", "found 'a' twice"},
      {head + "a,,1,c=1,t,r\n", "must name a deck"},
      {head + "a,d,yes,c=1,t,r\n", "must be 0 or 1, found 'yes'"},
      {head + "a,d,1,c,t,r\n", "takes NAME=VALUE without blanks, found 'c'"},
      {head + "a,d,1,c=1 2,t,r\n", "takes NAME=VALUE without blanks"},
      {head + "a,d,1,c=$(rm),t,r\n", "takes NAME=VALUE without blanks"},
      {head + "a,d,1,c=1,\"t,r\n", "must close its quotes"},
      {head + "a,d,1,c=1,\"t\"x,r\n", "must have a comma behind quotes"},
      {head + std::string("a,d,1,c=\0 1,t,r\n", 16), "must be text in UTF-8"},
      {head + "a,d,1,c=1,\xff\xfe,r\n", "must be text in UTF-8"},
      {head + "a,d,1,c=1," + std::string(20'000, 'x') + ",r\n", "bytes at most"},
      {std::string(5'000'000, 'x'), "bytes at most"},
  };
  for (const Bad& bad : table) {
    const std::string sentence = refusal(bad.text, series);
    EXPECT_NE(sentence.find(bad.says), std::string::npos) << bad.text.substr(0, 200) << "\n"
                                                          << sentence;
    EXPECT_TRUE(is_one_sentence(sentence)) << sentence;
  }
}

TEST_F(MalformedFile, RecordIsRefusedWithOneSentence)
{
  const std::vector<Bad> table{
      {"", "not JSON"},
      {"{", "not JSON"},
      {"[]", "no object"},
      {"7", "no object"},
      {"{}", "no text 'id'"},
      {R"({"id": 7, "deck": "d", "variables": {}})", "no text 'id'"},
      {R"({"id": "", "deck": "d", "variables": {}})", "an empty id"},
      {R"({"id": "a", "variables": {}})", "no text 'deck'"},
      {R"({"id": "a", "deck": "d"})", "no object 'variables'"},
      {R"({"id": "a", "deck": "d", "variables": []})", "no object"},
      {R"({"id": "a", "deck": "d", "variables": {"b": null}})", "'b', which is neither"},
      {R"({"id": "a", "deck": "d", "variables": {"b": [1]}})", "'b', which is neither"},
      {R"({"id": "a", "deck": "d", "title": 3, "variables": {}})", "no text 'title'"},
      {std::string("{\"id\": \"\0\"}", 11), "must be text in UTF-8"},
      {std::string(100'000, '['), ""},
  };
  for (const Bad& bad : table) {
    const std::string sentence = refusal(bad.text, record);
    EXPECT_NE(sentence.find(bad.says), std::string::npos) << bad.text.substr(0, 200) << "\n"
                                                          << sentence;
    EXPECT_TRUE(is_one_sentence(sentence)) << sentence;
  }
}

// A cut may fall behind a whole row or a whole file: then less is read, and that is no fault.
TEST_F(MalformedFile, EachTruncationIsTakenOrRefusedWithOneSentence)
{
  const std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> files{
      {good_series_file, series}, {good_case_record, record}, {good_used_file, used}};
  for (const auto& [text, read] : files) {
    int refused = 0;
    for (int n = 0; n < 100; ++n) {
      const std::string part = text.substr(0, text.size() * static_cast<std::size_t>(n) / 100);
      const std::string sentence = refusal(part, read);
      refused += !sentence.empty();
      EXPECT_TRUE(sentence.empty() || is_one_sentence(sentence)) << part << "\n" << sentence;
    }
    EXPECT_GT(refused, 10);
  }
}

TEST_F(MalformedFile, FolderOrMissingFileIsRefused)
{
  EXPECT_THROW(read_series("/", "own.csv"), InputError);
  EXPECT_THROW(read_series("/no/such/file", "own.csv"), InputError);
  EXPECT_THROW(read_case_record("/"), InputError);
}

TEST_F(MalformedFile, SealTellsAWholeRestartFileFromEachPartOfIt)
{
  std::string text;
  for (int n = 0; n < 5000; ++n) text += static_cast<char>(n * 7 % 251);
  const fs::path file = write(text);
  EXPECT_FALSE(is_sealed(file));
  ASSERT_TRUE(seal_file(file));
  EXPECT_TRUE(is_sealed(file));
  const std::string whole = encased_column::testing::read_text(file);
  EXPECT_EQ(whole.substr(0, text.size()), text) << "the host reads what it wrote";
  for (int n = 0; n < 100; ++n)
    EXPECT_FALSE(
        is_sealed(write(whole.substr(0, whole.size() * static_cast<std::size_t>(n) / 100))));
  for (const std::size_t at : {0u, 2500u, 4999u, 5003u, 5012u, 5020u}) {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ 4);
    EXPECT_FALSE(is_sealed(write(other))) << at;
  }
}
