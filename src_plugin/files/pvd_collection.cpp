// SPDX-License-Identifier: GPL-2.0-only
#include "files/pvd_collection.h"

#include <algorithm>
#include <sstream>

namespace encased_column {

namespace {

std::string xml_attribute(const std::string& text)
{
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

void PvdCollection::add(double time, const std::string& file)
{
  const auto first_later = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const PvdEntry& entry) { return entry.time >= time; });
  entries_.erase(first_later, entries_.end());
  entries_.push_back({time, file, 0, ""});
}

std::string pvd_text(const std::vector<PvdEntry>& entries)
{
  std::ostringstream xml;
  xml.precision(15);
  xml << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    xml << "    <DataSet timestep=\"" << entry.time << "\" part=\"" << entry.part << "\"";
    if (!entry.name.empty()) xml << " name=\"" << xml_attribute(entry.name) << "\"";
    xml << " file=\"" << xml_attribute(entry.file) << "\"/>\n";
  }
  xml << "  </Collection>\n</VTKFile>\n";
  return xml.str();
}

std::vector<PvdEntry> parts_together(const std::vector<PvdPart>& parts)
{
  std::vector<PvdEntry> together;
  for (std::size_t n = 0; n < parts.size(); ++n)
    for (const PvdEntry& entry : parts[n].entries)
      together.push_back(
          {entry.time, parts[n].folder + "/" + entry.file, static_cast<int>(n), parts[n].name});
  std::stable_sort(together.begin(), together.end(),
                   [](const PvdEntry& a, const PvdEntry& b) { return a.time < b.time; });
  return together;
}

}  // namespace encased_column
