// The search kernels; included once by each file that compiles them for an instruction set.
#include "core/kernels/field_lanes.hpp"
#include "core/kernels/search_kernels.hpp"

namespace abstand::kernels {
namespace {

constexpr float kNever = __builtin_huge_valf();
using Entry = PairScratch::Entry;
using Family = shell::PointSphereTree::Family;

inline Point8 moved(const float* m, Float8 x, Float8 y, Float8 z) {
  const auto row = [&](int r) {
    const float* a = m + 4 * r;
    return multiplyAdd(splat(a[0]), x, multiplyAdd(splat(a[1]), y, multiplyAdd(splat(a[2]), z, splat(a[3]))));
  };
  return {row(0), row(1), row(2)};
}

inline Point8 pointsAt(const TreeView& tree, std::uint32_t first) {
  return moved(tree.X_FP, load(tree.x + first), load(tree.y + first), load(tree.z + first));
}

inline Point8 centresOf(const TreeView& tree, const Family& family) {
  return moved(tree.X_FP, load(family.cx), load(family.cy), load(family.cz));
}

/// Index of the first lane that is at most `smallest`; there is one.
inline std::uint32_t laneOf(Float8 lanes, float smallest) {
  return static_cast<std::uint32_t>(
      __builtin_ctz(static_cast<unsigned>(bits(lanes <= splat(smallest)) | 0x80)));
}

inline Mask8 farther(const Point8& p, const Ball& ball, Float8 by) {
  const Float8 x = p.x - splat(ball.centre[0]), y = p.y - splat(ball.centre[1]),
               z = p.z - splat(ball.centre[2]);
  const Float8 reach = max(splat(ball.radius) - by, splat(0.0f));
  return reach * reach < multiplyAdd(x, x, multiplyAdd(y, y, z * z));
}

/// Smallest lower bound over the points outside of a ball, without the point's index.
template <class Lanes>
float searchOutside(const TreeView& tree, const FieldView& field, const Ball& ball, float best,
                    Entry* stack) {
  const Lanes lanes(field);
  const Float8 none = splat(kNever);
  std::size_t top = 0;
  stack[top++] = {-kNever, 0};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (!(entry.lower_bound < best)) continue;
    const Family& family = tree.families[entry.node];
    const Point8 centres = centresOf(tree, family);
    const Float8 radius = load(family.radius);
    const Float8 bound = select(farther(centres, ball, radius), lanes.spheres(centres, radius), none);
    float of[8];
    store(of, bound);
    for (int left = bits(bound < splat(best)); left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(static_cast<unsigned>(left));
      const std::uint32_t child = family.child[lane];
      if (!(child & shell::PointSphereTree::kLeafChild)) {
        stack[top++] = {of[lane], child};
        continue;
      }
      const std::uint32_t first =
          (child & ~shell::PointSphereTree::kLeafChild) * shell::PointSphereTree::kLane;
      const Point8 p = pointsAt(tree, first);
      const float f = smallestOf(select(farther(p, ball, splat(0.0f)), lanes.points(p, tree, first).f, none));
      best = f < best ? f : best;
    }
  }
  return best;
}

/// Among points with equal estimates (at a medial axis the field is level) the first in leaf order is taken,
/// so that the result does not depend on the order of the search.
inline void takeNearer(Float8 s, std::uint32_t first, NearestPoint& nearest) {
  const float smallest = smallestOf(s);
  if (!(smallest < nearest.estimate || (smallest == nearest.estimate && first < nearest.point))) return;
  nearest.estimate = smallest;
  nearest.point = first + laneOf(s, smallest);
}

/// Branch and bound for the smallest distance over all shell points.
template <class Lanes>
class NearestSearch {
 public:
  NearestSearch(const TreeView& tree, const FieldView& field, const NearestLimits& limits, Entry* stack)
      : tree_(tree), lanes_(field), limits_(limits), stack_(stack), best_(limits.start) {
    updateEnough();
  }

  NearestPoint run() {
    stack_[top_++] = {-kNever, 0};
    while (top_ > 0) {
      const Entry entry = stack_[--top_];
      if (entry.lower_bound < enough_)
        visit(tree_.families[entry.node]);
      else
        dropped_ = entry.lower_bound < dropped_ ? entry.lower_bound : dropped_;
    }
    nearest_.lower_bound = visited_ < dropped_ ? visited_ : dropped_;
    return nearest_;
  }

 private:
  void updateEnough() { enough_ = best_ > limits_.far_from ? best_ * (1.0f - limits_.far_part) : best_; }

