#include "output/pvd_collection.h"

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
  entries_.push_back({time, file});
}

std::string PvdCollection::text() const
{
  std::ostringstream xml;
  xml.precision(15);
  xml << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "  <Collection>\n";
  for (const PvdEntry& entry : entries_)
    xml << "    <DataSet timestep=\"" << entry.time << "\" part=\"0\" file=\""
        << xml_attribute(entry.file) << "\"/>\n";
  xml << "  </Collection>\n</VTKFile>\n";
  return xml.str();
}

}  // namespace encased_column
