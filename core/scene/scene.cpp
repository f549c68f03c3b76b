#include "core/scene/scene.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/object_motion.hpp"
#include "core/scene/pair_workers.hpp"

namespace abstand::scene {
namespace {

void checkNotNegative(const char* what, double value) {
  if (!std::isfinite(value) || value < 0.0)
    throw UsageError(std::string(what) + " " + formatDouble(value) + ": expected a finite number, 0 or more");
}

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Queries of a thread between two looks at the clock.
constexpr std::size_t kBatch = 8;

}  // namespace

class Scene::History : public MotionHistory<Scene::kMeanSamples> {};

/// On cache lines of its own.
struct alignas(64) Scene::Scratch {
  kernels::PairScratch of_query;
};

Scene::Scene() : scratch_(1), clock_(steadySeconds) { batch_.reserve(kBatch); }
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

ObjectId Scene::addObject(ObjectSpec spec) {
  ABSTAND_CHECK(spec.structure);
  if (spec.name.empty()) throw UsageError("an object without a name: expected one");
  checkNotNegative("margin", spec.margin);
  const ObjectId id(static_cast<std::uint32_t>(objects_.size()));
  if (!index_of_.emplace(spec.name, id.index()).second)
    throw UsageError("object name `" + spec.name + "`: taken already, expected a new one");
  Object object;
  object.spec = std::move(spec);
  reaches_.emplace_back(object.spec.structure->bounding_sphere);
  objects_.push_back(std::move(object));
  pairs_of_.emplace_back();
  histories_.emplace_back();
  has_moved_.push_back(false);
  last_update_step_.push_back(0);
  moved_.reserve(objects_.capacity());
  return id;
}

PairId Scene::addPair(ObjectId a, ObjectId b) {
  ABSTAND_CHECK(a.index() < objects_.size() && b.index() < objects_.size());
  const auto name = [&](ObjectId id) -> const std::string& { return objects_[id.index()].spec.name; };
  if (a == b) throw UsageError("pair of `" + name(a) + "` with itself: expected two different objects");
  const auto [low, high] = std::minmax({a.index(), b.index()});
  if (!pair_keys_.insert(std::uint64_t{low} << 32 | high).second)
    throw UsageError("pair `" + name(a) + "`, `" + name(b) + "`: there already, expected a new one");
  const PairId id(static_cast<std::uint32_t>(pairs_.size()));
  query::PairOptions options;
  options.margin = objects_[a.index()].spec.margin + objects_[b.index()].spec.margin;
  options.law = law_;
  options.stiffness = stiffness_;
  options.far_share = culling_.farShare();
  pairs_.push_back({a, b, PairOutcome::kChecked, false, false, false, 0, {}, {}, options});
  result_time_.push_back(kNaN);
  pairs_of_[a.index()].push_back(id);
  pairs_of_[b.index()].push_back(id);
  for (auto* list : {&pending_, &renewed_, &touching_}) list->reserve(pairs_.capacity());
  if (culling_.limited()) agenda_.reserve(pairs_.capacity());
  if (culling_.remember) memories_.resize(pairs_.size());
  renew(id);
  return id;
}

void Scene::setThreads(int threads) {
  if (threads < 0 || threads > kMaxThreads)
    throw UsageError("threads " + std::to_string(threads) + ": expected 0 (all cores) to " +
                     std::to_string(kMaxThreads));
  if (threads == 0)
    threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
  if (threads == threads_) return;
  workers_.reset();
  threads_ = 1;
  scratch_.resize(static_cast<std::size_t>(threads));
  batch_.reserve(scratch_.size() * kBatch);
  if (threads > 1) workers_ = std::make_unique<PairWorkers>(threads - 1);
  threads_ = threads;
}

void Scene::setMargin(ObjectId object, double margin) {
  checkNotNegative("margin", margin);
  objects_[object.index()].spec.margin = margin;
  for (const PairId id : pairs_of_[object.index()]) {
    Pair& pair = pairs_[id.index()];
    pair.options.margin = objects_[pair.a.index()].spec.margin + objects_[pair.b.index()].spec.margin;
    renew(id);
  }
}

void Scene::setPaused(PairId id, bool paused, double t) {
  Pair& pair = pairs_[id.index()];
  if (pair.paused == paused) return;
  double& time = result_time_[id.index()];
  if (paused) {
    enqueue(id);  // the next step takes it out of the totals
    if (std::isnan(time)) time = std::isnan(pair.result.distance) ? -kInfinity : t;
    ++paused_count_;
    pair.paused = dated_ = true;
    pair.outcome = PairOutcome::kChecked;
  } else {
    --paused_count_;
    pair.paused = false;
    renew(id);
  }
}

double Scene::ageOf(PairId id, double t) const {
  const double time = result_time_[id.index()];
  if (std::isnan(time)) return std::isnan(pairs_[id.index()].result.distance) ? kInfinity : 0.0;
  return t >= time ? t - time : kInfinity;
}

void Scene::setForceLaw(query::ForceLaw law, double stiffness) {
  checkNotNegative("stiffness", stiffness);
  law_ = law;
  stiffness_ = stiffness;
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    pairs_[i].options.law = law;
    pairs_[i].options.stiffness = stiffness;
    renew(PairId(i));
  }
}

