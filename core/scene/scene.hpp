// The shared collision scene: objects, pairs and the lock-step cycle.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/base/huge_pages.hpp"
#include "core/base/id.hpp"
#include "core/query/pair_query.hpp"
#include "core/scene/minimum_tree.hpp"
#include "core/scene/query_queue.hpp"
#include "core/scene/speed_watch.hpp"
#include "core/scene/temporal_culling.hpp"

namespace abstand::scene {

/// What is needed to put a body into the scene.
struct ObjectSpec {
  std::string name;   ///< unique in the scene
  std::string group;  ///< a mechanism's, a human's name, or "objects"
  std::shared_ptr<const structure::HapticStructure> structure;
  double margin{0.0};  ///< m, safety margin
};

/// How trustworthy an object's pose is; everything but kFresh is shown and never counts as safe.
enum class PoseState : std::uint8_t { kFresh, kInferred, kStale, kRejected };

/// One body in the scene, with its recent motion and what acts on it. World frame.
struct Object {
  ObjectSpec spec;
  Transform X_WB{Transform::Identity()};
  PoseState pose_state{PoseState::kFresh};
  /// m: every point of the body is within so much of where X_WB puts it; it widens the margins by which the
  /// body's distances are judged. Infinite: it may be anywhere.
  double reach{0.0};
  long rejected_poses{0};       ///< poses that were not finite or no rotation; the last good one stayed
  double t{0.0};                ///< s, of X_WB
  Twist velocity;               ///< instant: from the last two poses; linear of the centre of mass
  Twist mean_velocity;          ///< over the last Scene::kMeanSamples poses
  double max_speed{kInfinity};  ///< m/s, of its farthest point; what rests on it is watched by setPose
  /// Grows when what was concluded from times and speeds no longer holds: at a breach of max_speed, when
  /// max_speed changes, and when the object is moved back in time or without time.
  long interruptions{0};
  SpeedWatch::State speed_state;
  Wrench contact;  ///< sum over its pairs, about its centre of mass
  int contacts{0};
  bool colliding{false};  ///< some pair of it has a contact (margins included)
  Vector3d p_WCom() const { return X_WB * spec.structure->com; }
};

/// Cache-line aligned to avoid false sharing; hot fields first.
struct alignas(64) Pair {
  ObjectId a, b;
  PairOutcome outcome{PairOutcome::kChecked};
  bool queued{false};    ///< the next step() looks at it
  bool touching{false};  ///< is among Scene::touching()
  bool paused{false};    ///< see Scene::setPaused
  int waited{0};         ///< steps that it has been put off
  TemporalCulling rest;
  query::PairResult result;
  query::PairOptions options;  ///< margin = margin_a + margin_b, kept up to date by setMargin
};

using PairTable = std::vector<Pair, HugePageAllocator<Pair>>;

/// How the pairs of a step came to their results; those that nothing moved do not count.
struct StepCounts {
  long checked{0}, rested{0}, beyond{0}, put_off{0};
  int longest_wait{0};  ///< steps, of the pairs put off
};

class PairWorkers;

/// One thread builds and steps a scene; step() spreads the pairs over worker threads and sums in pair order,
/// so the bits are the same for any number of threads. Pairs of two bodies that have not moved keep their
/// results, which are those that a query would give again, so a step costs what has moved. What else may be
/// left out is in QueryCulling. After the first step(), step() allocates nothing and locks nothing but the
/// workers' barrier. Other threads read snapshots, never the scene.
class Scene {
 public:
  /// Poses in the mean velocity.
  static constexpr int kMeanSamples = 10;
  /// Poses closer in time than this (s) count as one.
  static constexpr double kMinTimeStep = 1e-9;
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
  int threads() const { return threads_; }
  void setMargin(ObjectId object, double margin);  ///< throws UsageError, as addObject
  /// For all pairs, those that are added later too. Throws UsageError unless finite and not negative.
  void setForceLaw(query::ForceLaw law, double stiffness);

  /// m/s, from the next pose on; infinity: no bound. Throws UsageError unless 0 or more.
  void setMaxSpeed(ObjectId object, double speed);
  const SpeedWatch& speedWatch() const { return speed_watch_; }
  /// From the next step() on. Throws UsageError.
  void setCulling(const QueryCulling& culling);
  /// The next step() queries every pair, and from nothing but its poses: its numbers, and those of the steps
  /// after it, do not depend on what was before. No allocation.
  void startCold() noexcept;
  const QueryCulling& culling() const { return culling_; }
  /// What the time budget is measured with: seconds from any beginning. Default: the steady clock.
  using Clock = double (*)();
  void setClock(Clock clock) { clock_ = clock; }

