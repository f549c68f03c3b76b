// Physics world of mechanisms and free bodies.
#pragma once

#include <memory>

#include "core/physics/articulation.hpp"
#include "core/physics/contact_damping.hpp"

struct dxThreadingImplementation;  // ODE's

namespace abstand::physics {

/// Target of a wrench. Default-constructed: the world itself, on which wrenches have no effect.
struct PhysicsObject {
  int mechanism{-1};  ///< number of the mechanism; -1: a free body, or the world
  int index{-1};      ///< index of the mechanism's frame (-1: its base), or number of the free body
};

struct PhysicsOptions {
  Vector3d gravity_W{mechanism::kGravity};  ///< m/s^2
};

/// An ODE world. ODE moves the free bodies and solves the mechanisms' joints (or own forward dynamics, if a
/// mechanism selects it). Contact forces come from this project's engine; ODE's collision detection is never
/// called. Loop thread only; worlds of different threads are independent.
class PhysicsWorld {
 public:
  explicit PhysicsWorld(const PhysicsOptions& options = {});
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  /// Adds a mechanism at q = 0, at rest; returns its number. X_WB: constant pose of its base. Throws
  /// ParseError for a mechanism that cannot be simulated (the message names the link without mass),
  /// UsageError for invalid options.
  int addMechanism(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                   const MechanismOptions& options = {});
  /// Adds a body whose frame F is at X_WF, moving with `twist_W` (of its centre of mass); returns its number.
  /// Throws UsageError for a body without mass or extent.
  int addFreeBody(const mechanism::LinkInertia& body, const Transform& X_WF, const Twist& twist_W = {});

  Articulation& mechanism(int number) { return *mechanisms_.at(static_cast<std::size_t>(number)); }
  const Articulation& mechanism(int number) const {
    return *mechanisms_.at(static_cast<std::size_t>(number));
  }

  /// Joint values and rates (rad, m, rad/s, m/s) of a mechanism; Articulation has the rest.
  std::span<const double> q(int mechanism_number) const { return mechanism(mechanism_number).q(); }
  std::span<const double> qd(int mechanism_number) const { return mechanism(mechanism_number).qd(); }
  /// Values that are not finite or above 1e9 in absolute value are dropped and counted: the old value stays.
  void setJointEffort(int mechanism_number, int dof, double effort);
  void setMotor(int mechanism_number, int dof, double velocity, double max_effort);

  /// Adds a wrench for the next step, torque about `p_W`. Wrenches that are not finite or above 1e9 N or N m
  /// are dropped and counted.
  void applyWrench(const PhysicsObject& object, const Wrench& w_W, const Vector3d& p_W);
  /// Applies the penalty wrench of a pair to both bodies, with damping and friction, for a next step of `h`
  /// seconds. No effect if the force is 0.
  void applyContact(const PhysicsObject& a, const PhysicsObject& b, const Contact& contact,
                    const ContactOptions& options, double h);

  /// Advances by `h` seconds (> 0) under the wrenches applied since the last step. No throw, and no
  /// allocation of our own after the first steps; ODE keeps its own memory from step to step.
  void step(double h);

  /// Pose of a frame, a mechanism's base or a free body's own frame; identity for the world.
  Transform pose(const PhysicsObject& object) const;
  /// Velocity of the point of the object that is at `p_W`.
  Twist velocityAt(const PhysicsObject& object, const Vector3d& p_W) const;
  /// J, of all mechanisms and free bodies; potential energy is 0 at the world's origin.
  mechanism::MechanicalEnergy energy();

  double time() const { return time_; }      ///< s, sum of all steps
  long dropped() const { return dropped_; }  ///< number of dropped inputs

 private:
  struct FreeBody;
  double mobilityOf(const PhysicsObject& object, const Vector3d& p_W, const Wrench& w_W);
  bool accept(const Wrench& w, const Vector3d& p);

  Vector3d gravity_W_;
  double time_{0.0};
  long dropped_{0};
  std::unique_ptr<dxThreadingImplementation, void (*)(dxThreadingImplementation*)> threading_;
  std::unique_ptr<dxWorld, void (*)(dxWorld*)> world_;
  std::vector<std::unique_ptr<Articulation>> mechanisms_;  // must be destroyed before the world
  std::vector<Transform> bases_;
  std::vector<FreeBody> bodies_;
};

}  // namespace abstand::physics
