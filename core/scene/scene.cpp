#include "core/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/scene/object_motion.hpp"
#include "core/scene/pair_workers.hpp"

namespace abstand {
namespace {

void checkNotNegative(const char* what, double value) {
  if (!std::isfinite(value) || value < 0.0)
    throw UsageError(std::string(what) + " " + formatDouble(value) + ": expected a finite number, 0 or more");
}

}  // namespace

class Scene::History : public MotionHistory<Scene::kMeanSamples> {};

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
    throw UsageError("object name `" + spec.name + "`: taken already, expected a new one");
  Object object;
  object.spec = std::move(spec);
  objects_.push_back(std::move(object));
  pairs_of_.emplace_back();
  histories_.emplace_back();
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
  PairOptions options;
  options.margin = objects_[a.index()].spec.margin + objects_[b.index()].spec.margin;
  options.law = law_;
  options.stiffness = stiffness_;
  pairs_.push_back({a, b, options, {}, {}});
  pairs_of_[a.index()].push_back(id);
  pairs_of_[b.index()].push_back(id);
  return id;
}

void Scene::setThreads(int threads) {
  if (threads < 0 || threads > kMostThreads)
    throw UsageError("threads " + std::to_string(threads) + ": expected 0 (all cores) to " +
                     std::to_string(kMostThreads));
  if (threads == 0)
    threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads);
  if (threads == threads_) return;
  workers_.reset();
  threads_ = 1;
  if (threads > 1) workers_ = std::make_unique<PairWorkers>(threads - 1);
  threads_ = threads;
}

void Scene::setMargin(ObjectId object, double margin) {
  checkNotNegative("margin", margin);
  objects_[object.index()].spec.margin = margin;
  for (const PairId id : pairs_of_[object.index()]) {
    Pair& pair = pairs_[id.index()];
    pair.options.margin = objects_[pair.a.index()].spec.margin + objects_[pair.b.index()].spec.margin;
  }
}

void Scene::setForceLaw(ForceLaw law, double stiffness) {
  checkNotNegative("stiffness", stiffness);
  law_ = law;
  stiffness_ = stiffness;
  for (Pair& pair : pairs_) {
    pair.options.law = law;
    pair.options.stiffness = stiffness;
  }
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
  if (!history.started() || dt <= -kLeastTimeStep) {
    history.start();
    object.velocity = object.mean_velocity = Twist{};
  } else if (dt >= kLeastTimeStep) {
    const Vector3d way = X_WB * object.spec.structure->com - object.p_WCom();
    const Vector3d rotation = rotationBetween(object.X_WB.linear(), X_WB.linear());
    history.add(dt, way, rotation);
    object.velocity = {way / dt, rotation / dt};
    object.mean_velocity = history.mean();
  }
  object.X_WB = X_WB;
  object.t = t;
  object.pose_state = state;
  return true;
}

void Scene::step() {
  const auto query = [](void* context, std::size_t i) {
    auto& scene = *static_cast<Scene*>(context);
    Pair& pair = scene.pairs_[i];
    const Object& a = scene.objects_[pair.a.index()];
    const Object& b = scene.objects_[pair.b.index()];
    queryPair(*a.spec.structure, a.X_WB, *b.spec.structure, b.X_WB, pair.options, pair.scratch, pair.result);
  };
  if (workers_) {
    workers_->run(pairs_.size(), query, this);
  } else {
    for (std::size_t i = 0; i < pairs_.size(); ++i) query(this, i);
  }
  addUp();
}

void Scene::addUp() {
  for (Object& object : objects_) {
    object.contact = {};
    object.contacts = 0;
    object.colliding = false;
  }
  for (const Pair& pair : pairs_) {
    const PairResult& r = pair.result;
    Object& a = objects_[pair.a.index()];
    Object& b = objects_[pair.b.index()];
    a.contact += {r.force_a, r.torque_a};
    b.contact += {-r.force_a, r.torque_b};
    a.contacts += r.contacts;
    b.contacts += r.contacts;
    if (r.contacts > 0) a.colliding = b.colliding = true;
  }
}

const Object* Scene::find(const std::string& name, ObjectId* id) const {
  const auto it = index_of_.find(name);
  if (it == index_of_.end()) return nullptr;
  if (id) *id = ObjectId(it->second);
  return &objects_[it->second];
}

std::size_t Scene::memoryBytes() const {
  std::unordered_set<const HapticStructure*> counted;
  std::size_t bytes = 0;
  for (const Object& object : objects_)
    if (counted.insert(object.spec.structure.get()).second) bytes += object.spec.structure->memoryBytes();
  return bytes;
}

}  // namespace abstand