  /// Visits leaves at once, nearest first; pushes inner nodes, nearest on top.
  void visit(const Family& family) {
    const Float8 bound = lanes_.spheres(centresOf(tree_, family), load(family.radius));
    const Mask8 near = bound < splat(enough_);
    const int wanted = bits(near);
    if (wanted != 0xff) {
      const float smallest = smallestOf(select(near, splat(kNever), bound));
      dropped_ = smallest < dropped_ ? smallest : dropped_;
      if (wanted == 0) return;
    }
    float of[8];
    store(of, bound);
    int order[8], n = 0;
    for (int left = wanted; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(static_cast<unsigned>(left));
      int at = n++;
      for (; at > 0 && of[order[at - 1]] > of[lane]; --at) order[at] = order[at - 1];
      order[at] = lane;
    }
    int waiting[8], m = 0;
    for (int i = 0; i < n; ++i) {
      const int lane = order[i];
      if (!(of[lane] < enough_)) {
        dropped_ = of[lane] < dropped_ ? of[lane] : dropped_;
      } else if (family.child[lane] & shell::PointSphereTree::kLeafChild) {
        visitLeaf((family.child[lane] & ~shell::PointSphereTree::kLeafChild) * shell::PointSphereTree::kLane);
      } else {
        waiting[m++] = lane;
      }
    }
    while (m > 0) {
      const int lane = waiting[--m];
      stack_[top_++] = {of[lane], family.child[lane]};
    }
  }

  void visitLeaf(std::uint32_t first) {
    const Distance8 d = lanes_.points(pointsAt(tree_, first), tree_, first);
    const float f = smallestOf(d.f);
    visited_ = f < visited_ ? f : visited_;
    if (f < best_) {
      best_ = f;
      updateEnough();
    }
    takeNearer(d.s, first, nearest_);
  }

  const TreeView& tree_;
  const Lanes lanes_;
  const NearestLimits& limits_;
  Entry* stack_;
  std::size_t top_{0};
  float best_, enough_{0.0f};
  float visited_{kNever}, dropped_{kNever};
  NearestPoint nearest_{kNever, kNever, kNoPoint};
};

/// Sums of forces and moments of the contact points for each lane, in the field body's frame.
struct WrenchLanes {
  Float8 force[3], moment[3];

  void clear() {
    for (int k = 0; k < 3; ++k) force[k] = moment[k] = splat(0.0f);
  }

  /// Adds a force of magnitude `push` along the normal of each point of the leaf. Always inlined: a call
  /// would spill the sums.
  [[gnu::always_inline]] void add(const TreeView& tree, std::uint32_t first, Float8 push) {
    const Point8 p = pointsAt(tree, first);
    const float* m = tree.X_FP;
    const Float8 a = load(tree.nx + first), b = load(tree.ny + first), c = load(tree.nz + first);
    const auto along = [&](int r) {
      return multiplyAdd(splat(m[4 * r]), a, multiplyAdd(splat(m[4 * r + 1]), b, splat(m[4 * r + 2]) * c)) *
             push;
    };
    const Float8 fx = along(0), fy = along(1), fz = along(2);
    force[0] = force[0] + fx;
    force[1] = force[1] + fy;
    force[2] = force[2] + fz;
    moment[0] = moment[0] + (p.y * fz - p.z * fy);
    moment[1] = moment[1] + (p.z * fx - p.x * fz);
    moment[2] = moment[2] + (p.x * fy - p.y * fx);
  }

