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
  // An open body has no certain inside: wherever the engine sees one, it may say so.
  if (!F.closed) return {-kInfinity, apart, apart == 0.0, false};
  if (apart > 0.0) {
    // No surface cuts another: then all of a piece is inside the other body, or nothing of it.
    if ((X_FP * P.centre - F.centre).norm() > P.radius + F.radius) return {apart, apart, false, false};
    if (!anyInside(moved.probes(), F)) {
      std::vector<Vector3d> probes;
      for (const Vector3d& q : F.soup.probes()) probes.push_back(X_FP.inverse() * q);
      const bool swallowed = anyInside(probes, P);
      return {apart, apart, swallowed, swallowed};
    }
  }
  const Penetration depth =
      penetration(moved, F.soup, tolerance, kMostSamples + static_cast<int>(moved.size()));
  return {-std::max(0.0, depth.most), -std::max(0.0, depth.least), true, false};
}

}  // namespace abstand::verify
