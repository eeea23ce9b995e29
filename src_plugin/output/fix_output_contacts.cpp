// SPDX-License-Identifier: GPL-2.0-only
#include "output/fix_output_contacts.h"

#include "core/input_error.h"
#include "host/messages.h"
#include "host/ranks.h"
#include "host/restart_block.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace encased_column {

const KeywordTable FixOutputContacts::keywords{
    {"every", 1, "steps", "one VTK file every so many steps"},
    {"folder", 1, "-", "folder of the VTK files, created if missing"},
    {"name", 1, "-", "name of the series (default contacts)"},
    {"threshold", 1, "N", "VTK files leave out contacts that bear less (default 0)"},
    {"rows", 1, "steps", "one row of the statistics every so many steps (default 1000)"},
    {"file", 1, "-", "CSV file of the statistics (default contacts.csv)"},
    {"level", 1, "N", "they count contacts that bear it (may be repeated; default 5, 20, 40, 60)",
     true},
};

std::vector<TableText> FixOutputContacts::tables()
{
  return {{"contacts.csv", contact_texts()}};
}

FixOutputContacts::FixOutputContacts(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this),
      clock_(lmp),
      file_("", {})
{
  try {
    const Options options = keywords.read(narg, arg);
    frame_every_ = options.integer("every", 1);
    row_every_ = options.integer("rows", 1, 1000);
    nevery = static_cast<int>(std::gcd(frame_every_, row_every_));
    threshold_ = options.not_negative("threshold", 0.0);
    forces_ = ContactForces(contact_levels(options));
    file_ =
        CsvSeries(files_.file(options, "file", "contacts.csv"), contact_headings(forces_.levels()));
    series_ = make_series(files_, options, "contacts");
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  batch_.assign(contact_headings(forces_.levels()).size(), 0.0);
  restart_global = 1;
  vector_flag = 1;
  size_vector = static_cast<int>(batch_.size());
  global_freq = 1;
  extvector = 0;
}

int FixOutputContacts::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_FORCE | END_OF_STEP;
}

bool FixOutputContacts::wants_contacts(LAMMPS_NS::bigint step) const
{
  return first_forces_ || step % row_every_ == 0 || step % frame_every_ == 0;
}

bool FixOutputContacts::wants_frame() const
{
  return first_forces_ || update->ntimestep % frame_every_ == 0;
}

void FixOutputContacts::init()
{
  try {
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixOutputContacts::setup_pre_force(int)
{
  first_forces_ = !written_;
  clear_contacts();
}

void FixOutputContacts::pre_force(int)
{
  first_forces_ = false;
  if (wants_contacts(update->ntimestep)) clear_contacts();
}

void FixOutputContacts::clear_contacts()
{
  contacts_.clear();
  forces_.clear();
}

/// A pair across a border of ranks is seen on both; the rank of the grain with the smaller id
/// counts it.
bool FixOutputContacts::is_seen_elsewhere(const Contact& contact) const
{
  return contact.share < 1.0 && atom->tag[contact.j] < atom->tag[contact.i];
}

void FixOutputContacts::add_contact(const Contact& contact)
{
  if (is_seen_elsewhere(contact)) return;
  const double force = contact.force.norm();
  const int kind = static_cast<int>(contact.kind);
  forces_.add(kind, force, contact.sliding);
  if (!wants_frame() || force < threshold_) return;

  ContactRecord record{};
  record.first = atom->tag[contact.i];
  record.second = contact.j < 0 ? 0 : atom->tag[contact.j];
  record.kind = kind;
  record.sliding = contact.sliding;
  as_vec3(record.from.data()) = as_vec3(atom->x[contact.i]);
  as_vec3(record.to.data()) = as_vec3(atom->x[contact.i]) + contact.length * contact.normal;
  if (record.second > 0 && record.second < record.first) {
    std::swap(record.first, record.second);
    std::swap(record.from, record.to);
  }
  record.force = force;
  record.normal_force = normal_force(contact.force, contact.normal);
  record.shear_force = shear_force(contact.force, contact.normal);
  contacts_.push_back(record);
}

// The first row and the first file are the state before the first step.
void FixOutputContacts::setup(int)
{
  clock_.begin_run();
  if (written_) return;
  write_row();
  write_frame();
  written_ = true;
}

void FixOutputContacts::end_of_step()
{
  if (update->ntimestep % row_every_ == 0) write_row();
  if (update->ntimestep % frame_every_ == 0) write_frame();
}

void FixOutputContacts::write_row()
{
  sum_over_ranks(forces_.sums().data(), forces_.sums().size(), world);
  forces_.set_largest(max_over_ranks(forces_.largest(), world));
  batch_ = contact_numbers({static_cast<double>(update->ntimestep), forces_});
  if (comm->me == 0 && !file_.append(batch_)) files_.stop(file_.path());
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
  std::vector<double> numbers{clock_.now(), static_cast<double>(batch_.size())};
  numbers.insert(numbers.end(), batch_.begin(), batch_.end());
  write_block(file, numbers, series_->saved());
}

void FixOutputContacts::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    clock_.restart(block.take());
    std::vector<double> row(static_cast<std::size_t>(block.take()));
    block.take(row.data(), row.size());
    if (row.size() == batch_.size()) batch_ = row;
    written_ = true;
    if (comm->me != 0) return;
    if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
    if (!series_->restore(block.text()))
      files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
