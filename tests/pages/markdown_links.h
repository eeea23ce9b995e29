// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A link or picture of a page.
struct Link {
  int line = 0;
  std::string target;
};

/// Links and pictures of a Markdown page, in its own way or that of HTML, without those in blocks
/// and spans of code and without those to other hosts.
std::vector<Link> local_links(const std::vector<std::string>& lines);

/// The names under which GitHub finds the headings of a page: "## On paper: a cluster" is
/// "on-paper-a-cluster".
std::vector<std::string> heading_names(const std::vector<std::string>& lines);

/// What is wrong with a link of `page`, empty if nothing: its file must exist, and the heading
/// after '#' must stand on that page.
std::string problem_with(const std::string& target, const std::filesystem::path& page);

/// The Markdown pages below `root`, but for what builds, runs and hidden folders hold.
std::vector<std::filesystem::path> pages_below(const std::filesystem::path& root);

/// A sentence for each link of the pages below `root` that something is wrong with.
std::vector<std::string> broken_links(const std::filesystem::path& root);

}  // namespace encased_column::testing
