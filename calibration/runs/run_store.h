// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runs/run_result.h"

#include <Eigen/Dense>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace encased_column {

/// A point of the unit cube that is run.
struct StoredPoint {
  int id = 0;         ///< from 0, in the order they came
  std::string stage;  ///< "design", "morris" or "candidate"
  int round = 0;      ///< of candidates
  int repeats = 1;    ///< packings it is run with
  Eigen::VectorXd point;
};

/// One run: a case at a point with one packing.
struct RunKey {
  int point = 0, repeat = 0;
  std::string name;  ///< of the case

  bool operator<(const RunKey& other) const
  {
    return std::tie(point, repeat, name) < std::tie(other.point, other.repeat, other.name);
  }
};

/// Points and runs of a calibration in one SQLite file. Each change is whole or not there at all,
/// whatever ends the program.
class RunStore {
 public:
  /// Opens `file`, which is made if there is none; ":memory:" keeps it in memory. Throws InputError
  /// if that is impossible.
  explicit RunStore(const std::filesystem::path& file);
  ~RunStore();
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;

  /// Keeps `identity`, lines that say what the runs are of, or compares it with what is kept.
  /// Throws InputError that names the first line that differs.
  void identify(const std::string& identity);

  /// Adds all of them or none; their ids follow those that are there.
  void add_points(const std::vector<StoredPoint>& points);
  std::vector<StoredPoint> points() const;

  /// Adds a run, or takes the place of what was known of it.
  void record(const RunKey& key, const RunResult& result);
  std::map<RunKey, RunResult> runs() const;
  long run_count() const;
  /// Forgets runs that failed, so that they are made again.
  void forget_failed();

 private:
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace encased_column
