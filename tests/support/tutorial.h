// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A fenced block of a tutorial that its reader is to follow. The first word behind the fence says
/// what it is:
///
///   sh               commands of a shell, which goes on from block to block
///   sh by_hand       the same, but too long for a test: not run
///   ANY file=NAME    text of a file, behind what blocks before have put into it
///   diff file=NAME from=OLD   the text of OLD without the lines that begin with -, each of which
///                    must stand there, and with those that begin with + in place of the last one
///   output           lines that the commands before it print, in this order; ... is any text
///
/// With `needs=NAME` a block is left out, and the output behind it, where neither a program nor a
/// module of Python has that name.
struct TutorialStep {
  int line = 0;  ///< of the page
  std::string kind;
  std::map<std::string, std::string> words;  ///< "file" and "needs"; a word alone stands for itself
  std::string text;
};

/// The steps of `page`, or of what stands there under the heading `section`, up to the next heading
/// of its rank. Throws std::runtime_error, with the line, for a block that does not end and for a
/// section that is not there.
std::vector<TutorialStep> read_steps(const std::filesystem::path& page,
                                     const std::string& section = "");

/// Follows `steps` as a user whose home is `home`, beginning in the folder `from`, and stops at the
/// first that fails. Returns what went wrong there, with the line of the page; empty if all is
/// well.
std::string follow(const std::vector<TutorialStep>& steps, const std::filesystem::path& home,
                   const std::filesystem::path& from);

/// Makes `home`/encased-columns, which stands for the folder of a user who has cloned and built the
/// project: it holds the sources and the build that is under test. Returns it.
std::filesystem::path clone_in(const std::filesystem::path& home);

/// Whether `line` is `pattern`, where ... stands for any text.
bool is_like(const std::string& line, const std::string& pattern);

}  // namespace encased_column::testing
