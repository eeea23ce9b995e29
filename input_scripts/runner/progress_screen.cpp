// SPDX-License-Identifier: GPL-2.0-only
#include "runner/progress_screen.h"

#include <unistd.h>

#include <iostream>

#include <sys/ioctl.h>

namespace encased_column {

namespace {

using Clock = std::chrono::steady_clock;

/// A line that wraps could not be written over.
std::size_t columns_of_terminal()
{
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return 80;
  return size.ws_col;
}

}  // namespace

ProgressScreen::ProgressScreen() : on_terminal_(isatty(STDOUT_FILENO)), spoken_(Clock::now()) {}

bool ProgressScreen::is_due() const
{
  return Clock::now() - spoken_ >= std::chrono::seconds(on_terminal_ ? 1 : 30);
}

void ProgressScreen::show(const std::vector<std::string>& lines)
{
  spoken_ = Clock::now();
  clear();
  const std::size_t most = on_terminal_ ? columns_of_terminal() - 1 : std::string::npos;
  for (const std::string& line : lines) std::cout << line.substr(0, most) << '\n';
  std::cout << std::flush;
  if (on_terminal_) shown_ = lines.size();
}

void ProgressScreen::clear()
{
  if (shown_ > 0) std::cout << "\033[" << shown_ << "A\r\033[J" << std::flush;
  shown_ = 0;
}

}  // namespace encased_column