void Scene::setMaxSpeed(ObjectId object, double speed) {
  if (!(speed >= 0.0))
    throw UsageError("max_speed " + formatDouble(speed) + ": expected a speed in m/s, 0 or more");
  objects_[object.index()].max_speed = speed;
  ++objects_[object.index()].interruptions;
}

void Scene::setCulling(const QueryCulling& culling) {
  culling.validate();
  culling_ = culling;
  if (culling.limited()) agenda_.reserve(pairs_.capacity());
  memories_.assign(culling.remember ? pairs_.size() : 0, {});
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    pairs_[i].options.far_share = culling.farShare();
    renew(PairId(i));
  }
}

void Scene::startCold() noexcept {
  std::fill(memories_.begin(), memories_.end(), query::PairMemory{});
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) renew(PairId(i));
}

bool Scene::setPose(ObjectId id, const Transform& X_WB, double t, PoseState state) {
  Object& object = objects_[id.index()];
  if (!std::isfinite(t) || !isPose(X_WB) || X_WB.translation().cwiseAbs().maxCoeff() > kFarthest) {
    object.pose_state = PoseState::kRejected;
    ++object.rejected_poses;
    return false;
  }
  History& history = histories_[id.index()];
  const double dt = t - object.t;
  const bool moved = object.X_WB.matrix() != X_WB.matrix();
  const double step = moved ? reaches_[id.index()].moveTo(X_WB) : 0.0;
  if (moved) touch(id);
  if (!history.started() || dt <= -kMinTimeStep) {
    ++object.interruptions;
    history.start();
    object.velocity = object.mean_velocity = Twist{};
  } else if (dt >= kMinTimeStep) {
    const Vector3d way = X_WB * object.spec.structure->com - object.p_WCom();
    const Vector3d rotation = rotationBetween(object.X_WB.linear(), X_WB.linear());
    history.add(dt, way, rotation);
    object.velocity = {way / dt, rotation / dt};
    object.mean_velocity = history.mean();
    if (speed_watch_.add(id, t, step, dt, object.max_speed, object.speed_state)) ++object.interruptions;
  } else if (moved) {
    ++object.interruptions;
  }
  object.X_WB = X_WB;
  object.t = t;
  object.pose_state = state;
  return true;
}

void Scene::setPoseUncertainty(ObjectId object, double reach) noexcept {
  objects_[object.index()].reach = reach >= 0.0 ? reach : kInfinity;
}

void Scene::touch(ObjectId id) {
  if (has_moved_[id.index()]) return;
  has_moved_[id.index()] = true;
  moved_.push_back(id);
}

void Scene::enqueue(PairId id) {
  Pair& pair = pairs_[id.index()];
  if (pair.queued || pair.paused) return;
  pair.queued = true;
  pending_.push_back(id);
}

/// The next step() queries it, whatever was proven.
void Scene::renew(PairId id) {
  pairs_[id.index()].rest.forget();
  enqueue(id);
}

/// What the last steps left and the pairs of everything that has moved, each once, become the work of this
/// step.
void Scene::enqueueMoved() {
  for (const PairId id : pending_) last_update_step_[pairs_[id.index()].a.index()] = steps_;
  for (const ObjectId object : moved_) {
    const auto& pairs = pairs_of_[object.index()];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      prefetch(pairs, i);
      enqueue(pairs[i]);
    }
    has_moved_[object.index()] = false;
    last_update_step_[object.index()] = steps_;
  }
  moved_.clear();
  std::swap(renewed_, pending_);
  pending_.clear();
}

