// SPDX-License-Identifier: GPL-2.0-only
#include "files/mesh_bytes.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <optional>

namespace encased_column {

namespace {

/// No sleeve of at most a million facets needs an array of more bytes.
constexpr std::uint64_t most_bytes = 1'000'000'000;

std::size_t count_of(const std::string& words, const std::string& text)
{
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

// In bytes it tells its size, in text its end.
bool is_whole_stl(const std::string& text)
{
  constexpr std::size_t head = 84, facet = 50;
  if (text.size() >= head) {
    std::uint32_t facets;
    std::memcpy(&facets, text.data() + head - 4, sizeof(facets));
    if (text.size() == head + facet * facets) return true;
  }
  const std::size_t facets = count_of("facet normal", text);
  return text.compare(0, 5, "solid") == 0 && text.find('\0') == std::string::npos &&
         count_of("endfacet", text) == facets && count_of("vertex", text) == 3 * facets &&
         count_of("endsolid", text) > 0 &&
         text.find("facet", text.rfind("endsolid")) == std::string::npos;
}

/// Whole numbers of a .vtk file one after the other: words, or big-endian integers of 4 bytes.
class WholeNumbers {
 public:
  WholeNumbers(const std::string& text, std::size_t at)
      : at_(text.data() + at),
        end_(text.data() + text.size())
  {
  }
  std::optional<long> take() { return is_binary_ ? take_bytes() : take_word(); }
  void go_on_in_next_line(bool is_binary)
  {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_) ++at_;
    is_binary_ = is_binary;
  }

 private:
  std::optional<long> take_bytes()
  {
    if (end_ - at_ < 4) return std::nullopt;
    std::uint32_t number = 0;
    for (int n = 0; n < 4; ++n) number = number << 8 | static_cast<unsigned char>(*at_++);
    return static_cast<std::int32_t>(number);
  }
  std::optional<long> take_word()
  {
    char* behind;
    const long number = std::strtol(at_, &behind, 10);
    const bool is_word = behind != at_ && std::isspace(static_cast<unsigned char>(*behind));
    at_ = behind;
    return is_word ? std::optional(number) : std::nullopt;
  }

  const char *at_, *end_;
  bool is_binary_ = false;
};

// Up to version 4: "KEYWORD cells numbers", then of each cell how many points it names, and these.
bool has_sound_cells(const std::string& text, std::size_t behind_keyword, bool is_binary)
{
  WholeNumbers numbers(text, behind_keyword);
  const std::optional<long> cells = numbers.take(), size = numbers.take();
  if (!cells || !size) return false;
  numbers.go_on_in_next_line(is_binary);
  long left = *size;
  for (long cell = 0; cell < *cells; ++cell) {
    const std::optional<long> points = numbers.take();
    if (!points || *points < 0 || *points >= left) return false;
    for (long n = 0; n < *points; ++n)
      if (!numbers.take()) return false;
    left -= *points + 1;
  }
  return left == 0;
}

bool is_whole_vtk(const std::string& text)
{
  const std::string head = "# vtk DataFile Version ";
  if (text.size() < head.size() + 4 || text.compare(0, head.size(), head) != 0) return false;
  const char major = text[head.size()], point = text[head.size() + 1],
             minor = text[head.size() + 2], behind = text[head.size() + 3];
  if (major < '1' || major > '5' || point != '.' || minor < '0' || minor > '9' ||
      !std::isspace(static_cast<unsigned char>(behind)))
    return false;
  if (text.back() != '\n') return false;  // its last number may lack digits
  if (major == '5') return true;          // cells are arrays, with sizes of their own
  std::string lower = text;               // keywords are the same in capitals
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t title = lower.find('\n');
  const std::size_t form = lower.find('\n', title + 1);
  const bool is_binary = form != std::string::npos && lower.compare(form + 1, 6, "binary") == 0;
  for (const std::string keyword : {"\nvertices ", "\nlines ", "\npolygons ", "\ntriangle_strips "})
    for (auto at = lower.find(keyword); at != std::string::npos; at = lower.find(keyword, at + 1))
      if (!has_sound_cells(text, at + keyword.size(), is_binary)) return false;
  return true;
}

/// `count` bytes that stand as base64 from `at` on; fewer where the text ends.
std::string from_base64(const std::string& text, std::size_t at, std::size_t count)
{
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  for (int held = 0; at < text.size() && bytes.size() < count; ++at) {
    const std::size_t digit = digits.find(text[at]);
    if (digit == std::string::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held);
  }
  return bytes;
}

/// The value of `name` in an XML tag.
std::string attribute(const std::string& tag, const std::string& name)
{
  const std::string begin = ' ' + name + "=\"";
  const auto at = tag.find(begin);
  if (at == std::string::npos) return "";
  const auto first = at + begin.size();
  return tag.substr(first, tag.find('"', first) - first);
}

/// The arrays of a .vtp file that are compressed: number of blocks, bytes of each and of the last
/// one, then what each takes in the file.
class CompressedArrays {
 public:
  explicit CompressedArrays(const std::string& text) : text_(text)
  {
    const std::string file = tag("<VTKFile", 0);
    is_wide_ = attribute(file, "header_type") == "UInt64";
    is_big_endian_ = attribute(file, "byte_order") == "BigEndian";
    any_ = file.find(" compressor=") != std::string::npos;
    const auto appended = text.find("<AppendedData");
    if (appended == std::string::npos) return;
    is_raw_ = attribute(tag("<AppendedData", appended), "encoding") == "raw";
    appended_ = std::min(text.find('_', appended), text.size());
  }

