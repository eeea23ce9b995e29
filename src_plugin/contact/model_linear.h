#pragma once

#include "contact/linear_law.h"
#include "contact/model_numbers.h"
#include "contact/rolling_resistance.h"
#include "core/input_error.h"
#include "host/contact_probe.h"
#include "host/granular_host.h"
#include "host/pair_property.h"

// `pair_style gran model linear tangential history [rolling_friction epsd2]`, and the same for
// walls. The host builds a contact model of five parts, each called on its own; this is one
// specialisation for the whole, so that the law is inlined into the host's loops.
namespace LIGGGHTS {
namespace ContactModels {

using encased_column::ContactMaterial;
using encased_column::linear_model_number;

template <int rolling>
using LinearStyle =
    GranStyle<linear_model_number, TANGENTIAL_HISTORY, COHESION_OFF, rolling, SURFACE_DEFAULT>;

template <int rolling>
class ContactModel<
    GranStyle<linear_model_number, TANGENTIAL_HISTORY, COHESION_OFF, rolling, SURFACE_DEFAULT>>
    : public ContactModelBase {
  using Vec3 = encased_column::Vec3;

 public:
  static const int64_t STYLE_HASHCODE = LinearStyle<rolling>::HASHCODE;

  ContactModel(LAMMPS* lmp, IContactHistorySetup* history, bool is_wall, const int64_t)
      : ContactModelBase(lmp, is_wall), lmp_(lmp)
  {
    spring_ = history->add_history_value("shearx", "1");
    history->add_history_value("sheary", "1");
    history->add_history_value("shearz", "1");
    last_step_ = history->add_history_value("last_step", "0");
    if constexpr (rolling != ROLLING_OFF) {
      rolling_torque_ = history->add_history_value("r_torquex_old", "1");
      history->add_history_value("r_torquey_old", "1");
      history->add_history_value("r_torquez_old", "1");
    }
  }

  int64_t hashcode() { return STYLE_HASHCODE; }
  double stressStrainExponent() { return 1.0; }
  void registerSettings(Settings&) {}
  void postSettings(IContactHistorySetup*) {}

  /// Called at the start of every run: reads the materials and finds who listens.
  void connectToProperties(PropertyRegistry&)
  {
    try {
      read_materials();
    } catch (const encased_column::InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
    probes_ = encased_column::fixes_that_are<encased_column::ContactProbe>(lmp_);
    owners_ = encased_column::fixes_that_are<encased_column::WallContactOwner>(lmp_);
    const auto losses = encased_column::fixes_that_are<encased_column::ContactLossOwner>(lmp_);
    losses_ = losses.empty() ? &no_account_ : &losses.front()->contact_losses;
    asked_step_ = -1;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) { ask_probes(); }
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  bool checkSurfaceIntersect(SurfacesIntersectData&) { return true; }
  void tally_pp(double, int, int, int) {}
  void tally_pw(double, int, int, int) {}

  void surfacesIntersect(SurfacesIntersectData& s, ForceData& i_forces, ForceData& j_forces)
  {
    using namespace encased_column;
    const bool wall = s.is_wall;
    const bool advance = s.computeflag && s.shearupdate;
    const double dt = lmp_->update->dt;
    const double step = static_cast<double>(lmp_->update->ntimestep);
    const Vec3 normal = -as_vec3(s.en);  // the host's points from j to i
    const double overlap = wall ? s.deltan : s.radsum - s.r;
    const double arm_i = s.radi - 0.5 * overlap;
    const double arm_j = wall ? 0.0 : s.radj - 0.5 * overlap;
    s.deltan = overlap;
    s.cri = arm_i;
    s.crj = arm_j;

    const ContactMaterial& material = materials_[s.itype * stride_ + s.jtype];
    const ContactStiffness k =
        wall ? linear_stiffness(material, s.radi, s.radi)
             : linear_stiffness(material, std::min(s.radi, s.radj), s.radsum);

    if (s.contact_flags) *s.contact_flags |= CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL;
    Eigen::Map<Vec3> spring(s.contact_history + spring_);
    double& last_step = s.contact_history[last_step_];
    // The host forgets to clear the history of a pair that parts and meets again between two list
    // builds: a contact that did not exist one step ago starts anew.
    const bool fresh = last_step < step - 1.0;
    if (fresh) spring.setZero();
    if (advance) last_step = step;

    const Vec3 still = Vec3::Zero();
    const Vec3 omega_i = as_vec3(s.omega_i);
    const Vec3 omega_j = wall ? still : Vec3(as_vec3(s.omega_j));
    const ContactVelocity velocity = contact_velocity(normal, as_vec3(s.v_i), omega_i, arm_i,
                                                      as_vec3(s.v_j), omega_j, arm_j);
    Vec3 elongation = spring;
    const ContactForce force =
        linear_contact(material, k, overlap, s.meff, velocity, normal, dt, advance, elongation);
    if (advance) spring = elongation;

    const Vec3 on_i = force.shear - force.normal * normal;
    const Vec3 twist = normal.cross(force.shear);
    as_vec3(i_forces.delta_F) += on_i;
    as_vec3(i_forces.delta_torque) += arm_i * twist;
    as_vec3(j_forces.delta_F) -= on_i;
    as_vec3(j_forces.delta_torque) += arm_j * twist;

    double rolling_loss = 0.0;
    if constexpr (rolling != ROLLING_OFF) {
      Eigen::Map<Vec3> kept(s.contact_history + rolling_torque_);
      if (fresh) kept.setZero();
      Vec3 torque = kept;
      const double r = wall ? s.radi : rolling_radius(s.radi, s.radj);
      rolling_loss = advance_rolling_torque(k.shear, material.rolling_friction, r, force.normal,
                                            omega_i - omega_j, normal, advance ? dt : 0.0, torque);
      if (advance) kept = torque;
      as_vec3(i_forces.delta_torque) -= torque;
      as_vec3(j_forces.delta_torque) += torque;
    }

    s.kn = k.normal;
    s.kt = k.shear;
    s.Fn = force.normal;
    if (!s.computeflag) return;

    const double share = wall || s.j < lmp_->atom->nlocal ? 1.0 : 0.5;
    if (advance) {
      losses_->friction += share * force.friction_loss;
      losses_->dashpots += share * force.dashpot_loss;
      losses_->rolling += share * rolling_loss;
    }
    if (wall) {
      ask_probes();
      tell_owner(s, normal, -on_i, k.normal);
    }
    if (!active_.empty()) {
      const Contact contact{s.i,      wall ? -1 : s.j,
                            wall ? s.fix_mesh : nullptr,
                            normal,   on_i,
                            arm_i,    s.r,
                            k.normal, k.shear,
                            spring_energy(k, overlap, elongation),
                            share,    force.sliding};
      for (ContactProbe* probe : active_) probe->add_contact(contact);
    }
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
  void read_materials()
  {
    using encased_column::read_pair_property;
    const auto modulus = read_pair_property(lmp_, "contactModulus", 0.0, true);
    const auto ratio = read_pair_property(lmp_, "stiffnessRatio", 0.0, true);
    const auto friction = read_pair_property(lmp_, "coefficientFriction", 0.0, false);
    const auto beta_n = read_pair_property(lmp_, "dampingRatioNormal", 0.0, false, 0.0);
    const auto beta_s = read_pair_property(lmp_, "dampingRatioShear", 0.0, false, 0.0);
    const std::optional<double> no_rolling =
        rolling == ROLLING_OFF ? std::optional<double>(0.0) : std::nullopt;
    const auto roll = read_pair_property(lmp_, "coefficientRollingFriction", 0.0, false, no_rolling);
    stride_ = lmp_->atom->ntypes + 1;
    materials_.assign(stride_ * stride_, ContactMaterial());
    for (int i = 1; i < stride_; ++i)
      for (int j = 1; j < stride_; ++j)
        materials_[i * stride_ + j] = {modulus.at(i, j), ratio.at(i, j),  friction.at(i, j),
                                       beta_n.at(i, j),  beta_s.at(i, j), roll.at(i, j)};
  }

  void ask_probes()
  {
    if (asked_step_ == lmp_->update->ntimestep) return;
    asked_step_ = lmp_->update->ntimestep;
    active_.clear();
    for (encased_column::ContactProbe* probe : probes_)
      if (probe->wants_contacts(asked_step_)) active_.push_back(probe);
  }

  void tell_owner(const SurfacesIntersectData& s, const Vec3& normal, const Vec3& force,
                  double stiffness)
  {
    for (encased_column::WallContactOwner* owner : owners_)
      if (owner->wall_mesh() == s.fix_mesh) {
        const Vec3 point = Vec3(lmp_->atom->x[s.i]) + s.r * normal;
        owner->wall_contacts.push_back({s.i, s.j, point, force, stiffness});
        return;
      }
  }

  LAMMPS* lmp_;
  int spring_ = 0;
  int last_step_ = 0;
  int rolling_torque_ = 0;
  int stride_ = 0;
  std::vector<ContactMaterial> materials_;
  std::vector<encased_column::ContactProbe*> probes_, active_;
  std::vector<encased_column::WallContactOwner*> owners_;
  encased_column::ContactLosses no_account_;
  encased_column::ContactLosses* losses_ = &no_account_;
  bigint asked_step_ = -1;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

namespace encased_column {

/// Enters the linear law with one rolling model into the host's factories, for pairs and walls.
template <int rolling>
void register_linear_model()
{
  using namespace LIGGGHTS;
  using Model = ContactModels::ContactModel<ContactModels::LinearStyle<rolling>>;
  const int hash = static_cast<int>(Model::STYLE_HASHCODE);
  ContactModels::Factory::instance().addNormalModel("linear", linear_model_number);
  PairStyles::Factory::instance().addStyle(
      "gran", hash,
      [](LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGran* parent,
         int64_t hash) -> PairStyles::IGranularPairStyle* {
        return new PairStyles::Granular<Model>(lmp, parent, hash);
      });
  Walls::Factory::instance().addStyle("gran", hash,
                                      [](LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* parent,
                                         int64_t hash) -> Walls::IGranularWall* {
                                        return new Walls::Granular<Model>(lmp, parent, hash);
                                      });
}

}  // namespace encased_column
