// Checks whether a robot can still stop before a person can reach its path.
#pragma once

#include "app/session/robot_pairs.hpp"
#include "core/safety/link_motion.hpp"
#include "core/safety/stop_reason.hpp"
#include "core/safety/swept_pair.hpp"

namespace abstand::session {

/// The law `braking`: from its current joint values and velocities the robot is assumed to continue for the
/// reaction time and then brake, while every part of a person moves arbitrarily within bounds on its speed
/// and acceleration (reach_set.hpp), starting where it was seen and with a speed bound of at least its
/// observed speed. If the certified minimum distance along that path is below the required one, there is a
/// cause to stop now. A robot that brakes as specified when told therefore never moves while it is nearer to
/// a person [the question of the thesis's [33], Taeubig and Frese, for a moving person].
///
/// A pair that is far enough in any case costs one addition; a near one some queries along the path
/// (swept_pair.hpp). One thread; only the constructor allocates or throws.
class BrakingWatch {
 public:
  /// Watches the pairs with people among `own`, RobotPairs::own(). Throws UsageError for options that do not
  /// fit the mechanism. Driver, scene and own must outlive this object.
  BrakingWatch(const MechanismDriver& driver, const scene::Scene& scene, std::span<const RobotPairs::Own> own,
               const control::BrakingLawOptions& options);

  /// Replaces the options, between two cycles. Throws UsageError before anything changes.
  void setOptions(const control::BrakingLawOptions& options);
  /// The worst cause, with the certified distance (m; -infinity if joint values are unknown), or nullopt.
  /// Call after the scene's step. `q`, `qd`: size dof.
  std::optional<safety::StopCause> check(const scene::Scene& scene, std::span<const double> q,
                                         std::span<const double> qd) noexcept;
  /// Number of pair queries in the last check().
  int queries() const { return queries_; }

 private:
  struct Watched {
    PairId id;
    int link;     ///< index into links_
    bool link_a;  ///< the link is A of the pair
    query::PairMemory memory;
  };
  double minDistance(Watched& watched, const scene::Scene& scene) noexcept;
  void setSwept();

  const mechanism::Mechanism& mechanism_;
  control::BrakingLawOptions options_;
  safety::BrakingPath path_;
  std::vector<safety::LinkMotion> links_;
  std::vector<double> speeds_;  ///< m/s, speed bound of each of links_ on the current path
  std::vector<Watched> watched_;
  safety::SweptOptions swept_;
  safety::SweptScratch scratch_;
  int queries_{0};
};

}  // namespace abstand::session
