// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"
#include "files/restart_seal.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace encased_column {

[[noreturn]] inline void refuse_restart_file(const std::string& file, const std::string& found)
{
  throw InputError("'read_restart' must name a whole restart file, found '" + file + "', " + found +
                   ", write the name of another one");
}

/// The bytes of a restart file, taken one number or name after the other.
class RestartBytes {
 public:
  explicit RestartBytes(const std::string& file) : file_(file)
  {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
      refuse_restart_file(file, "which is no file that can be read");
    stream_.open(file, std::ios::binary);
    left_ = static_cast<std::int64_t>(std::filesystem::file_size(file, none));
    if (!stream_ || none) refuse_restart_file(file, "which is no file that can be read");
  }

  template <typename Number>
  Number take()
  {
    Number number;
    take(&number, sizeof(number));
    return number;
  }
  void skip(std::int64_t bytes)
  {
    spend(bytes);
    stream_.seekg(bytes, std::ios::cur);
  }
  /// A number of things of at least `bytes` each that are still to come.
  std::int64_t take_count(std::int64_t bytes)
  {
    const auto count = take<std::int32_t>();
    if (count < 0) strange();
    if (count * bytes > left_) cut_off();
    return count;
  }
  std::string take_name()
  {
    std::string name(static_cast<std::size_t>(take_count(1)), '\0');
    take(name.data(), static_cast<std::int64_t>(name.size()));
    if (name.empty() || name.find('\0') != name.size() - 1) strange();
    name.pop_back();
    return name;
  }
  std::vector<double> take_numbers(std::int64_t count)
  {
    if (count * 8 > left_) cut_off();
    std::vector<double> numbers(static_cast<std::size_t>(count));
    take(numbers.data(), 8 * count);
    return numbers;
  }

  /// What is left may be the seal of the bytes before it (RestartSeal), and nothing else.
  void take_end() const
  {
    if (left_ > 0 && !is_sealed(file_)) refuse_restart_file(file_, "which is cut off or damaged");
  }

  [[noreturn]] void cut_off() const { refuse_restart_file(file_, "which is cut off"); }
  [[noreturn]] void strange() const
  {
    refuse_restart_file(file_, "which is damaged or no restart file");
  }

 private:
  void spend(std::int64_t bytes)
  {
    left_ -= bytes;
    if (left_ < 0) cut_off();
  }
  void take(void* to, std::int64_t bytes)
  {
    spend(bytes);
    if (!stream_.read(static_cast<char*>(to), bytes)) cut_off();
  }

  std::string file_;
  std::ifstream stream_;
  std::int64_t left_;
};

}  // namespace encased_column
