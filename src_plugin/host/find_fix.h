// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"
#include "host/host_types.h"

#include <string>
#include <vector>

namespace encased_column {

/// The fix that `keyword` names by its ID, as a T; throws InputError when there is none or when it
/// is of another kind. `kind` says in words what is wanted.
template <typename T>
T* find_fix(LAMMPS_NS::LAMMPS* lmp, const std::string& keyword, const std::string& id,
            const std::string& kind)
{
  const int n = lmp->modify->find_fix(id.c_str());
  if (n < 0)
    throw InputError("'" + keyword + "' must name a " + kind + ", found '" + id +
                     "' and no fix has that ID, define it before");
  auto* fix = dynamic_cast<T*>(lmp->modify->fix[n]);
  if (!fix)
    throw InputError("'" + keyword + "' must name a " + kind + ", found '" + id +
                     "', which is a 'fix " + lmp->modify->fix[n]->style + "', write the ID of a " +
                     kind);
  return fix;
}

/// Every fix of `lmp` that is a T, in the deck's order.
template <typename T>
std::vector<T*> fixes_that_are(LAMMPS_NS::LAMMPS* lmp)
{
  std::vector<T*> found;
  for (int n = 0; n < lmp->modify->nfix; ++n)
    if (auto* fix = dynamic_cast<T*>(lmp->modify->fix[n])) found.push_back(fix);
  return found;
}

/// A fix of the deck that a keyword names by its ID, found at the start of each run. `unfix` may
/// take it away between two runs, and leaves the pointer dangling: ask is_there() outside a run.
template <typename T>
class NamedFix {
 public:
  explicit NamedFix(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// What the deck says; `kind` in words is what is wanted, for the sentence where it is not there.
  void name(const std::string& keyword, const std::string& id, const std::string& kind)
  {
    keyword_ = keyword;
    id_ = id;
    kind_ = kind;
  }
  bool is_named() const { return !id_.empty(); }
  const std::string& id() const { return id_; }

  /// Throws InputError as find_fix().
  void find()
  {
    fix_ = find_fix<T>(lmp_, keyword_, id_, kind_);
    in_list_ = dynamic_cast<LAMMPS_NS::Fix*>(fix_);
  }
  /// True where it was found and still is one of the deck's fixes.
  bool is_there() const
  {
    for (int n = 0; fix_ && n < lmp_->modify->nfix; ++n)
      if (lmp_->modify->fix[n] == in_list_)  // or another at the same place
        return dynamic_cast<T*>(lmp_->modify->fix[n]) == fix_;
    return false;
  }
  T& operator*() const { return *fix_; }
  T* operator->() const { return fix_; }

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  std::string keyword_, id_, kind_;
  T* fix_ = nullptr;
  const LAMMPS_NS::Fix* in_list_ = nullptr;
};

}  // namespace encased_column
