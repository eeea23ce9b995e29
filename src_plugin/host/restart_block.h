#pragma once

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace encased_column {

/// Writes a fix's block of a restart file: its size, as the host asks for, numbers, then a text.
inline void write_block(FILE* file, const std::vector<double>& numbers, const std::string& text)
{
  const int size = static_cast<int>(numbers.size() * sizeof(double) + text.size() + 1);
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(numbers.data(), sizeof(double), numbers.size(), file);
  std::fwrite(text.c_str(), 1, text.size() + 1, file);
}

/// Takes a block of write_block() apart, in the order in which it was written.
class RestartBlock {
 public:
  explicit RestartBlock(const char* block) : at_(block) {}

  void take(double* numbers, std::size_t count)
  {
    std::memcpy(numbers, at_, count * sizeof(double));
    at_ += count * sizeof(double);
  }
  double take()
  {
    double number;
    take(&number, 1);
    return number;
  }
  /// What follows the numbers.
  const char* text() const { return at_; }

 private:
  const char* at_;
};

}  // namespace encased_column
