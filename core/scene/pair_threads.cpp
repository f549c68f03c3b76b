// Live mode: one thread for each group, triple buffers in both directions, waiting on an atomic counter.
#include "core/scene/pair_threads.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/triple_buffer.hpp"
#include "core/scene/live_culling.hpp"

namespace abstand::scene {
namespace {

/// Input of a group, published by the owner.
struct PoseSet {
  std::vector<Transform> X_WB;              ///< one for each object
  std::vector<LiveObject> objects;          ///< one for each object
  std::vector<query::PairOptions> options;  ///< one for each pair
  double t{-kInfinity};
  long number{0};  ///< counts publications; t may jump back
};

/// Pairs of a group. `index` has capacity for all pairs of the scene, so that it never reallocates.
struct PairList {
  std::vector<std::uint32_t> index;
  std::size_t count{0};
};

/// Output of a group: results[k] belongs to pair index[k].
struct ResultSet {
  PairList pairs;
  std::vector<query::PairResult> results;
  double t{-kInfinity};
  long number{0};  ///< number of the pose set
  long cycle{0};
};

struct PairBodies {
  std::uint32_t a, b;
};

/// Constant data shared by all groups.
struct SharedData {
  std::vector<std::shared_ptr<const structure::HapticStructure>> structures;
  std::vector<PairBodies> pairs;
  double rest{0.0};  ///< QueryCulling::rest

  void query(std::uint32_t pair, const PoseSet& poses, query::PairMemory& memory,
             kernels::PairScratch& scratch, query::PairResult& result) const {
    const auto [a, b] = pairs[pair];
    query::queryPair({*structures[a], poses.X_WB[a]}, {*structures[b], poses.X_WB[b]}, poses.options[pair],
                     {memory, scratch}, result);
  }

  /// Updates the result of a pair: from the last query if culling allows it, otherwise by a new query. True
  /// if it was queried.
  bool updateResult(std::uint32_t pair, const PoseSet& poses, LiveCulling& last, query::PairMemory& memory,
                    kernels::PairScratch& scratch, query::PairResult& result) const {
    const auto [a, b] = pairs[pair];
    const query::PairOptions& options = poses.options[pair];
    const LiveObject &state_a = poses.objects[a], &state_b = poses.objects[b];
    if (last.mayCull(state_a, state_b, options.margin)) {
      result = {};  // a culled pair has no contacts
      last.carry(poses.X_WB[a], poses.X_WB[b], state_a, state_b, result);
      return false;
    }
    query(pair, poses, memory, scratch, result);
    last.update(result, {poses.X_WB[a], state_a}, {poses.X_WB[b], state_b},
                contactDistance(*structures[a], *structures[b], options), options.margin, rest);
    return true;
  }
};

enum class GroupState : std::uint8_t { kRun, kPause, kStop };

class Group {
 public:
  Group(const SharedData& shared, const PoseSet& poses, PairList pairs)
      : shared_(shared),
        poses_(poses),
        requested_(pairs),
        results_(emptyResults(shared)),
        cullings_(shared.rest > 0.0 ? shared.pairs.size() : 0),
        memories_(shared.pairs.size()),
        pairs_(std::move(pairs)) {}
  ~Group() { stop(); }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void start() {
    state_.store(GroupState::kRun, std::memory_order_release);
    if (thread_.joinable()) {
      wake();
      return;
    }
    first_cycle_ = cycles_.load(std::memory_order_relaxed);
    thread_ = std::jthread([this] { run(); });
  }

  void pause() {
    if (!thread_.joinable()) return;
    state_.store(GroupState::kPause, std::memory_order_release);
    wake();
  }

  void stop() {
    if (!thread_.joinable()) return;
    state_.store(GroupState::kStop, std::memory_order_release);
    wake();
    thread_.join();
  }

  void publish(const PoseSet& poses) {
    poses_.back() = poses;
    poses_.publish();
    wake();
  }

  const PairList& pairs() const { return pairs_; }

  void setPairs(const PairList& pairs) {
    pairs_ = pairs;
    requested_.back() = pairs;
    requested_.publish();
    wake();
  }

  const ResultSet& latest() { return results_.latest(); }
  StepCounts counts() const {
    StepCounts c;
    c.checked = checked_.load(std::memory_order_relaxed);
    c.rested = rested_.load(std::memory_order_relaxed);
    return c;
  }
  long cycles() const { return cycles_.load(std::memory_order_acquire) - first_cycle_; }

  long collected{0};  ///< owner's: cycle of the last collected results

 private:
  static ResultSet emptyResults(const SharedData& shared) {
    ResultSet set;
    set.pairs.index.resize(shared.pairs.size());
    set.results.resize(shared.pairs.size());
    return set;
  }

  void wake() {
    signal_.fetch_add(1, std::memory_order_release);
    signal_.notify_one();
  }

