// Lower bounds of the distances from grid vertices to a mesh: nearest sites, block by block.
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
/// Relative rounding error of a squared distance in float: about ten operations and a reserve.
constexpr double kRounding = 16.0 * 0x1p-23;
/// A block with this few remaining sites is not subdivided further.
constexpr std::size_t kFewSites = 32;
/// The smallest block, and the largest that is not subdivided.
const Vector3i kSmallest{4, 2, 2}, kLargest{4, 4, 4};

/// Largest squared distance of a point of the triangle to its nearest corner: the squared circumradius, or
/// that of half the longest side if the circumcentre lies outside.
double reach2(const std::array<Vector3d, 3>& t) {
  const double a2 = (t[1] - t[0]).squaredNorm(), b2 = (t[2] - t[1]).squaredNorm(),
               c2 = (t[0] - t[2]).squaredNorm();
  const double longest2 = std::max({a2, b2, c2});
  if (a2 + b2 + c2 <= 2.0 * longest2) return 0.25 * longest2;
  return 0.25 * a2 * b2 * c2 / (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm();
}

Four lanesAt(const std::vector<float>& v, std::size_t i) { return load(&v[i]); }

}  // namespace

/// A subset of the sites, padded to whole lanes with far points. The arrays may be longer.
struct FarSites::List {
  std::vector<float> x, y, z, power;  ///< power: |v|^2
  std::size_t size{0};
  void reserve(std::size_t count) {
    for (auto* v : {&x, &y, &z, &power})
      if (v->size() < count + kLanes) v->resize(count + kLanes);
  }
  /// Appends the site, but advances only if `keep` is set: branchless selection.
  void add(float px, float py, float pz, float w, bool keep) {
    x[size] = px, y[size] = py, z[size] = pz, power[size] = w;
    size += keep;
  }
  void pad() {
    while (size % kLanes != 0) add(0.0f, 0.0f, 0.0f, kFar, true);
  }
};

