// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <csignal>

namespace encased_column {

/// Puts the signals back as they were when it goes: while runs are made they wait to be asked for,
/// while surrogates are fitted Ctrl-C ends the program at once, which loses nothing.
class SignalMask {
 public:
  SignalMask() { sigprocmask(SIG_BLOCK, nullptr, &before_); }
  ~SignalMask() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalMask(const SignalMask&) = delete;
  SignalMask& operator=(const SignalMask&) = delete;

 private:
  sigset_t before_;
};

}  // namespace encased_column
