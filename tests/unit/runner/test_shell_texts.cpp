// SPDX-License-Identifier: GPL-2.0-only
// Pages of `man` and completions of shells come from the options of a command line; bash itself is
// asked what it makes of them.
#include "runner/completion.h"
#include "runner/manual_page.h"
#include "support/child_program.h"

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;

namespace {

/// A program with one command.
class ShellTexts : public ::testing::Test {
 protected:
  ShellTexts()
  {
    CLI::App* const run = app_.add_subcommand("run", "Runs it: [all]");
    run->add_flag("--fast", fast_, "it's quick");
    run->add_option("--input", text_, "what it reads")->type_name("FILE");
    run->add_option("--end", text_, "which end")->check(CLI::IsMember({"top", "bottom"}));
    run->footer(".starts with a dot\nand a \\ sign");
    app_.add_subcommand("list", "Lists it");
  }

  /// What bash would offer behind these words.
  std::string offered(const std::vector<std::string>& words) const
  {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "completion") << bash_completion(app_);
    std::ofstream(folder.path() / "a_file");
    std::string script = ". ./completion; COMP_WORDS=(encase";
    for (const std::string& word : words) script += " '" + word + "'";
    script += "); COMP_CWORD=" + std::to_string(words.size()) + "; _encase; echo ${COMPREPLY[@]}";
    return run_program({"bash", "-c", script}, folder.path()).output;
  }

  CLI::App app_{"A program", "encase"};
  bool fast_ = false;
  std::string text_;
};

}  // namespace

TEST_F(ShellTexts, BashOffersCommandsOptionsAndValues)
{
  EXPECT_EQ(offered({""}), "run list --help\n");
  EXPECT_EQ(offered({"r"}), "run\n");
  EXPECT_EQ(offered({"run", "--"}), "--help --fast --input --end\n");
  EXPECT_EQ(offered({"run", "--end", "t"}), "top\n");
  EXPECT_EQ(offered({"run", "--input", "a_"}), "a_file\n");
  EXPECT_EQ(offered({"list", "--"}), "--help\n");
}

TEST_F(ShellTexts, ManualPagesHaveEveryOptionAndKeepTheSignsOfRoff)
{
  const std::string page = manual_page(*app_.get_subcommand("run"), "encase run", "version 1.2");
  const auto has = [&](const std::string& text) {
    EXPECT_NE(page.find(text), std::string::npos) << text << "\nin\n" << page;
  };
  has(".TH ENCASE\\-RUN 1 \"\" \"version 1.2\"");
  has("encase\\-run \\- Runs it: [all]\n");
  has(".TP\n\\fB\\-\\-fast\\fR\nit's quick\n");
  has(".TP\n\\fB\\-\\-input\\fR \\fIFILE\\fR\nwhat it reads\n");
  has("\n\\&.starts with a dot\nand a \\e sign\n");
  const std::string of_program = manual_page(app_, "encase", "");
  EXPECT_NE(of_program.find("\\fBlist\\fR\nLists it: see encase\\-list(1)\n"), std::string::npos)
      << of_program;
}

// zsh is not on every machine; its own check of the syntax where it is.
TEST_F(ShellTexts, ZshReadsItsCompletion)
{
  const std::string text = zsh_completion(app_);
  EXPECT_EQ(text.rfind("#compdef encase\n", 0), 0u);
  EXPECT_NE(text.find("'*--fast[it'\\''s quick]'"), std::string::npos) << text;
  EXPECT_NE(text.find("'*--end[which end]:value:(top bottom)'"), std::string::npos) << text;
  EXPECT_NE(text.find("'run:Runs it\\: \\[all\\]'"), std::string::npos) << text;
  const TemporaryFolder folder;
  if (run_program({"sh", "-c", "command -v zsh"}, "/").exit_code != 0) GTEST_SKIP() << "no zsh";
  std::ofstream(folder.path() / "_encase") << text;
  const Outcome outcome = run_program({"zsh", "-n", "_encase"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}
