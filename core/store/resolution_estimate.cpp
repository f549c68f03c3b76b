// Predicts cost and accuracy of a resolution before it is built.
#include "core/store/resolution_estimate.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.hpp"
#include "core/field/far_spacing.hpp"
#include "core/query/pair_query.hpp"

namespace abstand::store {
namespace {

using Clock = std::chrono::steady_clock;

// The coarse build: number of voxels along the longest extent, and about the number of shell points. Enough
// to resolve edges; takes a fraction of a second.
constexpr double kProbeVoxels = 32.0;
constexpr double kProbePoints = 1200.0;
constexpr double kAreaPerPoint = 2.0 / std::numbers::sqrt3;  // spacings^2 for each point, on flat surfaces
// Number of blocks sampled; of more blocks, an even selection.
constexpr std::size_t kAskedBlocks = 4096;
// Rounding of a field's float coordinates relative to its extent; independent of the voxel size.
constexpr double kFieldRounding = 1e-5;
constexpr double kMaxFieldBytes = 2e9;  // limit of NearField
// Empirical exponents of build time: voxelization with the voxels along an edge (between surface and volume);
// a mesh's near field with its blocks (each has fewer features); the far field with its vertices. Fitted to
// robot links, body parts, the bunny and a table at 32 to 256 voxels along them.
constexpr double kVoxelTimeGrowth = 2.2, kMeshFieldGrowth = 0.6, kFarTimeGrowth = 1.2;
// Points of the sphere that calibrates the time for a point on this machine. It is the same for any body
// except for the quadrature correction, whose time hardly depends on the number of points.
constexpr double kBallPoints = 2000.0;
// Empirical exponents of query time with the number of points, fitted to robot links, shapes and tables at 5
// to 3 mm: the candidates of a distance query lie along a curve, those of a contact on a patch that the field
// partly decides at once.
constexpr double kDistanceGrowth = 0.5, kContactGrowth = 0.75;
constexpr double kApart = 0.1, kPressed = 0.02;  // shares of the body's size
constexpr double kTimed = 2e-3;                  // s, time spent on each kind of query
constexpr std::size_t kMinTimed = 11;

double milliseconds(Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); }

struct Blocks {
  double kept{0.0};  ///< expected number with samples
  double deep{0.0};  ///< expected number inside without samples
  double all{0.0};
};

/// Widths of the bands of stored blocks (m).
struct Bands {
  double outer, inner;
};

// A cube of half edge r intersects the band of a flat surface with normal n if its centre is no farther than
// band + r |n|_1.
Blocks countBlocks(const geometry::Surface& surface, const field::VoxelGrid& grid, const Bands& bands,
                   bool dense) {
  constexpr int kCells = field::NearField::kCells;
  std::array<std::size_t, 3> n;
  for (int k = 0; k < 3; ++k) n[k] = (static_cast<std::size_t>(grid.size[k]) + kCells - 1) / kCells;
  const std::size_t all = n[0] * n[1] * n[2];
  if (dense) return {double(all), 0.0, double(all)};
  const double edge = kCells * grid.voxel_size;
  const Vector3d first = grid.first_centre.array() + 0.5 * (edge - grid.voxel_size);
  const std::size_t asked = std::min(all, kAskedBlocks);
  std::size_t near = 0, deep = 0;
  for (std::size_t i = 0; i < asked; ++i) {
    // Golden-ratio sequence: even selection for any sizes.
    const double place =
        all == asked ? double(i) : std::fmod(double(i) * std::numbers::phi, 1.0) * double(all);
    const auto b = std::min(static_cast<std::size_t>(place), all - 1);
    const Vector3d c =
        first + edge * Vector3d(double(b % n[0]), double(b / n[0] % n[1]), double(b / (n[0] * n[1])));
    const geometry::SurfacePoint nearest = surface.closest(c);
    const double towards = (c - nearest.point).lpNorm<1>() / std::max(nearest.distance, 1e-12);
    const bool inside = surface.inside(c, nearest);
    if (nearest.distance <= (inside ? bands.inner : bands.outer) + 0.5 * edge * towards)
      ++near;
    else if (inside)
      ++deep;
  }
  const double of_asked = double(all) / double(asked);
  return {double(near) * of_asked, double(deep) * of_asked, double(all)};
}

// Same rules as in NearField.
Blocks countNearBlocks(const geometry::Surface& surface, const field::VoxelGrid& grid, double band,
                       bool dense) {
  Blocks blocks = countBlocks(surface, grid, {band, field::NearField::kInnerBand * grid.voxel_size}, dense);
  constexpr double kBlockBytes = field::NearField::kBlockValues * sizeof(std::int16_t);
  if ((blocks.kept + blocks.deep) * kBlockBytes <= double(field::NearField::kWholeInsideBytes))
    blocks.kept += std::exchange(blocks.deep, 0.0);
  return blocks;
}

double layeredBytes(const geometry::Surface& surface, const field::VoxelGrid& grid) {
  const bool exact = grid.cells() <= field::Voxelmap::kMaxExactVoxels;
  const double steps = (field::Voxelmap::kExactSteps + 1) * grid.voxel_size;
  const Blocks blocks = countBlocks(surface, grid, {steps, steps}, exact);
  const double packed = field::LayerView::kPackedBytes + sizeof(std::int16_t);
  return packed * blocks.kept + sizeof(std::int32_t) * blocks.all +
         (exact ? 0.0 : sizeof(std::int16_t) * blocks.all);
}

// Median time (us) of one query of two copies at distance `gap` (m; negative: overlapping), over three
// directions.
double timeQueries(const structure::HapticStructure& s, double gap) {
  const geometry::Bounds box = s.surface->bounds();
  kernels::PairScratch scratch;
  query::PairResult result;
  std::array<double, 3> us;
  for (int axis = 0; axis < 3; ++axis) {
    // Start certainly apart; then move along the witness line.
    Transform X = Transform::Identity();
    X.translation() = (1.0 + kApart) * box.extent()[axis] * Vector3d::Unit(axis);
    query::queryPair({s, Transform::Identity()}, {s, X}, {}, scratch, result);
    const Vector3d direction = (result.witness_a - result.witness_b).normalized();
    X.translation() += (result.distance - gap) * direction;
    // Timed one by one: other load on the machine disturbs a few of them, but not the median.
    std::vector<double> one;
    for (double all = 0.0; all < kTimed || one.size() < kMinTimed; all += one.back()) {
      const auto begin = Clock::now();
      query::queryPair({s, Transform::Identity()}, {s, X}, {}, scratch, result);
      one.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    const auto middle = one.begin() + static_cast<std::ptrdiff_t>(one.size() / 2);
    std::nth_element(one.begin(), middle, one.end());
    us[axis] = 1e6 * *middle;
  }
  std::sort(us.begin(), us.end());
  return us[1];
}

// Number of vertices of one grid of the far field.
double farVertices(const geometry::Bounds& body, double voxel) {
  const double spacing = field::farSpacing(body, voxel);
  return (body.extent().array() / spacing + 2.0 * field::FarField::kMargin + 1.0).prod();
}

// Build time (ms) of one shell point.
double timePoint() {
  const auto begin = Clock::now();
  const geometry::Sphere ball{0.1};
  const auto surface = geometry::makeSurface(ball);
  const shell::Pointshell shell =
      shell::makePointshell(*surface, std::sqrt(surface->area() / (kAreaPerPoint * kBallPoints)));
  return milliseconds(Clock::now() - begin) / double(shell.size());
}

}  // namespace

struct ResolutionProbe::Coarse {
  std::shared_ptr<const structure::HapticStructure> built;
  double area{0.0};
  double edges{0.0}, tips{0.0};  ///< b (m) and c of the formula for the number of points
  Blocks blocks;
  double band{0.0};  ///< voxels
  double field_bytes{0.0}, far_bytes{0.0}, shell_bytes{0.0};
  double voxels_ms{0.0}, field_ms{0.0}, far_ms{0.0}, shell_ms{0.0};
  double point_ms{0.0};  ///< share of shell_ms for one point
  double distance_us{0.0}, contact_us{0.0};

