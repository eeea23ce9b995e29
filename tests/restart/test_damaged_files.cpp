// SPDX-License-Identifier: GPL-2.0-only
// A restart file that is cut off, or no restart file, is refused with a sentence; one that is whole
// is read, whatever program wrote it.
#include "files/restart_file.h"

#include "core/input_error.h"
#include "input_errors/refusal.h"

#include <cctype>
#include <fstream>
#include <random>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Two grains that touch, walls and motion: histories, blocks of fixes and what grains carry for
/// them.
const std::string specimen =
    opening_deck("two_grains") +
    "unfix move\nfix move all motion\n"
    "fix bottom all servo/platen position bottom z 0.09 area 0.01 type 2\n";

const std::string read_again =
    "units si\natom_style granular\natom_modify map array\n"
    "boundary f f f\nnewton off\ncommunicate single vel yes\n";

void write(const fs::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string refusal_of(const fs::path& file)
{
  try {
    check_restart_file(file);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

std::string random_bytes(std::mt19937& random)
{
  std::string bytes(random() % 5000, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

}  // namespace

/// The files of one run by each way the host and this project write them, on two ranks.
class RestartFile : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const Outcome outcome = run_deck(specimen +
                                         "restart 10 timed.*\n"
                                         "fix save all output/restart every 10 file ours\nrun 20\n"
                                         "write_restart hosts\nwrite_restart split.%\n",
                                     2, folder());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path folder() { return folder_->path(); }

  static TemporaryFolder* folder_;
};

TemporaryFolder* RestartFile::folder_ = nullptr;

TEST_F(RestartFile, IsReadWhoeverWroteIt)
{
  for (const char* name : {"ours", "hosts", "timed.20", "timed.*", "split.%"}) {
    const Outcome outcome = run_deck(
        read_again + "read_restart " + name + "\nvariable n equal atoms\nprint \"grains ${n}\"\n",
        1, folder());
    EXPECT_EQ(outcome.exit_code, 0) << name << "\n" << outcome.output;
    EXPECT_EQ(outcome.value("grains"), 2.0) << name;
  }
  EXPECT_EQ(restart_file_of(folder() / "timed.*"), folder() / "timed.20");
}

TEST_F(RestartFile, IsRefusedWhereverItIsCutOff)
{
  std::mt19937 random(17);
  for (const char* name : {"ours", "hosts", "timed.20"}) {
    const std::string whole = read_text(folder() / name);
    EXPECT_EQ(refusal_of(folder() / name), "");
    for (int n = 0; n < 100; ++n) {
      const std::size_t length = random() % whole.size();
      write(folder() / "cut", whole.substr(0, length));
      EXPECT_NE(refusal_of(folder() / "cut"), "") << "after " << length << " bytes of " << name;
    }
  }
}

TEST_F(RestartFile, IsRefusedWhereOneOfItsPartsIsCutOffOrMissing)
{
  const std::string part = read_text(folder() / "split.0");
  write(folder() / "split.0", part.substr(0, part.size() - 1));
  EXPECT_NE(refusal_of(folder() / "split.%").find("split.0', which is cut off"), std::string::npos);
  fs::remove(folder() / "split.0");
  EXPECT_NE(refusal_of(folder() / "split.%").find("no file that can be read"), std::string::npos);
  write(folder() / "split.0", part);
  EXPECT_EQ(refusal_of(folder() / "split.%"), "");
}

TEST_F(RestartFile, IsNotTakenForOneWhereBytesAreRandom)
{
  std::mt19937 random(18);
  const std::string whole = read_text(folder() / "ours");
  for (int n = 0; n < 100; ++n) {
    write(folder() / "random", random_bytes(random));
    EXPECT_NE(refusal_of(folder() / "random"), "");
    // Damage in the middle may be anything, a changed velocity too, but never ends the program.
    std::string damaged = whole;
    for (int k = 0; k < 20; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
    write(folder() / "damaged", damaged);
    refusal_of(folder() / "damaged");
  }
}

TEST_F(RestartFile, IsRefusedByTheProgramWithASentence)
{
  std::mt19937 random(19);
  const std::string whole = read_text(folder() / "ours");
  write(folder() / "random", random_bytes(random));
  write(folder() / "half", whole.substr(0, whole.size() / 2));
  write(folder() / "one_byte_less", whole.substr(0, whole.size() - 1));
  std::vector<std::string> names{"random", "half", "one_byte_less", "missing"};
  for (int n = 0; n < 4; ++n) {
    names.push_back("cut_" + std::to_string(n));
    write(folder() / names.back(), whole.substr(0, random() % whole.size()));
    names.push_back("changed_" + std::to_string(n));
    std::string changed = whole;
    changed[random() % changed.size()] ^= 1;  // its seal tells
    write(folder() / names.back(), changed);
  }
  for (const std::string& name : names)
    for (const int ranks : {1, 2}) {
      if (ranks == 2 && name != "half") continue;
      const Outcome outcome = run_deck(
          read_again + "read_restart " + name + "\nprint \"it was read\"\n", ranks, folder());
      EXPECT_EQ(outcome.exit_code, 1) << name << "\n" << outcome.output;
      EXPECT_TRUE(outcome.says("'read_restart' must name a whole restart file, found '" + name +
                               "', which is "))
          << outcome.output;
      EXPECT_FALSE(outcome.says("it was read"));
    }
}
