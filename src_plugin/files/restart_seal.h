// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

namespace encased_column {

/// A seal at the end of a restart file: where it is there, and right, no byte before it is missing
/// or changed. The host reads what it wrote and never comes to it.
struct RestartSeal {
  char mark[8] = {'E', 'N', 'C', 'S', 'E', 'A', 'L', '1'};
  std::uint64_t size = 0;  ///< bytes before the seal
  std::uint64_t sum = 0;   ///< over them: FNV-1a on words of 8 bytes
};

namespace seal_details {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

inline File open(const std::string& path, const char* mode)
{
  return {std::fopen(path.c_str(), mode), std::fclose};
}

/// Of the first `size` bytes of `file`, all of them if `size` is the largest number.
/// Source of the constants: Fowler, Noll, Vo, RFC draft "The FNV Non-Cryptographic Hash Algorithm".
inline RestartSeal seal_of(std::FILE* file, std::uint64_t size)
{
  RestartSeal seal;
  seal.sum = 14695981039346656037ull;
  std::array<char, 1 << 16> part;
  while (seal.size < size) {
    const std::uint64_t most = std::min<std::uint64_t>(part.size(), size - seal.size);
    const std::size_t found = std::fread(part.data(), 1, most, file);
    for (std::size_t n = 0; n < found; n += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, part.data() + n, std::min<std::size_t>(8, found - n));
      seal.sum = (seal.sum ^ word) * 1099511628211ull;
    }
    seal.size += found;
    if (found < most) break;
  }
  return seal;
}

}  // namespace seal_details

/// Puts the seal at the end of a finished file; false when that is impossible.
inline bool seal_file(const std::string& path)
{
  const auto file = seal_details::open(path, "rb+");
  if (!file) return false;
  const RestartSeal seal = seal_details::seal_of(file.get(), UINT64_MAX);
  return std::fseek(file.get(), 0, SEEK_END) == 0 &&
         std::fwrite(&seal, sizeof seal, 1, file.get()) == 1 && std::fflush(file.get()) == 0;
}

/// What a file ends with.
enum class SealFound { none, of_other_bytes, right };

inline SealFound seal_found(const std::string& path)
{
  const auto file = seal_details::open(path, "rb");
  RestartSeal there;
  if (!file || std::fseek(file.get(), -static_cast<long>(sizeof there), SEEK_END) != 0)
    return SealFound::none;
  const long size = std::ftell(file.get());
  if (std::fread(&there, sizeof there, 1, file.get()) != 1 ||
      std::memcmp(there.mark, RestartSeal().mark, sizeof there.mark) != 0)
    return SealFound::none;
  std::rewind(file.get());
  const RestartSeal right = seal_details::seal_of(file.get(), static_cast<std::uint64_t>(size));
  return there.size == right.size && there.sum == right.sum ? SealFound::right
                                                            : SealFound::of_other_bytes;
}

/// True for a file that ends with its seal.
inline bool is_sealed(const std::string& path)
{
  return seal_found(path) == SealFound::right;
}

}  // namespace encased_column
