// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_folder.h"

#include "core/input_error.h"
#include "files/restart_seal.h"
#include "runner/case_variables.h"
#include "runner/last_words.h"
#include "runner/text_file.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

fs::path restart_file(const fs::path& folder, int stage)
{
  return folder / ("restart_" + std::to_string(stage));
}

/// A folder in which cases were run has their lock.
bool holds_runs(const fs::path& folder)
{
  return fs::exists(folder / ".lock") || folder.filename() == "runs";
}

/// Copies what a user's deck may read: all beside it but results of runs and what is hidden.
void copy_folder(const fs::path& from, const fs::path& to)
{
  constexpr int most_files = 1000;
  constexpr std::uintmax_t most_bytes = 200'000'000;
  std::uintmax_t bytes = 0;
  int files = 0;
  for (auto entry = fs::recursive_directory_iterator(from); entry != fs::end(entry); ++entry) {
    const fs::path& path = entry->path();
    if (entry->is_directory() && (holds_runs(path) || path.filename().string().front() == '.')) {
      entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file()) continue;
    bytes += entry->file_size();
    if (++files > most_files || bytes > most_bytes)
      throw InputError(
          "the folder of --deck must hold the deck's own files only, at most 1000 and "
          "200 MB, found more in '" +
          shown(from) + "', give the deck a folder of its own");
    const fs::path target = to / path.lexically_relative(from);
    fs::create_directories(target.parent_path());
    fs::copy_file(path, target, fs::copy_options::overwrite_existing);
  }
}

}  // namespace

FolderState CaseFolder::state() const
{
  FolderState state;
  state.begun = fs::exists(folder_ / "case.json");
  state.finished = fs::exists(folder_ / "finished");
  std::ifstream reason(folder_ / "failed");
  std::getline(reason, state.failed);
  for (int stage = 1; stage <= 9; ++stage)
    if (fs::exists(restart_file(folder_, stage)))
      (is_sealed(restart_file(folder_, stage)) ? state.whole : state.broken).push_back(stage);
  if (!state.begun) return state;
  try {
    const CaseRecord there = read_case_record(folder_ / "case.json");
    const Difference difference = first_difference(there.asked, plan_.asked);
    state.there = difference.there;
    state.now = difference.now;
    if (!difference && there.deck != plan_.deck->name) {
      state.there = "deck " + there.deck;
      state.now = "deck " + plan_.deck->name;
    }
  } catch (const InputError& problem) {
    state.unreadable = problem.what();
  }
  return state;
}

int CaseFolder::last_stage() const
{
  for (int stage = 9; stage > 0; --stage)
    if (is_sealed(restart_file(folder_, stage))) return stage;
  return 0;
}

CaseRecord CaseFolder::record(const Settings& used) const
{
  return {id(), plan_.deck->name, plan_.row.title, plan_.row.reproduces, plan_.asked, used};
}

// Whatever ends us half way, what is left is no case yet, and begins again.
void CaseFolder::fill() const
{
  fs::remove(folder_ / "case.json");
  for (const auto& entry : fs::directory_iterator(folder_))
    if (entry.path().filename() != ".lock") fs::remove_all(entry.path());
  copy_inputs();
  write_case_record(folder_ / "case.json", record({}));
}

void CaseFolder::copy_inputs() const
{
  const fs::path input = folder_ / "input";
  const auto over = fs::copy_options::overwrite_existing | fs::copy_options::recursive;
  fs::create_directories(input);
  fs::copy(plan_.deck->common, input / "common", over);
  if (plan_.deck->ours)
    fs::copy_file(plan_.deck->file, input / plan_.deck->file.filename());
  else
    copy_folder(plan_.deck->file.parent_path(), input);
}

// Keeps the deck, the results and the logs so far. What the host wrote at a signal goes: from the
// restart file of the stage, which is older, a run goes on bit by bit, from the host's it does not.
void CaseFolder::make_ready_for(int stage) const
{
  std::vector<fs::path> old;
  int logs = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename();
    if (name.rfind("restart_forced_liggghts_", 0) == 0 || name == variables_file ||
        name == "failed")
      old.push_back(entry.path());
    if (name.rfind("log.", 0) == 0 && name != "log.liggghts") ++logs;
  }
  for (int later = stage + 1; later <= 9; ++later) old.push_back(restart_file(folder_, later));
  for (const fs::path& file : old) fs::remove(file);
  const fs::path log = folder_ / "log.liggghts";
  if (fs::exists(log)) fs::rename(log, folder_ / ("log." + std::to_string(logs) + ".liggghts"));
}

void CaseFolder::note_start(const std::string& versions,
                            const std::vector<std::string>& command) const
{
  append_to_file(folder_ / "versions.txt", versions);
  append_to_file(folder_ / "command.txt", joined(command) + "\n");
}

std::vector<std::string> CaseFolder::command(const Places& places, int ranks, int stage) const
{
  std::vector<std::string> words;
  // Unbound: Open MPI would pin the first ranks of every case to the same cores.
  if (ranks > 1)
    words = {"mpirun", "-np", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
  words.insert(words.end(),
               {places.host, "-in", "input/" + plan_.deck->file.filename().string(), "-log",
                "log.liggghts", "-screen", "none", "-var", "common", common_of_case});
  for (const auto& [name, value] : plan_.given) words.insert(words.end(), {"-var", name, value});
  if (stage > 0) words.insert(words.end(), {"-var", "resume", std::to_string(stage)});
  return words;
}

bool CaseFolder::confirm_variables() const
{
  const fs::path file = folder_ / variables_file;
  if (!fs::exists(file)) return false;
  const Settings used = confirmed_variables(id(), plan_.asked, read_used_variables(file));
  write_case_record(folder_ / "case.json", record(used));
  return true;
}

Progress CaseFolder::progress() const
{
  std::ifstream stream(folder_ / "progress.txt");
  return read_progress({std::istreambuf_iterator<char>(stream), {}});
}

bool CaseFolder::was_stopped() const
{
  return end_of(folder_ / "log.liggghts", 400).find("Stopped by a signal") != std::string::npos;
}

std::string CaseFolder::last_words() const
{
  return last_words_of(folder_ / "log.liggghts", folder_ / "output.txt");
}

void CaseFolder::note_finished(long seconds) const
{
  const std::time_t now = std::time(nullptr);
  char date[40];
  std::strftime(date, sizeof date, "%FT%TZ", std::gmtime(&now));
  write_text_file(folder_ / "finished",
                  std::string(date) + "\nwall time " + std::to_string(seconds) + " s\n");
}

void CaseFolder::note_failed(const std::string& sentence) const
{
  const std::size_t end = sentence.find('\n'), error = sentence.find("ERROR");
  std::string reason = sentence.substr(0, end);
  if (error != std::string::npos)
    reason = sentence.substr(error, sentence.find('\n', error) - error);
  else if (end != std::string::npos && end + 1 < sentence.size())
    reason += ": " + sentence.substr(end + 1, sentence.find('\n', end + 1) - end - 1);
  if (reason.empty()) reason = "no reason was found";
  write_text_file(folder_ / "failed", reason + "\n");
}

}  // namespace encased_column
