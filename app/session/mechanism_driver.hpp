// Moves a mechanism's links, and maps their contact wrenches to joint efforts.
#pragma once

#include <optional>
#include <span>

#include "app/scene_file/scene_description.hpp"
#include "core/mechanism/dof_limits.hpp"
#include "core/mechanism/joint_axis.hpp"
#include "core/mechanism/mechanism.hpp"
#include "core/mechanism/motion_file.hpp"
#include "core/scene/scene.hpp"

namespace abstand::session {

/// One mechanism of a session. Loop thread only.
class MechanismDriver {
 public:
  /// Reads the mechanism and its motion. Throws ParseError.
  explicit MechanismDriver(const scene_file::MechanismDescription& description);

  /// Sets the scene object of link `link` of the description.
  void bind(std::size_t link, ObjectId object) { links_[link].object = object; }
  /// Pose of the base in the world, from the next pose on. Not while a closed loop runs.
  void setBase(const Transform& X_WB) { X_WB_ = X_WB; }
  /// `loose`: the link is posed by the proxy, and its contacts do not act on the joints.
  void setProxyControlled(std::size_t link, bool loose) { links_[link].loose = loose; }
  /// Pairs of links (indices) that share a joint, i.e. without another link between them in the tree of
  /// frames, or that no joint moves relative to each other.
  std::vector<std::pair<std::size_t, std::size_t>> adjacentLinks() const;

  /// Joint values at time t (home() without a motion; those set by hand while it is posed by hand), forward
  /// kinematics, poses of all links. No allocation, no throw.
  void apply(double t, scene::Scene& scene);
  /// The same for given joint values (rad, m; size dof()).
  void moveTo(std::span<const double> q, double t, scene::Scene& scene);
  /// Sets one joint (rad, m) by hand, clamped to its limits; from then on apply() ignores the motion. The
  /// other joints keep their present values. False, and no effect, for an unknown joint and for a value that
  /// is not finite. No allocation, no throw.
  bool poseByHand(int joint, double value) noexcept;
  /// Ends poseByHand().
  void followMotion() noexcept { by_hand_ = false; }
  bool byHand() const { return by_hand_; }
  const std::vector<mechanism::DofLimits>& limits() const { return limits_; }
  /// Marks all links as stale.
  void markStale(double t, scene::Scene& scene) const;
  /// Joint efforts (N m, N) caused by the contact wrenches on the links: J^T w. Size: dof().
  void efforts(const scene::Scene& scene, std::span<double> out) const;

  /// Axes of the joints in the world. Size: dof().
  void axes(std::span<mechanism::JointAxis> out) const;

  struct Link {
    int frame;  ///< index into the mechanism's frames, -1: the base
    Transform X_FL;
    std::optional<ObjectId> object;
    bool loose{false};  ///< setProxyControlled()
  };
  const std::vector<Link>& links() const { return links_; }
  const Transform& X_WB() const { return X_WB_; }  ///< base in world
  int dof() const { return mechanism_.dof; }
  const mechanism::Mechanism& mechanism() const { return mechanism_; }
  const std::vector<double>& q() const { return q_; }
  const std::vector<double>& home() const { return home_; }  ///< joint values in the scene file
  const std::optional<mechanism::MotionTable>& motion() const { return motion_; }
  const mechanism::MechanismState& state() const { return state_; }  ///< at q()

 private:
  int rigidBody(int frame) const;
  void place(double t, scene::Scene& scene);

  mechanism::Mechanism mechanism_;
  mechanism::MechanismState state_;
  Transform X_WB_;
  std::vector<mechanism::DofLimits> limits_;
  std::vector<double> home_, q_;
  std::vector<double> hand_;  ///< joint values set by hand
  bool by_hand_{false};
  std::optional<mechanism::MotionTable> motion_;
  std::vector<Link> links_;
};

}  // namespace abstand::session
