// Exact distances from grid vertices to a mesh: candidate features, four vertices at once.
#include "core/field/near_distances.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace abstand::field {
namespace {

/// Largest error of half-space planes in float, relative to the spacing and to the body.
constexpr double kPlane = 1e-4, kPlaneOfBody = 1e-6;
/// Relative rounding error of squared distances in comparisons.
constexpr float kCompared = 1e-5f;
/// Limit of half-spaces of an edge or a vertex; more would hardly reduce the candidates.
constexpr std::size_t kMaxHalfSpaces = 8;
constexpr float kNoDistance = std::numeric_limits<float>::max();

/// Side of a triangle, from corner `side` to the next.
struct Side {
  std::uint32_t high, slot, side;
};

/// For each vertex the sides whose lower vertex it is, in the order of the slots.
struct Sides {
  Sides(const geometry::TriangleMesh& mesh, const geometry::TriangleTree& tree)
      : first(mesh.vertices.size() + 1, 0) {
    const auto each = [&](auto&& fn) {
      for (std::uint32_t s = 0; s < tree.size(); ++s) {
        const auto& t = mesh.triangles[tree.triangle(s)];
        for (std::uint32_t i = 0; i < 3; ++i) {
          const std::uint32_t a = t[i], b = t[(i + 1) % 3];
          fn(std::min(a, b), Side{std::max(a, b), s, i});
        }
      }
    };
    each([&](std::uint32_t low, const Side&) { ++first[low + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    list.resize(first.back());
    std::vector<std::uint32_t> next = first;
    each([&](std::uint32_t low, const Side& side) { list[next[low]++] = side; });
    // Groups the sides of one edge.
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
      std::sort(list.begin() + first[v], list.begin() + first[v + 1], [](const Side& l, const Side& r) {
        return l.high != r.high ? l.high < r.high : l.slot < r.slot;
      });
    }
  }
  std::vector<std::uint32_t> first;
  std::vector<Side> list;
};

}  // namespace

NearDistances::NearDistances(const geometry::MeshSurface& surface, const Vector3d& origin, double spacing)
    : surface_(surface), origin_(origin), middle_(surface.bounds().centre()), spacing_(spacing) {
  const geometry::TriangleMesh mesh = surface.mesh(0.0);
  const geometry::TriangleTree& tree = surface.tree();
  const double size = surface.bounds().extent().norm();
  tolerance_ = static_cast<float>(kPlane * spacing + kPlaneOfBody * size);
  features_.reserve(3 * tree.size());
  balls_.reserve(3 * tree.size());
  half_spaces_.reserve(4 * tree.size());

  for (std::uint32_t s = 0; s < tree.size(); ++s) {
    const std::uint32_t t = tree.triangle(s);
    addFace(s, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  }
  // Edges, and their directions at the vertices.
  struct Leaving {
    std::uint32_t vertex, slot;
    Vector3d direction;
  };
  std::vector<Leaving> leaving;
  const Sides sides(mesh, tree);
  for (std::uint32_t v = 0; v + 1 < sides.first.size(); ++v) {
    for (std::uint32_t i = sides.first[v], end = i; i < sides.first[v + 1]; i = end) {
      while (end < sides.first[v + 1] && sides.list[end].high == sides.list[i].high) ++end;
      const Vector3d &a = mesh.vertices[v], &b = mesh.vertices[sides.list[i].high];
      const Vector3d along = (b - a).normalized();
      // Edges between coplanar faces are skipped: the faces are equally near.
      const Vector3d& normal = tree.normal(sides.list[i].slot);
      const double turn = normal.cross(tree.normal(sides.list[end - 1].slot)).norm();
      const bool plane = end == i + 2 && normal.dot(tree.normal(sides.list[i + 1].slot)) > 0.0 &&
                         turn * size < 0.1 * double(tolerance_);
      if (plane) continue;
      leaving.push_back({v, sides.list[i].slot, along});
      leaving.push_back({sides.list[i].high, sides.list[i].slot, -along});
      const auto first = static_cast<std::uint32_t>(half_spaces_.size());
      addHalfSpace(0, along, a);
      addHalfSpace(1, -along, b);
      for (std::uint32_t k = i; k < end && k - i < kMaxHalfSpaces; ++k) {
        const Side& side = sides.list[k];
        const auto& t = mesh.triangles[tree.triangle(side.slot)];
        // In the face, perpendicular to the edge.
        const bool rising = t[side.side] == v;
        const Vector3d into = tree.normal(side.slot).cross(rising ? along : Vector3d(-along));
        addHalfSpace(2 + k - i, -into, a);
      }
      addFeature(Kind::kEdge, sides.list[i].slot, 0.5 * (a + b), 0.5 * (b - a).norm(), first);
    }
  }
  std::stable_sort(leaving.begin(), leaving.end(),
                   [](const Leaving& l, const Leaving& r) { return l.vertex < r.vertex; });
  for (std::size_t i = 0, end = 0; i < leaving.size(); i = end) {
    while (end < leaving.size() && leaving[end].vertex == leaving[i].vertex) ++end;
    const Vector3d& v = mesh.vertices[leaving[i].vertex];
    const auto first = static_cast<std::uint32_t>(half_spaces_.size());
    for (std::size_t k = i; k < std::min(end, i + kMaxHalfSpaces); ++k)
      addHalfSpace(k - i, -leaving[k].direction, v);
    addFeature(Kind::kVertex, leaving[i].slot, v, 0.0, first);
  }
}

void NearDistances::addHalfSpace(std::size_t n, const Vector3d& normal, const Vector3d& through) {
  const auto lane = static_cast<Eigen::Index>(n % 4);
  if (lane == 0) half_spaces_.push_back(HalfSpaces{});
  HalfSpaces& four = half_spaces_.back();
  four.x[lane] = static_cast<float>(normal.x());
  four.y[lane] = static_cast<float>(normal.y());
  four.z[lane] = static_cast<float>(normal.z());
  four.offset[lane] = static_cast<float>(-normal.dot(through - middle_));
}

void NearDistances::addFeature(Kind kind, std::uint32_t slot, const Vector3d& centre, double radius,
                               std::uint32_t first) {
  const Vector3f at = (centre - middle_).cast<float>();
  balls_.push_back({{at.x(), at.y(), at.z(), static_cast<float>(radius)}});
  features_.push_back({first, static_cast<std::uint32_t>(half_spaces_.size()) - first, slot, kind});
}

void NearDistances::addFace(std::uint32_t slot, const Vector3d (&corner)[3]) {
  const Vector3d& normal = surface_.tree().normal(slot);
  const auto first = static_cast<std::uint32_t>(half_spaces_.size());
  Vector3d centre = (corner[0] + corner[1] + corner[2]) / 3.0;
  for (std::size_t i = 0; i < 3; ++i)
    addHalfSpace(i, normal.cross(corner[(i + 1) % 3] - corner[i]).normalized(), corner[i]);
  addHalfSpace(3, normal, corner[0]);
  // For an obtuse triangle the middle of the opposite side is nearer to all corners.
  for (int i = 0; i < 3; ++i) {
    const Vector3d p = corner[(i + 1) % 3] - corner[i], q = corner[(i + 2) % 3] - corner[i];
    if (p.dot(q) < 0.0) centre = 0.5 * (corner[(i + 1) % 3] + corner[(i + 2) % 3]);
  }
  double radius = 0.0;
  for (const Vector3d& c : corner) radius = std::max(radius, (c - centre).norm());
  addFeature(Kind::kFace, slot, centre, radius, first);
}

NearDistances::List NearDistances::all() const {
  List list(features_.size());
  std::iota(list.begin(), list.end(), 0u);
  return list;
}

void NearDistances::near(const Block& block, const List& list, std::uint32_t& hint, List& kept) const {
  const Vector3d half = 0.5 * (block.size - Vector3i::Ones()).cast<double>();
  const Vector3d at = place(block.first.cast<double>() + half);
  const geometry::SurfacePoint nearest = surface_.closest(at, hint);
  hint = nearest.hint;
  const Vector3f c = (at - middle_).cast<float>(), r = (spacing_ * half).cast<float>(),
                 w = (nearest.point - middle_).cast<float>();
  const float reach = r.norm(), distance = static_cast<float>(nearest.distance);
  const float limit = distance * distance * (1.0f + kCompared);
  const float plane_limit = (distance + reach) * (1.0f + kCompared) + tolerance_;
  const Four lowest_face{-tolerance_, -tolerance_, -tolerance_, -plane_limit}, lowest = splat(-tolerance_);

  // Four at once: rejects features whose balls are too far.
  constexpr std::size_t kFour = 4;
  const std::size_t n = list.size();
  kept.resize(n);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; i += kFour) {
    const auto ball = [&](std::size_t k) { return load(balls_[list[std::min(i + k, n - 1)]].v); };
    Four x = ball(0), y = ball(1), z = ball(2), radius = ball(3);
    transpose(x, y, z, radius);
    const auto square = [](Four v) { return v * v; };
    const Four distance2 = square(x - c.x()) + square(y - c.y()) + square(z - c.z());
    const Four apart = max(sqrt(distance2) * (1.0f - kCompared) - (radius + tolerance_), Four{});
    const Four gain = 2.0f * (r.x() * abs(x - w.x()) + r.y() * abs(y - w.y()) + r.z() * abs(z - w.z()) +
                              reach * (radius + tolerance_));
    const int beyond = bits(square(apart) * (1.0f - kCompared) - (limit + gain * (1.0f + kCompared)) > 0.0f);
    if (beyond == 15) continue;
    for (std::size_t k = 0; k < std::min(kFour, n - i); ++k) {
      if ((beyond >> k & 1) != 0) continue;
      const Feature& f = features_[list[i + k]];
      // Largest value of n . p over the block's corners.
      bool misses = false;
      const bool face = f.kind == Kind::kFace;
      for (std::uint32_t s = f.first; s < f.first + f.fours && !misses; ++s) {
        const HalfSpaces& m = half_spaces_[s];
        const Four at_middle = m.x * c.x() + m.y * c.y() + m.z * c.z() + m.offset;
        const Four width = abs(m.x) * r.x() + abs(m.y) * r.y() + abs(m.z) * r.z();
        misses = bits(at_middle + width - (face ? lowest_face : lowest) < 0.0f) != 0 ||
                 (face && at_middle[3] - width[3] > plane_limit);
      }
      kept[count] = list[i + k];
      count += !misses;
    }
  }
  kept.resize(count);
}

/// Nearest features so far of a block's vertices, four vertices of a row at once.
class NearDistances::Candidates {
 public:
  /// `first`: first vertex relative to middle_; `h`: spacing of the vertices.
  Candidates(const Vector3i& size, const Vector3f& first, float h, float tolerance)
      : nx_((size.x() + 3) / 4),
        ny_(size.y()),
        nz_(size.z()),
        first_(first),
        h_(h),
        tolerance_(tolerance),
        steps_{0.0f, h, 2.0f * h, 3.0f * h} {
    for (int k = 0; k < nz_; ++k) {
      for (int j = 0; j < ny_; ++j) {
        for (int i = 0; i < nx_; ++i) best_[k][j][i] = {splat(kNoDistance), Four{}};
      }
    }
  }

