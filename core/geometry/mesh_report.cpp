#include "core/geometry/mesh_report.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace abstand {
namespace {

constexpr double kLargestRobotPart = 20.0;  // m; more is most likely a file in millimetres
constexpr double kSmallestRobotPart =
    0.002;  // m; less is most likely a file in kilometres or the wrong scale

struct EdgeUse {
  int forward{0}, backward{0};
};

std::string count(std::size_t n, const char* what) { return std::to_string(n) + " " + what; }

std::size_t components(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> root(mesh.vertices.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& t : mesh.triangles) {
    root[find(t[1])] = find(t[0]);
    root[find(t[2])] = find(t[0]);
  }
  std::vector<char> seen(root.size(), 0);
  for (const auto& t : mesh.triangles) seen[find(t[0])] = 1;
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), 1));
}

/// By the divergence theorem; negative for a closed mesh that is inside out.
double signedVolume(const TriangleMesh& mesh) {
  const Vector3d centre = bounds(mesh).centre();
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += (mesh.corner(t, 0) - centre).dot((mesh.corner(t, 1) - centre).cross(mesh.corner(t, 2) - centre));
  return sum / 6.0;
}

}  // namespace

MeshReport inspect(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.vertices.size();
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      EdgeUse& use = edges[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? use.forward : use.backward);
    }
  for (const auto& [edge, use] : edges) {
    const int total = use.forward + use.backward;
    if (total == 1) ++report.open_edges;
    if (total > 2) ++report.non_manifold_edges;
    if (total == 2 && use.forward != 1) ++report.flipped_edges;
  }
  report.components = components(mesh);
  report.volume = signedVolume(mesh);
  report.extent = bounds(mesh).extent();
  report.watertight = report.open_edges == 0 && report.non_manifold_edges == 0 && report.flipped_edges == 0 &&
                      report.volume > 0.0;

  if (report.open_edges > 0)
    report.remarks.push_back("the surface is open (" + count(report.open_edges, "edges with one triangle") +
                             "): inside and outside follow the winding number");
  if (report.non_manifold_edges > 0)
    report.remarks.push_back(count(report.non_manifold_edges, "edges with more than two triangles") +
                             ": inside and outside follow the winding number");
  if (report.flipped_edges > 0)
    report.remarks.push_back(count(report.flipped_edges, "edges whose triangles face opposite ways"));
  const double largest = report.extent.maxCoeff();
  if (largest > kLargestRobotPart)
    report.remarks.push_back("the body is " + std::to_string(largest) +
                             " m large: probably in millimetres, scale: 0.001");
  if (largest < kSmallestRobotPart)
    report.remarks.push_back("the body is " + std::to_string(1e3 * largest) + " mm small: check its scale");
  return report;
}

}  // namespace abstand
