// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace encased_column {

/// Which loop over pairs applies the law: contacts side by side, one by one, or the host's own
/// template. All give the same forces; the last two are there to be compared with.
enum class PairLoop { batches, single, host };

/// Takes `loop WORD` out of the words of a pair style; batches where it is not there. Throws
/// InputError.
inline PairLoop take_pair_loop(std::vector<char*>& words)
{
  const auto keyword = std::find(words.begin(), words.end(), std::string("loop"));
  if (keyword == words.end()) return PairLoop::batches;
  const std::string value = keyword + 1 == words.end() ? "nothing" : *(keyword + 1);
  const std::vector<std::string> names{"batches", "single", "host"};
  const auto name = std::find(names.begin(), names.end(), value);
  if (name == names.end())
    throw InputError("'loop' must be batches, single or host, found '" + value +
                     "', write 'loop batches' or leave it out");
  words.erase(keyword, keyword + 2);
  return static_cast<PairLoop>(name - names.begin());
}

}  // namespace encased_column