/// The pairs of an object that moves lie far apart in memory: asks for one some places ahead.
void Scene::prefetch(const std::vector<PairId>& pairs, std::size_t i) const {
  constexpr std::size_t kAhead = 8;
  if (i + kAhead >= pairs.size()) return;
  const char* line = reinterpret_cast<const char*>(&pairs_[pairs[i + kAhead].index()]);
  for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(line + 64 * k, 1);
}

/// task(pair, scratch) for each, on all threads.
template <class Task>
void Scene::spread(const std::vector<PairId>& pairs, Task task) {
  struct Context {
    Scene& scene;
    const std::vector<PairId>& pairs;
    Task& task;
  } context{*this, pairs, task};
  const auto one = [](void* c, std::size_t i, std::size_t thread) {
    auto& [scene, list, work] = *static_cast<Context*>(c);
    scene.prefetch(list, i);
    work(scene.pairs_[list[i].index()], scene.scratch_[thread].of_query);
  };
  if (workers_) {
    workers_->run(pairs.size(), one, &context);
  } else {
    for (std::size_t i = 0; i < pairs.size(); ++i) one(&context, i, 0);
  }
}

void Scene::check(Pair& pair, kernels::PairScratch& scratch) {
  const Object& a = objects_[pair.a.index()];
  const Object& b = objects_[pair.b.index()];
  query::PairMemory nothing;
  query::PairMemory& memory =
      culling_.remember ? memories_[static_cast<std::size_t>(&pair - pairs_.data())] : nothing;
  query::queryPair({*a.spec.structure, a.X_WB}, {*b.spec.structure, b.X_WB}, pair.options, {memory, scratch},
                   pair.result);
  pair.outcome = PairOutcome::kChecked;
  if (!culling_.any()) return;
  pair.rest.take(pair.result, {a.X_WB, reaches_[pair.a.index()]}, {b.X_WB, reaches_[pair.b.index()]},
                 touchFrom(*a.spec.structure, *b.spec.structure, pair.options), culling_);
}

void Scene::visit(Pair& pair, kernels::PairScratch& scratch) {
  if (pair.paused) return;
  const MotionBound& a = reaches_[pair.a.index()];
  const MotionBound& b = reaches_[pair.b.index()];
  pair.outcome = culling_.any() ? pair.rest.outcome(a, b, culling_) : PairOutcome::kChecked;
  if (pair.outcome == PairOutcome::kChecked) {
    // Under a budget what is proven has to do until its turn comes.
    if (!culling_.limited() || !pair.rest.proven()) return check(pair, scratch);
    pair.outcome = PairOutcome::kPutOff;
  }
  pair.rest.proof().carry(objects_[pair.a.index()].X_WB, objects_[pair.b.index()].X_WB,
                          pair.rest.lowerNow(a, b), pair.result);
}

/// Queries what was put off, the most urgent first, until the clock shows `deadline`; one batch at least, so
/// that everything gets its turn.
void Scene::queryUntil(double deadline) {
  agenda_.clear();
  for (const PairId id : renewed_) {
    const Pair& pair = pairs_[id.index()];
    if (pair.outcome != PairOutcome::kPutOff) continue;
    const double clearance = pair.result.distance - pair.result.bound - pair.rest.touchFrom();
    agenda_.add({id, clearance <= 0.0, pair.waited, clearance});
  }
  agenda_.sortOut();
  do {
    batch_.clear();
    while (!agenda_.empty() && batch_.size() < kBatch * scratch_.size()) batch_.push_back(agenda_.next());
    spread(batch_, [this](Pair& pair, kernels::PairScratch& scratch) { check(pair, scratch); });
  } while (!agenda_.empty() && clock_() < deadline);
}

void Scene::step() {
  const double deadline = culling_.limited() ? clock_() + culling_.budget : kInfinity;
  ++steps_;
  // What take() left may be older than the present poses although nothing has moved since.
  if (taken_)
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) enqueue(PairId(i));
  taken_ = false;
  enqueueMoved();
  spread(renewed_, [this](Pair& pair, kernels::PairScratch& scratch) { visit(pair, scratch); });
  if (culling_.limited()) queryUntil(deadline);
  dateResults();
  updateContactList();
  sumWrenches();
}

