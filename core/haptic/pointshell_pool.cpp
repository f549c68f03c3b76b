// A surface cut into small triangles by halving them at their longest edges.
#include "core/haptic/pointshell_pool.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand {
namespace {

/// In multiples of the longest edge allowed: parts larger than this are not yet asked what is near them.
/// Twice, as most of a surface is far from all.
constexpr double kAskFirst = 8.0, kAskAgain = 2.0;

/// Squared length over area from which on a piece is a sliver, whose square of the longest edge may only be
/// this part of others': its middle says less of where its ends are.
constexpr double kSliver = 12.0, kSliverEdge = 0.4;

/// The first of the longest.
int longest(const double (&length2)[3]) {
  int e = 0;
  for (int i = 1; i < 3; ++i) {
    if (length2[i] > length2[e]) e = i;
  }
  return e;
}

/// The squared lengths of the edges, from each corner to the next.
void measure(const Vector3d (&corner)[3], double (&length2)[3]) {
  for (int i = 0; i < 3; ++i) length2[i] = (corner[(i + 1) % 3] - corner[i]).squaredNorm();
}

/// Of the halves at edge e. Edges of the first: e (half), cut, g. Edges of the second: e (half), f, cut.
struct HalfSharp {
  unsigned first, second;
  HalfSharp(unsigned sharp, int e) {
    const auto bit = [&](int edge) { return (sharp >> (edge % 3)) & 1u; };
    first = bit(e) | bit(e + 2) << 2;
    second = bit(e) | bit(e + 1) << 1;
  }
};

}  // namespace

void SubTriangle::split(SubTriangle& first, SubTriangle& second) const {
  double length2[3];
  measure(corner, length2);
  const int e = longest(length2), f = (e + 1) % 3, g = (e + 2) % 3;
  const Vector3d middle = 0.5 * (corner[e] + corner[f]);
  const HalfSharp half(sharp, e);
  first = {{corner[e], middle, corner[g]}, triangle, half.first};
  second = {{middle, corner[f], corner[g]}, triangle, half.second};
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

/// A piece that may still have to be halved.
struct SurfacePool::Part {
  Piece piece;
  double length2[3];  ///< squared lengths of its edges
  double area;
  int asked;  ///< how often; not once more
  PitchField::Near near;
};

SurfacePool::SurfacePool(const TriangleMesh& mesh, double max_edge, double max_area, const PitchField& field)
    : mesh_(mesh), max_edge_(max_edge), normals_(faceNormals(mesh)) {
  double pieces = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const SubTriangle whole{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, t, 0u};
    double length2[3];
    measure(whole.corner, length2);
    // Halving overshoots by a factor of two at most.
    pieces += 1.0 + 2.0 * (whole.area() / max_area + std::sqrt(length2[longest(length2)]) / max_edge);
  }
  if (!(pieces <= kMaxPieces)) {
    throw UsageError("point spacing is too small for this surface: " + std::to_string(pieces / 1e6) +
                     " million surface pieces, at most " + std::to_string(kMaxPieces / 1e6) +
                     " million are allowed");
  }
  // Room that is not used takes no memory.
  const auto room = static_cast<std::size_t>(pieces);
  pieces_.reserve(room);
  for (auto* v : {&area_, &spread_, &pitch_}) v->reserve(room);
  std::vector<Part> stack;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!normals_[t].isZero()) cut(t, max_area, field, stack);
  }
}

void SurfacePool::cut(std::uint32_t t, double max_area, const PitchField& field, std::vector<Part>& stack) {
  const double max_edge2 = max_edge_ * max_edge_;
  const SubTriangle whole{{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, t, 0u};
  const Vector3d &a = whole.corner[0], ab = whole.corner[1] - a, ac = whole.corner[2] - a;
  Part root{{{0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, t, field.sharp()[t]},
            {},
            whole.area(),
            field.plain() ? 2 : 0,
            {}};
  measure(whole.corner, root.length2);
  stack.push_back(root);
  while (!stack.empty()) {
    Part part = stack.back();
    stack.pop_back();
    const Piece& piece = part.piece;
    const auto centroid = [&]() -> Vector3d {
      return a + (double(piece.b[0]) + double(piece.b[1]) + double(piece.b[2])) / 3.0 * ab +
             (double(piece.c[0]) + double(piece.c[1]) + double(piece.c[2])) / 3.0 * ac;
    };
    const int e = longest(part.length2);
    const double length = std::sqrt(part.length2[e]);
    if (part.asked < 2 && length <= (part.asked == 0 ? kAskFirst : kAskAgain) * max_edge_) {
      part.near = field.near(centroid(), 2.0 / 3.0 * length);
      part.asked = part.near.none() || length <= kAskAgain * max_edge_ ? 2 : 1;
    }
    double pitch = 1.0;
    bool halved = part.area > max_area || part.length2[e] > max_edge2 ||
                  (part.length2[e] > kSliver * part.area && part.length2[e] > kSliverEdge * max_edge2);
    if (!halved && !part.near.none()) {
      pitch = field.pitch(centroid(), part.near);
      halved = part.area > pitch * pitch * max_area;
    }
    if (!halved) {
      pieces_.push_back(piece);
      area_.push_back(static_cast<float>(part.area));
      // A twelfth of the sum over the corners, and that is a third of the sum over the edges.
      spread_.push_back(static_cast<float>((part.length2[0] + part.length2[1] + part.length2[2]) / 36.0));
      pitch_.push_back(static_cast<float>(pitch));
      continue;
    }
    const int f = (e + 1) % 3, g = (e + 2) % 3;
    const float mb = 0.5f * (piece.b[e] + piece.b[f]), mc = 0.5f * (piece.c[e] + piece.c[f]);
    // The cut is the median.
    const double half2 = 0.25 * part.length2[e],
                 cut2 = std::max(0.0, 0.5 * (part.length2[f] + part.length2[g]) - half2);
    const HalfSharp half(piece.sharp, e);
    const Part first{{{piece.b[e], mb, piece.b[g]}, {piece.c[e], mc, piece.c[g]}, t, half.first},
                     {half2, cut2, part.length2[g]},
                     0.5 * part.area,
                     part.asked,
                     part.near};
    stack.push_back({{{mb, piece.b[f], piece.b[g]}, {mc, piece.c[f], piece.c[g]}, t, half.second},
                     {half2, part.length2[f], cut2},
                     0.5 * part.area,
                     part.asked,
                     part.near});
    stack.push_back(first);
  }
}

std::vector<SubTriangle> SurfacePool::degenerate() const {
  std::vector<SubTriangle> out;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (normals_[t].isZero()) {
      out.push_back({{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, t, 0u});
    }
  }
  return out;
}

}  // namespace abstand
