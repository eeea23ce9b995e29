// Rows and frames of the contacts, and what a restart file keeps of them.
#include "output/fix_output_contacts.h"

#include "host/gather.h"
#include "host/rank_sums.h"
#include "host/restart_block.h"

#include <algorithm>
#include <tuple>

namespace encased_column {

void FixOutputContacts::write_row()
{
  sum_over_ranks(forces_.sums().data(), forces_.sums().size(), world);
  forces_.set_largest(max_over_ranks(forces_.largest(), world));
  row_ = {static_cast<double>(update->ntimestep), forces_.contacts()};
  for (int kind = 0; kind < ContactForces::kinds; ++kind) row_.push_back(forces_.of_kind(kind));
  row_.insert(row_.end(), {forces_.sliding_fraction(), forces_.mean(), forces_.largest()});
  for (std::size_t n = 0; n < forces_.levels().size(); ++n)
    row_.insert(row_.end(), {forces_.above(n), forces_.share_above(n)});
  if (comm->me == 0 && !file_.append(row_)) files_.stop(file_.path());
}

/// Sorted, so that the file does not depend on the number of ranks; walls of a grain come in the
/// order of their fixes.
void FixOutputContacts::write_frame()
{
  std::vector<ContactRecord> contacts = gather_on_first_rank(contacts_, lmp);
  if (comm->me != 0) return;
  const auto grains = [](const ContactRecord& c) { return std::tie(c.first, c.second); };
  std::stable_sort(
      contacts.begin(), contacts.end(),
      [&](const ContactRecord& a, const ContactRecord& b) { return grains(a) < grains(b); });
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  if (!write_contacts(path, contacts) || !series_->list(clock_.now(), step)) files_.stop(path);
}

/// The time, the number of columns and the last row, then the series as text.
void FixOutputContacts::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::vector<double> numbers{clock_.now(), static_cast<double>(row_.size())};
  numbers.insert(numbers.end(), row_.begin(), row_.end());
  write_block(file, numbers, series_->saved());
}

void FixOutputContacts::restart(char* buffer)
{
  RestartBlock block(buffer);
  clock_.restart(block.take());
  std::vector<double> row(static_cast<std::size_t>(block.take()));
  block.take(row.data(), row.size());
  if (row.size() == row_.size()) row_ = row;
  written_ = true;
  if (comm->me != 0) return;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
  if (!series_->restore(block.text()))
    files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
}

}  // namespace encased_column
