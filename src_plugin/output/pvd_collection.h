#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// One file of a time series.
struct PvdEntry {
  double time;       ///< [s]
  std::string file;  ///< relative to the folder of the collection
};

/// A ParaView data collection: the list of files that make up one run, by time.
class PvdCollection {
 public:
  /// Adds a file. What is listed at this time [s] or later is dropped first: a run that goes back
  /// writes its files anew.
  void add(double time, const std::string& file);
  const std::vector<PvdEntry>& entries() const { return entries_; }
  /// The collection as XML.
  std::string text() const;

 private:
  std::vector<PvdEntry> entries_;
};

}  // namespace encased_column