  bool have_sound_sizes() const
  {
    const std::string begin = "<DataArray";
    for (auto at = text_.find(begin); any_ && at != std::string::npos && at < appended_;
         at = text_.find(begin, at + 1)) {
      const std::string array = tag(begin, at), format = attribute(array, "format");
      const std::size_t inside = text_.find_first_not_of(" \t\r\n", at + array.size() + 1);
      const std::size_t offset = std::strtoul(attribute(array, "offset").c_str(), nullptr, 10);
      if (format == "binary" && !has_sound_blocks(inside, false)) return false;
      if (format == "appended" &&
          !(offset < text_.size() && has_sound_blocks(appended_ + 1 + offset, is_raw_)))
        return false;
    }
    return true;
  }

 private:
  std::string tag(const std::string& begin, std::size_t from) const
  {
    const auto at = text_.find(begin, from);
    return at == std::string::npos ? "" : text_.substr(at, text_.find('>', at) - at);
  }
  bool has_sound_blocks(std::size_t at, bool is_raw) const
  {
    if (at >= text_.size()) return false;
    const std::uint64_t blocks = number(at, is_raw, 0);
    if (blocks == 0) return true;
    if (blocks > text_.size() || number(at, is_raw, 1) > most_bytes / blocks) return false;
    if (number(at, is_raw, 2) > most_bytes) return false;
    for (std::uint64_t n = 0; n < blocks; ++n)
      if (number(at, is_raw, 3 + n) > text_.size()) return false;
    return true;
  }
  /// The n-th number of the head of an array.
  std::uint64_t number(std::size_t at, bool is_raw, std::size_t n) const
  {
    const std::size_t width = is_wide_ ? 8 : 4;
    const std::size_t first = width * n, digits = first / 3 * 4, passed = first % 3;
    const std::string bytes =
        is_raw ? text_.substr(std::min(at + first, text_.size()), width)
               : from_base64(text_, at + digits, passed + width).erase(0, passed);
    if (bytes.size() < width) return UINT64_MAX;
    std::uint64_t found = 0;
    for (std::size_t k = 0; k < width; ++k)
      found = found << 8 | static_cast<unsigned char>(bytes[is_big_endian_ ? k : width - 1 - k]);
    return found;
  }

  const std::string& text_;
  bool any_ = false, is_wide_ = false, is_big_endian_ = false, is_raw_ = false;
  std::size_t appended_ = std::string::npos;
};

/// Each `name` in XML tags is a whole number up to `most`.
bool are_whole_numbers(const std::string& text, const std::string& name, double most)
{
  const std::string begin = ' ' + name + "=\"";
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const auto first = at + begin.size();
    const std::string number = text.substr(first, text.find('"', first) - first);
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos ||
        std::strtod(number.c_str(), nullptr) > most)
      return false;
  }
  return true;
}

bool is_whole_vtp(const std::string& text)
{
  for (const char* name : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips",
                           "NumberOfPolys", "NumberOfTuples"})
    if (!are_whole_numbers(text, name, most_bytes / 8.0)) return false;
  return are_whole_numbers(text, "NumberOfComponents", 100.0) &&
         text.find("</VTKFile>") != std::string::npos && CompressedArrays(text).have_sound_sizes();
}

}  // namespace

bool is_whole_mesh(const std::string& kind, const std::string& bytes)
{
  if (kind == ".stl") return is_whole_stl(bytes);
  if (kind == ".vtk") return is_whole_vtk(bytes);
  return is_whole_vtp(bytes);
}

}  // namespace encased_column
