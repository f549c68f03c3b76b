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

/// One thread builds and steps a scene. step() distributes the pairs over worker threads and sums in pair
/// order, so results are bit-identical for any number of threads. Pairs whose bodies have not moved keep
/// their results, which equal those of a new query, so the cost of a step is that of the moved bodies.
/// Further savings: QueryCulling. After the first step(), step() allocates nothing and locks nothing except
/// the workers' barrier. Other threads read snapshots, never the scene.
class Scene {
 public:
  /// Number of poses in the mean velocity.
  static constexpr int kMeanSamples = ObjectMotions::kMeanSamples;
  /// m: largest distance of a pose from the origin; farther ones are rejected.
  static constexpr double kFarthest = 1e6;
  static constexpr int kMaxThreads = 256;

  Scene();
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// Throws UsageError for a name that is empty or taken, and for a margin that is negative or not finite.
  ObjectId addObject(ObjectSpec spec);
  PairId addPair(ObjectId a, ObjectId b);  ///< throws UsageError for a == b or an existing pair
  /// Number of lock-step threads, including the calling one; 1: no workers; 0: all cores. Not during step().
  /// Throws UsageError below 0 or above kMaxThreads.
  void setThreads(int threads);
  int threads() const { return queries_.threads(); }
  void setMargin(ObjectId object, double margin);  ///< throws UsageError, as addObject
  /// Margin (m) of one pair, which replaces the sum of the margins of its objects; nullopt: the sum again.
  /// Throws UsageError for a margin that is negative or not finite. No allocation.
  void setPairMargin(PairId id, std::optional<double> margin);
  /// For all pairs, including those added later. Throws UsageError unless finite and not negative.
  void setForceLaw(query::ForceLaw law, double stiffness);

  /// Speed bound (m/s) from the next pose on; infinity: none. Throws UsageError unless >= 0.
  void setMaxSpeed(ObjectId object, double speed);
  const SpeedWatch& speedWatch() const { return motions_.speedWatch(); }
  /// Takes effect in the next step(). Throws UsageError.
  void setCulling(const QueryCulling& culling);
  /// The next step() queries every pair cold: its results, and those of later steps, do not depend on earlier
  /// steps. No allocation.
  void startCold() noexcept;
  const QueryCulling& culling() const { return queries_.culling(); }
  /// Clock of the time budget: seconds since any fixed time. Default: the steady clock.
  using Clock = PairQueries::Clock;
  void setClock(Clock clock) { queries_.setClock(clock); }

  /// Returns false, keeps the last pose and sets kRejected, if the pose is not finite, not a rotation or
  /// farther than kFarthest from the origin, or t is not finite. Velocities are computed from the increase of
  /// t: at the same t the pose is replaced and the velocities stay; at an earlier t (a jump back in a
  /// recording) they restart from zero.
  bool setPose(ObjectId object, const Transform& X_WB, double t, PoseState state = PoseState::kFresh);

  /// Uncertainty (m) of the last pose; negative values and NaN count as infinite. Distances, contacts and
  /// forces remain those of the observed poses. `from_age`: its share due to the age of the pose.
  /// `ellipsoid`: Object::pose_ellipsoid; ignored if it is not finite. No allocation, no throw.
  void setPoseUncertainty(ObjectId object, double radius, double from_age = 0.0,
                          const Matrix3d& ellipsoid = Matrix3d::Zero()) noexcept;
  /// m: by how much the bodies of a pair may be nearer than its distance; infinite for a paused pair.
  double pairUncertainty(PairId id) const {
    const Pair& pair = pairs_[id.index()];
    if (pair.paused) return kInfinity;
    return objects_[pair.a.index()].pose_uncertainty + objects_[pair.b.index()].pose_uncertainty;
  }

  /// Pauses or resumes queries of a pair; initially not paused. From the next step() on, a paused pair is not
  /// part of touching(), nearest() and the totals of objects; its result stays that of time `t` (s) and is
  /// stale, so pairUncertainty() is infinite. A resumed pair is queried in the next step(). No effect if
  /// nothing changes. No allocation.
  void setPaused(PairId id, bool paused, double t);
  std::size_t pausedCount() const { return paused_count_; }
  /// Age (s), at time `t`, of the poses of the pair's result: 0 if the last step() updated it, the age from
  /// setResults() otherwise; infinite without a result and if `t` is earlier.
  double ageOf(PairId id, double t) const;

  /// Updates every pair's result to the current poses and sums the totals of the objects.
  void step();
  /// Replaces step() if other threads query the pairs (live mode): takes a result for each pair, in order,
  /// with the times (s) of their poses; without times they belong to the current poses.
  void setResults(const std::vector<query::PairResult>& results, std::span<const double> times = {});
  /// Number of steps so far.
  long steps() const { return steps_; }
  const StepCounts& counts() const { return counts_; }  ///< of the last step()

  std::size_t objectCount() const { return objects_.size(); }
  const Object& object(ObjectId id) const { return objects_[id.index()]; }
  const std::vector<Object>& objects() const { return objects_; }
  const PairTable& pairs() const { return pairs_; }
  const query::PairResult& result(PairId id) const { return pairs_[id.index()].result; }
  /// Pairs whose results the last step() updated, in no particular order.
  const std::vector<PairId>& updated() const { return updates_.updated(); }
  /// Pairs with contacts, in order.
  const std::vector<PairId>& touching() const { return touching_; }
  /// The pair with the smallest distance, the first of equal ones; nullopt before the first step().
  std::optional<PairId> nearest() const;
  /// Number of the last step() that updated a pair indexed by this object; every updated pair is indexed by
  /// one of its two objects.
  long lastUpdateStep(ObjectId id) const { return updates_.lastUpdateStep(id); }
  /// The object with this name, or null. The pointer is valid until the next addObject().
  const Object* find(const std::string& name, ObjectId* id = nullptr) const;
  /// The thesis's relation table: the pairs of one object (row and column).
  const std::vector<PairId>& pairsOf(ObjectId id) const { return pairs_of_[id.index()]; }
  /// Bytes of all haptic structures; shared ones count once.
  std::size_t memoryBytes() const;

 private:
  void enqueue(PairId id) { updates_.enqueue(id, pairs_[id.index()]); }
  void enqueueAll();
  void invalidate(PairId id);
  double marginOf(PairId id) const;
  void count(Pair& pair);
  void clearResultTimes();
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
  /// time (s) of the poses of each pair's result; NaN: the current ones.
  std::vector<double> result_time_;
  std::vector<double> pair_margin_;  ///< m, of each pair; NaN: the sum of the margins of its objects
  bool external_results_{false};     ///< the results came from setResults()
  bool has_result_times_{false};     ///< result_time_ may contain values other than NaN
  std::size_t paused_count_{0};
  long steps_{0};
};

}  // namespace abstand::scene
