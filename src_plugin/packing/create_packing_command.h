// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"
#include "packing/gradation.h"
#include "packing/placement.h"

#include <string>
#include <vector>

namespace encased_column {

struct PackingSummary;

/// Command `create_packing`: fills a cylinder with the grains of a gradation at reduced radius.
class CreatePackingCommand : protected LAMMPS_NS::Pointers {
 public:
  static const KeywordTable keywords;

  explicit CreatePackingCommand(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);

 private:
  void check_host(const Cylinder& cylinder, long type) const;
  /// At full size, as the deck gives it or a relative density asks for.
  double read_porosity(const Options& options, const Cylinder& cylinder, double finest) const;
  /// All of a small text file, read by rank 0.
  std::string read_file(const std::string& keyword, const std::string& file) const;
  void report(const Gradation& wanted, const std::vector<double>& diameters, double volume,
              const std::string& file) const;
  void print(const PackingSummary& summary) const;
  void create_atoms(const std::vector<Vec3>& centers, const std::vector<double>& radii, int type,
                    double density);
  void check_created(std::size_t wanted) const;
};

}  // namespace encased_column
