// Whether a robot could still stop before anybody can be where it goes.
#pragma once

#include "app/session/robot_pairs.hpp"
#include "core/safety/link_motion.hpp"
#include "core/safety/stop_reason.hpp"
#include "core/safety/swept_pair.hpp"

namespace abstand::session {

/// The law `braking`: from its present joint values and velocities the robot goes on for the reaction time
/// and then brakes; every part of a person goes anywhere that the bounds on its speed and acceleration let it
/// go (reach_set.hpp), from where it was seen, and at least as fast as it was seen. Where the certified
/// smallest distance on that way is below what is allowed, there is a cause to stop now. So a robot that
/// brakes as it says, when it is told, never moves while it is nearer to a person than that [the question of
/// the thesis's [33], Taeubig and Frese, for a person who moves].
///
/// A pair that is far enough, whatever happens, costs an addition; a near one some queries along the way
/// (swept_pair.hpp). One thread; nothing allocates or throws but the constructor.
class BrakingWatch {
 public:
  /// Of the pairs with people among `own`, RobotPairs::own(). Throws UsageError for options that do not fit
  /// the mechanism. Driver, scene and own must outlive it.
  BrakingWatch(const MechanismDriver& driver, const scene::Scene& scene, std::span<const RobotPairs::Own> own,
               const control::BrakingLawOptions& options);

  /// The worst cause, with the certified distance (m; -infinity where the joints are not known), or nothing.
  /// After the scene's step. `q`, `qd`: size dof.
  std::optional<safety::StopCause> look(const scene::Scene& scene, std::span<const double> q,
                                        std::span<const double> qd) noexcept;
  /// Queries of pairs in the last look().
  int queries() const { return queries_; }

 private:
  struct Watched {
    PairId id;
    int link;     ///< index into links_
    bool link_a;  ///< the link is A of the pair
    query::PairMemory memory;
  };
  double least(Watched& watched, const scene::Scene& scene) noexcept;

  control::BrakingLawOptions options_;
  safety::BrakingPath path_;
  std::vector<safety::LinkMotion> links_;
  std::vector<double> speeds_;  ///< m/s, of each of links_ on the present path
  std::vector<Watched> watched_;
  safety::SweptOptions swept_;
  safety::SweptScratch scratch_;
  int queries_{0};
};

}  // namespace abstand::session