  void run() {
    for (bool started = false;;) {
      // Read first: any later action of the owner changes the signal, so no wake-up is lost.
      const std::uint32_t signal = signal_.load(std::memory_order_acquire);
      const GroupState state = state_.load(std::memory_order_acquire);
      if (state == GroupState::kStop) return;
      if (state == GroupState::kPause || (started && !poses_.fresh() && !requested_.fresh())) {
        signal_.wait(signal, std::memory_order_acquire);
        continue;
      }
      started = true;
      cycle();
    }
  }

  void cycle() {
    const PoseSet& poses = poses_.latest();
    const PairList& pairs = requested_.latest();
    ResultSet& out = results_.back();
    out.pairs.count = pairs.count;
    out.t = poses.t;
    out.number = poses.number;
    long rested = 0;
    for (std::size_t k = 0; k < pairs.count; ++k) {
      const std::uint32_t pair = pairs.index[k];
      out.pairs.index[k] = pair;
      if (cullings_.empty()) {
        shared_.query(pair, poses, memories_[pair], scratch_, out.results[k]);
      } else if (!shared_.updateResult(pair, poses, cullings_[pair], memories_[pair], scratch_,
                                       out.results[k])) {
        ++rested;
      }
    }
    rested_.fetch_add(rested, std::memory_order_relaxed);
    checked_.fetch_add(static_cast<long>(pairs.count) - rested, std::memory_order_relaxed);
    const long cycle = cycles_.load(std::memory_order_relaxed) + 1;
    out.cycle = cycle;
    // Stored before the results, so that a thread that reads them finds their cycle counted.
    cycles_.store(cycle, std::memory_order_release);
    results_.publish();
  }

  const SharedData& shared_;
  TripleBuffer<PoseSet> poses_;        ///< owner to group
  TripleBuffer<PairList> requested_;   ///< owner to group
  TripleBuffer<ResultSet> results_;    ///< group to owner
  std::vector<LiveCulling> cullings_;  ///< group's, one for each pair of the scene; empty if culling is off
  std::vector<query::PairMemory> memories_;  ///< likewise
  PairList pairs_;                           ///< owner's copy of the wanted list
  kernels::PairScratch scratch_;
  long first_cycle_{0};  ///< owner's
  alignas(64) std::atomic<std::uint32_t> signal_{0};
  std::atomic<GroupState> state_{GroupState::kRun};
  alignas(64) std::atomic<long> cycles_{0};  ///< over all threads of this group
  std::atomic<long> checked_{0}, rested_{0};
  std::jthread thread_;
};

}  // namespace

struct PairThreads::Impl {
  static constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);

  SharedData shared;
  PoseSet poses;  ///< last published
  std::vector<std::unique_ptr<Group>> groups;
  std::vector<std::size_t> group_of;       ///< of each pair
  std::vector<query::PairResult> results;  ///< newest of each pair
  std::vector<double> result_time;
  std::vector<long> result_number;  ///< number of the pose set; -1: no result yet
  std::vector<std::string> pair_names;
  kernels::PairScratch scratch;

  Group& group(GroupIndex index) {
    ABSTAND_CHECK(index < groups.size());
    return *groups[index];
  }

  void copyState(const Scene& scene) {
    ABSTAND_CHECK(scene.objectCount() >= shared.structures.size() &&
                  scene.pairs().size() >= shared.pairs.size());
    double latest = -kInfinity;
    for (std::size_t i = 0; i < poses.X_WB.size(); ++i) {
      const Object& object = scene.objects()[i];
      poses.X_WB[i] = object.X_WB;
      poses.objects[i] = {object.t, object.interruptions, object.max_speed};
      latest = std::max(latest, object.t);
    }
    for (std::size_t i = 0; i < poses.options.size(); ++i) poses.options[i] = scene.pairs()[i].options;
    poses.t = latest;
    ++poses.number;
  }

  void checkFree(PairId pair) const {
    ABSTAND_CHECK(pair.index() < shared.pairs.size());
    if (group_of[pair.index()] == kNoGroup) return;
    throw UsageError("pair " + pair_names[pair.index()] +
                     ": in a thread group already, expected to be in one only");
  }

  /// Adds a pair to a list, with a first result.
  void insert(PairId pair, GroupIndex group, PairList& list) {
    const std::uint32_t i = pair.index();
    group_of[i] = group;
    list.index[list.count++] = i;
    query::PairMemory nothing;
    shared.query(i, poses, nothing, scratch, results[i]);
    result_time[i] = poses.t;
    result_number[i] = poses.number;
  }
};

