// SPDX-License-Identifier: GPL-2.0-only
// A restart file put together here as the host writes it (tests/restart reads the host's own), cut
// off and with other bytes: taken or one sentence. Instrumented, no byte is read outside of it.
#include "core/input_error.h"
#include "files/restart_file.h"
#include "files/restart_seal.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;

namespace {

/// The parts of a restart file of two grains, each of which may be another one.
struct RestartParts {
  std::string version, head, groups, masses, force_fields, fixes, grains;

  RestartParts()
  {
    put_name(version, 0, "Version LIGGGHTS");
    put_name(head, 4, "si");
    put(head, 5, 20L);  // step
    put(head, 7, 1);    // blocks of grains
    put_name(head, 22, "hybrid");
    put(head, 1);  // styles in it
    put_name(head, "granular");
    put(head, 23, 2L);   // grains
    put(head, 24, 3);    // types
    put(head, 37, 0.5);  // a border of the box
    put(head, -1);
    put(groups, 2);  // groups, then the names of up to 32 of them
    put_name(groups, "all");
    put(groups, 0);
    put_name(groups, "rest");
    put(masses, 0);
    for (const double mass : {1.0, 2.0, 3.0}) put(masses, mass);
    put(masses, -1);
    put_name(force_fields, 0, "gran");
    put(force_fields, 7L);  // contact model
    force_fields.append(2 * 3 * 4, '\1');
    put(force_fields, -1);
    put(fixes, 1);  // with a state of their own
    put_name(fixes, "move");
    put_name(fixes, "motion");
    put(fixes, 16);
    fixes.append(16, '\2');
    put(fixes, 1);  // with one per grain
    put_name(fixes, "history");
    put_name(fixes, "contacthistory");
    put(fixes, 3);
    put(grains, 20);
    for (int n = 0; n < 20; ++n) put(grains, n % 10 == 0 ? 10.0 : 0.1 * n);
  }

  std::string all() const
  {
    return version + head + groups + masses + force_fields + fixes + grains;
  }

