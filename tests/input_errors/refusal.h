// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <gtest/gtest.h>

namespace encased_column::testing {

/// Expects that `lines`, put after the opening deck, end the program before its first step with an
/// exit code that is not 0 and `sentence` on the screen; on two ranks too, where no rank may be
/// left waiting.
inline void expect_refused(const std::string& opening, const std::string& lines,
                           const std::string& sentence)
{
  for (const int ranks : {1, 2}) {
    const Outcome outcome = run_deck(opening_deck(opening) + lines, ranks);
    EXPECT_NE(outcome.exit_code, 0) << "on " << ranks << " ranks";
    EXPECT_TRUE(outcome.says(sentence)) << sentence << "\nnot in\n" << outcome.output;
    EXPECT_FALSE(outcome.says("Loop time")) << "refused after the first step, not before";
  }
}

}  // namespace encased_column::testing
