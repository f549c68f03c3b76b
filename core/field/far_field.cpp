// Certified lower bound of the distance from a body, on nested grids.
#include "core/field/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/field/far_distances.hpp"

namespace abstand::field {
namespace {

constexpr double kMaxVertices = 5e7;
constexpr double kMaxFarQuanta = 65535.0;
constexpr float kEpsilon = 0x1p-23f;
// Relative rounding error of a distance before it is stored.
constexpr double kStored = 1e-12;
// Overlap with the next finer grid, in cells: vertices deeper inside of it are not computed.
constexpr float kOverlap = 2.0f;
// Loss of the sites, in spacings; its square, 0.06, is small beside the loss of up to 0.75 by interpolation
// of squared distances.
constexpr double kLoss = 0.245;
// With more sites, exact queries of the surface are faster.
constexpr std::size_t kMaxDirectSites = 1000, kSitesPerTriangle = 30;

Vector3d centreOf(const FarField::View& v) { return {v.centre[0], v.centre[1], v.centre[2]}; }
Vector3d halfCellsOf(const FarField::View& v) { return {v.middle[0], v.middle[1], v.middle[2]}; }
double spacingOf(const FarField::View& v, int level) { return 1.0 / double(v.inv_h[level]); }
std::size_t rowOf(const FarField::View& v) { return static_cast<std::size_t>(v.n[0]); }
std::size_t sliceOf(const FarField::View& v) { return rowOf(v) * static_cast<std::size_t>(v.n[1]); }
std::size_t verticesOf(const FarField::View& v) { return sliceOf(v) * static_cast<std::size_t>(v.n[2]); }

// Consecutive slices of vertices of one level.
struct Slices {
  int level, first, count;
};

// One FarSites for each level; empty if too many sites would be needed, null for a shape.
std::vector<std::unique_ptr<FarSites>> sitesOfLevels(const geometry::Surface& surface,
                                                     const FarField::View& v, int threads) {
  std::vector<std::unique_ptr<FarSites>> sites(static_cast<std::size_t>(v.levels));
  if (surface.shape() != nullptr) return sites;
  const geometry::TriangleMesh mesh = surface.mesh(0.0);
  parallelFor(threads, sites.size(), [&](std::size_t level) {
    sites[level] =
        std::make_unique<FarSites>(mesh, centreOf(v), kLoss * spacingOf(v, static_cast<int>(level)),
                                   kMaxDirectSites + kSitesPerTriangle * mesh.triangles.size());
  });
  return sites;
}

void measureFromSites(const FarSites& sites, const FarField::View& v, const Slices& slices, float* values) {
  const Vector3i corner = -halfCellsOf(v).cast<int>();
  const FarSites::Block block{corner + Vector3i(0, 0, slices.first), Vector3i(v.n[0], v.n[1], slices.count)};
  sites.distances(block, spacingOf(v, slices.level), rowOf(v), sliceOf(v), values);
}

// Skips vertices where the next finer grid answers.
void measureFromSurface(const geometry::Surface& surface, const FarField::View& v, const Slices& slices,
                        float* values) {
  const auto& [level, first, count] = slices;
  const Vector3d centre = centreOf(v), half_cells = halfCellsOf(v);
  const double spacing = spacingOf(v, level);
  const float inner = level == 0 ? 0.0f : FarField::kRatio[level - 1] / FarField::kRatio[level];
  const auto inside = [&](int at, int axis) {
    return std::abs(static_cast<float>(at) - v.middle[axis]) < inner * v.middle[axis] - kOverlap;
  };
  std::uint32_t hint = geometry::kNoHint;
  for (int k = first; k < first + count; ++k) {
    for (int j = 0; j < v.n[1]; ++j) {
      for (int step = 0; step < v.n[0]; ++step) {
        // Serpentine order, so that the hint is always a neighbour's.
        const int i = j % 2 == 0 ? step : v.n[0] - 1 - step;
        if (inside(i, 0) && inside(j, 1) && inside(k, 2)) continue;
        const Vector3d p = centre + spacing * (Vector3d(i, j, k) - half_cells);
        const geometry::SurfacePoint nearest = surface.closest(p, hint);
        hint = nearest.hint;
        values[static_cast<std::size_t>(k - first) * sliceOf(v) + static_cast<std::size_t>(j) * rowOf(v) +
               static_cast<std::size_t>(i)] =
            std::nextafter(static_cast<float>(nearest.distance * (1.0 - kStored)), 0.0f);
      }
    }
  }
}

// Distances (m) at the vertices of all levels.
std::vector<float> distancesAtVertices(const geometry::Surface& surface, const FarField::View& v,
                                       int threads) {
  std::vector<float> distance(verticesOf(v) * static_cast<std::size_t>(v.levels), 0.0f);
  const std::vector<std::unique_ptr<FarSites>> sites = sitesOfLevels(surface, v, threads);
  // Adjacent slices of one unit of work, so that a search shares work among them.
  constexpr int kSlices = 8;
  const int parts = (v.n[2] + kSlices - 1) / kSlices;
  parallelFor(threads, static_cast<std::size_t>(v.levels * parts), [&](std::size_t task) {
    const int level = static_cast<int>(task) / parts, first = static_cast<int>(task) % parts * kSlices;
    const Slices slices{level, first, std::min(kSlices, v.n[2] - first)};
    float* values = &distance[static_cast<std::size_t>(level * v.n[2] + first) * sliceOf(v)];
    const FarSites* near = sites[static_cast<std::size_t>(level)].get();
    if (near != nullptr && near->size() > 0)
      measureFromSites(*near, v, slices, values);
    else
      measureFromSurface(surface, v, slices, values);
  });
  return distance;
}

}  // namespace

FarField::FarField(const geometry::Surface& surface, double first_spacing, double reach, int threads) {
  setUpGrid(surface.bounds(), first_spacing, reach);
  quantize(distancesAtVertices(surface, view_, threads));
}

void FarField::setUpGrid(const geometry::Bounds& body, double first_spacing, double reach) {
  const double margin = kMargin * first_spacing;
  const Vector3d half_cells = ((0.5 * body.extent().array() + margin) / first_spacing).ceil();
  if (!((2.0 * half_cells.array() + 1.0).prod() <= kMaxVertices)) {
    throw UsageError("the voxel size is far too small for the size of the body");
  }
  View& v = view_;
  const Vector3d centre = body.centre();
  for (int k = 0; k < 3; ++k) {
    v.centre[k] = static_cast<float>(centre[k]);
    v.middle[k] = static_cast<float>(half_cells[k]);
    v.n[k] = 2 * static_cast<int>(half_cells[k]) + 1;
    v.inv_half[k] = static_cast<float>(1.0 / (half_cells[k] * first_spacing));
  }
  const double min_half = half_cells.minCoeff() * first_spacing;
  v.levels = 1;
  while (v.levels < kMaxLevels && min_half * kRatio[v.levels - 1] < reach + 0.5 * body.extent().maxCoeff())
    ++v.levels;
  v.outermost = kRatio[v.levels - 1];
  v.ball = static_cast<float>((0.5 * body.extent()).norm() + (centreOf(v) - centre).norm()) *
           (1.0f + 4.0f * kEpsilon);
  for (int l = 0; l < kMaxLevels; ++l) {
    const int of = std::min(l, v.levels - 1);
    v.width[l] = l + 1 < v.levels ? kRatio[l] : std::numeric_limits<float>::infinity();
    v.inv_h[l] = static_cast<float>(1.0 / (first_spacing * double(kRatio[of])));
    const float h = 1.0f / v.inv_h[l];
    v.h2[l] = h * h * (1.0f + 4.0f * kEpsilon);
    v.rounding[l] = 16.0f * kEpsilon *
                    static_cast<float>(centre.cwiseAbs().maxCoeff() + half_cells.maxCoeff() * double(h));
  }
}

void FarField::quantize(const std::vector<float>& distance) {
  View& v = view_;
  const std::size_t grid = verticesOf(v);
  values_.resize(distance.size());
  for (int l = 0; l < v.levels; ++l) {
    const float* from = &distance[grid * static_cast<std::size_t>(l)];
    const double largest = *std::max_element(from, from + grid);
    const double quantum = std::max(largest, 1e-12) / (kMaxFarQuanta - 1.0);
    for (std::size_t i = 0; i < grid; ++i)
      values_[grid * static_cast<std::size_t>(l) + i] = static_cast<std::uint16_t>(double(from[i]) / quantum);
    v.q2[l] = static_cast<float>(quantum * quantum) * (1.0f - kEpsilon);
  }
  for (int l = v.levels; l < kMaxLevels; ++l) v.q2[l] = v.q2[v.levels - 1];
}

float FarField::lowerBound(float px, float py, float pz) const {
  const View& v = view_;
  const float p[3] = {px - v.centre[0], py - v.centre[1], pz - v.centre[2]};
  const float length2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  if (values_.empty() || !std::isfinite(length2)) return 0.0f;
  float r = 0.0f;
  for (int a = 0; a < 3; ++a) r = std::max(r, std::abs(p[a]) * v.inv_half[a]);
  const float from_ball = std::sqrt(length2) * (1.0f - kSummed) - v.ball;
  if (r > v.outermost) return std::max(0.0f, from_ball);
  int level = 0;
  while (r > v.width[level]) ++level;
  std::size_t at = static_cast<std::size_t>(level);
  float t[3];
  for (int a = 2; a >= 0; --a) {
    const float g = std::max(0.0f, p[a] * v.inv_h[level] + v.middle[a]);
    const int i = std::min(static_cast<int>(g), v.n[a] - 2);
    t[a] = std::min(g - static_cast<float>(i), 1.0f);
    at = at * static_cast<std::size_t>(v.n[a]) + static_cast<std::size_t>(i);
  }
  const std::size_t nx = static_cast<std::size_t>(v.n[0]), nxy = nx * static_cast<std::size_t>(v.n[1]);
  const auto along = [&](std::size_t i) {
    const float a = values_[i], b = values_[i + 1];
    return a * a + t[0] * (b * b - a * a);
  };
  const float y0 = along(at) + t[1] * (along(at + nx) - along(at));
  const float y1 = along(at + nxy) + t[1] * (along(at + nxy + nx) - along(at + nxy));
  const float sum = (y0 + t[2] * (y1 - y0)) * v.q2[level];
  const float loss = v.h2[level] * (t[0] * (1.0f - t[0]) + t[1] * (1.0f - t[1]) + t[2] * (1.0f - t[2]));
  const float d2 = sum - loss - kSummed * (sum + 4.0f * v.h2[level]);
  return std::max(from_ball, d2 > 0.0f ? std::max(0.0f, std::sqrt(d2) - v.rounding[level]) : 0.0f);
}

}  // namespace abstand::field
