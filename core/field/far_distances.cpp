// Distances from the vertices of a grid to a mesh: nearest sites, block by block.
#include "core/field/far_distances.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/math/four.hpp"

namespace abstand::field {
namespace {

constexpr int kLanes = 4;
constexpr float kFar = std::numeric_limits<float>::max();
/// Relative, for what rounding in float does to a squared distance: some ten operations, and a reserve.
constexpr double kRounding = 16.0 * 0x1p-23;
/// A block with so few sites left is not parted any more.
constexpr std::size_t kFewSites = 32;
/// The smallest block, and the largest that is not parted.
const Vector3i kSmallest{4, 2, 2}, kLargest{4, 4, 4};

/// The largest squared distance of a point of the triangle to its nearest corner: that of the centre of its
/// circle, or half of the longest side where that lies outside.
double reach2(const std::array<Vector3d, 3>& t) {
  const double a2 = (t[1] - t[0]).squaredNorm(), b2 = (t[2] - t[1]).squaredNorm(),
               c2 = (t[0] - t[2]).squaredNorm();
  const double longest2 = std::max({a2, b2, c2});
  if (a2 + b2 + c2 <= 2.0 * longest2) return 0.25 * longest2;
  return 0.25 * a2 * b2 * c2 / (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm();
}

}  // namespace

/// Some of the sites, padded to whole lanes with ones that are far away. The arrays may be longer.
struct FarSites::List {
  std::vector<float> x, y, z, power;  ///< power: |v|^2
  std::size_t size{0};
  void makeRoom(std::size_t most) {
    for (auto* v : {&x, &y, &z, &power})
      if (v->size() < most + kLanes) v->resize(most + kLanes);
  }
  /// Stays only where `keep` is set: a choice without a branch.
  void add(float px, float py, float pz, float w, bool keep) {
    x[size] = px, y[size] = py, z[size] = pz, power[size] = w;
    size += keep;
  }
  void pad() {
    while (size % kLanes != 0) add(0.0f, 0.0f, 0.0f, kFar, true);
  }
};

/// Exact copies of a point are taken once.
class Distinct {
 public:
  explicit Distinct(std::vector<Vector3d>& points) : points_(points) {}
  void add(const Vector3d& p) {
    if (2 * (points_.size() + 1) > table_.size()) {
      table_.assign(std::bit_ceil(4 * (points_.size() + 1)), 0);
      for (std::size_t i = 0; i < points_.size(); ++i) place(points_[i]) = static_cast<std::uint32_t>(i) + 1;
    }
    std::uint32_t& at = place(p);
    if (at != 0) return;
    points_.push_back(p);
    at = static_cast<std::uint32_t>(points_.size());
  }

 private:
  /// That of p, or where it belongs; 0: none yet.
  std::uint32_t& place(const Vector3d& p) {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      // + 0.0 turns -0.0 into 0.0, which is equal.
      h = (h ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    std::size_t i = static_cast<std::size_t>(h);
    for (;; ++i) {
      std::uint32_t& at = table_[i & (table_.size() - 1)];
      if (at == 0 || points_[at - 1] == p) return at;
    }
  }
  std::vector<Vector3d>& points_;
  std::vector<std::uint32_t> table_;  ///< open addressing, a power of two; index + 1
};

/// What one thread needs.
struct FarSites::Search {
  double spacing;
  std::size_t row, slice;
  std::vector<float> at_middle;
  std::array<List, 40> lists;  ///< one a depth
  std::size_t depth{0};
};

FarSites::FarSites(const geometry::TriangleMesh& mesh, const Vector3d& origin, double most,
                   std::size_t most_sites) {
  std::vector<Vector3d> sites;
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      if (!used[v]) sites.push_back(mesh.vertices[v] - origin);
      used[v] = true;
    }
  }
  if (sites.size() > most_sites) return;
  Distinct distinct(sites);
  // Halved at the longest side, so that both triangles at a side halve it at the same point.
  std::vector<std::array<Vector3d, 3>> stack;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    stack.push_back({mesh.corner(t, 0) - origin, mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin});
    while (!stack.empty()) {
      const std::array<Vector3d, 3> part = stack.back();
      stack.pop_back();
      const double r2 = reach2(part);
      if (r2 <= most * most) {
        reach2_ = std::max(reach2_, r2);
        continue;
      }
      int e = 0;
      double longest2 = -1.0;
      for (int i = 0; i < 3; ++i) {
        const double length2 = (part[(i + 1) % 3] - part[i]).squaredNorm();
        if (length2 > longest2) longest2 = length2, e = i;
      }
      const Vector3d &a = part[e], &b = part[(e + 1) % 3], &c = part[(e + 2) % 3], middle = 0.5 * (a + b);
      distinct.add(middle);
      if (sites.size() > most_sites) return;
      const std::array<Vector3d, 3> first{a, middle, c}, second{middle, b, c};
      stack.push_back(first);
      stack.push_back(second);
    }
  }
  for (const Vector3d& v : sites) {
    x_.push_back(static_cast<float>(v.x()));
    y_.push_back(static_cast<float>(v.y()));
    z_.push_back(static_cast<float>(v.z()));
    radius2_ = std::max(radius2_, v.squaredNorm());
  }
}

void FarSites::distances(const Block& block, double spacing, std::size_t row, std::size_t slice,
                         float* values) const {
  Search search{spacing, row, slice, {}, {}, 0};
  List all;
  all.makeRoom(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i)
    all.add(x_[i], y_[i], z_[i], x_[i] * x_[i] + y_[i] * y_[i] + z_[i] * z_[i], true);
  all.pad();
  find(search, block, all, values);
}

