#pragma once

#include "host/contact_observer.h"

#include <vector>

namespace encased_column {

/// The contacts of each grain of this rank. A pair across a border of ranks, or of a periodic box,
/// is seen from both ends, each time with its own grain as i.
class ContactCounter {
 public:
  void start(int grains) { contacts_.assign(grains, 0); }
  void add(const Contact& contact)
  {
    ++contacts_[contact.i];
    if (is_here(contact)) ++contacts_[contact.j];
  }
  /// The other end is a grain of this rank, and not seen from there.
  bool is_here(const Contact& contact) const
  {
    return contact.j >= 0 && contact.j < static_cast<int>(contacts_.size());
  }
  int operator[](int i) const { return contacts_[i]; }
  int grains() const { return static_cast<int>(contacts_.size()); }

 private:
  std::vector<int> contacts_;
};

}  // namespace encased_column
