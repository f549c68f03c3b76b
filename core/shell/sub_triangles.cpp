// Subdivision of a surface by longest-edge bisection.
#include "core/shell/sub_triangles.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/error.hpp"

namespace abstand::shell {
namespace {

/// In multiples of the largest allowed edge: parts larger than this are not yet tested for nearby tips and
/// sharp edges. Two stages, as most of a surface is far from all of them.
constexpr double kFirstNearTest = 8.0, kSecondNearTest = 2.0;

/// With more sub-triangles (estimated), triangles are processed in spatial order.
constexpr double kManyPieces = 2e5;

/// Squared length over area above which a sub-triangle is a sliver. Its squared longest edge is limited to
/// the share kSliverEdge of the usual limit, as its centroid represents its ends less well.
constexpr double kSliver = 12.0, kSliverEdge = 0.4;

/// Index of the longest edge; the first of equal ones.
int longest(const double (&length2)[3]) {
  int e = 0;
  for (int i = 1; i < 3; ++i) {
    if (length2[i] > length2[e]) e = i;
  }
  return e;
}

/// Squared lengths of the edges, from each corner to the next.
void measure(const Vector3d (&corner)[3], double (&length2)[3]) {
  for (int i = 0; i < 3; ++i) length2[i] = (corner[(i + 1) % 3] - corner[i]).squaredNorm();
}

/// `sharp` bits of the two halves after a bisection of edge e. Edges of the first: e (half), cut, g. Of the
/// second: e (half), f, cut.
struct HalfSharp {
  std::uint16_t first, second;
  HalfSharp(unsigned sharp, int e) {
    const auto bit = [&](int edge) { return (sharp >> (edge % 3)) & 1u; };
    first = static_cast<std::uint16_t>(bit(e) | bit(e + 2) << 2);
    second = static_cast<std::uint16_t>(bit(e) | bit(e + 1) << 1);
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

/// A part that may have to be bisected further.
struct SubTriangles::Part {
  Piece piece;
  double length2[3];  ///< squared lengths of its edges
  double area;
  std::uint32_t frame;
  int near_tests;  ///< stages of tests done; 2: all
  PitchField::Near near;
};

SubTriangles::SubTriangles(const geometry::TriangleMesh& mesh, double max_edge, double max_area,
                           const PitchField& field)
    : mesh_(mesh), max_edge_(max_edge), normals_(faceNormals(mesh)) {
  double pieces = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const SubTriangle whole{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, t, 0u};
    double length2[3];
    measure(whole.corner, length2);
    // Bisection overshoots by a factor of at most two.
    pieces += 1.0 + 2.0 * (whole.area() / max_area + std::sqrt(length2[longest(length2)]) / max_edge);
  }
  if (!(pieces <= kMaxPieces)) {
    throw UsageError("point spacing is too small for this surface: " + std::to_string(pieces / 1e6) +
                     " million surface pieces, at most " + std::to_string(kMaxPieces / 1e6) +
                     " million are allowed");
  }
  // Reserved but unused memory is not committed. A fine pitch needs more.
  const auto capacity = static_cast<std::size_t>(field.isUniform() ? pieces : 2.0 * pieces);
  pieces_.reserve(capacity);
  if (!field.isUniform()) pitch_.reserve(capacity);
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  if (pieces > kManyPieces) {
    std::vector<Vector3f> middles;
    middles.reserve(order.size());
    for (const std::uint32_t t : order)
      middles.push_back(((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0).cast<float>());
    order = mortonOrder(middles);
  }
  std::vector<Part> stack;
  for (const std::uint32_t t : order) {
    if (!normals_[t].isZero()) subdivide(t, max_area, field, stack);
  }
}

SubTriangles::Frame SubTriangles::frameOf(std::uint32_t t, std::uint32_t frame) const {
  if (frame != kTriangle) return frames_[frame];
  const Vector3d& a = mesh_.corner(t, 0);
  return {a, mesh_.corner(t, 1) - a, mesh_.corner(t, 2) - a};
}

void SubTriangles::subdivide(std::uint32_t t, double max_area, const PitchField& field,
                             std::vector<Part>& stack) {
  const double max_edge2 = max_edge_ * max_edge_;
  const SubTriangle whole{{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, t, 0u};
  constexpr std::uint16_t kOne = kWhole;
  Part root{{{0, kOne, 0}, {0, 0, kOne}, 0, field.sharp()[t]},
            {},
            whole.area(),
            kTriangle,
            field.isUniform() ? 2 : 0,
            {}};
  measure(whole.corner, root.length2);
  stack.push_back(root);
  View view;
  view.frame_ = frameOf(t, kTriangle);
  std::uint32_t frame = kTriangle;
  bool new_run = true;
  while (!stack.empty()) {
    Part part = stack.back();
    stack.pop_back();
    const Piece& piece = part.piece;
    if (part.frame != frame) {
      frame = part.frame;
      view.frame_ = frameOf(t, frame);
      new_run = true;
    }
    view.piece_ = &piece;
    const int e = longest(part.length2);
    const double length = std::sqrt(part.length2[e]);
    if (part.near_tests < 2 &&
        length <= (part.near_tests == 0 ? kFirstNearTest : kSecondNearTest) * max_edge_) {
      part.near = field.near(view.centroid(), 2.0 / 3.0 * length);
      part.near_tests = part.near.none() || length <= kSecondNearTest * max_edge_ ? 2 : 1;
    }
    double pitch = 1.0;
    bool halved = part.area > max_area || part.length2[e] > max_edge2 ||
                  (part.length2[e] > kSliver * part.area && part.length2[e] > kSliverEdge * max_edge2);
    if (!halved && !part.near.none()) {
      pitch = field.pitch(view.centroid(), part.near);
      halved = part.area > pitch * pitch * max_area;
    }
    if (!halved) {
      if (new_run) runs_.push_back({size(), t, frame});
      new_run = false;
      pieces_.push_back(piece);
      if (!field.isUniform()) pitch_.push_back(static_cast<float>(pitch));
      continue;
    }
    const int f = (e + 1) % 3, g = (e + 2) % 3;
    if ((piece.b[e] + piece.b[f]) % 2 != 0 || (piece.c[e] + piece.c[f]) % 2 != 0) {
      // Too fine for this frame: continues in a frame of its own.
      const Vector3d a = view.corner(0);
      frames_.push_back({a, view.corner(1) - a, view.corner(2) - a});
      part.piece = {{0, kOne, 0}, {0, 0, kOne}, piece.level, piece.sharp};
      part.frame = static_cast<std::uint32_t>(frames_.size() - 1);
      stack.push_back(part);
      continue;
    }
    const auto mb = static_cast<std::uint16_t>((piece.b[e] + piece.b[f]) / 2),
               mc = static_cast<std::uint16_t>((piece.c[e] + piece.c[f]) / 2),
               level = static_cast<std::uint16_t>(piece.level + 1);
    // The cut is the median.
    const double half2 = 0.25 * part.length2[e],
                 cut2 = std::max(0.0, 0.5 * (part.length2[f] + part.length2[g]) - half2);
    const HalfSharp half(piece.sharp, e);
    Part first = part, second = part;
    first.area = second.area = 0.5 * part.area;
    first.piece = {{piece.b[e], mb, piece.b[g]}, {piece.c[e], mc, piece.c[g]}, level, half.first};
    second.piece = {{mb, piece.b[f], piece.b[g]}, {mc, piece.c[f], piece.c[g]}, level, half.second};
    first.length2[0] = second.length2[0] = half2;
    first.length2[1] = second.length2[2] = cut2;
    first.length2[2] = part.length2[g];
    second.length2[1] = part.length2[f];
    stack.push_back(second);
    stack.push_back(first);
  }
}

SubTriangle SubTriangles::piece(std::uint32_t index) const {
  SubTriangle piece;
  forEach(index, index + 1, [&](std::uint32_t, const View& view) { piece = view.whole(); });
  return piece;
}

std::vector<SubTriangle> SubTriangles::degenerate() const {
  std::vector<SubTriangle> out;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (normals_[t].isZero()) {
      out.push_back({{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, t, 0u});
    }
  }
  return out;
}

}  // namespace abstand::shell
