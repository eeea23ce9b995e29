#include "style_table.h"

#include "host/granular_host.h"

#include "contact/model_linear.h"
#include "servo/create_wall_mesh_command.h"

namespace encased_column {

const std::vector<Style>& style_table()
{
  static const std::vector<Style> table{
      {"create_wall_mesh", make<CreateWallMeshCommand>()},
  };
  return table;
}

void register_contact_models()
{
  register_linear_model<LIGGGHTS::ContactModels::ROLLING_OFF>();
  register_linear_model<LIGGGHTS::ContactModels::ROLLING_EPSD2>();
}

}  // namespace encased_column
