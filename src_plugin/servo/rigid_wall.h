#pragma once

#include "core/keyword_table.h"
#include "host/contact_probe.h"
#include "servo/servo_law.h"

#include <memory>
#include <string>

namespace encased_column {

class WallMover;

/// A rigid wall made of one mesh, standing still, moving at a speed, or driven by a stress.
/// What a platen and a cylinder share: the mesh, its motion, its contacts, its load and work.
class RigidWall : public LAMMPS_NS::Fix, public WallContactOwner {
 public:
  RigidWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~RigidWall() override;

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_force(int) override;
  void final_integrate() override;
  int modify_param(int narg, char** arg) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  LAMMPS_NS::FixMeshSurface* wall_mesh() const override { return mesh_; }

  const WallLoad& load() const { return load_; }
  double work_on_grains() const { return work_; }
  /// Speed [m/s] towards the specimen.
  double speed() const { return speed_; }

 protected:
  /// Keywords every rigid wall reads; a derived table begins with them.
  void read_motion(const Options& options);
  virtual const KeywordTable& table() const = 0;
  /// Force and stiffness of this rank's contacts.
  virtual WallLoad local_load() const = 0;
  /// Area [m^2] that turns the target stress into a force.
  virtual double loaded_area() const = 0;
  /// Largest speed [m/s] when the deck gives none.
  virtual double usual_speed_limit() const = 0;
  /// Moves the mesh by `distance` [m] towards the specimen and gives its nodes their velocity.
  virtual void advance(WallMover& mover, double distance) = 0;
  /// Called once the mesh is complete on all ranks.
  virtual void measure(WallMover& mover) = 0;

  WallMover& mover() { return *mover_; }
  LAMMPS_NS::FixMeshSurface* mesh_ = nullptr;

 private:
  enum class Drive { hold, speed, stress };
  void take_load();
  double target_now() const;
  void choose_speed();

  std::string mesh_id_;
  std::unique_ptr<WallMover> mover_;
  Drive drive_ = Drive::hold;
  double target_ = 0.0, ramp_from_ = 0.0;
  LAMMPS_NS::bigint ramp_start_ = 0, ramp_steps_ = 0;
  double gain_ = 0.8;
  double speed_limit_ = 0.0;  ///< 0: usual_speed_limit()
  bool measured_ = false;
  WallLoad load_;
  double speed_ = 0.0, work_ = 0.0, force_before_ = 0.0;
};

/// The keywords of RigidWall.
const std::vector<Keyword>& rigid_wall_keywords();

}  // namespace encased_column