/// What this step has renewed belongs to the present poses.
void Scene::dateResults() {
  if (!dated_) return;
  for (const PairId id : renewed_)
    if (!pairs_[id.index()].paused) result_time_[id.index()] = kNaN;
  dated_ = paused_count_ > 0;
}

void Scene::take(const std::vector<query::PairResult>& results, std::span<const double> times) {
  ABSTAND_CHECK(results.size() == pairs_.size() && (times.empty() || times.size() == pairs_.size()));
  ++steps_;
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) enqueue(PairId(i));
  enqueueMoved();
  taken_ = dated_ = true;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].paused) continue;
    result_time_[i] = times.empty() ? kNaN : times[i];
    pairs_[i].result = results[i];
    pairs_[i].outcome = PairOutcome::kChecked;
    pairs_[i].rest.forget();
  }
  updateContactList();
  sumWrenches();
}

void Scene::count(Pair& pair) {
  switch (pair.outcome) {
    case PairOutcome::kChecked:
      ++counts_.checked;
      break;
    case PairOutcome::kRested:
      ++counts_.rested;
      break;
    case PairOutcome::kBeyond:
      ++counts_.beyond;
      break;
    case PairOutcome::kPutOff:
      ++counts_.put_off;
      counts_.longest_wait = std::max(counts_.longest_wait, ++pair.waited);
      return;
  }
  pair.waited = 0;
}

/// What the renewed pairs change in what is known of all pairs.
void Scene::updateContactList() {
  if (distances_.size() != pairs_.size()) {
    distances_.resize(pairs_.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      distances_.set(i, pairs_[i].paused ? kInfinity : pairs_[i].result.distance);
  }
  for (const PairId id : touching_) {
    const Pair& pair = pairs_[id.index()];
    for (const ObjectId object : {pair.a, pair.b}) {
      objects_[object.index()].contact = {};
      objects_[object.index()].contacts = 0;
      objects_[object.index()].colliding = false;
    }
  }
  counts_ = {};
  bool begun = false, ended = false;
  for (std::size_t i = 0; i < renewed_.size(); ++i) {
    prefetch(renewed_, i);
    const PairId id = renewed_[i];
    Pair& pair = pairs_[id.index()];
    pair.queued = false;
    if (!pair.paused) count(pair);
    distances_.set(id.index(), pair.paused ? kInfinity : pair.result.distance);
    if (pair.outcome == PairOutcome::kPutOff) enqueue(id);
    if (pair.outcome != PairOutcome::kChecked && !pair.paused) continue;
    const bool touches = !pair.paused && pair.result.contacts > 0;
    if (touches == pair.touching) continue;
    pair.touching = touches;
    (touches ? begun : ended) = true;
    if (touches) touching_.push_back(id);
  }
  if (ended) std::erase_if(touching_, [this](PairId id) { return !pairs_[id.index()].touching; });
  if (begun) std::sort(touching_.begin(), touching_.end());
}

/// In pair order. Pairs without contacts would add zeros.
void Scene::sumWrenches() {
  for (const PairId id : touching_) {
    const Pair& pair = pairs_[id.index()];
    const query::PairResult& r = pair.result;
    Object& a = objects_[pair.a.index()];
    Object& b = objects_[pair.b.index()];
    a.contact += {r.force_a, r.torque_a};
    b.contact += {-r.force_a, r.torque_b};
    a.contacts += r.contacts;
    b.contacts += r.contacts;
    a.colliding = b.colliding = true;
  }
}

std::optional<PairId> Scene::nearest() const {
  const auto i = distances_.smallest();
  return i ? std::optional(PairId(static_cast<std::uint32_t>(*i))) : std::nullopt;
}

const Object* Scene::find(const std::string& name, ObjectId* id) const {
  const auto it = index_of_.find(name);
  if (it == index_of_.end()) return nullptr;
  if (id) *id = ObjectId(it->second);
  return &objects_[it->second];
}

std::size_t Scene::memoryBytes() const {
  std::unordered_set<const structure::HapticStructure*> counted;
  std::size_t bytes = 0;
  for (const Object& object : objects_)
    if (counted.insert(object.spec.structure.get()).second) bytes += object.spec.structure->memoryBytes();
  return bytes;
}

}  // namespace abstand::scene
