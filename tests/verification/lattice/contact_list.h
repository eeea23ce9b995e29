// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "support/child_program.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace encased_column::testing {

/// Stands before the first run of a deck that ends with write_contacts.
inline const std::string find_contacts = "compute contacts all pair/gran/local pos id force\n";

/// Lines that write the contacts between grains, and the grains, as they are at the last step.
inline const std::string write_contacts =
    "dump contacts all local 1 contacts.txt c_contacts[1] c_contacts[2] c_contacts[3] "
    "c_contacts[4] c_contacts[5] c_contacts[6] c_contacts[7] c_contacts[8] c_contacts[9] "
    "c_contacts[10] c_contacts[11] c_contacts[12]\n"
    "dump_modify contacts format \"%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g "
    "%.17g %.17g\"\n"
    "dump grains all custom 1 grains.txt id radius x y z fx fy fz\n"
    "dump_modify grains sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
    "run 0\n";

/// Two grains that touch.
struct GrainContact {
  int i, j;      ///< ids
  Vec3 branch;   ///< from i to j [m]
  Vec3 force_i;  ///< on i [N]
};

struct Grain {
  double radius;
  Vec3 center, force;
};

/// Rows of the only frame in a dump.
inline std::vector<std::vector<double>> dump_rows(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  std::vector<std::vector<double>> rows;
  bool within = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("ITEM:", 0) == 0) {
      within = line.rfind("ITEM: ATOMS", 0) == 0 || line.rfind("ITEM: ENTRIES", 0) == 0;
      continue;
    }
    if (!within) continue;
    std::istringstream numbers(line);
    rows.emplace_back();
    for (double number; numbers >> number;) rows.back().push_back(number);
  }
  if (rows.empty()) throw std::runtime_error("nothing in " + file.string());
  return rows;
}

inline std::vector<GrainContact> contacts_in(const std::filesystem::path& folder)
{
  std::vector<GrainContact> contacts;
  for (const auto& r : dump_rows(folder / "contacts.txt"))
    contacts.push_back({static_cast<int>(r.at(6)),
                        static_cast<int>(r.at(7)),
                        {r.at(3) - r.at(0), r.at(4) - r.at(1), r.at(5) - r.at(2)},
                        {r.at(9), r.at(10), r.at(11)}});
  return contacts;
}

/// In the order of their ids, which count from 1.
inline std::vector<Grain> grains_in(const std::filesystem::path& folder)
{
  std::vector<Grain> grains;
  for (const auto& r : dump_rows(folder / "grains.txt"))
    grains.push_back({r.at(1), {r.at(2), r.at(3), r.at(4)}, {r.at(5), r.at(6), r.at(7)}});
  return grains;
}

/// Love-Weber sum over contacts between grains [N m]: divided by a volume it is their part of the
/// stress, positive in compression.
inline Mat3 love_weber_sum(const std::vector<GrainContact>& contacts)
{
  Mat3 sum = Mat3::Zero();
  for (const GrainContact& c : contacts) sum -= c.force_i * c.branch.transpose();
  return sum;
}

}  // namespace encased_column::testing