  /// In the prism of a face the distance is that to its plane.
  void addFace(const HalfSpaces& m, Four slot) {
    const Four far = splat(kNoDistance);
    const Four first = m.x * first_.x() + m.y * first_.y() + m.z * first_.z() + m.offset;
    const auto start = [&](int n, int i) -> Four {
      return (first[n] + 4.0f * h_ * static_cast<float>(i) * m.x[n]) + m.x[n] * steps_;
    };
    const Four along_y = h_ * m.y, along_z = h_ * m.z;
    for (int i = 0; i < nx_; ++i) {
      Four e0 = start(0, i), e1 = start(1, i), e2 = start(2, i), s = start(3, i);
      for (int k = 0; k < nz_; ++k) {
        Four r0 = e0, r1 = e1, r2 = e2, rs = s;
        for (int j = 0; j < ny_; ++j) {
          const Four over = min(min(r0, r1), r2);
          offer(best_[k][j][i], over >= -tolerance_ ? square(rs) : far, slot);
          r0 += along_y[0], r1 += along_y[1], r2 += along_y[2], rs += along_y[3];
        }
        e0 += along_z[0], e1 += along_z[1], e2 += along_z[2], s += along_z[3];
      }
    }
  }

  /// Distance to an edge (along its first half-space normal) or to a vertex (the ball's centre).
  void addBall(const Ball& ball, const HalfSpaces& m, bool edge, Four slot) {
    const Vector3f from = first_ - Vector3f::Map(ball.v);
    const float along[3] = {m.x[0], m.y[0], m.z[0]}, half = ball.v[3];
    for (int i = 0; i < nx_; ++i) {
      const Four x = from.x() + 4.0f * h_ * static_cast<float>(i) + steps_;
      for (int k = 0; k < nz_; ++k) {
        const float z = from.z() + h_ * static_cast<float>(k);
        for (int j = 0; j < ny_; ++j) {
          const float y = from.y() + h_ * static_cast<float>(j);
          if (edge) {
            const Four u = min(max(x * along[0] + (y * along[1] + z * along[2]), splat(-half)), splat(half));
            offer(best_[k][j][i],
                  square(x - u * along[0]) + square(y - u * along[1]) + square(z - u * along[2]), slot);
          } else {
            offer(best_[k][j][i], square(x) + (y * y + z * z), slot);
          }
        }
      }
    }
  }

