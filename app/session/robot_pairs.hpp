// Pairs of one mechanism as input of its reaction.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/session/mechanism_driver.hpp"
#include "core/control/reaction.hpp"

namespace abstand::session {

class HumanDriver;

/// For each object of the scene, whether it is part of a person.
std::vector<bool> partsOfPeople(const scene::Scene& scene,
                                const std::vector<std::unique_ptr<HumanDriver>>& humans);

/// Distances, rows and rates of all pairs of the scene with a link of the mechanism. One thread; only the
/// constructor allocates or throws.
class RobotPairs {
 public:
  /// A pair of the scene with one or two of the mechanism's links.
  struct Own {
    PairId id;
    int link_a, link_b;  ///< index of the link, -1: not one of its links
    bool person;
  };

  /// `people`: partsOfPeople(). `reaction`: pairs not used by any of its laws get no row. The driver's links
  /// are bound. Driver and scene must outlive this object.
  RobotPairs(const MechanismDriver& driver, const scene::Scene& scene, const std::vector<bool>& people,
             const control::ReactionDescription& reaction);

  /// From now on pairs have the rows that the laws of this reaction use. No allocation.
  void setReaction(const control::ReactionDescription& reaction) noexcept;
  /// Call after the scene's step. `planned`: qd (rad/s or m/s; NaN: unknown) for ReactionPair::spread. In the
  /// order of own(); valid until the next call.
  std::span<const control::ReactionPair> gather(const scene::Scene& scene, std::span<const double> planned);
  const std::vector<Own>& own() const { return own_; }
  /// s, age at time `t` of the oldest result of its pairs (Scene::ageOf); 0 without pairs.
  double oldest(const scene::Scene& scene, double t) const;

 private:
  void moveLinks(std::span<const double> rates);
  double otherRate(const scene::Object& other, const Vector3d& p_W, const Vector3d& n_W, double sign) const;
  double spread(const Own& pair, const scene::Scene& scene, const Vector3d& n_W) const;

  const MechanismDriver& driver_;
  double reach_{-kInfinity};  ///< m: pairs within this distance have rows
  bool people_rows_{false};   ///< pairs with people have rows at any distance
  std::vector<Own> own_;
  std::vector<control::ReactionPair> pairs_;
  std::vector<double> rows_;   ///< one value for each dof and pair
  std::vector<Twist> twists_;  ///< planned twist of each link, at its frame's origin, world axes
  Eigen::Matrix<double, 6, Eigen::Dynamic> J_;
};

}  // namespace abstand::session
