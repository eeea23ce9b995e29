// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace encased_column {

/// 64-bit FNV-1a.
inline std::uint64_t checksum_of(const char* bytes, std::size_t count)
{
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char* end = bytes + count; bytes != end; ++bytes)
    sum = (sum ^ static_cast<unsigned char>(*bytes)) * 0x100000001b3;
  return sum;
}

/// Begin of a fix's block in a restart file: enough to tell a block of this layout that is whole.
struct RestartBlockHead {
  static constexpr std::uint64_t mark = 0x314b4c4245534e45;  // "ENSEBLK1"

  std::uint64_t layout = mark;
  std::uint64_t numbers = 0, letters = 0;  ///< how many follow, the text with its closing 0
  std::uint64_t body_sum = 0;              ///< checksum of their bytes
  std::uint64_t head_sum = 0;              ///< of the fields above

  std::uint64_t sum() const { return checksum_of(reinterpret_cast<const char*>(this), 4 * 8); }
};

/// The block of a fix: numbers, then a text.
inline std::string restart_block(const std::vector<double>& numbers, const std::string& text = "")
{
  std::string body(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  body.append(text.c_str(), text.size() + 1);
  RestartBlockHead head;
  head.numbers = numbers.size();
  head.letters = text.size() + 1;
  head.body_sum = checksum_of(body.data(), body.size());
  head.head_sum = head.sum();
  return std::string(reinterpret_cast<const char*>(&head), sizeof(head)) + body;
}

/// Writes a block, and before it its size, as the host asks for.
inline void write_block(FILE* file, const std::vector<double>& numbers,
                        const std::string& text = "")
{
  const std::string block = restart_block(numbers, text);
  const int size = static_cast<int>(block.size());
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(block.data(), 1, block.size(), file);
}

/// Takes a block of write_block() apart, in the order in which it was written.
class RestartBlock {
 public:
  /// Throws InputError where the block is cut off or of another layout. The host does not say how
  /// long the block is: a head that is not ours is not followed.
  explicit RestartBlock(const char* block)
  {
    RestartBlockHead head;
    std::memcpy(&head, block, sizeof(head));
    if (head.layout != RestartBlockHead::mark)
      refuse("one of another version of the program or of another fix");
    at_ = block + sizeof(head);
    left_ = head.numbers;
    if (head.head_sum != head.sum() ||
        checksum_of(at_, head.numbers * sizeof(double) + head.letters) != head.body_sum)
      refuse("one that is cut off or damaged");
  }

  /// How many numbers are left.
  std::size_t left() const { return left_; }
  void take(double* numbers, std::size_t count)
  {
    if (count > left_) refuse("one with fewer numbers than it must have");
    std::memcpy(numbers, at_, count * sizeof(double));
    at_ += count * sizeof(double);
    left_ -= count;
  }
  double take()
  {
    double number;
    take(&number, 1);
    return number;
  }
  /// What follows the numbers.
  const char* text() const { return at_ + left_ * sizeof(double); }

 private:
  [[noreturn]] static void refuse(const std::string& found)
  {
    throw InputError("its part of the restart file must be whole and of this version, found " +
                     found + ", go on from another file or start the test again");
  }

  const char* at_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace encased_column
