#include "core/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::scene {
namespace {

void checkNotNegative(const char* what, double value) {
  if (!std::isfinite(value) || value < 0.0)
    throw UsageError(std::string(what) + " " + formatDouble(value) + ": expected a finite number, 0 or more");
}

}  // namespace

Scene::Scene() = default;
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

ObjectId Scene::addObject(ObjectSpec spec) {
  ABSTAND_CHECK(spec.structure);
  if (spec.name.empty()) throw UsageError("an object without a name: expected one");
  checkNotNegative("margin", spec.margin);
  const ObjectId id(static_cast<std::uint32_t>(objects_.size()));
  if (!index_of_.emplace(spec.name, id.index()).second)
    throw UsageError("object name `" + spec.name + "`: already used, expected a new one");
  Object object;
  object.spec = std::move(spec);
  motions_.addObject(object.spec.structure->bounding_sphere);
  objects_.push_back(std::move(object));
  pairs_of_.emplace_back();
  updates_.addObject(objects_.capacity());
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
  options.far_share = culling().farShare();
  pairs_.push_back({a, b, PairOutcome::kChecked, false, false, false, 0, {}, {}, options});
  result_time_.push_back(kNaN);
  pair_margin_.push_back(kNaN);
  pairs_of_[a.index()].push_back(id);
  pairs_of_[b.index()].push_back(id);
  touching_.reserve(pairs_.capacity());
  updates_.addPair(pairs_.capacity());
  queries_.reserve(pairs_);
  invalidate(id);
  return id;
}

void Scene::setThreads(int threads) {
  if (threads < 0 || threads > kMaxThreads)
    throw UsageError("threads " + std::to_string(threads) + ": expected 0 (all cores) to " +
                     std::to_string(kMaxThreads));
  if (threads == 0)
    threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
  queries_.setThreads(threads);
}

void Scene::setMargin(ObjectId object, double margin) {
  checkNotNegative("margin", margin);
  objects_[object.index()].spec.margin = margin;
  for (const PairId id : pairs_of_[object.index()]) {
    pairs_[id.index()].options.margin = marginOf(id);
    invalidate(id);
  }
}

void Scene::setPairMargin(PairId id, std::optional<double> margin) {
  if (margin) checkNotNegative("margin", *margin);
  pair_margin_[id.index()] = margin.value_or(kNaN);
  pairs_[id.index()].options.margin = marginOf(id);
  invalidate(id);
}

double Scene::marginOf(PairId id) const {
  const double own = pair_margin_[id.index()];
  if (!std::isnan(own)) return own;
  const Pair& pair = pairs_[id.index()];
  return objects_[pair.a.index()].spec.margin + objects_[pair.b.index()].spec.margin;
}

void Scene::setPaused(PairId id, bool paused, double t) {
  Pair& pair = pairs_[id.index()];
  if (pair.paused == paused) return;
  double& time = result_time_[id.index()];
  if (paused) {
    enqueue(id);  // the next step removes it from the totals
    if (std::isnan(time)) time = std::isnan(pair.result.distance) ? -kInfinity : t;
    ++paused_count_;
    pair.paused = has_result_times_ = true;
    pair.outcome = PairOutcome::kChecked;
  } else {
    --paused_count_;
    pair.paused = false;
    invalidate(id);
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
    invalidate(PairId(i));
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
  queries_.setCulling(culling, pairs_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    pairs_[i].options.far_share = culling.farShare();
    invalidate(PairId(i));
  }
}

void Scene::startCold() noexcept {
  queries_.startCold();
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) invalidate(PairId(i));
}

bool Scene::setPose(ObjectId id, const Transform& X_WB, double t, PoseState state) {
  Object& object = objects_[id.index()];
  if (!std::isfinite(t) || !isPose(X_WB) || X_WB.translation().cwiseAbs().maxCoeff() > kFarthest) {
    object.pose_state = PoseState::kRejected;
    ++object.rejected_poses;
    return false;
  }
  if (motions_.update(id, object, X_WB, t)) updates_.addMoved(id);
  object.X_WB = X_WB;
  object.t = t;
  object.pose_state = state;
  return true;
}

