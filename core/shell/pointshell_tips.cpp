// Corners and tips by angle defects; pitch of the points near tips and sharp edges.
#include "core/shell/pointshell_tips.hpp"

#include <algorithm>
#include <array>

namespace abstand::shell {
namespace {

constexpr double kTipAngle = 1.0;   ///< rad, in 3 x 3 x 3 cells
constexpr double kCellAngle = 0.2;  ///< rad, in the middle cell

/// Distance from a tip, in spacings, beyond which the pitch is 1.
constexpr double kTipReach = 6.0;
/// Pitch at a sharp convex edge, as a multiple of the usual one. It is constant up to kEdgeStart spacings
/// from the edge and rises to 1 at kEdgeEnd.
constexpr double kEdgePitch = 0.65;
constexpr double kEdgeStart = 1.0, kEdgeEnd = 2.5;
/// Spacing of the points that sample sharp edges, in shell spacings.
constexpr double kAlongSharpEdge = 0.5;

struct TipCell {
  std::array<std::int64_t, 3> key;
  double defect;
  double weight;      ///< of the convex vertices
  Vector3d position;  ///< weighted sum of their positions
};

/// 2 pi minus the sum of angles at each vertex; 0 on open edges, where it is undefined.
std::vector<double> angleDefects(const geometry::TriangleMesh& mesh) {
  std::vector<double> angle(mesh.vertices.size(), 0.0);
  std::vector<Vector3d> turn(mesh.vertices.size(), Vector3d::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[t][i];
      const Vector3d to_next = mesh.corner(t, (i + 1) % 3) - mesh.vertices[v];
      const Vector3d to_last = mesh.corner(t, (i + 2) % 3) - mesh.vertices[v];
      angle[v] += std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
      // Around an inner vertex every edge is counted once as next and once as last.
      turn[v] += to_next - to_last;
    }
  }
  for (std::size_t v = 0; v < angle.size(); ++v) {
    const double scale = mesh.vertices[v].cwiseAbs().maxCoeff() + turn[v].cwiseAbs().maxCoeff();
    angle[v] = angle[v] > 0.0 && turn[v].norm() <= 1e-9 * scale ? 2.0 * kPi - angle[v] : 0.0;
  }
  return angle;
}

}  // namespace

std::vector<Vector3f> findTips(const geometry::TriangleMesh& mesh, double scale) {
  const std::vector<double> defect = angleDefects(mesh);
  std::vector<TipCell> cells;
  for (std::size_t v = 0; v < defect.size(); ++v) {
    if (defect[v] == 0.0) continue;
    const Vector3d key = (mesh.vertices[v] / scale).array().floor();
    if (!(key.cwiseAbs().maxCoeff() < 1e15)) continue;
    const double weight = std::max(defect[v], 0.0);
    cells.push_back({{std::int64_t(key.x()), std::int64_t(key.y()), std::int64_t(key.z())},
                     defect[v],
                     weight,
                     weight * mesh.vertices[v]});
  }
  const auto by_key = [](const TipCell& l, const TipCell& r) { return l.key < r.key; };
  std::stable_sort(cells.begin(), cells.end(), by_key);
  std::size_t last = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].key == cells[last].key) {
      cells[last].defect += cells[i].defect;
      cells[last].weight += cells[i].weight;
      cells[last].position += cells[i].position;
    } else {
      cells[++last] = cells[i];
    }
  }
  if (!cells.empty()) cells.resize(last + 1);

  std::vector<Vector3f> tips;
  for (const TipCell& cell : cells) {
    if (cell.defect < kCellAngle) continue;
    double sum = 0.0;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        TipCell probe = cell;
        probe.key = {cell.key[0] + dx, cell.key[1] + dy, cell.key[2] - 1};
        auto it = std::lower_bound(cells.begin(), cells.end(), probe, by_key);
        for (; it != cells.end() && it->key[0] == probe.key[0] && it->key[1] == probe.key[1] &&
               it->key[2] <= cell.key[2] + 1;
             ++it) {
          sum += it->defect;
        }
      }
    }
    if (sum >= kTipAngle) tips.push_back((cell.position / cell.weight).cast<float>());
  }
  return tips;
}

PitchField::PitchField(const geometry::TriangleMesh& mesh, double spacing)
    : spacing_(spacing),
      edges_(findSharpEdges(mesh, faceNormals(mesh))),
      tips_(findTips(mesh, spacing)),
      nearest_tip_(tips_) {
  std::vector<Vector3f> along;
  for (std::uint32_t c = 0; c < edges_.sharp_edges.size(); ++c) {
    const SharpEdge& sharp_edge = edges_.sharp_edges[c];
    const Vector3d edge = sharp_edge.end[1] - sharp_edge.end[0];
    const int steps = 1 + static_cast<int>(edge.norm() / (kAlongSharpEdge * spacing));
    for (int i = 0; i <= steps; ++i) {
      along.push_back((sharp_edge.end[0] + i * edge / steps).cast<float>());
      sharp_edge_of_.push_back(c);
    }
  }
  nearest_on_sharp_edge_ = NearestOfPoints(along);
}

PitchField::Near PitchField::near(const Vector3d& p, double around) const {
  Near found;
  const double tip_limit = kTipReach * spacing_ + around;
  std::uint32_t at = 0;
  if (nearest_tip_.distance(p, at, tip_limit) < tip_limit) found.tip = at;
  // Any point of a sharp edge is within half a step of a point sampled along it.
  const double edge_limit = (kEdgeEnd + 0.5 * kAlongSharpEdge) * spacing_ + around;
  if (nearest_on_sharp_edge_.distance(p, at, edge_limit) < edge_limit) found.sharp_edge = sharp_edge_of_[at];
  return found;
}

double PitchField::pitch(const Vector3d& p, const Near& near) const {
  double pitch = 1.0;
  if (near.tip != Near::kNone) {
    const double distance = (tips_[near.tip].cast<double>() - p).norm();
    pitch = std::clamp(distance / (kTipReach * spacing_), kSmallest, 1.0);
  }
  if (near.sharp_edge != Near::kNone) {
    const double distance = edges_.sharp_edges[near.sharp_edge].distance(p) / spacing_;
    const double at_edge = std::clamp((kEdgeEnd - distance) / (kEdgeEnd - kEdgeStart), 0.0, 1.0);
    pitch = std::min(pitch, 1.0 - (1.0 - kEdgePitch) * at_edge);
  }
  return pitch;
}

}  // namespace abstand::shell
