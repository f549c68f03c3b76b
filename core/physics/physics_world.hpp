// Mechanisms and free bodies that obey Newton and Euler.
#pragma once

#include <memory>

#include "core/physics/articulation.hpp"
#include "core/physics/contact_damping.hpp"

struct dxThreadingImplementation;  // ODE's

namespace abstand::physics {

/// What can be pushed. A default one is the world itself: pushes on it do nothing.
struct PhysicsObject {
  int mechanism{-1};  ///< number of the mechanism; -1: a free body, or the world
  int index{-1};      ///< index of the mechanism's frame (-1: its base), or number of the free body
};

struct PhysicsOptions {
  Vector3d gravity_W{mechanism::kGravity};  ///< m/s^2
};

/// An ODE world. ODE moves the free bodies and solves the mechanisms' joints (or our own forward dynamics
/// does, where a mechanism asks for it); contact forces come from outside, from our own engine, and ODE's
/// collider is never called. Loop thread only; worlds of different threads are independent.
class PhysicsWorld {
 public:
  explicit PhysicsWorld(const PhysicsOptions& options = {});
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  /// At q = 0, at rest; gives its number. X_WB: its base, for good. Throws ParseError for a mechanism that
  /// cannot be simulated (the message says which link lacks a mass), UsageError for unfit options.
  int addMechanism(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                   const MechanismOptions& options = {});
  /// A body whose own frame F stands at X_WF, moving with `twist_W` (of its centre of mass); gives its
  /// number. Throws UsageError for a body without mass or extent.
  int addFreeBody(const mechanism::LinkInertia& body, const Transform& X_WF, const Twist& twist_W = {});

  Articulation& mechanism(int number) { return *mechanisms_.at(static_cast<std::size_t>(number)); }
  const Articulation& mechanism(int number) const {
    return *mechanisms_.at(static_cast<std::size_t>(number));
  }

  /// Joint values and rates (rad, m, rad/s, m/s) of a mechanism; Articulation has the rest.
  std::span<const double> q(int mechanism_number) const { return mechanism(mechanism_number).q(); }
  std::span<const double> qd(int mechanism_number) const { return mechanism(mechanism_number).qd(); }
  /// What is not finite, or beyond 1e9 in size, is dropped and counted: the old value stays.
  void setJointEffort(int mechanism_number, int dof, double effort);
  void setMotor(int mechanism_number, int dof, double velocity, double max_effort);

  /// A wrench that acts during the next step, torque about `p_W`. Wrenches add up. One that is not finite, or
  /// beyond 1e9 N or N m, is dropped and counted.
  void applyWrench(const PhysicsObject& object, const Wrench& w_W, const Vector3d& p_W);
  /// The penalty wrench of a pair on both bodies, with what makes them come to rest, for a next step of `h`
  /// seconds. No contact (force 0): nothing happens.
  void applyContact(const PhysicsObject& a, const PhysicsObject& b, const Contact& contact,
                    const ContactOptions& options, double h);

  /// Moves everything by `h` seconds (> 0) under the wrenches that were applied since the last step. No
  /// throw, and no allocation of ours after the first steps; ODE keeps its own memory from step to step.
  void step(double h);

  /// Pose of a frame, of a mechanism's base, of a free body's own frame; identity for the world.
  Transform pose(const PhysicsObject& object) const;
  /// Velocity of the object's point that is at `p_W`.
  Twist velocityAt(const PhysicsObject& object, const Vector3d& p_W) const;
  /// J, of all mechanisms and free bodies; potential energy is 0 at the world's origin.
  mechanism::MechanicalEnergy energy();

  double time() const { return time_; }      ///< s, of all steps
  long dropped() const { return dropped_; }  ///< inputs that were no numbers

 private:
  struct FreeBody;
  double mobilityOf(const PhysicsObject& object, const Vector3d& p_W, const Wrench& w_W);
  bool accept(const Wrench& w, const Vector3d& p);

  Vector3d gravity_W_;
  double time_{0.0};
  long dropped_{0};
  std::unique_ptr<dxThreadingImplementation, void (*)(dxThreadingImplementation*)> threading_;
  std::unique_ptr<dxWorld, void (*)(dxWorld*)> world_;
  std::vector<std::unique_ptr<Articulation>> mechanisms_;  // die before the world
  std::vector<Transform> bases_;
  std::vector<FreeBody> bodies_;
};

}  // namespace abstand::physics
