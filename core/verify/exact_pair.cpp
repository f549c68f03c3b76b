// True signed distance of two bodies, by brute force.
#include "core/verify/exact_pair.hpp"

#include <algorithm>

#include "core/verify/penetration.hpp"

namespace abstand::verify {
namespace {

constexpr int kMaxSamples = 400;

bool anyInside(const std::vector<Vector3d>& probes, const AdversarialBody& body) {
  return body.closed && std::ranges::any_of(probes, [&](const Vector3d& p) { return body.soup.inside(p); });
}

}  // namespace

ExactDistance exactDistance(const AdversarialBody& P, const AdversarialBody& F, const Transform& X_FP,
                            double tolerance) {
  const TriangleSoup moved = P.soup.moved(X_FP);
  const double apart = moved.distanceTo(F.soup);
  // An open body has no definite inside: any depth reported by the engine is accepted.
  if (!F.closed || !P.closed) return {-kInfinity, apart, apart == 0.0, false};
  bool swallowed = false;
  const Transform X_PF = X_FP.inverse();
  if (apart > 0.0) {
    // The surfaces do not intersect: a component lies entirely inside the other body or entirely outside.
    if ((X_FP * P.centre - F.centre).norm() > P.radius + F.radius) return {apart, apart, false, false};
    std::vector<Vector3d> probes;
    for (const Vector3d& q : F.soup.probes()) probes.push_back(X_PF * q);
    swallowed = anyInside(probes, P);
    if (!swallowed && !anyInside(moved.probes(), F)) return {apart, apart, false, false};
  }
  const auto samples = [](const TriangleSoup& soup) { return kMaxSamples + static_cast<int>(soup.size()); };
  const Penetration of_points = penetration(moved, F.soup, tolerance, samples(moved));
  const Penetration of_field = penetration(F.soup.moved(X_PF), P.soup, tolerance, samples(F.soup));
  return {-std::max({0.0, of_points.upper, of_field.upper}),
          -std::max({0.0, of_points.lower, of_field.lower}), true, swallowed};
}

}  // namespace abstand::verify
