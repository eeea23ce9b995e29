// SPDX-License-Identifier: GPL-2.0-only
#include "contact/pair_history.h"

#include <algorithm>

namespace encased_column {

void PairHistory::take()
{
  in_charge_ = true;
  lent_ = false;
  flags_ = std::vector<int>();
  lent_memories_ = std::vector<double>();
  listed_ = atom->nlocal;
  for (int n = 0; n < pairs.size(); ++n) {
    const int i = pairs.first()[n], other = atom->tag[pairs.second()[n]];
    int* const end = partner_[i] + npartner_[i];
    int* const found = std::find(partner_[i], end, other);
    if (found != end) pairs.restore(n, contacthistory(i, static_cast<int>(found - partner_[i])));
  }
  // Nothing of it is read before it is given to the grains again.
  std::fill_n(npartner_, atom->nlocal, 0);
  ipage_->init(oneatom_, pgsize_);
  dpage_->init(oneatom_ * std::max(1, dnum_), pgsize_);
}

void PairHistory::lend(LAMMPS_NS::NeighList& list)
{
  if (lent_) return;
  lent_ = true;
  LAMMPS_NS::NeighList& touches = *list.listgranhistory;
  flags_.assign(pairs.size(), 0);
  lent_memories_.assign(static_cast<std::size_t>(pairs.size()) * dnum_, 0.0);
  for (int n = pairs.size() - 1; n >= 0; --n) {
    double* const lent = lent_memories_.data() + static_cast<std::size_t>(n) * dnum_;
    touches.firstneigh[pairs.first()[n]] = flags_.data() + n;
    touches.firstdouble[pairs.first()[n]] = lent;
    const double* const memory = pairs.memory_of_touching(n);
    if (!memory) continue;
    flags_[n] = 1;
    std::copy_n(memory, dnum_, lent);
  }
}

// Flags stay where pairs have parted: the step in their memory tells. The rows stay until the next
// list: others of the host may look at them.
void PairHistory::take_back()
{
  if (!lent_) return;
  lent_ = false;
  for (int n = 0; n < pairs.size(); ++n)
    if (flags_[n])
      std::copy_n(lent_memories_.data() + static_cast<std::size_t>(n) * dnum_, dnum_,
                  pairs.memory(n));
}

void PairHistory::pre_exchange()
{
  if (!in_charge_) {
    FixContactHistory::pre_exchange();
    return;
  }
  if (!*computeflag_) return;  // what the grains have is the latest: they may have moved since
  take_back();
  give_to_grains();
  *computeflag_ = 0;  // what the grains have is the latest, until forces are made
  maxtouch_ = atom->nlocal ? *std::max_element(npartner_, npartner_ + atom->nlocal) : 0;
  comm->maxexchange_fix = std::max(comm->maxexchange_fix, (dnum_ + 1) * maxtouch_ + 1);
}

// The host throws its pages away where `neigh_modify` changed their sizes, with what is in them.
void PairHistory::allocate_pages()
{
  const bool kept = ipage_ && (pgsize_ != neighbor->pgsize || oneatom_ != neighbor->oneatom);
  std::vector<int> partners;
  std::vector<double> memories;
  for (int i = 0; kept && i < atom->nlocal; ++i) {
    partners.insert(partners.end(), partner_[i], partner_[i] + npartner_[i]);
    memories.insert(memories.end(), contacthistory_[i], contacthistory_[i] + dnum_ * npartner_[i]);
  }
  FixContactHistory::allocate_pages();
  const int* partner = partners.data();
  const double* memory = memories.data();
  for (int i = 0; kept && i < atom->nlocal; ++i) {
    make_room(i);
    std::copy_n(partner, npartner_[i], partner_[i]);
    std::copy_n(memory, dnum_ * npartner_[i], contacthistory_[i]);
    partner += npartner_[i];
    memory += dnum_ * npartner_[i];
  }
}

// The host calls this before it packs the grains. It copies memories to them when it builds a list,
// before the forces of that step: in the middle of a run they would be those of an earlier step.
void PairHistory::write_restart(FILE* file)
{
  if (*computeflag_) pre_exchange();
  FixContactHistory::write_restart(file);
}

/// Each grain gets its own copy of what its contacts remember, as seen from there.
void PairHistory::give_to_grains()
{
  const auto for_touching = [this](const auto& act) {
    for (int n = 0; n < pairs.size(); ++n)
      if (const double* const memory = pairs.memory_of_touching(n))
        act(pairs.first()[n], pairs.second()[n], memory);
  };
  std::fill_n(npartner_, std::max(listed_, atom->nlocal), 0);  // of those made since the list too
  for_touching([this](int i, int j, const double*) {
    ++npartner_[i];
    if (j < listed_) ++npartner_[j];
  });
  ipage_->reset();
  dpage_->reset();
  for (int i = 0; i < listed_; ++i) {
    make_room(i);
    npartner_[i] = 0;
  }
  for_touching([this](int i, int j, const double* memory) {
    const int m = npartner_[i]++;
    partner_[i][m] = atom->tag[j];
    std::copy_n(memory, dnum_, contacthistory(i, m));
    if (j >= listed_) return;
    const int k = npartner_[j]++;
    partner_[j][k] = atom->tag[i];
    double* const seen_from_j = contacthistory(j, k);
    for (int d = 0; d < dnum_; ++d) seen_from_j[d] = newtonflag_[d] ? -memory[d] : memory[d];
  });
}

/// For what grain i remembers of `npartner_` others.
void PairHistory::make_room(int i)
{
  partner_[i] = ipage_->get(npartner_[i]);
  contacthistory_[i] = dpage_->get(dnum_ * npartner_[i]);
  if (partner_[i] && contacthistory_[i]) return;
  error->one(FLERR, ("a grain touches " + std::to_string(npartner_[i]) +
                     " others, write 'neigh_modify one' with a larger number and 'page' with 10 "
                     "times that")
                        .c_str());
}

double PairHistory::memory_usage()
{
  return FixContactHistory::memory_usage() + static_cast<double>(pairs.bytes());
}

}  // namespace encased_column
