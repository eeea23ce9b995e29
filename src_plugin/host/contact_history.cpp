// SPDX-License-Identifier: GPL-2.0-only
#include "host/contact_history.h"

#include "host/contact_observer.h"
#include "host/find_fix.h"

#include "fix_contact_history.h"

#include <cstring>
#include <unordered_map>
#include <vector>

namespace encased_column {

namespace {

/// The numbers of the grains a grain touched are protected in the host: only a derived class may
/// write them.
struct Partners : LAMMPS_NS::FixContactHistory {
  static int* of(LAMMPS_NS::FixContactHistory& history, int i)
  {
    return (history.*(&Partners::partner_))[i];
  }
};

std::vector<int> of_all_ranks(const std::vector<int>& mine, LAMMPS_NS::LAMMPS* lmp)
{
  const int ranks = lmp->comm->nprocs, count = static_cast<int>(mine.size());
  std::vector<int> counts(ranks), starts(ranks, 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, lmp->world);
  for (int rank = 1; rank < ranks; ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<int> all(starts.back() + counts.back());
  MPI_Allgatherv(mine.data(), count, MPI_INT, all.data(), counts.data(), starts.data(), MPI_INT,
                 lmp->world);
  return all;
}

/// Numbers the grains from 1 on and tells the contacts.
void renumber(LAMMPS_NS::LAMMPS* lmp)
{
  LAMMPS_NS::Atom* const atom = lmp->atom;
  const int owned = atom->nlocal;
  const std::vector<int> before = of_all_ranks({atom->tag, atom->tag + owned}, lmp);
  std::fill_n(atom->tag, owned, 0);
  atom->tag_extend();
  const std::vector<int> after = of_all_ranks({atom->tag, atom->tag + owned}, lmp);
  if (atom->map_style) {
    atom->map_init();
    atom->map_set();
  }

  std::unordered_map<int, int> new_number;
  for (std::size_t n = 0; n < before.size(); ++n) new_number[before[n]] = after[n];
  constexpr int no_grain = 0;
  for (auto* history : fixes_that_are<LAMMPS_NS::FixContactHistory>(lmp)) {
    if (std::strcmp(history->style, "contacthistory") != 0) continue;  // those of meshes
    for (int i = 0; i < owned; ++i) {
      int* const partners = Partners::of(*history, i);
      for (int m = 0; m < history->n_partner(i); ++m) {
        const auto found = new_number.find(partners[m]);
        partners[m] = found == new_number.end() ? no_grain : found->second;
      }
    }
  }
}

}  // namespace

void delete_grains(void (*host)(LAMMPS_NS::LAMMPS*, int, char**), LAMMPS_NS::LAMMPS* lmp, int narg,
                   char** arg)
{
  std::vector<char*> words(arg, arg + narg);
  char keyword[] = "compress", keep_numbers[] = "no";
  bool compress = true;
  std::size_t n = 2;  // behind the style and what it is about
  while (n < words.size() && std::strcmp(words[n], "compress") != 0) ++n;
  if (n + 1 < words.size()) {
    compress = std::strcmp(words[n + 1], "yes") == 0;
    if (compress) words[n + 1] = keep_numbers;
  }
  if (n == words.size()) words.insert(words.end(), {keyword, keep_numbers});
  host(lmp, static_cast<int>(words.size()), words.data());
  if (compress) renumber(lmp);
}

void refuse_replicated_contacts(LAMMPS_NS::LAMMPS* lmp)
{
  if (!lmp->update->first_update && !lmp->modify->fix_restart_in_progress()) return;
  lmp->error->all(
      FLERR,
      "'replicate' must stand before the first run, found one behind a run or a restart "
      "file, whose contacts it would give to other grains, write it before 'run' or "
      "'solve'");
}

}  // namespace encased_column