void Scene::setPoseUncertainty(ObjectId object, double radius, double from_age,
                               const Matrix3d& ellipsoid) noexcept {
  Object& o = objects_[object.index()];
  o.pose_uncertainty = radius >= 0.0 ? radius : kInfinity;
  o.pose_age_uncertainty = from_age > 0.0 ? std::min(from_age, o.pose_uncertainty) : 0.0;
  o.pose_ellipsoid = ellipsoid.allFinite() ? ellipsoid : Matrix3d::Zero();
}

void Scene::enqueueAll() {
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) enqueue(PairId(i));
}

/// Forces a query in the next step, whatever is proven.
void Scene::invalidate(PairId id) {
  pairs_[id.index()].culling.invalidate();
  enqueue(id);
}

void Scene::step() {
  const double deadline = queries_.deadline();
  ++steps_;
  // Results from setResults() may be older than the current poses although nothing has moved since.
  if (external_results_) enqueueAll();
  external_results_ = false;
  updates_.begin(steps_, pairs_, pairs_of_);
  queries_.run(updated(), {pairs_, objects_, motions_.bounds()}, deadline);
  clearResultTimes();
  updateContactList();
  sumWrenches();
}

/// Results updated in this step belong to the current poses.
void Scene::clearResultTimes() {
  if (!has_result_times_) return;
  for (const PairId id : updated())
    if (!pairs_[id.index()].paused) result_time_[id.index()] = kNaN;
  has_result_times_ = paused_count_ > 0;
}

void Scene::setResults(const std::vector<query::PairResult>& results, std::span<const double> times) {
  ABSTAND_CHECK(results.size() == pairs_.size() && (times.empty() || times.size() == pairs_.size()));
  ++steps_;
  enqueueAll();
  updates_.begin(steps_, pairs_, pairs_of_);
  external_results_ = has_result_times_ = true;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].paused) continue;
    result_time_[i] = times.empty() ? kNaN : times[i];
    pairs_[i].result = results[i];
    pairs_[i].outcome = PairOutcome::kChecked;
    pairs_[i].culling.invalidate();
  }
  updateContactList();
  sumWrenches();
}

void Scene::count(Pair& pair) {
  switch (pair.outcome) {
    case PairOutcome::kChecked:
      ++counts_.checked;
      break;
    case PairOutcome::kCulled:
      ++counts_.rested;
      break;
    case PairOutcome::kBeyondHorizon:
      ++counts_.beyond;
      break;
    case PairOutcome::kDeferred:
      ++counts_.deferred;
      counts_.longest_wait = std::max(counts_.longest_wait, ++pair.waited);
      return;
  }
  pair.waited = 0;
}

/// Updates contacts and minimum from the updated pairs.
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
  bool any_started = false, any_ended = false;
  for (std::size_t i = 0; i < updated().size(); ++i) {
    prefetchAhead(pairs_, updated(), i);
    const PairId id = updated()[i];
    Pair& pair = pairs_[id.index()];
    pair.queued = false;
    if (!pair.paused) count(pair);
    distances_.set(id.index(), pair.paused ? kInfinity : pair.result.distance);
    if (pair.outcome == PairOutcome::kDeferred) enqueue(id);
    if (pair.outcome != PairOutcome::kChecked && !pair.paused) continue;
    const bool touches = !pair.paused && pair.result.contacts > 0;
    if (touches == pair.touching) continue;
    pair.touching = touches;
    (touches ? any_started : any_ended) = true;
    if (touches) touching_.push_back(id);
  }
  if (any_ended) std::erase_if(touching_, [this](PairId id) { return !pairs_[id.index()].touching; });
  if (any_started) std::sort(touching_.begin(), touching_.end());
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
