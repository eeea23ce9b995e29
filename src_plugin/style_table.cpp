// SPDX-License-Identifier: GPL-2.0-only
#include "style_table.h"

#include "host/granular_host.h"

#include "contact/pair_history.h"
#include "contact/register_linear.h"
#include "deck/record_variables_command.h"
#include "deck/require_command.h"
#include "dynamics/fix_motion.h"
#include "dynamics/solve_command.h"
#include "host/fix_stop_request.h"
#include "host/gravity.h"
#include "measure/fix_measure_sphere.h"
#include "measure/fix_specimen_history.h"
#include "output/fix_output_collection.h"
#include "output/fix_output_contacts.h"
#include "output/fix_output_grains.h"
#include "output/fix_output_restart.h"
#include "output/fix_output_sleeve.h"
#include "packing/create_packing_command.h"
#include "packing/fix_grow_radius.h"
#include "servo/create_wall_mesh_command.h"
#include "servo/fix_servo_cylinder.h"
#include "servo/fix_servo_platen.h"
#include "shell/fix_mesh_surface_shell.h"
#include "shell/fix_wall_of_sleeves.h"

namespace encased_column {

const std::vector<Style>& style_table()
{
  constexpr bool reads_contact_law = true;
  static const std::vector<Style> table{
      {"contacthistory", make_instead<PairHistory>()},
      {"create_packing", make<CreatePackingCommand>()},
      {"create_wall_mesh", make<CreateWallMeshCommand>()},
      {"gravity", make_instead<FixGravityOfMotion>()},
      {"grow/radius", make<FixGrowRadius>()},
      {"measure/sphere", make<FixMeasureSphere>(), reads_contact_law},
      {"mesh/surface/shell", make<FixMeshSurfaceShell>(), reads_contact_law},
      {"motion", make<FixMotion>(), reads_contact_law},
      {"output/collection", make<FixOutputCollection>()},
      {"output/contacts", make<FixOutputContacts>(), reads_contact_law},
      {"output/grains", make<FixOutputGrains>(), reads_contact_law},
      {"output/restart", make<FixOutputRestart>()},
      {"output/sleeve", make<FixOutputSleeve>()},
      {"record_variables", make<RecordVariablesCommand>()},
      {"require", make<RequireCommand>()},
      {"servo/cylinder", make<FixServoCylinder>(), reads_contact_law},
      {"servo/platen", make<FixServoPlaten>(), reads_contact_law},
      {"solve", make<SolveCommand>()},
      {"specimen/history", make<FixSpecimenHistory>(), reads_contact_law},
      {"stop_request", make_instead<FixStopRequest>()},
      {"wall/gran", make_instead<make_wall>()},
  };
  return table;
}

void register_contact_models()
{
  register_linear_model<LIGGGHTS::ContactModels::ROLLING_OFF>();
  register_linear_model<LIGGGHTS::ContactModels::ROLLING_EPSD2>();
}

}  // namespace encased_column
