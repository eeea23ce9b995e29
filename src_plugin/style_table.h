#pragma once

#include "core/keyword_table.h"
#include "files/column.h"
#include "host/creators.h"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace encased_column {

/// How the host makes an object of a style, and the keywords it reads.
struct Maker {
  std::variant<FixCreator, CommandCreator> create;
  const KeywordTable* keywords;
  std::vector<TableText> (*tables)();  ///< that it writes; null where it writes none
};

/// One style of the plugin: the name a deck writes and what stands behind it.
struct Style {
  std::string name;
  Maker maker;
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
            &T::keywords, TablesOf<T>::all};
  } else {
    return {CommandCreator(
                [](LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) { T(lmp).command(narg, arg); }),
            &T::keywords, TablesOf<T>::all};
  }
}

/// Every fix and command of the plugin.
const std::vector<Style>& style_table();

/// Enters the contact models into the host's factories; once per process.
void register_contact_models();

}  // namespace encased_column