void FarSites::find(Search& search, const Block& block, const List& list, float* values) const {
  const double h = search.spacing;
  const Vector3d half = 0.5 * h * (block.size - Vector3i::Ones()).cast<double>();
  const Vector3d middle = h * block.first.cast<double>() + half;
  const double middle2 = middle.squaredNorm();
  const double slack = kRounding * (radius2_ + 2.0 * std::sqrt(radius2_ * (middle2 + half.squaredNorm())));

  // |p - v|^2 - |p|^2 at the middle, and the nearest site there.
  const Vector3f c = -2.0f * middle.cast<float>(), r = half.cast<float>();
  const std::size_t n = list.size;
  search.at_middle.resize(n);
  const auto at = [](const std::vector<float>& v, std::size_t i) { return load(&v[i]); };
  Four least = splat(kFar);
  for (std::size_t i = 0; i < n; i += kLanes) {
    const Four g = at(list.power, i) + c.x() * at(list.x, i) + c.y() * at(list.y, i) + c.z() * at(list.z, i);
    storeFour(g, &search.at_middle[i]);
    least = min(least, g);
  }
  const float nearest = leastOf(least);
  const std::size_t w = static_cast<std::size_t>(
      std::find(search.at_middle.begin(), search.at_middle.end(), nearest) - search.at_middle.begin());

  // Those that may be nearest somewhere in the block.
  List& kept = search.lists[search.depth];
  kept.size = 0;
  kept.makeRoom(n);
  const float wx = list.x[w], wy = list.y[w], wz = list.z[w],
              limit = nearest + 2.0f * static_cast<float>(slack);
  for (std::size_t i = 0; i < n; i += kLanes) {
    const Four gain = 2.0f * (r.x() * abs(at(list.x, i) - wx) + r.y() * abs(at(list.y, i) - wy) +
                              r.z() * abs(at(list.z, i) - wz));
    const int near = bits(at(search.at_middle, i) - gain <= limit);
    if (near == 0) continue;
    for (std::size_t k = 0; k < kLanes; ++k)
      kept.add(list.x[i + k], list.y[i + k], list.z[i + k], list.power[i + k], (near >> k & 1) != 0);
  }
  kept.pad();

  const bool small = (block.size.array() <= (kept.size <= kFewSites ? kLargest : kSmallest).array()).all();
  if (!small && search.depth + 1 < search.lists.size()) {
    int axis = 0;
    (block.size.cast<double>().array() / kSmallest.cast<double>().array()).maxCoeff(&axis);
    const int unit = kSmallest[axis];
    Block first = block, second = block;
    first.size[axis] = (block.size[axis] / unit + 1) / 2 * unit;
    second.first[axis] += first.size[axis];
    second.size[axis] -= first.size[axis];
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? search.row : search.slice;
    ++search.depth;
    find(search, first, kept, values);
    find(search, second, kept, values + step * static_cast<std::size_t>(first.size[axis]));
    --search.depth;
    return;
  }

  // Four vertices of a row at once; from one to the next row the same is added.
  const Vector3f first = -2.0f * (h * block.first.cast<double>()).cast<float>();
  const float step = -2.0f * static_cast<float>(h);
  const Four along{0.0f, step, 2.0f * step, 3.0f * step};
  for (int i = 0; i < block.size.x(); i += kLanes) {
    const float x0 = first.x() + static_cast<float>(i) * step;
    for (int k0 = 0; k0 < block.size.z(); k0 += kLanes) {
      for (int j0 = 0; j0 < block.size.y(); j0 += kLanes) {
        const int nj = std::min(kLanes, block.size.y() - j0), nk = std::min(kLanes, block.size.z() - k0);
        const float y0 = first.y() + static_cast<float>(j0) * step,
                    z0 = first.z() + static_cast<float>(k0) * step;
        std::array<Four, kLanes * kLanes> nearest_of;
        nearest_of.fill(splat(kFar));
        for (std::size_t s = 0; s < kept.size; ++s) {
          const float x = kept.x[s], y = kept.y[s], z = kept.z[s];
          Four slice = kept.power[s] + (x0 * x + y0 * y + z0 * z) + x * along;
          for (int k = 0; k < nk; ++k, slice += step * z) {
            Four row = slice;
            for (int j = 0; j < nj; ++j, row += step * y) {
              Four& best = nearest_of[static_cast<std::size_t>(k * kLanes + j)];
              best = min(best, row);
            }
          }
        }
        for (int k = 0; k < nk; ++k) {
          for (int j = 0; j < nj; ++j) {
            const Four& best = nearest_of[static_cast<std::size_t>(k * kLanes + j)];
            float* out = values + static_cast<std::size_t>(i) +
                         search.row * static_cast<std::size_t>(j0 + j) +
                         search.slice * static_cast<std::size_t>(k0 + k);
            for (int l = 0; l < std::min(kLanes, block.size.x() - i); ++l) {
              const Vector3d p = h * (block.first + Vector3i(i + l, j0 + j, k0 + k)).cast<double>();
              const double d2 = p.squaredNorm() + double(best[l]) - reach2_ - slack;
              out[l] = d2 > 0.0 ? std::nextafter(static_cast<float>(std::sqrt(d2)), 0.0f) : 0.0f;
            }
          }
        }
      }
    }
  }
}

}  // namespace abstand::field
