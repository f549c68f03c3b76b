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

// Beyond this distance the search may end within this part of the smallest distance; the bound says so.
constexpr float kFarFrom = 0.1f;  // m
constexpr float kFarPart = 0.01f;

/// Branch and bound for the smallest distance over all shell points.
class NearestSearch {
 public:
  NearestSearch(const MovedTree& tree, const FieldSampler& field, PairScratch& scratch)
      : tree_(tree), field_(field), stack_(scratch.stack) {}

  void run() {
    stack_[top_++] = {-std::numeric_limits<float>::infinity(), 0};
    while (top_ > 0) {
      const auto entry = stack_[--top_];
      if (pruned(entry.lower_bound)) continue;
      const auto& node = tree_.node(entry.node);
      if (node.children > 0)
        pushChildren(node);
      else
        visitLeaf(node);
    }
  }

  std::uint32_t point() const {
    return point_;
  }  ///< leaf-ordered index of the point with the smallest estimate
  float estimate() const { return estimate_; }
  /// No shell point's true distance is below it.
  float lowerBound() const { return std::min(best_, lowest_pruned_); }

 private:
  bool pruned(float lower_bound) {
    const float enough = best_ > kFarFrom ? best_ * (1.0f - kFarPart) : best_;
    if (lower_bound < enough) return false;
    lowest_pruned_ = std::min(lowest_pruned_, lower_bound);
    return true;
  }

  /// The nearest child last, so that it is taken first.
  void pushChildren(const PointSphereTree::Node& node) {
    const std::size_t first = top_;
    for (std::uint32_t c = node.first_child; c < node.first_child + node.children; ++c) {
      const auto& child = tree_.node(c);
      const float f = field_.lowerBound(tree_.centre(child)) - child.radius;
      if (pruned(f)) continue;
      std::size_t at = top_++;
      for (; at > first && stack_[at - 1].lower_bound < f; --at) stack_[at] = stack_[at - 1];
      stack_[at] = {f, c};
    }
  }

  void visitLeaf(const PointSphereTree::Node& node) {
    for (std::uint32_t i = node.first_point; i < node.first_point + node.points; ++i) {
      float f, s;
      field_.point(tree_.point(i), field_.layered() ? tree_.normal(i) : Vector3f(Vector3f::Zero()), f, s);
      best_ = std::min(best_, f);
      if (s < estimate_) {
        estimate_ = s;
        point_ = i;
      }
    }
  }

  const MovedTree& tree_;
  const FieldSampler& field_;
  decltype(PairScratch::stack)& stack_;
  std::size_t top_{0};
  std::uint32_t point_{0};
  float estimate_{std::numeric_limits<float>::infinity()};
  float best_{std::numeric_limits<float>::infinity()};
  float lowest_pruned_{std::numeric_limits<float>::infinity()};
};

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
      for (std::uint32_t c = node.first_child; c < node.first_child + node.children; ++c)
        if (field.lowerBound(tree.centre(tree.node(c))) - tree.node(c).radius < reach)
          scratch.stack[top++] = {0.0f, c};
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
  NearestSearch nearest(tree, field, scratch);
  nearest.run();
  const int side = nearest.lowerBound() > 0.0f ? 1 : nearest.estimate() < -field.slack() ? -1 : 0;
  const Vector3d start =
      X_FP * Vector3d(P.tree.x[nearest.point()], P.tree.y[nearest.point()], P.tree.z[nearest.point()]);
  const Witness witness = refineWitness(*P.surface, *F.surface, X_FP, start, P.shell.spacing, side);
  const double certified =
      static_cast<double>(nearest.lowerBound()) - kFloatRounding - P.shell.covering_radius;
  result.distance = witness.distance;
  result.bound = std::max(0.0, witness.distance - certified);
  const Vector3d on_points = X_WF * witness.on_points, on_field = X_WF * witness.on_field;
  result.witness_a = from_a ? on_points : on_field;
  result.witness_b = from_a ? on_field : on_points;

  // Penalty forces of the shell points within the margins.
  ContactSum sum;
  if (nearest.lowerBound() <= static_cast<float>(options.margin))
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