  double points(double spacing) const {
    return area / (kAreaPerPoint * spacing * spacing) + edges / spacing + tips;
  }
  /// A constant part and one proportional to the points.
  double shellMs(double n) const { return shell_ms + point_ms * (n - double(built->shell.size())); }
};

const ResolutionProbe::Coarse& ResolutionProbe::coarse(const structure::HapticOptions& asked,
                                                       const structure::BuildMonitor& monitor) {
  structure::HapticOptions o = asked;
  const double area = surface_->area();
  o.voxel_size = std::max(o.voxel_size, surface_->bounds().extent().maxCoeff() / kProbeVoxels);
  o.point_spacing = std::max(o.point_spacing, std::sqrt(area / (kAreaPerPoint * kProbePoints)));
  const auto same = [&](const structure::HapticOptions& l) {
    return l.voxel_size == o.voxel_size && l.point_spacing == o.point_spacing &&
           l.outer_layers == o.outer_layers && l.field == o.field;
  };
  if (coarse_ && same(coarse_->built->options)) return *coarse_;

  auto c = std::make_shared<Coarse>();
  c->area = area;
  auto last = Clock::now();
  double* running = nullptr;
  structure::BuildMonitor timer;
  timer.cancelled = monitor.cancelled;
  timer.progress = [&](double fraction, std::string_view phase) {
    double* next = phase == "voxels"       ? &c->voxels_ms
                   : phase == "near field" ? &c->field_ms
                   : phase == "far field"  ? &c->far_ms
                                           : &c->shell_ms;
    if (next == running && fraction < 1.0) return;
    if (running) *running += milliseconds(Clock::now() - last);
    last = Clock::now();
    running = next;
  };
  c->built = structure::buildHapticStructure("probe", surface_, o, 0, timer);
  const structure::HapticStructure& s = *c->built;
  c->point_ms = std::min(timePoint(), c->shell_ms / double(s.shell.size()));

  // Two equations for edges and tips.
  const double s1 = 2.0 * o.point_spacing, s2 = o.point_spacing;
  const double n1 = double(shell::makePointshell(*surface_, s1).size());
  const double rest1 = n1 - c->points(s1), rest2 = double(s.shell.size()) - c->points(s2);
  c->edges = (rest2 - rest1) / (1.0 / s2 - 1.0 / s1);
  c->tips = rest2 - c->edges / s2;

  c->far_bytes = double(s.far_field.memoryBytes());
  if (s.near_field) {
    c->band = s.near_field->band() / o.voxel_size;
    c->blocks =
        countNearBlocks(*surface_, s.grid, s.near_field->band(), o.field == structure::FieldKind::kFloat);
    c->field_bytes = double(s.near_field->memoryBytes());
  } else {
    c->field_bytes = double(s.voxelmap->memoryBytes());
  }
  c->shell_bytes = double(s.memoryBytes()) - c->far_bytes - c->field_bytes;
  const double size = s.surface->bounds().extent().maxCoeff();
  c->distance_us = timeQueries(s, kApart * size);
  c->contact_us = timeQueries(s, -kPressed * size);
  coarse_ = std::move(c);
  return *coarse_;
}

ResolutionEstimate ResolutionProbe::estimate(const structure::HapticOptions& options,
                                             const structure::BuildMonitor& monitor) {
  options.validate();
  ResolutionEstimate e;
  e.options = options;
  const double h = options.voxel_size;
  field::VoxelGrid grid;
  try {
    grid = field::makeGrid(surface_->bounds(), h, options.outer_layers);
  } catch (const UsageError& error) {
    e.refused = error.what();
    return e;
  }
  const Coarse& c = coarse(options, monitor);
  const structure::HapticStructure& s = *c.built;
  const double finer = s.options.voxel_size / h;
  const geometry::Bounds box = surface_->bounds();

  double field_bytes = c.field_bytes, field_ms = c.field_ms;
  if (options.field == structure::FieldKind::kLayered) {
    field_bytes = layeredBytes(*surface_, grid);
  } else if (finer > 1.0) {
    const Blocks blocks =
        countNearBlocks(*surface_, grid, c.band * h, options.field == structure::FieldKind::kFloat);
    const double index = sizeof(std::uint32_t);
    const double more = blocks.kept / std::max(1.0, c.blocks.kept);
    field_bytes = (c.field_bytes - index * c.blocks.all) * more + index * blocks.all;
    if (blocks.deep > 0.0) field_bytes += sizeof(std::int16_t) * blocks.all;
    field_ms *= std::pow(more, surface_->shape() != nullptr ? 1.0 : kMeshFieldGrowth);
    if (field_bytes > kMaxFieldBytes) {
      e.refused = "the distance field would take more than 2 GB";
      return e;
    }
  }
  const bool same_shell = s.options.point_spacing == options.point_spacing;
  e.points = same_shell ? double(s.shell.size()) : c.points(options.point_spacing);
  const double more_points = e.points / double(s.shell.size());
  const double more_far = farVertices(box, h) / farVertices(box, s.options.voxel_size);
  e.memory_bytes = field_bytes + c.far_bytes * more_far + c.shell_bytes * more_points;
  e.error_bound =
      (s.errorBound() - s.shell.covering_radius) / finer +
      (finer > 1.0 ? kFieldRounding * (box.upper.cwiseMax(-box.lower) + box.extent()).maxCoeff() : 0.0) +
      (same_shell ? s.shell.covering_radius : kCovering * options.point_spacing);
  e.build_ms = c.voxels_ms * std::pow(finer, kVoxelTimeGrowth) + field_ms +
               c.far_ms * std::pow(more_far, kFarTimeGrowth) + c.shellMs(e.points);
  e.distance_us = c.distance_us * std::pow(more_points, kDistanceGrowth);
  e.contact_us =
      e.distance_us + std::max(0.0, c.contact_us - c.distance_us) * std::pow(more_points, kContactGrowth);
  return e;
}

}  // namespace abstand::store
