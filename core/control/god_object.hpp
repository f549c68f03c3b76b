// God-object method: a held object stays on the surface while the hand is pressed into it.
#pragma once

#include <optional>
#include <span>

#include "core/config/number_rule.hpp"
#include "core/query/pair_query.hpp"

namespace abstand::control {

/// SI.
struct GodObjectOptions {
  static constexpr const char* kName = "proxy";
  double stiffness{1000.0};         ///< N/m, of the spring between object and hand
  double rotation_stiffness{10.0};  ///< N m/rad
  double force{50.0};               ///< N, largest
  double torque{5.0};               ///< N m, largest
  /// m, kept between object and surface. Apart, distances and directions are exact; inside, the direction out
  /// is less certain.
  double gap{5e-4};
  double step{0.01};  ///< m, largest displacement of a point of the object in one update

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("stiffness", o.stiffness, config::NumberRule{0.0, 1e7, "N/m"});
    visit("rotation_stiffness", o.rotation_stiffness, config::NumberRule{0.0, 1e6, "N m/rad"});
    visit("force", o.force, config::NumberRule{0.0, 1e6, "N"});
    visit("torque", o.torque, config::NumberRule{0.0, 1e6, "N m"});
    visit("gap", o.gap, config::NumberRule{0.0, 0.1, "m"});
    visit("step", o.step, config::NumberRule{0.0, 1.0, "m", true});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// The object must not move along -normal by more than the gap at this point.
struct ContactConstraint {
  Vector3d p_W{Vector3d::Zero()};       ///< on the object
  Vector3d normal_W{Vector3d::Zero()};  ///< unit, outward normal of the other body
  double gap{0.0};                      ///< m, signed distance
};

/// From the result of a pair with the object as A (or as B), queried at the object's pose, preferably with a
/// PairMemory; nullopt if the pair has no direction. The gap is the certified lower bound if `certain`,
/// otherwise the distance.
std::optional<ContactConstraint> constraintOf(const query::PairResult& result, bool object_is_a,
                                              bool certain = false) noexcept;

/// God-object method of the thesis's [25] (Ortega, Redon, Coquillart 2007, A Six Degree-of-Freedom God-Object
/// Method; Zilles and Salisbury 1995): the object's pose is the one nearest to the hand's that the contacts
/// allow, by Gauss's principle of least constraint. One update moves it by the (dp, dtheta) that minimise
///   |dp - dp*|^2 + rho^2 |dtheta - dtheta*|^2   with   n_i . (dp + dtheta x (p_i - c)) >= gap - gap_i
/// where (dp*, dtheta*) leads to the hand's pose, limited to `step`, c is the centre and rho^2 = 2 r^2 / 5
/// that of a ball around the body. No friction. Contacts are those of the pose before the update, so it may
/// penetrate by the curvature of the surfaces within a step; the next update corrects it. Call repeatedly
/// with new contacts until still() for the pose nearest to the hand. One thread, no allocation.
class GodObject {
 public:
  static constexpr std::size_t kMaxConstraints = 32;

  /// `sphere_O` contains the object; its centre is c. Throws UsageError.
  GodObject(const GodObjectOptions& options, const geometry::EnclosingSphere& sphere_O);

  /// Replaces the options; the pose stays. `options`: validated.
  void setOptions(const GodObjectOptions& options) noexcept { o_ = options; }
  void reset(const Transform& X_WO) noexcept;  ///< sets object and hand to X_WO
  /// @param X_WH         pose of the object in the hand; not finite: the object stays and the wrench is 0
  /// @param constraints  at pose(), at most kMaxConstraints; if there are more, the nearest ones
  void update(const Transform& X_WH, std::span<const ContactConstraint> constraints) noexcept;

  const Transform& pose() const { return X_WO_; }
  /// The spring's wrench on the hand, about the object's centre at the hand's pose (handCentre()), limited to
  /// the largest force and torque.
  const Wrench& wrench() const { return wrench_; }
  const Vector3d& handCentre() const { return hand_; }  ///< world
  double moved() const {
    return moved_;
  }  ///< m, upper bound on the displacement of any point by the last
     ///< update
  bool still(double tolerance = 1e-6) const { return moved_ <= tolerance; }

 private:
  GodObjectOptions o_;
  geometry::EnclosingSphere sphere_O_;
  Transform X_WO_{Transform::Identity()};
  Wrench wrench_;
  Vector3d hand_{Vector3d::Zero()};
  double moved_{0.0};
};

}  // namespace abstand::control
