// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/pair_linear.h"

namespace encased_column {

/// Enters the linear law with one rolling model into the host's factories, for pairs and walls.
template <int rolling>
void register_linear_model()
{
  using namespace LIGGGHTS;
  using Model = ContactModels::ContactModel<ContactModels::LinearStyle<rolling>>;
  const int hash = static_cast<int>(Model::STYLE_HASHCODE);
  ContactModels::Factory::instance().addNormalModel("linear", linear_model_number);
  PairStyles::Factory::instance().addStyle("gran", hash,
                                           [](LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGran* parent,
                                              int64_t hash) -> PairStyles::IGranularPairStyle* {
                                             return new PairLinear<rolling>(lmp, parent, hash);
                                           });
  Walls::Factory::instance().addStyle("gran", hash,
                                      [](LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* parent,
                                         int64_t hash) -> Walls::IGranularWall* {
                                        return new Walls::Granular<Model>(lmp, parent, hash);
                                      });
}

}  // namespace encased_column
