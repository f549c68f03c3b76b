// Enclosure of the penetration depth of one mesh in another.
#include "core/verify/penetration.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace abstand::verify {
namespace {

/// A part of a triangle, and the upper bound of the depth of its points.
struct Part {
  Triangle corners;
  double upper;
  bool operator<(const Part& other) const { return upper < other.upper; }
};

}  // namespace

Penetration penetration(const TriangleSoup& P, const TriangleSoup& F, double tolerance, int max_samples) {
  Penetration found;
  std::priority_queue<Part> open;
  int samples = 0;
  const auto bound = [&](const Triangle& t) {
    ++samples;
    const Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
    const double radius = std::max({(t[0] - centre).norm(), (t[1] - centre).norm(), (t[2] - centre).norm()});
    const double distance = F.distanceTo(centre);
    // The side only matters if it could be deeper than the deepest so far.
    if (distance + radius <= found.lower) return;
    const double depth = F.inside(centre) ? distance : -distance;
    found.lower = std::max(found.lower, depth);
    open.push({t, depth + radius});
  };
  for (std::size_t i = 0; i < P.size(); ++i) bound(P[i]);
  while (!open.empty() && open.top().upper > found.lower + tolerance && samples < max_samples) {
    const Triangle t = open.top().corners;
    open.pop();
    // Bisects the longest side.
    int longest = 0;
    for (int i = 1; i < 3; ++i)
      if ((t[(i + 1) % 3] - t[i]).norm() > (t[(longest + 1) % 3] - t[longest]).norm()) longest = i;
    const Vector3d &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
    const Vector3d middle = 0.5 * (a + b);
    bound({a, middle, c});
    bound({middle, b, c});
  }
  found.upper = open.empty() ? found.lower : std::max(found.lower, open.top().upper);
  return found;
}

}  // namespace abstand::verify