  void addTo(ContactSum& sum) const {
    for (int k = 0; k < 3; ++k) {
      sum.force[k] += sumOf(force[k]);
      sum.moment[k] += sumOf(moment[k]);
    }
  }
};

/// Without kSearch, `nearest` stays empty.
template <class Lanes, bool kSearch>
ContactSearch sumContacts(const TreeView& tree, const FieldView& field, const ContactLimits& limits,
                          Entry* stack) {
  const Lanes lanes(field);
  const Float8 margin = splat(limits.margin), zero = splat(0.0f);
  ContactSum sum{};
  sum.nearest = kNoPoint;
  Float8 deepest = zero;
  WrenchLanes wrench;  // of the leaves of one family
  float reach = limits.watch;
  NearestPoint nearest{kNever, limits.watch, kNoPoint};
  Float8 visited = splat(kNever), dropped = splat(kNever);  // lower bounds of the true distances of points
  const auto leaf = [&](std::uint32_t first, Float8 s) {
    if constexpr (kSearch) takeNearer(s, first, nearest);
    const Float8 area = load(tree.area + first);
    // Padding copies in a leaf have no area.
    const Mask8 touches = (s <= margin) & (zero < area);
    const int touching = bits(touches);
    if (touching == 0) {
      if (sum.contacts > 0) return;
      const float smallest = smallestOf(s);
      if (!(smallest < reach)) return;
      reach = smallest;
      sum.nearest = first + laneOf(s, smallest);
      return;
    }
    reach = limits.margin;
    const Float8 depth = margin - s;
    wrench.add(tree, first, select(touches, limits.by_area ? depth * area : depth, zero));
    deepest = max(deepest, select(touches, depth, zero));
    sum.contacts += __builtin_popcount(static_cast<unsigned>(touching));
  };
  std::size_t top = 0;
  stack[top++] = {0.0f, 0};
  while (top > 0) {
    const Family& family = tree.families[stack[--top].node];
    const Float8 bound = lanes.contacts(centresOf(tree, family), load(family.radius), reach);
    // All loads first, then the computations that depend on them: hides memory latency.
    std::uint32_t first[8];
    Float8 estimate[8];
    int leaves = 0;
    const Mask8 near = bound <= splat(reach);
    if constexpr (kSearch) dropped = min(dropped, select(near, splat(kNever), bound));
    for (int left = bits(near); left != 0; left &= left - 1) {
      const std::uint32_t child = family.child[__builtin_ctz(static_cast<unsigned>(left))];
      if (child & shell::PointSphereTree::kLeafChild)
        first[leaves++] = (child & ~shell::PointSphereTree::kLeafChild) * shell::PointSphereTree::kLane;
      else
        stack[top++] = {0.0f, child};
    }
    for (int i = 0; i < leaves; ++i) {
      const Distance8 d = lanes.within(pointsAt(tree, first[i]), tree, first[i], reach);
      estimate[i] = d.s;
      if constexpr (kSearch) visited = min(visited, d.f);
    }
    const int before = sum.contacts;
    wrench.clear();
    for (int i = 0; i < leaves; ++i) leaf(first[i], estimate[i]);
    if (sum.contacts != before) wrench.addTo(sum);
  }
  sum.depth = -smallestOf(zero - deepest);
  if (sum.contacts > 0) sum.nearest = kNoPoint;
  nearest.lower_bound = smallestOf(min(visited, dropped - splat(lanes.error())));
  return {sum, nearest};
}

NearestPoint nearest(const TreeView& tree, const FieldView& field, const NearestLimits& limits,
                     PairScratch& scratch) {
  return field.kind == FieldView::Kind::kNear
             ? NearestSearch<NearLanes>(tree, field, limits, scratch.stack).run()
             : NearestSearch<LayeredLanes>(tree, field, limits, scratch.stack).run();
}

float nearestOutside(const TreeView& tree, const FieldView& field, const Ball& ball, float start,
                     PairScratch& scratch) {
  return field.kind == FieldView::Kind::kNear
             ? searchOutside<NearLanes>(tree, field, ball, start, scratch.stack)
             : searchOutside<LayeredLanes>(tree, field, ball, start, scratch.stack);
}

ContactSum contacts(const TreeView& tree, const FieldView& field, const ContactLimits& limits,
                    PairScratch& scratch) {
  return field.kind == FieldView::Kind::kNear
             ? sumContacts<NearLanes, false>(tree, field, limits, scratch.stack).sum
             : sumContacts<LayeredLanes, false>(tree, field, limits, scratch.stack).sum;
}

ContactSearch contactSearch(const TreeView& tree, const FieldView& field, const ContactLimits& limits,
                            PairScratch& scratch) {
  return field.kind == FieldView::Kind::kNear
             ? sumContacts<NearLanes, true>(tree, field, limits, scratch.stack)
             : sumContacts<LayeredLanes, true>(tree, field, limits, scratch.stack);
}

float support(const PointArrays& points, float gx, float gy, float gz) {
  const auto& [x, y, z, count] = points;
  const Float8 a = splat(gx), b = splat(gy), c = splat(gz);
  Float8 largest = splat(-kNever);
  for (std::size_t i = 0; i < count; i += 8)
    largest = max(largest, multiplyAdd(a, load(x + i), multiplyAdd(b, load(y + i), c * load(z + i))));
  return -smallestOf(splat(0.0f) - largest);
}

std::size_t extreme(const PointArrays& points, float gx, float gy, float gz) {
  const auto& [x, y, z, count] = points;
  const Float8 a = splat(gx), b = splat(gy), c = splat(gz);
  // Integers below 2^24 are exact in float.
  Float8 largest = splat(-kNever), where = splat(0.0f);
  for (std::size_t i = 0; i < count; i += 8) {
    const Float8 h = multiplyAdd(a, load(x + i), multiplyAdd(b, load(y + i), c * load(z + i)));
    const Mask8 more = largest < h;
    largest = select(more, h, largest);
    where = select(more, splat(static_cast<float>(i)), where);
  }
  const Float8 farthest = splat(-smallestOf(splat(0.0f) - largest));
  const auto lane =
      static_cast<std::size_t>(__builtin_ctz(static_cast<unsigned>(bits(farthest <= largest) | 0x80)));
  float first[8];
  store(first, where);
  return static_cast<std::size_t>(first[lane]) + lane;
}

std::uint64_t meeting(const float* X_FP, const SphereGroup& P, const SphereGroup& F, std::size_t count,
                      float by) {
  const Point8 centres = moved(X_FP, load(P.x), load(P.y), load(P.z));
  const Float8 radius = load(P.radius) + splat(by), zero = splat(0.0f);
  std::uint64_t pairs = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const Float8 x = centres.x - splat(F.x[j]), y = centres.y - splat(F.y[j]), z = centres.z - splat(F.z[j]);
    const Float8 reach = max(radius + splat(F.radius[j]), zero);
    const Mask8 near = multiplyAdd(x, x, multiplyAdd(y, y, z * z)) < reach * reach;
    pairs |= static_cast<std::uint64_t>(bits(near)) << (8 * j);
  }
  return pairs;
}

}  // namespace
}  // namespace abstand::kernels
