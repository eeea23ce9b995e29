// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/contact_context.h"
#include "contact/model_numbers.h"
#include "core/input_error.h"
#include "host/granular_host.h"

// `pair_style gran model linear tangential history [rolling_friction epsd2]`, and the same for
// walls. The host builds a contact model of five parts, each called on its own; this is one
// specialisation for the whole, so that the law is inlined into the host's loops.
namespace LIGGGHTS {
namespace ContactModels {

using encased_column::linear_model_number;

template <int rolling>
using LinearStyle =
    GranStyle<linear_model_number, TANGENTIAL_HISTORY, COHESION_OFF, rolling, SURFACE_DEFAULT>;

template <int rolling>
class ContactModel<
    GranStyle<linear_model_number, TANGENTIAL_HISTORY, COHESION_OFF, rolling, SURFACE_DEFAULT>>
    : public ContactModelBase {
 public:
  static const int64_t STYLE_HASHCODE = LinearStyle<rolling>::HASHCODE;
  static constexpr bool with_rolling = rolling != ROLLING_OFF;

  ContactModel(LAMMPS* lmp, IContactHistorySetup* history, bool is_wall, const int64_t)
      : ContactModelBase(lmp, is_wall),
        lmp_(lmp),
        context_(lmp)
  {
    memory_ = history->add_history_value("shearx", "1");
    history->add_history_value("sheary", "1");
    history->add_history_value("shearz", "1");
    history->add_history_value("last_step", "0");
    add_history_offset("contact_memory", memory_);
    if (!with_rolling) return;
    history->add_history_value("r_torquex_old", "1");
    history->add_history_value("r_torquey_old", "1");
    history->add_history_value("r_torquez_old", "1");
  }

  int64_t hashcode() { return STYLE_HASHCODE; }
  double stressStrainExponent() { return 1.0; }
  void registerSettings(Settings&) {}
  void postSettings(IContactHistorySetup*) {}

  /// Called at the start of every run.
  void connectToProperties(PropertyRegistry&)
  {
    try {
      context_.open(with_rolling);
    } catch (const encased_column::InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) { context_.ask_observers(); }
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  bool checkSurfaceIntersect(SurfacesIntersectData&) { return true; }
  void tally_pp(double, int, int, int) {}
  void tally_pw(double, int, int, int) {}

  void surfacesIntersect(SurfacesIntersectData& s, ForceData& i_forces, ForceData& j_forces)
  {
    using namespace encased_column;
    const bool wall = s.is_wall;
    const bool advance = s.computeflag && s.shearupdate;
    const Vec3 still = Vec3::Zero();
    // The host's normal points from j to i.
    const Touch touch{
        s.radsum - s.r,
        -as_vec3(s.en),
        s.meff,
        {s.radi, as_vec3(s.v_i), as_vec3(s.omega_i)},
        {wall ? 0.0 : s.radj, as_vec3(s.v_j), wall ? still : Vec3(as_vec3(s.omega_j))}};
    const ContactAction action = resolve_contact<with_rolling>(
        context_.material(s.itype, s.jtype), touch, lmp_->update->dt,
        static_cast<double>(lmp_->update->ntimestep), advance, s.contact_history + memory_);

    as_vec3(i_forces.delta_F) += action.force;
    as_vec3(i_forces.delta_torque) += action.moment_i;
    as_vec3(j_forces.delta_F) -= action.force;
    as_vec3(j_forces.delta_torque) += action.moment_j;
    if (s.contact_flags) *s.contact_flags |= CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL;
    s.deltan = touch.overlap;
    s.kn = action.stiffness.normal;
    s.kt = action.stiffness.shear;
    s.Fn = action.normal_force;
    if (!s.computeflag) return;
    if (wall) {
      context_.ask_observers();  // the host has no pass over walls
      context_.raise_mass_for_contact(s.i, action.stiffness);
    }
    const double share = wall || s.j < lmp_->atom->nlocal ? 1.0 : 0.5;
    context_.book(s.i, wall ? -1 : s.j, share, advance, touch, action);
  }

  void endSurfacesIntersect(SurfacesIntersectData&, TriMesh*, ForceData&, ForceData&) {}

  void surfacesClose(SurfacesCloseData& s, ForceData&, ForceData&)
  {
    if (s.contact_flags) *s.contact_flags &= ~(CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL);
  }

  bool contact_match(const std::string kind, const std::string model)
  {
    Factory& models = Factory::instance();
    if (kind == "surface") return models.getSurfaceModelId(model) == SURFACE_DEFAULT;
    if (kind == "normal") return models.getNormalModelId(model) == linear_model_number;
    if (kind == "cohesion") return models.getCohesionModelId(model) == COHESION_OFF;
    if (kind == "tangential") return models.getTangentialModelId(model) == TANGENTIAL_HISTORY;
    if (kind == "rolling_friction") return models.getRollingModelId(model) == rolling;
    return false;
  }

 private:
  LAMMPS* lmp_;
  encased_column::ContactContext context_;
  int memory_ = 0;  ///< where the contact's memory begins in the host's history
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
