#include "core/haptic/pair_query.hpp"

#include <algorithm>

#include "core/haptic/field_sampler.hpp"
#include "core/haptic/witness.hpp"

namespace abstand {
namespace {

// Shell points are moved between the frames in float: below 0.2 um for bodies within some metres.
constexpr float kFloatRounding = 1e-6f;

/// A point-sphere tree seen from the frame F of the other body.
class MovedTree {
 public:
  MovedTree(const PointSphereTree& tree, const Transform& X_FP)
      : tree_(tree), R_(X_FP.linear().cast<float>()), t_(X_FP.translation().cast<float>()) {}

  const PointSphereTree::Node& node(std::uint32_t i) const { return tree_.nodes[i]; }
  Vector3f centre(const PointSphereTree::Node& n) const { return R_ * Vector3f(n.cx, n.cy, n.cz) + t_; }
  Vector3f point(std::uint32_t i) const { return R_ * Vector3f(tree_.x[i], tree_.y[i], tree_.z[i]) + t_; }
  Vector3f normal(std::uint32_t i) const { return R_ * Vector3f(tree_.nx[i], tree_.ny[i], tree_.nz[i]); }
  float area(std::uint32_t i) const { return tree_.area[i]; }

 private:
  const PointSphereTree& tree_;
  Eigen::Matrix3f R_;
  Vector3f t_;
};

struct Nearest {
  std::uint32_t point{0};  ///< leaf-ordered index of the point with the smallest estimate
  float estimate{std::numeric_limits<float>::infinity()};
  float lower_bound{std::numeric_limits<float>::infinity()};  ///< of every shell point's true distance
};

/// Pushes the children of a node, the nearest last, so that it is taken first.
template <class Bound>
std::size_t pushChildren(const MovedTree& tree, const PointSphereTree::Node& node, std::size_t top,
                         float limit, PairScratch& scratch, Bound bound) {
  const std::size_t first = top;
  for (std::uint32_t c = node.first_child; c < node.first_child + node.children; ++c) {
    const auto& child = tree.node(c);
    const float f = bound(tree.centre(child)) - child.radius;
    if (f >= limit) continue;
    std::size_t at = top++;
    for (; at > first && scratch.stack[at - 1].lower_bound < f; --at)
      scratch.stack[at] = scratch.stack[at - 1];
    scratch.stack[at] = {f, c};
  }
  return top;
}

/// Branch and bound for the smallest distance over all shell points.
Nearest findNearest(const MovedTree& tree, const FieldSampler& field, PairScratch& scratch) {
  Nearest best;
  std::size_t top = 0;
  scratch.stack[top++] = {-std::numeric_limits<float>::infinity(), 0};
  while (top > 0) {
    const auto entry = scratch.stack[--top];
    if (entry.lower_bound >= best.lower_bound) continue;
    const auto& node = tree.node(entry.node);
    if (node.children > 0) {
      top = pushChildren(tree, node, top, best.lower_bound, scratch,
                         [&](const Vector3f& c) { return field.lowerBound(c); });
      continue;
    }
    for (std::uint32_t i = node.first_point; i < node.first_point + node.points; ++i) {
      float f, s;
      field.point(tree.point(i), tree.normal(i), f, s);
      best.lower_bound = std::min(best.lower_bound, f);
      if (s < best.estimate) {
        best.estimate = s;
        best.point = i;
      }
    }
  }
  return best;
}

/// Sum of the penalty forces in the field body's frame, moment about that frame's origin.
struct ContactSum {
  Vector3d force{Vector3d::Zero()};
  Vector3d moment{Vector3d::Zero()};
  int contacts{0};
  double depth{0.0};
};

ContactSum sumContacts(const MovedTree& tree, const FieldSampler& field, const PairOptions& options,
                       PairScratch& scratch) {
  ContactSum sum;
  const auto margin = static_cast<float>(options.margin);
  const float reach = margin + field.slack();
  std::size_t top = 0;
  scratch.stack[top++] = {-std::numeric_limits<float>::infinity(), 0};
  while (top > 0) {
    const auto& node = tree.node(scratch.stack[--top].node);
    if (node.children > 0) {
      top = pushChildren(tree, node, top, reach, scratch,
                         [&](const Vector3f& c) { return field.lowerBound(c); });
      continue;
    }
    for (std::uint32_t i = node.first_point; i < node.first_point + node.points; ++i) {
      const Vector3f p = tree.point(i), n = tree.normal(i);
      float f, s;
      field.point(p, n, f, s);
      if (!(s <= margin)) continue;
      const double depth = static_cast<double>(margin) - s;
      const double weight = options.law == ForceLaw::kVolume ? static_cast<double>(tree.area(i)) : 1.0;
      const Vector3d force = (options.stiffness * weight * depth) * n.cast<double>();
      sum.force += force;
      sum.moment += p.cast<double>().cross(force);
      sum.depth = std::max(sum.depth, depth);
      ++sum.contacts;
    }
  }
  return sum;
}

}  // namespace

bool pointsFromA(const HapticStructure& a, const HapticStructure& b) {
  return a.bounding_sphere.radius <= b.bounding_sphere.radius;
}

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairScratch& scratch,
               PairResult& result) noexcept {
  // P gives the points, F the field; everything happens in F's frame.
  const bool from_a = pointsFromA(a, b);
  const HapticStructure& P = from_a ? a : b;
  const HapticStructure& F = from_a ? b : a;
  const Transform& X_WP = from_a ? X_WA : X_WB;
  const Transform& X_WF = from_a ? X_WB : X_WA;
  const Transform X_FP = X_WF.inverse() * X_WP;
  const MovedTree tree(P.tree, X_FP);
  const FieldSampler field(F);

  // The nearest shell point, then the nearest points on the exact surfaces about it.
  const Nearest nearest = findNearest(tree, field, scratch);
  const int side = nearest.lower_bound > 0.0f ? 1 : nearest.estimate < -field.slack() ? -1 : 0;
  const Vector3d start =
      X_FP * Vector3d(P.tree.x[nearest.point], P.tree.y[nearest.point], P.tree.z[nearest.point]);
  const Witness witness = refineWitness(*P.surface, *F.surface, X_FP, start, P.shell.spacing, side);
  const double certified =
      static_cast<double>(nearest.lower_bound) - kFloatRounding - P.shell.covering_radius;
  result.distance = witness.distance;
  result.bound = std::max(0.0, witness.distance - certified);
  const Vector3d on_points = X_WF * witness.on_points, on_field = X_WF * witness.on_field;
  result.witness_a = from_a ? on_points : on_field;
  result.witness_b = from_a ? on_field : on_points;

  // Penalty forces of the shell points within the margins.
  ContactSum sum;
  if (nearest.lower_bound <= static_cast<float>(options.margin))
    sum = sumContacts(tree, field, options, scratch);
  result.contacts = sum.contacts;
  result.depth = sum.depth;
  const Vector3d force_P = X_WF.linear() * sum.force;
  const Vector3d torque_P = X_WF.linear() * (sum.moment - (X_FP * P.com).cross(sum.force));
  const Vector3d torque_F = -(X_WF.linear() * (sum.moment - F.com.cross(sum.force)));
  result.force_a = from_a ? force_P : Vector3d(-force_P);
  result.torque_a = from_a ? torque_P : torque_F;
  result.torque_b = from_a ? torque_F : torque_P;
}

}  // namespace abstand
