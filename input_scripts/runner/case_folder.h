// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_record.h"
#include "runner/deck.h"
#include "runner/places.h"
#include "runner/progress.h"
#include "runner/resume_decision.h"
#include "runner/series.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// One case as it is to be run.
struct CasePlan {
  Case row;
  const Deck* deck;
  Settings given;  ///< what the host is told
  Settings asked;  ///< all variables of the deck, as they must be used
};

/// The run folder of a case: what lies in it, what is put into it.
class CaseFolder {
 public:
  CaseFolder(std::filesystem::path folder, CasePlan plan)
      : folder_(std::move(folder)),
        plan_(std::move(plan))
  {
  }

  const std::filesystem::path& path() const { return folder_; }
  const CasePlan& plan() const { return plan_; }
  const std::string& id() const { return plan_.row.id; }

  FolderState state() const;
  /// The last stage with a whole restart file, 0 without.
  int last_stage() const;

  /// Empties the folder and puts in what repeats the case.
  void fill() const;
  /// Makes a folder ready that was begun before, to go on in `stage`.
  void make_ready_for(int stage) const;
  /// Adds to versions.txt and command.txt how this start was made.
  void note_start(const std::string& versions, const std::vector<std::string>& command) const;
  /// The words that start the host in this folder; stage 0 from the beginning.
  std::vector<std::string> command(const Places& places, int ranks, int stage) const;

  /// True once the run has said which variables it uses; they are then in case.json. Throws
  /// InputError if they are others than asked for.
  bool confirm_variables() const;
  Progress progress() const;
  /// True if the log ends with the words of a run that a signal has ended.
  bool was_stopped() const;
  /// What the end of the log or the screen says of an error.
  std::string last_words() const;
  void note_finished(long seconds) const;
  /// Keeps for later starts why the case failed: `sentence`, shorter where the host said why.
  void note_failed(const std::string& sentence) const;

 private:
  CaseRecord record(const Settings& used) const;
  void copy_inputs() const;

  std::filesystem::path folder_;
  CasePlan plan_;
};

}  // namespace encased_column
