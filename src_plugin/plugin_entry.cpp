#include "plugin_entry.h"

#include "host/fix_gravity_of_motion.h"
#include "shell/fix_wall_of_sleeves.h"
#include "style_table.h"

#include "input.h"
#include "lammps.h"
#include "modify.h"

#include <map>

namespace encased_column {

namespace {

// The maps of styles are private in the host. Explicit instantiation may name private members,
// so these two reach them without a change to the host.
template <typename Tag, typename Tag::type member>
struct Reveal {
  friend typename Tag::type reveal(Tag) { return member; }
};

struct FixMap {
  using type = std::map<std::string, FixCreator>* LAMMPS_NS::Modify::*;
  friend type reveal(FixMap);
};
template struct Reveal<FixMap, &LAMMPS_NS::Modify::fix_map>;

struct CommandMap {
  using type = std::map<std::string, CommandCreator>* LAMMPS_NS::Input::*;
  friend type reveal(CommandMap);
};
template struct Reveal<CommandMap, &LAMMPS_NS::Input::command_map>;

std::map<std::string, CommandCreator>& commands_of(LAMMPS_NS::LAMMPS* lmp)
{
  return *(lmp->input->*reveal(CommandMap()));
}

FixCreator host_wall = nullptr;

LAMMPS_NS::Fix* make_any_wall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  return make_wall(host_wall, lmp, narg, arg);
}

void register_fixes(LAMMPS_NS::LAMMPS* lmp)
{
  auto& fixes = *(lmp->modify->*reveal(FixMap()));
  if (fixes.at("wall/gran") != make_any_wall) host_wall = fixes.at("wall/gran");
  fixes["wall/gran"] = make_any_wall;
  fixes["gravity"] = FixGravityOfMotion::make;
  for (const Style& style : style_table())
    if (const auto* create = std::get_if<FixCreator>(&style.maker.create))
      fixes[style.name] = *create;
}

// `clear` gives the deck a new Modify that knows only the host's fixes. Ours need a box, and a box
// comes from one of these three commands, so each of them enters our fixes before it runs.
std::map<std::string, CommandCreator> host_box_commands;

template <int which>
void make_box(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  static const char* const names[] = {"create_box", "read_data", "read_restart"};
  register_fixes(lmp);
  host_box_commands.at(names[which])(lmp, narg, arg);
}

}  // namespace

void register_styles(LAMMPS_NS::LAMMPS* lmp)
{
  auto& commands = commands_of(lmp);
  if (host_box_commands.empty()) {
    register_contact_models();
    for (const char* name : {"create_box", "read_data", "read_restart"})
      host_box_commands[name] = commands.at(name);
  }
  commands["create_box"] = make_box<0>;
  commands["read_data"] = make_box<1>;
  commands["read_restart"] = make_box<2>;

  register_fixes(lmp);
  for (const Style& style : style_table())
    if (const auto* create = std::get_if<CommandCreator>(&style.maker.create))
      commands[style.name] = *create;
}

}  // namespace encased_column
