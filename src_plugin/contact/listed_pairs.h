// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace encased_column {

/// The pairs of a neighbour list one after the other, and what those of them remember that have
/// touched since it was made. A list of grains with a row each would cost a branch that the
/// processor mispredicts at the end of most of the rows, and memory for every listed pair more than
/// twice that of the pairs that touch, spread as wide.
class ListedPairs {
 public:
  /// Begins a new list, of contacts that remember `numbers` numbers each, among them at `place` the
  /// step they were last seen.
  void start(int numbers, int place)
  {
    first_.clear();
    second_.clear();
    rows_ = std::vector<int>();  // leaves its memory to what finds the pairs: `= {}` would not
    memories_ = std::vector<double>();
    numbers_ = numbers;
    place_ = place;
  }
  void add(int i, int j)
  {
    first_.push_back(i);
    second_.push_back(j);
  }
  /// Once all pairs are there: none remembers anything. Memories never move until the next list, as
  /// there is room for those of all, and some to come; the machine gives memory only to those that
  /// are written.
  void end()
  {
    rows_.assign(first_.size(), none);
    memories_.reserve((first_.size() + first_.size() / 8) * numbers_);
  }
  /// Adds those of `more` that are not there yet, where pairs are in the order of their first
  /// grains; they remember nothing. Memories may move.
  void insert(std::vector<std::pair<int, int>> more);

  int size() const { return static_cast<int>(first_.size()); }
  const int* first() const { return first_.data(); }
  /// How many pairs have i as their first grain, where they are in that order.
  int in_row_of(int i) const
  {
    const auto [begin, end] = std::equal_range(first_.begin(), first_.end(), i);
    return static_cast<int>(end - begin);
  }
  int* second() { return second_.data(); }
  const int* second() const { return second_.data(); }
  std::size_t bytes() const
  {
    return 3 * rows_.size() * sizeof(int) + memories_.size() * sizeof(double);
  }

  /// What pair n remembers; zeros where it has not touched yet.
  double* memory(int n)
  {
    if (rows_[n] == none) rows_[n] = new_row();
    return memories_.data() + static_cast<std::size_t>(rows_[n]) * numbers_;
  }
  /// What pair n remembers, where it touched in the last step that memories were advanced in; null
  /// for the others.
  const double* memory_of_touching(int n) const
  {
    if (rows_[n] == none) return nullptr;
    const double* const memory = memories_.data() + static_cast<std::size_t>(rows_[n]) * numbers_;
    return memory[place_] == last_step_ ? memory : nullptr;
  }
  /// Pair n touched in the last step before this list was made, and remembers `memory`.
  void restore(int n, const double* memory)
  {
    std::copy_n(memory, numbers_, this->memory(n));
    last_step_ = std::max(last_step_, memory[place_]);
  }
  /// Memories were advanced in the step that ends at number `step`.
  void set_step(double step) { last_step_ = step; }

 private:
  static constexpr int none = -1;

  int new_row()
  {
    const std::size_t begin = memories_.size();
    memories_.resize(begin + numbers_, 0.0);
    return static_cast<int>(begin / numbers_);
  }

  bool has(const std::pair<int, int>& pair) const
  {
    const auto [begin, end] = std::equal_range(first_.begin(), first_.end(), pair.first);
    const auto row_end = second_.begin() + (end - first_.begin());
    return std::find(second_.begin() + (begin - first_.begin()), row_end, pair.second) != row_end;
  }

  std::vector<int> first_, second_;  ///< the grains of each pair
  std::vector<int> rows_;            ///< of each pair in the memories, or none
  std::vector<double> memories_;
  int numbers_ = 1, place_ = 0;
  double last_step_ = -1.0;
};

// From the last one on, so that each pair moves once.
inline void ListedPairs::insert(std::vector<std::pair<int, int>> more)
{
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  more.erase(
      std::remove_if(more.begin(), more.end(), [this](const auto& pair) { return has(pair); }),
      more.end());
  std::size_t from = first_.size(), to = from + more.size();
  first_.resize(to);
  second_.resize(to);
  rows_.resize(to);
  memories_.reserve(to * numbers_);
  for (; !more.empty(); --to) {
    if (from > 0 && first_[from - 1] > more.back().first) {
      --from;
      first_[to - 1] = first_[from];
      second_[to - 1] = second_[from];
      rows_[to - 1] = rows_[from];
    } else {
      std::tie(first_[to - 1], second_[to - 1]) = more.back();
      rows_[to - 1] = none;
      more.pop_back();
    }
  }
}

}  // namespace encased_column