/// Hash set of points; exact duplicates are dropped.
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
  /// Table entry of p, or the free one for it; 0: empty.
  std::uint32_t& place(const Vector3d& p) {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      // + 0.0 maps -0.0 to 0.0.
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

/// Work space of one thread.
struct FarSites::Search {
  double spacing;
  std::size_t row, slice;
  double reach2;
  std::vector<float> at_middle;
  std::array<List, 40> lists;  ///< one for each level of the subdivision
  std::size_t depth{0};

  /// A block, and the rounding error (m^2) of squared distances in it.
  struct Box {
    const Block& block;
    Vector3d middle, half;
    double slack;
  };
  /// Up to kLanes vertices along each axis: position of the first in the block, number of rows and slices.
  struct Tile {
    const Block& block;
    Vector3i at;
    int rows, slices;
  };
  using TileValues = std::array<Four, static_cast<std::size_t>(kLanes* kLanes)>;

  /// The nearest site of a list, by |p - v|^2 - |p|^2 at the middle p of a box.
  struct NearestSite {
    std::size_t index;
    float value;
  };
  NearestSite nearestAtMiddle(const Box& box, const List& list);
  void selectNear(const Box& box, const List& list, const NearestSite& nearest, List& kept) const;
  TileValues nearestOf(const Tile& tile, const List& kept) const;
  void write(const Tile& tile, const TileValues& nearest_of, double slack, float* values) const;
  void measure(const Box& box, const List& kept, float* values) const;
};

/// Also sets at_middle to the values of all sites of the list.
FarSites::Search::NearestSite FarSites::Search::nearestAtMiddle(const Box& box, const List& list) {
  const Vector3f c = -2.0f * box.middle.cast<float>();
  at_middle.resize(list.size);
  Four smallest = splat(kFar);
  for (std::size_t i = 0; i < list.size; i += kLanes) {
    const Four g = lanesAt(list.power, i) + c.x() * lanesAt(list.x, i) + c.y() * lanesAt(list.y, i) +
                   c.z() * lanesAt(list.z, i);
    storeFour(g, &at_middle[i]);
    smallest = min(smallest, g);
  }
  const float nearest = smallestOf(smallest);
  const auto found = std::find(at_middle.begin(), at_middle.end(), nearest);
  return {static_cast<std::size_t>(found - at_middle.begin()), nearest};
}

/// Selects the sites that may be nearest to some point of the box.
void FarSites::Search::selectNear(const Box& box, const List& list, const NearestSite& nearest,
                                  List& kept) const {
  const Vector3f r = box.half.cast<float>();
  kept.size = 0;
  kept.reserve(list.size);
  const auto& [w, value] = nearest;
  const float wx = list.x[w], wy = list.y[w], wz = list.z[w],
              limit = value + 2.0f * static_cast<float>(box.slack);
  for (std::size_t i = 0; i < list.size; i += kLanes) {
    const Four gain = 2.0f * (r.x() * abs(lanesAt(list.x, i) - wx) + r.y() * abs(lanesAt(list.y, i) - wy) +
                              r.z() * abs(lanesAt(list.z, i) - wz));
    const int near = bits(lanesAt(at_middle, i) - gain <= limit);
    if (near == 0) continue;
    for (std::size_t k = 0; k < kLanes; ++k)
      kept.add(list.x[i + k], list.y[i + k], list.z[i + k], list.power[i + k], (near >> k & 1) != 0);
  }
  kept.pad();
}

/// Minimum of |p - v|^2 - |p|^2 for each vertex p, four vertices of a row at once; updated incrementally from
/// row to row.
FarSites::Search::TileValues FarSites::Search::nearestOf(const Tile& tile, const List& kept) const {
  const Vector3f first = -2.0f * (spacing * tile.block.first.cast<double>()).cast<float>();
  const float step = -2.0f * static_cast<float>(spacing);
  const Four along{0.0f, step, 2.0f * step, 3.0f * step};
  const float x0 = first.x() + static_cast<float>(tile.at.x()) * step,
              y0 = first.y() + static_cast<float>(tile.at.y()) * step,
              z0 = first.z() + static_cast<float>(tile.at.z()) * step;
  TileValues nearest_of;
  nearest_of.fill(splat(kFar));
  for (std::size_t s = 0; s < kept.size; ++s) {
    const float x = kept.x[s], y = kept.y[s], z = kept.z[s];
    Four of_slice = kept.power[s] + (x0 * x + y0 * y + z0 * z) + x * along;
    for (int k = 0; k < tile.slices; ++k, of_slice += step * z) {
      Four of_row = of_slice;
      for (int j = 0; j < tile.rows; ++j, of_row += step * y) {
        Four& best = nearest_of[static_cast<std::size_t>(k * kLanes + j)];
        best = min(best, of_row);
      }
    }
  }
  return nearest_of;
}

/// Writes the lower bounds that follow from nearestOf().
void FarSites::Search::write(const Tile& tile, const TileValues& nearest_of, double slack,
                             float* values) const {
  const int columns = std::min(kLanes, tile.block.size.x() - tile.at.x());
  for (int k = 0; k < tile.slices; ++k) {
    for (int j = 0; j < tile.rows; ++j) {
      const Four& best = nearest_of[static_cast<std::size_t>(k * kLanes + j)];
      float* out = values + static_cast<std::size_t>(tile.at.x()) +
                   row * static_cast<std::size_t>(tile.at.y() + j) +
                   slice * static_cast<std::size_t>(tile.at.z() + k);
      for (int l = 0; l < columns; ++l) {
        const Vector3d p = spacing * (tile.block.first + tile.at + Vector3i(l, j, k)).cast<double>();
        const double d2 = p.squaredNorm() + double(best[l]) - reach2 - slack;
        out[l] = d2 > 0.0 ? std::nextafter(static_cast<float>(std::sqrt(d2)), 0.0f) : 0.0f;
      }
    }
  }
}

void FarSites::Search::measure(const Box& box, const List& kept, float* values) const {
  const Vector3i& size = box.block.size;
  for (int i = 0; i < size.x(); i += kLanes) {
    for (int k = 0; k < size.z(); k += kLanes) {
      for (int j = 0; j < size.y(); j += kLanes) {
        const Tile tile{box.block, {i, j, k}, std::min(kLanes, size.y() - j), std::min(kLanes, size.z() - k)};
        write(tile, nearestOf(tile, kept), box.slack, values);
      }
    }
  }
}

FarSites::FarSites(const geometry::TriangleMesh& mesh, const Vector3d& origin, double max_distance,
                   std::size_t max_sites) {
  std::vector<Vector3d> sites;
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      if (!used[v]) sites.push_back(mesh.vertices[v] - origin);
      used[v] = true;
    }
  }
  if (sites.size() > max_sites) return;
  Distinct distinct(sites);
  // Bisects the longest side, so that both triangles at a side are split at the same point.
  std::vector<std::array<Vector3d, 3>> stack;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    stack.push_back({mesh.corner(t, 0) - origin, mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin});
    while (!stack.empty()) {
      const std::array<Vector3d, 3> part = stack.back();
      stack.pop_back();
      const double r2 = reach2(part);
      if (r2 <= max_distance * max_distance) {
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
      if (sites.size() > max_sites) return;
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
  Search search{spacing, row, slice, reach2_, {}, {}, 0};
  List all;
  all.reserve(x_.size());
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
  const Search::Box box{block, middle, half, slack};

  List& kept = search.lists[search.depth];
  search.selectNear(box, list, search.nearestAtMiddle(box, list), kept);

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
  search.measure(box, kept, values);
}

}  // namespace abstand::field
