#include "output/fix_output_contacts.h"

#include "core/input_error.h"
#include "core/read_number.h"
#include "host/say_understood.h"

#include <numeric>

namespace encased_column {

namespace {

/// Of the study's Figure 13 [N].
const std::vector<double> usual_levels{5.0, 20.0, 40.0, 60.0};

std::vector<std::string> columns_of(const std::vector<double>& levels)
{
  std::vector<std::string> columns{
      "step [-]",          "contacts [-]",        "grain_contacts [-]",
      "wall_contacts [-]", "sleeve_contacts [-]", "sliding_fraction [-]",
      "mean_force [N]",    "largest_force [N]"};
  for (const double level : levels) {
    columns.push_back("contacts_above_" + in_words(level) + "N [-]");
    columns.push_back("share_above_" + in_words(level) + "N [-]");
  }
  return columns;
}

}  // namespace

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
    read_levels(options);
    file_ = CsvSeries(files_.file(options, "file", "contacts.csv"), columns_of(forces_.levels()));
    series_ = files_.series(options, "contacts");
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  row_.assign(columns_of(forces_.levels()).size(), 0.0);
  restart_global = 1;
  vector_flag = 1;
  size_vector = static_cast<int>(row_.size());
  global_freq = 1;
  extvector = 0;
}

void FixOutputContacts::read_levels(const Options& options)
{
  std::vector<double> levels;
  if (options.has("level"))
    for (const auto& words : options.all("level")) {
      levels.push_back(read_number("level", words.front()));
      if (!(levels.back() > 0.0))
        throw InputError("'level' must be larger than zero, found " + in_words(levels.back()) +
                         ", write a force in N");
    }
  forces_ = ContactForces(levels.empty() ? usual_levels : levels);
  std::vector<std::string> words;
  for (const double level : forces_.levels()) words.push_back(in_words(level));
  options.assume("level", joined(words));
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

}  // namespace encased_column
