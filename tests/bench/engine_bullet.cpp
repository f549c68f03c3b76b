// Bullet in the benchmarks: GJK and EPA on convex hulls.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/geometry/convex_hull.hpp"
#include "tests/bench/engine.hpp"

namespace abstand::bench {
namespace {

btVector3 vector(const Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

std::unique_ptr<btConvexHullShape> hullOf(const geometry::TriangleMesh& mesh) {
  const auto hull = geometry::convexHull(mesh.vertices);
  if (!hull) throw UsageError("a mesh of the benchmarks has no hull");
  auto shape = std::make_unique<btConvexHullShape>();
  for (const std::uint32_t corner : hull->corners) shape->addPoint(vector(mesh.vertices[corner]), false);
  shape->setMargin(0);
  shape->recalcLocalAabb();
  return shape;
}

class Bullet final : public Engine {
 public:
  explicit Bullet(const BenchScene& scene)
      : pairs_(scene.pairs),
        axes_(pairs_.size(), btVector3(0, 1, 0)),
        X_WB_(scene.bodies.size()),
        boxes_(scene.bodies.size()),
        smallest_(pairs_.size()) {
    for (const auto& body : scene.bodies) hulls_.push_back(hullOf(body.mesh));
  }

  void frame(const Transform* X_WB, Work work, std::span<Answer> answers) override {
    for (std::size_t i = 0; i < hulls_.size(); ++i) {
      btMatrix3x3 R;
      for (int row = 0; row < 3; ++row) R[row] = vector(X_WB[i].linear().row(row));
      X_WB_[i] = btTransform(R, vector(X_WB[i].translation()));
      if (work != Work::kDistance) hulls_[i]->getAabb(X_WB_[i], boxes_[i].lower, boxes_[i].upper);
    }
    if (work == Work::kSmallest) {
      answers[0].value = smallest_
                             .find([&](std::size_t i) { return gap(i); },
                                   [&](std::size_t i) {
                                     return Answer{ask(i, true), kNaN};
                                   })
                             .value;
      return;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (work == Work::kDistance) {
        answers[i].value = ask(i, true);
        continue;
      }
      const double depth = gap(i) > 0.0 ? 0.0 : std::max(0.0, -ask(i, false));
      answers[i].value = work == Work::kContact ? depth : static_cast<double>(depth > 0.0);
    }
  }

 private:
  struct Box {
    btVector3 lower, upper;
  };

  /// Of the boxes.
  double gap(std::size_t i) const {
    const Box &a = boxes_[pairs_[i].first], &b = boxes_[pairs_[i].second];
    btVector3 way = a.lower - b.upper;
    way.setMax(b.lower - a.upper);
    way.setMax(btVector3(0, 0, 0));
    return static_cast<double>(way.length());
  }
  /// Signed distance of the hulls; 0 where only contact counts and there is none.
  double ask(std::size_t i, bool apart_too) {
    const auto [a, b] = pairs_[i];
    btGjkPairDetector detector(hulls_[a].get(), hulls_[b].get(), &simplex_, &penetration_);
    detector.setCachedSeparatingAxis(axes_[i]);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = X_WB_[a];
    input.m_transformB = X_WB_[b];
    if (!apart_too) input.m_maximumDistanceSquared = 0;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    axes_[i] = detector.getCachedSeparatingAxis();
    return found.m_hasResult ? static_cast<double>(found.m_distance) : 0.0;
  }

  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::vector<btVector3> axes_;
  std::vector<btTransform> X_WB_;
  std::vector<Box> boxes_;
  SmallestSearch smallest_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
};

}  // namespace

std::unique_ptr<Engine> openBullet(const BenchScene& scene) { return std::make_unique<Bullet>(scene); }

}  // namespace abstand::bench
