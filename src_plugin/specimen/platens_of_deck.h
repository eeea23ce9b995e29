// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/find_fix.h"
#include "specimen/platen.h"

#include <string>

namespace encased_column {

/// The two platens that a fix names by their IDs with the keyword `platens`.
class PlatensOfDeck {
 public:
  explicit PlatensOfDeck(LAMMPS_NS::LAMMPS* lmp) : top_(lmp), bottom_(lmp) {}

  /// Takes over the IDs, upper platen first.
  void read(const Options& options)
  {
    const auto& ids = options.all("platens").front();
    top_.name("platens", ids[0], "fix servo/platen");
    bottom_.name("platens", ids[1], "fix servo/platen");
  }
  /// At the start of a run: throws InputError where one is not there or they are the wrong way
  /// round.
  void find()
  {
    top_.find();
    bottom_.find();
    if (!top_->is_top() || bottom_->is_top())
      throw InputError("'platens' takes the upper platen first, found '" + top_.id() + " " +
                       bottom_.id() + "', write the ID of the top and then of the bottom one");
  }
  /// False before the first run, and when one was taken away.
  bool are_there() const { return top_.is_there() && bottom_.is_there(); }

  /// To be asked where they are there.
  Platens now() const { return {&*top_, &*bottom_}; }
  /// Heights [m] between them; all heights where they are not there.
  HeightWindow window() const { return are_there() ? now().window() : HeightWindow(); }
  const std::string& id(bool top) const { return top ? top_.id() : bottom_.id(); }

 private:
  NamedFix<Platen> top_, bottom_;
};

}  // namespace encased_column
