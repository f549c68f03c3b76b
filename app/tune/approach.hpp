// Approaches: local minima of a body part's clearance, and the contact that could have occurred.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/session/robot_mass.hpp"
#include "app/tune/motion_window.hpp"
#include "core/contact/contact_area.hpp"
#include "core/contact/contact_limits.hpp"
#include "core/contact/predicted_contact.hpp"

namespace abstand::tune {

/// Relative motion of a part and a link, along the line of their nearest points.
struct ClosingMotion {
  double robot_speed{0.0};   ///< m/s, of the link's nearest point, positive towards the person
  double person_speed{0.0};  ///< m/s, of the part's nearest point, positive towards the robot
  /// kg, effective mass at that point, set by complete(); infinite: immovable, or unknown
  double robot_mass{kInfinity};
  Vector3d p_W{Vector3d::Zero()};                          ///< m, the nearest point on the link
  Vector3d n_W{Vector3d::UnitX()};                         ///< unit vector from the link to the part
  Vector3d p_L{Vector3d::Zero()}, n_L{Vector3d::UnitX()};  ///< the same in the link's frame, set by
                                                           ///< complete()
  double closing() const { return robot_speed + person_speed; }
};

/// Predicted contact at the speeds of one time. Limits of the table's edition.
struct ContactShare {
  double t{0.0}, closing{0.0};  ///< s; m/s, closing speed then
  std::string region;           ///< of the table, the worst one for the part
  bool excluded{false};
  double force{0.0}, energy{0.0};  ///< N, J
  double share{0.0};               ///< of the force limit; infinite if contact is excluded
  double pressure{0.0};            ///< Pa, peak, from the link's surface
  double pressure_share{0.0};
  contact::ContactKind kind{contact::ContactKind::kTransient};  ///< quasi-static: the part may be clamped
  double robot_mass{kInfinity};                                 ///< kg, at that point then; infinite: a wall
};

/// In place of the index of a tool: a body part itself.
inline constexpr std::uint16_t kNoTool = 65535;

/// A local minimum of a part's clearance, where closing speeds are low, and the hardest possible contact on
/// the way there: at the highest closing speed since the part came within `near`, or since the previous
/// minimum.
struct Approach {
  std::uint16_t part{0}, link{0};  ///< indices into PassResult
  std::uint16_t tool{kNoTool};     ///< index into PassResult::tools: this tool in the hand came near
  double t{0.0}, distance{0.0}, clearance{0.0};
  ClosingMotion motion;
  ContactShare contact;
};

/// Closing speeds, masses and predicted contacts of the frames of a pass. A contact with a tool is judged as
/// one with the hand that holds it: its force and energy arrive there. One thread.
class ApproachJudge {
 public:
  /// `limits` null: contacts are not judged. `clamped`: names of parts whose contacts are quasi-static. The
  /// session must outlive this object.
  ApproachJudge(const session::Session& session, std::shared_ptr<const contact::ContactLimits> limits,
                std::vector<std::string> clamped);

  /// Motion of pair `index` at `frame`, with the velocities to the next frame; at rest if there is none.
  /// Without the members set by complete().
  static ClosingMotion motion(const WindowFrame& frame, const WatchedPair& pair, std::size_t index);
  /// Sets the members that a contact needs: the point in the link's frame, and the robot's mass in the
  /// posture of the frame, which is the larger of the effective mass with free joints at that point (without
  /// the inertia reflected by gears) and half the moving mass [ISO/TS 15066:2016, annex A].
  void complete(const WindowFrame& frame, const WatchedPair& pair, ClosingMotion& motion);
  /// Predicted contact of part `part` with a link (object indices in `pair`) for this motion at time `t`.
  ContactShare contact(const ClosingMotion& motion, double t, const WatchedPair& pair,
                       const std::string& part);
  /// True if no contact with part `part` is allowed: the table excludes it, or does not know it.
  bool excluded(const std::string& part);
  contact::ContactKind kindOf(const std::string& part) const;
  /// 0 to `wanted`, which is 1 at most: share of the robot's speed at which a contact of the pair
  /// would stay within the limits of every region of the part, with the person's speed as it is
  /// (contact::allowedSpeed). The robot moves towards the person. 0 for what is excluded. `motion` is
  /// complete() if its closing speed is above 0. The less is wanted, the less is computed.
  double contactShare(const WatchedPair& pair, const std::string& part, const ClosingMotion& motion,
                      double wanted);

 private:
  const std::vector<const contact::RegionLimits*>& regionsOf(const std::string& part);
  contact::ContactArea areaAt(const ClosingMotion& motion, const WatchedPair& pair, double indentation);

  struct Robot {
    session::RobotMass mass;
    std::size_t first, dof;  ///< index of its first joint value among those of all robots
  };
  const session::Session& session_;
  std::shared_ptr<const contact::ContactLimits> limits_;
  std::vector<std::string> clamped_;
  std::vector<Robot> robots_;
  /// m, for an object of a person: the smallest half extent of the bare part, or of a tool if that is
  /// smaller. A larger radius would increase the area and reduce the pressure.
  std::map<std::size_t, double> radius_of_;
  std::map<std::size_t, int> frame_of_;  ///< for a link's object: index of its mechanism's frame
  std::map<const structure::HapticStructure*, std::unique_ptr<contact::ContactSurface>> surfaces_;
  std::map<std::string, std::vector<const contact::RegionLimits*>> regions_;  ///< of parts, cached
  /// The last place of contact with its areas by indentation: regions of a part often share one.
  struct KnownAreas {
    const structure::HapticStructure* link{nullptr};
    Vector3d p_L{Vector3d::Zero()}, n_L{Vector3d::Zero()};
    double radius{0.0};
    std::vector<std::pair<double, contact::ContactArea>> areas;
  };
  KnownAreas last_;
};

}  // namespace abstand::tune