  template <typename Number>
  static void put(std::string& to, Number number)
  {
    to.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <typename Number>
  static void put(std::string& to, int entry, Number number)
  {
    put(to, entry);
    put(to, number);
  }
  static void put_name(std::string& to, const std::string& name)
  {
    put(to, static_cast<int>(name.size() + 1));
    to += name + '\0';
  }
  static void put_name(std::string& to, int entry, const std::string& name)
  {
    put(to, entry);
    put_name(to, name);
  }
};

class DamagedRestartFile : public ::testing::Test {
 protected:
  std::string write(const std::string& bytes) const
  {
    std::filesystem::remove(file_);  // to write over a file waits for the disk
    std::ofstream(file_, std::ios::binary) << bytes;
    return file_;
  }
  std::string sealed(const std::string& bytes) const
  {
    EXPECT_TRUE(seal_file(write(bytes)));
    return encased_column::testing::read_text(file_);
  }
  /// The sentence with which `bytes` are refused; empty where they are taken.
  std::string refusal(const std::string& bytes) const
  {
    try {
      check_restart_file(write(bytes));
    } catch (const InputError& problem) {
      const std::string sentence = problem.what();
      EXPECT_EQ(sentence.find("'read_restart' must name a whole restart file, found '"), 0u);
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      return sentence;
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "restart";
};

long most_memory()  // kB
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

TEST_F(DamagedRestartFile, IsTakenWholeWithAndWithoutASeal)
{
  const std::string bytes = RestartParts().all();
  EXPECT_EQ(refusal(bytes), "");
  EXPECT_EQ(refusal(sealed(bytes)), "");
}

TEST_F(DamagedRestartFile, IsRefusedWhereverItIsCutOff)
{
  std::minstd_rand random(3);
  const std::string plain = RestartParts().all(), with_seal = sealed(plain);
  for (const std::string& bytes : {plain, with_seal})
    for (int n = 0; n < 100; ++n) {
      const std::size_t size = n == 0 ? bytes.size() - 1 : random() % bytes.size();
      // Without its seal it is as the host writes it.
      EXPECT_EQ(refusal(bytes.substr(0, size)).empty(), size == plain.size()) << size;
    }
}

TEST_F(DamagedRestartFile, WithASealIsRefusedWithAnyOtherByte)
{
  const std::string bytes = sealed(RestartParts().all());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string other = bytes;
    other[at] = static_cast<char>(other[at] ^ (1 << at % 8));
    EXPECT_NE(refusal(other), "") << at;
  }
}

TEST_F(DamagedRestartFile, WithoutASealIsTakenOrRefusedWithOneSentence)
{
  const long memory = most_memory();
  std::minstd_rand random(4);
  const std::string bytes = RestartParts().all();
  int refused = 0;
  for (int n = 0; n < 200; ++n) {
    std::string other = bytes;
    for (int k = 0; k <= n % 3; ++k) other[random() % other.size()] = static_cast<char>(random());
    refused += !refusal(other).empty();
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(most_memory() - memory, 500'000);
}

TEST_F(DamagedRestartFile, IsRefusedByEachOfItsNumbersThatCannotBe)
{
  using Parts = RestartParts;
  struct Bad {
    std::string what;
    std::string Parts::*part;
    std::string bytes;
  };
  const auto ints = [](std::initializer_list<int> numbers) {
    std::string bytes;
    for (const int number : numbers) Parts::put(bytes, number);
    return bytes;
  };
  const auto head_with = [](int entry, auto number) {  // the last one counts
    std::string head = Parts().head;
    head.resize(head.size() - 4);
    Parts::put(head, entry, number);
    Parts::put(head, -1);
    return head;
  };
  const auto grains = [](std::initializer_list<double> numbers) {
    std::string bytes;
    Parts::put(bytes, static_cast<int>(numbers.size()));
    for (const double number : numbers) Parts::put(bytes, number);
    return bytes;
  };
  std::string foreign_version, fix_of_no_size = Parts().fixes;
  Parts::put_name(foreign_version, 0, "LAMMPS");
  fix_of_no_size.resize(fix_of_no_size.size() - 4);
  Parts::put(fix_of_no_size, -1);
  const std::vector<Bad> table{
      {"first entry", &Parts::version, ints({1}) + Parts().version.substr(4)},
      {"another program", &Parts::version, foreign_version},
      {"name of no length", &Parts::version, ints({0, 0})},
      {"name of negative length", &Parts::version, ints({0, -5})},
      {"name longer than the file", &Parts::version, ints({0, 2'000'000'000})},
      {"name without an end", &Parts::version, ints({0, 4}) + "abcd"},
      {"unknown entry", &Parts::head, head_with(52, 1)},
      {"no grains", &Parts::head, head_with(23, -1L)},
      {"no types", &Parts::head, head_with(24, 0)},
      {"many types", &Parts::head, head_with(24, 100'001)},
      {"no blocks", &Parts::head, head_with(7, 0)},
      {"more blocks", &Parts::head, head_with(7, 2)},
      {"more grains", &Parts::head, head_with(23, 3L)},
      {"fewer grains", &Parts::head, head_with(23, 1L)},
      {"no groups", &Parts::groups, ints({0})},
      {"fewer groups than it says", &Parts::groups, ints({1}) + std::string(4 * 32, '\0')},
      {"unknown entry of masses", &Parts::masses, ints({1})},
      {"unknown force field", &Parts::force_fields, ints({5})},
      {"state longer than the file", &Parts::fixes, ints({2'000'000'000})},
      {"state of negative length", &Parts::fixes, fix_of_no_size},
      {"block of no grains", &Parts::grains, grains({})},
      {"grain of no numbers", &Parts::grains, grains({0, 0, 0, 0, 0, 0, 0, 0, 0, 0})},
      {"grain of more than there are", &Parts::grains, grains({8, 1, 1, 1, 1, 1, 1, 1, 9})},
      {"grain of no number", &Parts::grains, grains({NAN, 1, 1, 1, 1, 1, 1, 1, 1})},
      {"block longer than the file", &Parts::grains, ints({2'000'000'000})},
      {"more behind the grains", &Parts::grains, Parts().grains + "x"},
  };
  for (const Bad& bad : table) {
    Parts parts;
    parts.*bad.part = bad.bytes;
    EXPECT_NE(refusal(parts.all()), "") << bad.what;
  }
}

// Only a style itself knows what it wrote, and what stands behind that: the seal alone speaks.
TEST_F(DamagedRestartFile, OfAnotherPairStyleIsTakenUnlessItsSealIsBroken)
{
  RestartParts parts;
  parts.force_fields.clear();
  RestartParts::put_name(parts.force_fields, 0, "lj/cut");
  EXPECT_EQ(refusal(parts.all()), "");
  std::string other = sealed(parts.all());
  EXPECT_EQ(refusal(other), "");
  other[other.size() - 40] ^= 1;
  EXPECT_NE(refusal(other), "");
}