PairThreads::PairThreads(const Scene& scene) : impl_(std::make_unique<Impl>()) {
  Impl& m = *impl_;
  const auto& objects = scene.objects();
  for (const Object& object : objects) {
    m.shared.structures.push_back(object.spec.structure);
  }
  m.shared.rest = scene.culling().rest;
  for (const Pair& pair : scene.pairs()) {
    m.shared.pairs.push_back({pair.a.index(), pair.b.index()});
    m.pair_names.push_back("`" + objects[pair.a.index()].spec.name + "`, `" +
                           objects[pair.b.index()].spec.name + "`");
  }
  m.poses.X_WB.resize(objects.size());
  m.poses.objects.resize(objects.size());
  m.poses.options.resize(scene.pairs().size());
  m.group_of.assign(scene.pairs().size(), Impl::kNoGroup);
  m.results.resize(scene.pairs().size());
  m.result_time.assign(scene.pairs().size(), -kInfinity);
  m.result_number.assign(scene.pairs().size(), -1);
  m.copyState(scene);
}

PairThreads::~PairThreads() = default;

PairThreads::GroupIndex PairThreads::addGroup(std::vector<PairId> pairs) {
  Impl& m = *impl_;
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    m.checkFree(pairs[k]);
    if (k > 0 && pairs[k] == pairs[k - 1]) {
      throw UsageError("pair " + m.pair_names[pairs[k].index()] + ": twice in a thread group, expected once");
    }
  }
  PairList list;
  list.index.resize(m.shared.pairs.size());
  m.groups.reserve(m.groups.size() + 1);
  for (const PairId pair : pairs) m.insert(pair, m.groups.size(), list);
  m.groups.push_back(std::make_unique<Group>(m.shared, m.poses, std::move(list)));
  return m.groups.size() - 1;
}

void PairThreads::start(GroupIndex group) { impl_->group(group).start(); }
void PairThreads::pause(GroupIndex group) { impl_->group(group).pause(); }
void PairThreads::stop(GroupIndex group) { impl_->group(group).stop(); }
long PairThreads::cycles(GroupIndex group) const { return impl_->group(group).cycles(); }

void PairThreads::addPair(GroupIndex group, PairId pair) {
  Impl& m = *impl_;
  Group& target = m.group(group);
  m.checkFree(pair);
  PairList list = target.pairs();
  m.insert(pair, group, list);
  target.setPairs(list);
}

void PairThreads::removePair(GroupIndex group, PairId pair) {
  Impl& m = *impl_;
  Group& target = m.group(group);
  ABSTAND_CHECK(pair.index() < m.shared.pairs.size());
  if (m.group_of[pair.index()] != group) {
    throw UsageError("pair " + m.pair_names[pair.index()] + ": not in this thread group");
  }
  PairList list = target.pairs();
  const auto end = list.index.begin() + static_cast<std::ptrdiff_t>(list.count);
  std::copy(std::find(list.index.begin(), end, pair.index()) + 1, end,
            std::find(list.index.begin(), end, pair.index()));
  --list.count;
  m.group_of[pair.index()] = Impl::kNoGroup;
  target.setPairs(list);
}

void PairThreads::publishPoses(const Scene& scene) {
  impl_->copyState(scene);
  for (const auto& group : impl_->groups) group->publish(impl_->poses);
}

long PairThreads::collect(std::vector<query::PairResult>& results) {
  Impl& m = *impl_;
  ABSTAND_CHECK(results.size() >= m.results.size());
  long finished = 0;
  for (std::size_t g = 0; g < m.groups.size(); ++g) {
    Group& group = *m.groups[g];
    const ResultSet& set = group.latest();
    finished += set.cycle - group.collected;
    if (set.cycle == group.collected) continue;
    group.collected = set.cycle;
    for (std::size_t k = 0; k < set.pairs.count; ++k) {
      const std::uint32_t i = set.pairs.index[k];
      // A pair that has left the group keeps its result; one that was just added may be newer.
      if (m.group_of[i] != g || set.number < m.result_number[i]) continue;
      m.results[i] = set.results[k];
      m.result_time[i] = set.t;
      m.result_number[i] = set.number;
    }
  }
  for (std::size_t i = 0; i < m.results.size(); ++i) {
    if (m.result_number[i] >= 0) results[i] = m.results[i];
  }
  return finished;
}

StepCounts PairThreads::counts() const {
  StepCounts sum;
  for (const auto& group : impl_->groups) {
    const StepCounts c = group->counts();
    sum.checked += c.checked;
    sum.rested += c.rested;
  }
  return sum;
}

std::span<const double> PairThreads::resultTimes() const { return impl_->result_time; }

bool PairThreads::upToDate() const {
  const Impl& m = *impl_;
  for (std::size_t i = 0; i < m.group_of.size(); ++i)
    if (m.group_of[i] != Impl::kNoGroup && m.result_number[i] != m.poses.number) return false;
  return true;
}

double PairThreads::resultTime(PairId pair) const {
  ABSTAND_CHECK(pair.index() < impl_->result_time.size());
  return impl_->result_time[pair.index()];
}

}  // namespace abstand::scene
