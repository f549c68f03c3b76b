#include "core/contact/connected_triangles.hpp"

namespace abstand::contact {

void connectedAbove(const ContactSurface& surface, std::span<const Vector3d> points, std::uint32_t start,
                    double level, ConnectedTriangles& found) {
  auto& [triangles, foremost, open, seen, taken] = found;
  triangles.clear();
  foremost = start;
  seen.assign(points.size(), 0);
  taken.assign(surface.mesh().triangles.size(), 0);
  open.assign(1, start);
  seen[start] = 1;
  while (!open.empty()) {
    const std::uint32_t vertex = open.back();
    open.pop_back();
    if (points[vertex].z() > points[foremost].z()) foremost = vertex;
    for (const std::uint32_t t : surface.around(vertex)) {
      if (taken[t]) continue;
      taken[t] = 1;
      triangles.push_back(t);
      for (const std::uint32_t next : surface.mesh().triangles[t])
        if (!seen[next] && points[next].z() >= level) {
          seen[next] = 1;
          open.push_back(next);
        }
    }
  }
}

}  // namespace abstand::contact
