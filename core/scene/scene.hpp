// The shared collision scene: objects, pairs and the lock-step cycle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/base/id.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/minimum_tree.hpp"
#include "core/scene/object_motions.hpp"
#include "core/scene/pair_queries.hpp"
#include "core/scene/pair_updates.hpp"
#include "core/scene/scene_object.hpp"
#include "core/scene/scene_pair.hpp"

namespace abstand::scene {

/// One thread builds and steps a scene; step() spreads the pairs over worker threads and sums in pair order,
/// so the bits are the same for any number of threads. Pairs of two bodies that have not moved keep their
/// results, which are those that a query would give again, so a step costs what has moved. What else may be
/// left out is in QueryCulling. After the first step(), step() allocates nothing and locks nothing but the
/// workers' barrier. Other threads read snapshots, never the scene.
class Scene {
 public:
  /// Poses in the mean velocity.
  static constexpr int kMeanSamples = ObjectMotions::kMeanSamples;
  /// A pose farther from the origin than this (m) is refused.
  static constexpr double kFarthest = 1e6;
  static constexpr int kMaxThreads = 256;

  Scene();
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// Throws UsageError for a name that is empty or taken and for a margin that is negative or not finite.
  ObjectId addObject(ObjectSpec spec);
  PairId addPair(ObjectId a, ObjectId b);  ///< throws UsageError for a == b or a pair that is there
  /// Lock-step threads, the calling one included; 1: the calling thread alone; 0: all cores. Not during
  /// step(). Throws UsageError for a number below 0 or above kMaxThreads.
  void setThreads(int threads);
  int threads() const { return queries_.threads(); }
  void setMargin(ObjectId object, double margin);  ///< throws UsageError, as addObject
  /// For all pairs, those that are added later too. Throws UsageError unless finite and not negative.
  void setForceLaw(query::ForceLaw law, double stiffness);

  /// m/s, from the next pose on; infinity: no bound. Throws UsageError unless 0 or more.
  void setMaxSpeed(ObjectId object, double speed);
  const SpeedWatch& speedWatch() const { return motions_.speedWatch(); }
  /// From the next step() on. Throws UsageError.
  void setCulling(const QueryCulling& culling);
  /// The next step() queries every pair, and from nothing but its poses: its numbers, and those of the steps
  /// after it, do not depend on what was before. No allocation.
  void startCold() noexcept;
  const QueryCulling& culling() const { return queries_.culling(); }
  /// What the time budget is measured with: seconds from any beginning. Default: the steady clock.
  using Clock = PairQueries::Clock;
  void setClock(Clock clock) { queries_.setClock(clock); }

  /// False, and the object keeps its last pose and is flagged kRejected, when the pose is not finite, no
  /// rotation or farther than kFarthest from the origin, or t is not finite. Velocities come from the rise of
  /// t: at the same t the pose is replaced and the velocities stay; at an earlier t (a jump back in a
  /// recording) they start again from zero.
  bool setPose(ObjectId object, const Transform& X_WB, double t, PoseState state = PoseState::kFresh);

  /// Of the pose that was set last, m; less than 0 and NaN count as infinite. Distances, contacts and forces
  /// stay those of the bodies where they were seen. No allocation, no throw.
  void setPoseUncertainty(ObjectId object, double radius) noexcept;
  /// m: by how much the bodies of a pair may be nearer to each other than its distance says; infinite for a
  /// paused pair.
  double pairUncertainty(PairId id) const {
    const Pair& pair = pairs_[id.index()];
    if (pair.paused) return kInfinity;
    return objects_[pair.a.index()].pose_uncertainty + objects_[pair.b.index()].pose_uncertainty;
  }

  /// Whether step() leaves the pair out; at first it does not. From the next step() on, a paused pair has no
  /// part in touching(), nearest() and the totals of objects, and its result stays that of time `t` (s): it
  /// is stale, so pairUncertainty() is infinite. A pair that goes on is queried in the next step(). Nothing
  /// where nothing changes. No allocation.
  void setPaused(PairId id, bool paused, double t);
  std::size_t pausedCount() const { return paused_count_; }
  /// s at time `t`: how old the poses are that the pair's result belongs to. 0 for what the last step()
  /// looked at; what take() was told else; infinite without a result and where `t` lies before it.
  double ageOf(PairId id, double t) const;

  /// Brings every pair's result up to the present poses and sums the totals of the objects.
  void step();
  /// In the place of step() where others query the pairs (live mode): takes a result for each pair, in order,
  /// and the times (s) of the poses that they belong to; without times they belong to the present poses.
  void take(const std::vector<query::PairResult>& results, std::span<const double> times = {});
  /// Steps so far.
  long steps() const { return steps_; }
  const StepCounts& counts() const { return counts_; }  ///< of the last step()

  std::size_t objectCount() const { return objects_.size(); }
  const Object& object(ObjectId id) const { return objects_[id.index()]; }
  const std::vector<Object>& objects() const { return objects_; }
  const PairTable& pairs() const { return pairs_; }
  const query::PairResult& result(PairId id) const { return pairs_[id.index()].result; }
  /// Pairs whose results the last step() renewed; the others are as they were. In no order.
  const std::vector<PairId>& renewed() const { return updates_.renewed(); }
  /// Pairs with contacts, in order.
  const std::vector<PairId>& touching() const { return touching_; }
  /// The pair with the smallest distance, the first of equal ones; none before the first step().
  std::optional<PairId> nearest() const;
  /// The last step() (of steps()) that renewed a pair which is named with this object; every renewed pair
  /// is named with one of its two.
  long lastUpdateStep(ObjectId id) const { return updates_.lastUpdateStep(id); }
  /// The object with this name, or null. The pointer holds until the next addObject.
  const Object* find(const std::string& name, ObjectId* id = nullptr) const;
  /// The thesis's relation table: the pairs of one object (row and column).
  const std::vector<PairId>& pairsOf(ObjectId id) const { return pairs_of_[id.index()]; }
  /// Bytes of all haptic structures, shared ones counted once.
  std::size_t memoryBytes() const;

 private:
  void enqueue(PairId id) { updates_.enqueue(id, pairs_[id.index()]); }
  void enqueueAll();
  void renew(PairId id);
  void count(Pair& pair);
  void dateResults();
  void updateContactList();
  void sumWrenches();

  std::vector<Object> objects_;
  PairTable pairs_;
  std::vector<std::vector<PairId>> pairs_of_;
  std::unordered_map<std::string, std::uint32_t> index_of_;
  std::unordered_set<std::uint64_t> pair_keys_;
  ObjectMotions motions_;
  PairUpdates updates_;
  PairQueries queries_;
  std::vector<PairId> touching_;
  MinimumTree distances_;
  query::ForceLaw law_{query::ForceLaw::kVolume};
  double stiffness_{query::PairOptions{}.stiffness};
  StepCounts counts_;
  /// Of each pair, s: the time of the poses of its result; NaN: the present ones.
  std::vector<double> result_time_;
  bool taken_{false};  ///< the results came from take()
  bool dated_{false};  ///< some of result_time_ may be no NaN
  std::size_t paused_count_{0};
  long steps_{0};
};

}  // namespace abstand::scene
