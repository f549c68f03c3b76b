#include "core/contact/connected_triangles.hpp"

namespace abstand::contact {

ConnectedTriangles connectedAbove(const ContactSurface& surface, std::span<const Vector3d> points,
                                  std::uint32_t start, double level) {
  ConnectedTriangles found{{}, start};
  std::vector<char> seen(points.size(), 0), taken(surface.mesh().triangles.size(), 0);
  std::vector<std::uint32_t> open{start};
  seen[start] = 1;
  while (!open.empty()) {
    const std::uint32_t vertex = open.back();
    open.pop_back();
    if (points[vertex].z() > points[found.foremost].z()) found.foremost = vertex;
    for (const std::uint32_t t : surface.around(vertex)) {
      if (taken[t]) continue;
      taken[t] = 1;
      found.triangles.push_back(t);
      for (const std::uint32_t next : surface.mesh().triangles[t])
        if (!seen[next] && points[next].z() >= level) {
          seen[next] = 1;
          open.push_back(next);
        }
    }
  }
  return found;
}

}  // namespace abstand::contact
