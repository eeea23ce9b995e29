// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

// The host keys contact models by six bits; its own normal models stop at 12. Ours live in 40..63.
constexpr int linear_model_number = 40;

static_assert(linear_model_number >= 40 && linear_model_number <= 63,
              "contact models of this plugin are numbered 40 to 63");

}  // namespace encased_column
