// SPDX-License-Identifier: GPL-2.0-only
#include "plugin_entry.h"

#include "contact/grain_grid.h"
#include "core/input_error.h"
#include "files/restart_file.h"
#include "host/contact_history.h"
#include "host/contact_law.h"
#include "host/fix_stop_request.h"
#include "host/messages.h"
#include "host/output_files.h"
#include "host/reveal.h"
#include "shell/refuse_as_mesh.h"
#include "style_table.h"

#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"

#include <dlfcn.h>

#include <algorithm>
#include <map>

namespace encased_column {

// The maps of styles and the word of a command are private in the host.
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

struct CommandWord {
  using type = char* LAMMPS_NS::Input::*;
  friend type reveal(CommandWord);
};
template struct Reveal<CommandWord, &LAMMPS_NS::Input::command>;

namespace {

std::map<std::string, CommandCreator>& commands_of(LAMMPS_NS::LAMMPS* lmp)
{
  return *(lmp->input->*reveal(CommandMap()));
}

std::map<std::string, FixCreator> host_mesh_takers;

LAMMPS_NS::Fix* make_mesh_taker(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  refuse_sleeve_as_mesh(lmp, narg, arg);
  return host_mesh_takers.at(arg[2])(lmp, narg, arg);
}

void register_fixes(LAMMPS_NS::LAMMPS* lmp)
{
  auto& fixes = *(lmp->modify->*reveal(FixMap()));
  for (const std::string& style : fixes_that_take_meshes()) {
    const auto known = fixes.find(style);
    if (known == fixes.end() || known->second == make_mesh_taker) continue;
    host_mesh_takers[style] = known->second;
    known->second = make_mesh_taker;
  }
  for (const Style& style : style_table()) {
    const auto* create = std::get_if<FixCreator>(&style.maker.create);
    if (!create) continue;
    FixCreator& known = fixes[style.name];
    if (style.maker.host && known != *create) *style.maker.host = known;
    known = *create;
  }
}

/// Every command of the map, the host's and ours, by the deck's word for it.
std::map<std::string, CommandCreator> all_commands;

/// Ends the run where two grains are at one place, as after a 'create_atoms' that stands twice.
void check_places(LAMMPS_NS::LAMMPS* lmp)
{
  const LAMMPS_NS::Atom& atom = *lmp->atom;
  int pair[2] = {0, 0};
  if (const auto same = atom.nlocal ? find_coincident(atom.x[0], atom.nlocal) : std::nullopt) {
    pair[0] = atom.tag[same->first];
    pair[1] = atom.tag[same->second];
  }
  // One rank's pair, where several have one.
  MPI_Allreduce(MPI_IN_PLACE, pair, 1, MPI_2INT, MPI_MAXLOC, lmp->world);
  if (pair[0] == 0) return;
  lmp->error->all(FLERR,
                  ("grains must be at different places, found grain " + std::to_string(pair[0]) +
                   " and grain " + std::to_string(pair[1]) +
                   " at the same, create them once or write 'delete_atoms overlap 1e-9 all all'")
                      .c_str());
}

/// Ends the run where a fix of ours would read contacts of another law than the linear one, or
/// where two grains stand at one place.
void check_contacts(LAMMPS_NS::LAMMPS* lmp)
{
  bool are_read = false;
  try {
    for (int n = 0; n < lmp->modify->nfix; ++n) {
      const LAMMPS_NS::Fix& fix = *lmp->modify->fix[n];
      for (const Style& style : style_table())
        if (style.reads_contact_law && style.maker.made(fix)) {
          require_linear_law(lmp, "'fix " + std::string(fix.id) + "' of style " + style.name);
          are_read = true;
        }
    }
  } catch (const InputError& problem) {
    lmp->error->all(FLERR, problem.what());
  }
  if (are_read) check_places(lmp);
}

/// Reads the name in `word` as the host will, and puts it right for a `*`.
void check_restart(LAMMPS_NS::LAMMPS* lmp, char*& word)
{
  static std::string file;  // the host reads it after this
  std::string problem;
  if (lmp->comm->me == 0) {
    try {
      file = restart_file_of(word);
      check_restart_file(file);
    } catch (const InputError& found) {
      problem = found.what();
    }
  }
  for (std::string* text : {&file, &problem}) {
    int length = static_cast<int>(text->size());
    MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
    text->resize(length);
    MPI_Bcast(text->data(), length, MPI_CHAR, 0, lmp->world);
  }
  if (!problem.empty()) lmp->error->all(FLERR, problem.c_str());
  word = file.data();
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Runs in place of every command: checks what must hold before it, then runs it.
void run_command(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  const std::string word = lmp->input->*reveal(CommandWord());
  const CommandCreator run = all_commands.at(word);
  secure_output(lmp);
  // `clear` gives the deck a new Modify that knows only the host's fixes. Ours need a box, and a
  // box comes from one of these.
  const bool makes_box = is_one_of(word, {"create_box", "read_data", "read_restart"});
  if (makes_box) {
    register_fixes(lmp);
    forget_files_of_commands();
  }
  if (is_one_of(word, {"run", "run_time", "minimize", "solve"}) && lmp->domain->box_exist)
    check_contacts(lmp);
  if (word == "read_restart" && narg == 1 && !lmp->domain->box_exist) check_restart(lmp, arg[0]);
  if (word == "replicate") refuse_replicated_contacts(lmp);
  if (word == "delete_atoms" && narg > 1 && lmp->domain->box_exist)
    delete_grains(run, lmp, narg, arg);
  else
    run(lmp, narg, arg);
  if (makes_box) FixStopRequest::add_to(lmp);
}

}  // namespace

void register_styles(LAMMPS_NS::LAMMPS* lmp)
{
  auto& commands = commands_of(lmp);
  if (all_commands.empty()) {
    register_contact_models();
    all_commands = commands;
    for (const Style& style : style_table())
      if (const auto* create = std::get_if<CommandCreator>(&style.maker.create))
        all_commands[style.name] = *create;
  }
  for (const auto& command : all_commands) commands[command.first] = run_command;
  register_fixes(lmp);
  secure_output(lmp);
}

}  // namespace encased_column

// No map holds the styles of dumps. The host calls this function by its exported name, and the one
// of the library that is linked first is called: ours checks the words and calls the host's.
void LAMMPS_NS::Output::add_dump(int narg, char** arg)
{
  using AddDump = void (*)(Output*, int, char**);
  static const auto host = reinterpret_cast<AddDump>(
      dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6Output8add_dumpEiPPc"));  // its mangled name
  encased_column::refuse_sleeve_as_mesh(lmp, narg, arg);
  host(this, narg, arg);
}
