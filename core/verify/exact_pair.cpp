// The true signed distance of two bodies, by brute force.
#include "core/verify/exact_pair.hpp"

#include <algorithm>

#include "core/verify/penetration.hpp"

namespace abstand::verify {
namespace {

constexpr int kMostSamples = 400;

bool anyInside(const std::vector<Vector3d>& probes, const NastyBody& body) {
  return body.closed && std::ranges::any_of(probes, [&](const Vector3d& p) { return body.soup.inside(p); });
}

}  // namespace

ExactDistance exactDistance(const NastyBody& P, const NastyBody& F, const Transform& X_FP, double tolerance) {
  const TriangleSoup moved = P.soup.moved(X_FP);
  const double apart = moved.distanceTo(F.soup);
  bool deep = apart == 0.0;
  if (!deep) {
    // No surface cuts another: then all of a piece is inside the other body, or nothing of it.
    const EnclosingSphere &p = P.structure->bounding_sphere, &f = F.structure->bounding_sphere;
    if ((X_FP * p.centre - f.centre).norm() > p.radius + f.radius) return {apart, apart, false};
    deep = anyInside(moved.probes(), F);
    if (!deep) {
      std::vector<Vector3d> probes;
      for (const Vector3d& q : F.soup.probes()) probes.push_back(X_FP.inverse() * q);
      if (anyInside(probes, P)) return {-kInfinity, 0.0, true};
      return {apart, apart, false};
    }
  }
  if (!F.closed) return {-kInfinity, 0.0, true};
  const Penetration depth =
      penetration(moved, F.soup, tolerance, kMostSamples + static_cast<int>(moved.size()));
  return {-std::max(0.0, depth.most), -std::max(0.0, depth.least), true};
}

}  // namespace abstand::verify
