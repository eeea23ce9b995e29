// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "files/column.h"
#include "host/host_types.h"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace encased_column {

/// How the host makes an object of a style, the keywords it reads, the tables it writes, and how to
/// tell its fixes: the host may know one by another name.
struct Maker {
  std::variant<FixCreator, CommandCreator> create;
  const KeywordTable* keywords = nullptr;  ///< none: a style of the host, with the host's words
  std::vector<TableText> (*tables)() = nullptr;  ///< that it writes; null where it writes none
  bool (*made)(const LAMMPS_NS::Fix& fix) = nullptr;
  /// Where the host's creator of a style that this one replaces is kept, if it is needed.
  FixCreator* host = nullptr;
};

/// One style of the plugin: the name a deck writes and what stands behind it.
struct Style {
  std::string name;
  Maker maker;
  /// Reads contacts of pairs and walls as those of the linear law: refused with any other law.
  bool reads_contact_law = false;
};

template <typename T, typename = void>
struct TablesOf {
  static constexpr std::vector<TableText> (*all)() = nullptr;
};
template <typename T>
struct TablesOf<T, std::void_t<decltype(T::tables())>> {
  static constexpr std::vector<TableText> (*all)() = T::tables;
};

/// A fix is made and kept by the host; a command is made, run and gone.
template <typename T>
Maker make()
{
  if constexpr (std::is_base_of_v<LAMMPS_NS::Fix, T>) {
    return {FixCreator([](LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) -> LAMMPS_NS::Fix* {
              return new T(lmp, narg, arg);
            }),
            &T::keywords, TablesOf<T>::all,
            [](const LAMMPS_NS::Fix& fix) { return dynamic_cast<const T*>(&fix) != nullptr; }};
  } else {
    return {CommandCreator(
                [](LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) { T(lmp).command(narg, arg); }),
            &T::keywords, TablesOf<T>::all, [](const LAMMPS_NS::Fix&) { return false; }};
  }
}

/// A fix of the host that we make ourselves, as a T that takes the same words.
template <typename T>
Maker make_instead()
{
  return {FixCreator([](LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) -> LAMMPS_NS::Fix* {
            return new T(lmp, narg, arg);
          }),
          nullptr};
}

/// A fix of the host that `make` makes, with the host's creator at hand.
template <LAMMPS_NS::Fix* (*make)(FixCreator host, LAMMPS_NS::LAMMPS*, int, char**)>
Maker make_instead()
{
  static FixCreator host = nullptr;
  return {FixCreator([](LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) -> LAMMPS_NS::Fix* {
            return make(host, lmp, narg, arg);
          }),
          nullptr, nullptr, nullptr, &host};
}

/// Every fix and command of the plugin, and the fixes of the host it takes the place of.
const std::vector<Style>& style_table();

/// Enters the contact models into the host's factories; once per process.
void register_contact_models();

}  // namespace encased_column