  /// False, and the object keeps its last pose and is flagged kRejected, when the pose is not finite, no
  /// rotation or farther than kFarthest from the origin, or t is not finite. Velocities come from the rise of
  /// t: at the same t the pose is replaced and the velocities stay; at an earlier t (a jump back in a
  /// recording) they start again from zero.
  bool setPose(ObjectId object, const Transform& X_WB, double t, PoseState state = PoseState::kFresh);

  /// Of the pose that was set last, m; less than 0 and NaN count as infinite. Distances, contacts and forces
  /// stay those of the bodies where they were seen. No allocation, no throw.
  void setPoseUncertainty(ObjectId object, double reach) noexcept;
  /// m: by how much the bodies of a pair may be nearer to each other than its distance says; infinite for a
  /// paused pair.
  double pairUncertainty(PairId id) const {
    const Pair& pair = pairs_[id.index()];
    if (pair.paused) return kInfinity;
    return objects_[pair.a.index()].reach + objects_[pair.b.index()].reach;
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
  const std::vector<PairId>& renewed() const { return renewed_; }
  /// Pairs with contacts, in order.
  const std::vector<PairId>& touching() const { return touching_; }
  /// The pair with the smallest distance, the first of equal ones; none before the first step().
  std::optional<PairId> nearest() const;
  /// The last step() (of steps()) that renewed a pair which is named with this object; every renewed pair
  /// is named with one of its two.
  long lastUpdateStep(ObjectId id) const { return last_update_step_[id.index()]; }
  /// The object with this name, or null. The pointer holds until the next addObject.
  const Object* find(const std::string& name, ObjectId* id = nullptr) const;
  /// The thesis's relation table: the pairs of one object (row and column).
  const std::vector<PairId>& pairsOf(ObjectId id) const { return pairs_of_[id.index()]; }
  /// Bytes of all haptic structures, shared ones counted once.
  std::size_t memoryBytes() const;

 private:
  class History;
  struct Scratch;
  template <class Task>
  void spread(const std::vector<PairId>& pairs, Task task);
  void enqueue(PairId id);
  void renew(PairId id);
  void enqueueMoved();
  void touch(ObjectId id);
  void check(Pair& pair, kernels::PairScratch& scratch);
  void visit(Pair& pair, kernels::PairScratch& scratch);
  void queryUntil(double deadline);
  void prefetch(const std::vector<PairId>& pairs, std::size_t i) const;
  void count(Pair& pair);
  void dateResults();
  void updateContactList();
  void sumWrenches();

  std::vector<Object> objects_;
  PairTable pairs_;
  std::vector<std::vector<PairId>> pairs_of_;
  std::unordered_map<std::string, std::uint32_t> index_of_;
  std::unordered_set<std::uint64_t> pair_keys_;
  std::vector<History> histories_;
  std::vector<MotionBound> reaches_;
  SpeedWatch speed_watch_;
  std::vector<ObjectId> moved_;  ///< since the last step()
  std::vector<bool> has_moved_;
  std::vector<PairId> pending_;  ///< to be looked at whatever has moved
  std::vector<PairId> renewed_, touching_;
  std::vector<long> last_update_step_;  ///< of each object
  MinimumTree distances_;
  std::vector<query::PairMemory> memories_;  ///< of the pairs, where culling_.remember
  std::vector<Scratch> scratch_;             ///< of each thread
  std::unique_ptr<PairWorkers> workers_;
  query::ForceLaw law_{query::ForceLaw::kVolume};
  double stiffness_{query::PairOptions{}.stiffness};
  QueryCulling culling_;
  Clock clock_;
  QueryQueue agenda_;
  std::vector<PairId> batch_;
  StepCounts counts_;
  /// Of each pair, s: the time of the poses of its result; NaN: the present ones.
  std::vector<double> result_time_;
  bool taken_{false};  ///< the results came from take()
  bool dated_{false};  ///< some of result_time_ may be no NaN
  std::size_t paused_count_{0};
  int threads_{1};
  long steps_{0};
};

}  // namespace abstand::scene
