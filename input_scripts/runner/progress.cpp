// SPDX-License-Identifier: GPL-2.0-only
#include "runner/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace encased_column {

namespace {

std::optional<double> number_of(const std::string& word)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  if (word.empty() || *end || !std::isfinite(x)) return std::nullopt;
  return x;
}

/// A stage that ends where a ratio has fallen to its limit.
class FallingRatio {
 public:
  Progress at(const std::string& stage, double from, double to, double ratio, double limit)
  {
    if (stage != stage_) {
      stage_ = stage;
      largest_ = 0.0;
      best_ = 0.0;
    }
    if (ratio > largest_) {  // while a stress is raised the ratio rises with it
      largest_ = ratio;
      best_ = 0.0;
    }
    if (ratio > 0.0 && limit > 0.0 && largest_ > limit)
      best_ = std::max(best_, std::log(largest_ / ratio) / std::log(largest_ / limit));
    best_ = std::clamp(best_, 0.0, 1.0);
    return {from + (to - from) * best_, stage};
  }

 private:
  std::string stage_;
  double largest_ = 0.0, best_ = 0.0;
};

}  // namespace

Progress read_progress(const std::string& text)
{
  Progress last;
  FallingRatio falling;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (stream.eof()) break;  // the line that is being written
    std::istringstream words(line);
    std::vector<std::string> word;
    for (std::string w; words >> w;) word.push_back(w);
    if (word.size() < 2) continue;
    const auto first = number_of(word[0]);
    if (!first) continue;
    const auto second = number_of(word[1]);
    if (word.size() == 6 && second && word[3] == "ratio") {
      const auto ratio = number_of(word[4]), limit = number_of(word[5]);
      if (ratio && limit) last = falling.at(word[2], *first, *second, *ratio, *limit);
    } else if (word.size() == 2 && !second)
      last = {*first, word[1]};
    last.fraction = std::clamp(last.fraction, 0.0, 1.0);
  }
  return last;
}

std::string in_time(double seconds)
{
  const long s = std::lround(std::clamp(seconds, 0.0, 1e9));
  char text[40];
  if (s >= 3600)
    std::snprintf(text, sizeof text, "%ld h %02ld min", s / 3600, s % 3600 / 60);
  else if (s >= 90)
    std::snprintf(text, sizeof text, "%ld min", (s + 30) / 60);
  else
    std::snprintf(text, sizeof text, "%ld s", s);
  return text;
}

std::vector<std::string> progress_lines(const std::vector<RunningCase>& running,
                                        const std::vector<CaseClock>& clocks, int jobs)
{
  const auto percent = [](double fraction) {
    return std::to_string(static_cast<int>(100.0 * fraction)) + " %";
  };
  std::size_t widest = 0;
  for (const RunningCase& one : running) widest = std::max(widest, one.id.size());
  std::vector<std::string> lines;
  for (const RunningCase& one : running)
    lines.push_back(one.id + std::string(widest - one.id.size(), ' ') + "  " +
                    percent(one.progress.fraction) + ' ' + one.progress.stage);
  double work = 0.0, done = 0.0;
  long ended = 0;
  for (const CaseClock& clock : clocks) {
    work += clock.work;
    done += clock.work * (clock.ended ? 1.0 : clock.fraction);
    ended += clock.ended;
  }
  std::string whole = std::to_string(ended) + " of " + std::to_string(clocks.size()) + " ended, " +
                      percent(work > 0.0 ? done / work : 1.0) + " done";
  if (const auto left = seconds_left(clocks, jobs)) whole += ", " + in_time(*left) + " left";
  lines.push_back(whole);
  return lines;
}

std::string stopped_line(const Left& left)
{
  const std::string again = left.series ? "; the same command " : "; --resume ";
  std::string line = "Stopped";
  if (!left.resumable.empty()) {
    line += again + "goes on with";
    for (std::size_t n = 0; n < left.resumable.size(); ++n)
      line += (n ? ", " : " ") + left.resumable[n].first + " from stage " +
              std::to_string(left.resumable[n].second);
  }
  if (!left.begin_again.empty()) {
    line += left.resumable.empty() ? again + "begins again with" : ", and begins again with";
    for (std::size_t n = 0; n < left.begin_again.size(); ++n)
      line += (n ? ", " : " ") + left.begin_again[n];
  }
  if (left.resumable.empty() && left.begin_again.empty() && left.tables_missing)
    line += again + "makes the tables: all cases have ended";
  return line;
}

}  // namespace encased_column
