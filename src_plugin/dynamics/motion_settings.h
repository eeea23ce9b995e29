// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"

#include <limits>

namespace encased_column {

/// What a deck says of the motion.
struct MotionSettings {
  static const KeywordTable keywords;

  double damping = 0.7;  ///< alpha [-]
  double step = 0.0;     ///< of density scaling [s]; 0: the stable step of the true masses
  double safety = 0.8;   ///< fraction of the stable step [-]
  int every = 50;        ///< steps
  double free_speed = std::numeric_limits<double>::infinity();  ///< [m/s]

  /// Of a fix line; throws InputError.
  static MotionSettings read(const Options& options);
  /// Of a `fix_modify` of the fix `id`; throws InputError.
  void modify(const Options& options, const char* id);

 private:
  void read_changeable(const Options& options);
};

}  // namespace encased_column
