// Generalised winding number of a mesh: inside or outside, even where the mesh is open or intersects itself.
#include "core/geometry/winding_number.hpp"

#include <cmath>

namespace abstand::geometry {
namespace {

// Solid angle of a triangle over 4 pi (Van Oosterom, Strackee 1983), positive seen from inside.
double solidAngle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double determinant = a.dot(b.cross(c));
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return std::atan2(determinant, denominator) / (2.0 * kPi);
}

}  // namespace

struct WindingNumber::Sums {
  Vector3d moment{Vector3d::Zero()};
  Vector3d weighted{Vector3d::Zero()};
  double area{0.0};
  Bounds box;
};

WindingNumber::WindingNumber(const TriangleTree& tree, const TriangleMesh& mesh) {
  corners_.resize(tree.size());
  for (std::uint32_t s = 0; s < tree.size(); ++s) {
    const std::uint32_t t = tree.triangle(s);
    corners_[s] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  }
  nodes_.resize(tree.nodes().size());
  addNode(tree, 0);
}

WindingNumber::Sums WindingNumber::addNode(const TriangleTree& tree, std::uint32_t node) {
  const TriangleTree::Node& from = tree.nodes()[node];
  Sums total;
  for (int c = 0; c < TriangleTree::kWidth; ++c) {
    nodes_[node].index[c] = from.index[c];
    nodes_[node].count[c] = from.count[c];
    if (from.index[c] == TriangleTree::kNone) continue;
    if (from.count[c] > 0) nodes_[node].index[c] = tree.firstSlot(from.index[c]);
    Sums sums;
    if (from.count[c] == 0) {
      sums = addNode(tree, from.index[c]);
    } else {
      const std::uint32_t first = nodes_[node].index[c];
      for (std::uint32_t s = first; s < first + from.count[c]; ++s) {
        const Corners& t = corners_[s];
        const Vector3d n = 0.5 * (t.b - t.a).cross(t.c - t.a);
        const double area = n.norm();
        sums.moment += n;
        sums.weighted += area * (t.a + t.b + t.c) / 3.0;
        sums.area += area;
        sums.box.add(t.a);
        sums.box.add(t.b);
        sums.box.add(t.c);
      }
    }
    Dipole& dipole = nodes_[node].dipole[c];
    dipole.centre = sums.weighted / sums.area;
    dipole.moment = sums.moment / (4.0 * kPi);
    const Vector3d reach = (dipole.centre - sums.box.lower).cwiseMax(sums.box.upper - dipole.centre);
    dipole.far2 = kFarRatio * kFarRatio * reach.squaredNorm();
    total.moment += sums.moment;
    total.weighted += sums.weighted;
    total.area += sums.area;
    total.box.add(sums.box.lower);
    total.box.add(sums.box.upper);
  }
  return total;
}

double WindingNumber::at(const Vector3d& p, std::uint32_t without) const {
  // Same size as the tree's stack.
  std::array<std::uint32_t, 256> stack;
  int top = 0;
  stack[top++] = 0;
  double sum = 0.0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    for (int c = 0; c < TriangleTree::kWidth; ++c) {
      if (node.index[c] == TriangleTree::kNone) continue;
      const Dipole& dipole = node.dipole[c];
      const Vector3d r = dipole.centre - p;
      const double r2 = r.squaredNorm();
      if (r2 > dipole.far2) {
        sum += dipole.moment.dot(r) / (r2 * std::sqrt(r2));
      } else if (node.count[c] == 0) {
        stack[top++] = node.index[c];
      } else {
        for (std::uint32_t s = node.index[c]; s < node.index[c] + node.count[c]; ++s) {
          if (s == without) continue;
          const Corners& t = corners_[s];
          sum += solidAngle(t.a - p, t.b - p, t.c - p);
        }
      }
    }
  }
  return sum;
}

double WindingNumber::exactAt(const Vector3d& p, std::uint32_t without) const {
  double sum = 0.0;
  for (std::uint32_t s = 0; s < corners_.size(); ++s) {
    if (s != without) sum += solidAngle(corners_[s].a - p, corners_[s].b - p, corners_[s].c - p);
  }
  return sum;
}

}  // namespace abstand::geometry