  /// m^2; kNoDistance where no feature was offered.
  float distance2(int i, int j, int k) const { return best_[k][j][i / 4].distance2[i % 4]; }
  std::uint32_t slot(int i, int j, int k) const {
    return std::bit_cast<std::uint32_t>(best_[k][j][i / 4].slot[i % 4]);
  }

 private:
  struct Best {
    Four distance2, slot;
  };
  static Four square(Four v) { return v * v; }
  static void offer(Best& b, Four distance2, Four slot) {
    b.slot = distance2 < b.distance2 ? slot : b.slot;
    b.distance2 = min(distance2, b.distance2);
  }

  static constexpr int kGroups = (kMaxSize + 3) / 4;
  const int nx_, ny_, nz_;
  const Vector3f first_;
  const float h_, tolerance_;
  const Four steps_;
  Best best_[kMaxSize][kMaxSize][kGroups];
};

void NearDistances::distances(const Block& block, const List& list, Nearest& nearest) const {
  const Vector3f first = (place(block.first.cast<double>()) - middle_).cast<float>();
  Candidates candidates(block.size, first, static_cast<float>(spacing_), tolerance_);
  for (const std::uint32_t id : list) {
    const Feature& f = features_[id];
    const Four slot = splat(std::bit_cast<float>(f.slot));
    const HalfSpaces& m = half_spaces_[f.first];
    if (f.kind == Kind::kFace)
      candidates.addFace(m, slot);
    else
      candidates.addBall(balls_[id], m, f.kind == Kind::kEdge, slot);
  }
  for (int k = 0; k < block.size.z(); ++k) {
    for (int j = 0; j < block.size.y(); ++j) {
      for (int i = 0; i < block.size.x(); ++i) {
        if (const float distance2 = candidates.distance2(i, j, k); distance2 < kNoDistance) {
          nearest.distance[k][j][i] = std::sqrt(distance2);
          nearest.slot[k][j][i] = candidates.slot(i, j, k);
        } else {
          const geometry::SurfacePoint found =
              surface_.closest(place((block.first + Vector3i(i, j, k)).cast<double>()));
          nearest.distance[k][j][i] = static_cast<float>(found.distance);
          nearest.slot[k][j][i] = found.hint;
        }
      }
    }
  }
}

}  // namespace abstand::field
