// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// One file of a time series.
struct PvdEntry {
  double time;            ///< [s]
  std::string file;       ///< relative to the folder of the collection
  int part = 0;           ///< of what is seen at that time
  std::string name = "";  ///< of the part; none where there is one part only
};

/// A list of files in the form that ParaView opens.
std::string pvd_text(const std::vector<PvdEntry>& entries);

/// A ParaView data collection: the list of files that make up one run, by time.
class PvdCollection {
 public:
  /// Adds a file. What is listed at this time [s] or later is dropped first: a run that goes back
  /// writes its files again.
  void add(double time, const std::string& file);
  const std::vector<PvdEntry>& entries() const { return entries_; }
  /// The collection as XML.
  std::string text() const { return pvd_text(entries_); }

 private:
  std::vector<PvdEntry> entries_;
};

/// One series among several that are seen together.
struct PvdPart {
  std::string name;
  std::string folder;  ///< of its files, relative to that of the collection
  std::vector<PvdEntry> entries;
};

/// The files of all parts, by time and, at one time, in the order of the parts.
std::vector<PvdEntry> parts_together(const std::vector<PvdPart>& parts);

}  // namespace encased_column
