// A surface cut into small triangles: subdivision and sharp edges.
#include "core/haptic/pointshell_pool.hpp"

#include <algorithm>
#include <tuple>

#include "core/base/error.hpp"

namespace abstand {
namespace {

/// Faces that meet at a larger angle than this are sampled apart from each other.
constexpr double kSharpAngle = unit::deg(35.0);

struct Edge {
  std::uint32_t low, high, triangle, side;
};

std::vector<std::uint8_t> sharpEdges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals,
                                     std::vector<Crease>& creases) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t a = mesh.triangles[t][side], b = mesh.triangles[t][(side + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, side});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
    return std::tie(l.low, l.high, l.triangle, l.side) < std::tie(r.low, r.high, r.triangle, r.side);
  });
  std::vector<std::uint8_t> sharp(mesh.triangles.size(), 0);
  const double smooth = std::cos(kSharpAngle);
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 2 && normals[edges[i].triangle].dot(normals[edges[i + 1].triangle]) >= smooth) continue;
    if (end == i + 2) {
      const Edge &e = edges[i], &f = edges[i + 1];
      const Vector3d across = mesh.corner(f.triangle, (f.side + 2) % 3) - mesh.vertices[e.low];
      if (normals[e.triangle].dot(across) < 0.0) {
        creases.push_back(
            {{normals[e.triangle], normals[f.triangle]}, {mesh.vertices[e.low], mesh.vertices[e.high]}});
      }
    }
    for (std::size_t k = i; k < end; ++k) sharp[edges[k].triangle] |= std::uint8_t(1u << edges[k].side);
  }
  return sharp;
}

}  // namespace

double SubTriangle::longestEdge(int* edge) const {
  double longest = -1.0;
  for (int i = 0; i < 3; ++i) {
    const double length2 = (corner[(i + 1) % 3] - corner[i]).squaredNorm();
    if (length2 > longest) {
      longest = length2;
      if (edge != nullptr) *edge = i;
    }
  }
  return std::sqrt(longest);
}

void SubTriangle::split(SubTriangle& first, SubTriangle& second) const {
  int e = 0;
  longestEdge(&e);
  const int f = (e + 1) % 3, g = (e + 2) % 3;
  const Vector3d middle = 0.5 * (corner[e] + corner[f]);
  const auto bit = [&](int edge) { return (sharp >> edge) & 1u; };
  // Edges of the first: e (half), cut, g. Edges of the second: e (half), f, cut.
  first = {{corner[e], middle, corner[g]}, triangle, bit(e) | bit(g) << 2};
  second = {{middle, corner[f], corner[g]}, triangle, bit(e) | bit(f) << 1};
}

Vector3d closestPoint(const SubTriangle& t, const Vector3d& p) {
  const Vector3d &a = t.corner[0], &b = t.corner[1], &c = t.corner[2];
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double scale = 1.0 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

SurfacePool::SurfacePool(const TriangleMesh& mesh, double max_edge, double max_area, const TipField& tips)
    : mesh_(mesh), normals_(mesh.triangles.size()) {
  double pieces = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d cross =
        (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    const double length = cross.norm();
    normals_[t] = length > 0.0 ? Vector3d(cross / length) : Vector3d::Zero();
    // Halving overshoots by a factor of two at most.
    pieces += 1.0 + 2.0 * (0.5 * length / max_area + whole(t).longestEdge() / max_edge);
  }
  if (!(pieces <= kMaxPieces)) {
    throw UsageError("point spacing is too small for this surface: " + std::to_string(pieces / 1e6) +
                     " million surface pieces, at most " + std::to_string(kMaxPieces / 1e6) +
                     " million are allowed");
  }
  sharp_ = sharpEdges(mesh, normals_, creases_);

  constexpr double kSmallestShare = TipField::kSmallest * TipField::kSmallest;
  const auto tooLarge = [&](const SubTriangle& piece) {
    const double area = piece.area();
    if (area > max_area || piece.longestEdge() > max_edge) return true;
    if (area <= kSmallestShare * max_area) return false;
    const double pitch = tips.pitch(piece.centroid());
    return area > pitch * pitch * max_area;
  };
  std::size_t count = 0;
  std::vector<SubTriangle> stack;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (normals_[t].isZero()) continue;
    stack.push_back(whole(t));
    while (!stack.empty()) {
      const SubTriangle piece = stack.back();
      stack.pop_back();
      split_.push_back(tooLarge(piece));
      if (!split_.back()) {
        if (++count <= kMostStored) pieces_.push_back(piece);
        continue;
      }
      stack.resize(stack.size() + 2);
      piece.split(stack[stack.size() - 1], stack[stack.size() - 2]);
    }
  }
  if (count > kMostStored) pieces_ = {};
}

SubTriangle SurfacePool::whole(std::uint32_t t) const {
  return {{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, t, sharp_.empty() ? 0u : sharp_[t]};
}

std::vector<SubTriangle> SurfacePool::degenerate() const {
  std::vector<SubTriangle> out;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (normals_[t].isZero()) out.push_back(whole(t));
  }
  return out;
}

}  // namespace abstand
