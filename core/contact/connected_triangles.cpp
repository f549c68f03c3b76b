#include "core/contact/connected_triangles.hpp"

#include <algorithm>

namespace abstand::contact {

void connectedAbove(const ContactSurface& surface, PlacedVertices& points, std::uint32_t start, double level,
                    ConnectedTriangles& found) {
  auto& [triangles, foremost, open, seen, taken, search] = found;
  const geometry::TriangleMesh& mesh = surface.mesh();
  triangles.clear();
  foremost = start;
  if (seen.size() < mesh.vertices.size()) seen.resize(mesh.vertices.size(), 0);
  if (taken.size() < mesh.triangles.size()) taken.resize(mesh.triangles.size(), 0);
  if (++search == 0) {
    std::fill(seen.begin(), seen.end(), 0);
    std::fill(taken.begin(), taken.end(), 0);
    search = 1;
  }
  open.assign(1, start);
  seen[start] = search;
  while (!open.empty()) {
    const std::uint32_t vertex = open.back();
    open.pop_back();
    if (points[vertex].z() > points[foremost].z()) foremost = vertex;
    for (const std::uint32_t t : surface.around(vertex)) {
      if (taken[t] == search) continue;
      taken[t] = search;
      triangles.push_back(t);
      for (const std::uint32_t next : mesh.triangles[t])
        if (seen[next] != search && points[next].z() >= level) {
          seen[next] = search;
          open.push_back(next);
        }
    }
  }
}

}  // namespace abstand::contact
