// FCL in the benchmarks: triangle meshes, exact distances and contacts.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cstdint>

#include "tests/bench/engine.hpp"

namespace abstand::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;
constexpr std::size_t kMaxContacts = 100000;  // of a pair: all of them
constexpr std::uint32_t kNoPair = 0xffffffffu;

std::shared_ptr<Model> modelOf(const geometry::TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

class Fcl final : public Engine {
 public:
  explicit Fcl(const BenchScene& scene)
      : pairs_(scene.pairs), pair_of_(scene.bodies.size() * scene.bodies.size(), kNoPair) {
    for (const auto& body : scene.bodies) {
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(modelOf(body.mesh)));
      objects_.back()->setUserData(reinterpret_cast<void*>(objects_.size() - 1));
    }
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
      const auto [a, b] = pairs_[i];
      pair_of_[a * objects_.size() + b] = pair_of_[b * objects_.size() + a] = i;
    }
    for (auto& object : objects_) {
      object->computeAABB();
      manager_.registerObject(object.get());
    }
    manager_.setup();
  }

  void frame(const Transform* X_WB, Work work, std::span<Answer> answers) override {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTransform(X_WB[i]);
      objects_[i]->computeAABB();
    }
    work_ = work;
    answers_ = answers;
    if (work == Work::kDistance || pairs_.size() == 1) {
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        answers[i].value = ask(objects_[pairs_[i].first].get(), objects_[pairs_[i].second].get());
      return;
    }
    std::ranges::fill(answers, Answer{work == Work::kSmallest ? kInfinity : 0.0, kNaN});
    manager_.update();
    if (work == Work::kSmallest)
      manager_.distance(this, &Fcl::visitNear);
    else
      manager_.collide(this, &Fcl::visitOverlap);
  }

 private:
  double ask(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b) const {
    if (work_ == Work::kDistance || work_ == Work::kSmallest) {
      const fcl::DistanceRequestd request(true);  // with nearest points
      fcl::DistanceResultd result;
      return fcl::distance(a, b, request, result);
    }
    const bool contacts = work_ == Work::kContact;
    const fcl::CollisionRequestd request(contacts ? kMaxContacts : 1, contacts);
    fcl::CollisionResultd result;
    fcl::collide(a, b, request, result);
    if (!contacts) return static_cast<double>(result.isCollision());
    double depth = 0.0;
    for (std::size_t i = 0; i < result.numContacts(); ++i)
      depth = std::max(depth, result.getContact(i).penetration_depth);
    return depth;
  }
  std::uint32_t pairOf(const fcl::CollisionObjectd* a, const fcl::CollisionObjectd* b) const {
    const auto index = [](const auto* o) { return reinterpret_cast<std::size_t>(o->getUserData()); };
    return pair_of_[index(a) * objects_.size() + index(b)];
  }
  static bool visitOverlap(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* self) {
    auto* fcl = static_cast<Fcl*>(self);
    const std::uint32_t pair = fcl->pairOf(a, b);
    if (pair != kNoPair) fcl->answers_[pair].value = fcl->ask(a, b);
    return false;
  }
  static bool visitNear(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* self, double& least) {
    auto* fcl = static_cast<Fcl*>(self);
    double& value = fcl->answers_[0].value;
    if (fcl->pairOf(a, b) != kNoPair) value = std::min(value, fcl->ask(a, b));
    least = value;
    return value <= 0.0;
  }

  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::vector<std::uint32_t> pair_of_;  ///< of two objects, in a square
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  Work work_{Work::kDistance};
  std::span<Answer> answers_;
};

}  // namespace

std::unique_ptr<Engine> openFcl(const BenchScene& scene) { return std::make_unique<Fcl>(scene); }

}  // namespace abstand::bench
