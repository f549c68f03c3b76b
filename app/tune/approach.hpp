// The moments at which a body part came nearest, and what a contact would have been then.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/session/robot_mass.hpp"
#include "app/tune/motion_window.hpp"
#include "core/contact/contact_area.hpp"
#include "core/contact/contact_limits.hpp"

namespace abstand::tune {

/// How a part and a link move towards each other at a moment, along the line of their nearest points.
struct ClosingMotion {
  double robot_speed{0.0};   ///< m/s, of the link's nearest point, positive towards the person
  double person_speed{0.0};  ///< m/s, of the part's nearest point, positive towards the robot
  /// kg, effective at that point, of complete(); infinite: a wall, or not known
  double robot_mass{kInfinity};
  Vector3d p_W{Vector3d::Zero()};                          ///< m, the nearest point on the link
  Vector3d n_W{Vector3d::UnitX()};                         ///< unit vector from the link to the part
  Vector3d p_L{Vector3d::Zero()}, n_L{Vector3d::UnitX()};  ///< the same in the link's frame, of complete()
  double closing() const { return robot_speed + person_speed; }
};

/// A contact as it would have been with the speeds of a moment. Limits of the table's edition.
struct ContactShare {
  double t{0.0}, closing{0.0};  ///< s; m/s: of the moment
  std::string region;           ///< of the table, the worst one of the part
  bool excluded{false};
  double force{0.0}, energy{0.0};  ///< N, J
  double share{0.0};               ///< of the force limit; infinite where contact is excluded
  double pressure{0.0};            ///< Pa, peak, from the link's surface
  double pressure_share{0.0};
};

/// A local minimum of a part's clearance, where closing speeds are low, and the hardest contact that could
/// have been on the way there: with the highest closing speed since the part came near or was nearest before.
struct Approach {
  std::uint16_t part{0}, link{0};  ///< indices into PassResult
  double t{0.0}, distance{0.0}, clearance{0.0};
  ClosingMotion motion;
  ContactShare contact;
};

/// Speeds, masses and contacts of the frames of a pass. One thread.
class ApproachJudge {
 public:
  /// Null for no table: contacts are not judged. The session must outlive it.
  ApproachJudge(const session::Session& session, std::shared_ptr<const contact::ContactLimits> limits);

  /// Of a pair (number `index`) at `frame`, with the velocities to the next frame; at rest without one.
  /// Without what complete() fills.
  static ClosingMotion motion(const WindowFrame& frame, const WatchedPair& pair, std::size_t index);
  /// What a contact needs besides: the point in the link's frame, and the robot's mass in the posture of the
  /// frame. That is the larger one of the mass that the free joints put against a push at that point, which
  /// leaves out what gears reflect, and of half the moving mass [ISO/TS 15066:2016, annex A].
  void complete(const WindowFrame& frame, const WatchedPair& pair, ClosingMotion& motion);
  /// Of the part called `part` with a link (numbers of their objects) that moved so at time `t`.
  ContactShare contact(const ClosingMotion& motion, double t, const WatchedPair& pair,
                       const std::string& part);
  /// No speed of contact is allowed with the part called `part`: the table excludes it, or none is known.
  bool excluded(const std::string& part);
  /// 0 to `wanted`, which is 1 at most: share of the robot's speed at which a transient contact of the pair
  /// would stay within the limits of every region of the part, with the person's speed as it is
  /// (contact::allowedSpeed). The robot moves towards the person. 0 for what is excluded. `motion` need not
  /// be complete(). The less is wanted, the less is computed.
  double contactShare(const WindowFrame& frame, const WatchedPair& pair, const std::string& part,
                      const ClosingMotion& motion, double wanted);

 private:
  const std::vector<const contact::RegionLimits*>& regionsOf(const std::string& part);
  contact::ContactArea areaAt(const ClosingMotion& motion, const WatchedPair& pair, double indentation);

  struct Robot {
    session::RobotMass mass;
    std::size_t first, dof;  ///< its joint values among those of all robots
  };
  const session::Session& session_;
  std::shared_ptr<const contact::ContactLimits> limits_;
  std::vector<Robot> robots_;
  std::map<std::size_t, int> frame_of_;  ///< of a link's object: index of its mechanism's frame
  std::map<std::size_t, std::unique_ptr<contact::ContactSurface>> surfaces_;
  std::map<std::string, std::vector<const contact::RegionLimits*>> regions_;  ///< of parts, once asked for
};

}  // namespace abstand::tune
