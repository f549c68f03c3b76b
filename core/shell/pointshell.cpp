// Pointshell: farthest-point sampling, Lloyd step, areas and normals, quadrature correction.
#include "core/shell/pointshell.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/geometry/mass_properties.hpp"
#include "core/shell/covering_radius.hpp"
#include "core/shell/pointshell_tips.hpp"
#include "core/shell/quadrature_correction.hpp"
#include "core/shell/shell_sampler.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {
namespace {

// Lengths in multiples of the spacing.
constexpr double kShellSagitta = 0.01;
/// Sagitta of the mesh that a shape's quadrature correction uses.
constexpr double kFineSagitta = 0.001;
/// Farthest-point sampling stops when every sub-triangle is within kStop of a point; after the Lloyd step,
/// holes wider than kFill are filled. Together this gives a mean area per point on smooth surfaces of about 2
/// / sqrt(3) spacing^2, that of a hexagonal packing with rows one spacing apart.
constexpr double kStop = 0.83;
constexpr double kFill = 0.775;
/// Distance that a difference of 1 between two unit normals counts as.
constexpr double kNormalLength = 1.0;
constexpr double kPiecesPerPoint = 10.0;
constexpr double kPointArea = 2.0 / std::numbers::sqrt3;
constexpr double kMaxEdge = 0.6;
/// Cell size of the sampler's grid.
constexpr double kCell = 1.0;
/// Limit of the factor by which tips and edges increase the number of points.
constexpr double kMaxExtra = 1.6;

/// Patch of surface that one point represents.
struct Cell {
  double area{0.0};
  Vector3d moment{Vector3d::Zero()};  ///< integral of the position
  Vector3d normal{Vector3d::Zero()};  ///< integral of the outward normal
  Vector3d rim{Vector3d::Zero()};  ///< integral of the conormal over its sharp edges (outward, in the face)
  double second_moment{0.0};       ///< integral of |x|^2
  double inverse_density{0.0};     ///< integral of u = 1 / density
  Vector3d inverse_density_moment{Vector3d::Zero()};  ///< integral of u x
};

std::vector<Cell> gatherCells(const SubTriangles& pool, const std::vector<float>& density,
                              const std::vector<std::uint32_t>& nearest, std::size_t count) {
  std::vector<Cell> cells(count);
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    Cell& cell = cells[nearest[i]];
    const double area = piece.area();
    const Vector3d& normal = pool.normal(piece.triangle());
    const Vector3d centroid = piece.centroid();
    cell.area += area;
    cell.inverse_density += area / density[i];
    cell.inverse_density_moment += area / density[i] * centroid;
    cell.moment += area * centroid;
    cell.normal += area * normal;
    cell.second_moment += area * (centroid.squaredNorm() + piece.variance());
    if (piece.sharp() == 0) return;
    for (int e = 0; e < 3; ++e) {
      if ((piece.sharp() >> e & 1u) != 0)
        cell.rim += (piece.corner((e + 1) % 3) - piece.corner(e)).cross(normal);
    }
  });
  return cells;
}

/// Target positions of the points, so that sums over the shell are unbiased. A linear function is integrated
/// exactly by its value at the centroid; but where the depth is clamped to zero, sum_i a_i max(0, f_i) is too
/// small by sigma^2 / 2 |grad f| on average per unit length of the contour f = 0 (sigma^2: variance of a cell
/// along one axis). Over the touching part of a face that is, by the divergence theorem,
///   1/2 (integral of sigma^2 grad f over the sharp edges, outwards - integral of grad sigma^2 . grad f over
///   the face),
/// so shifts by sigma^2 / 2 (conormal length of the sharp edges) / area - grad sigma^2 / 2 compensate it for
/// any f. sigma^2 is proportional to u = 1 / density, and grad sigma^2 = sigma^2 grad u / u = covariance(x,
/// u) / u within the cell.
std::vector<Vector3d> targets(const std::vector<Cell>& cells) {
  double scaled_variance = 0.0, area = 0.0;
  for (const Cell& cell : cells) {
    if (cell.area <= 0.0) continue;
    scaled_variance +=
        0.5 * cell.area / cell.inverse_density * (cell.second_moment - cell.moment.squaredNorm() / cell.area);
    area += cell.area;
  }
  scaled_variance /= area;
  std::vector<Vector3d> out(cells.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    if (cell.area <= 0.0) continue;
    const Vector3d centroid = cell.moment / cell.area;
    const double variance = scaled_variance * cell.inverse_density / cell.area;
    const Vector3d variance_gradient = cell.inverse_density_moment / cell.inverse_density - centroid;
    const Vector3d shift = 0.5 * (variance / cell.area * cell.rim - variance_gradient);
    // In a narrow face all cells touch sharp edges, and a full shift would leave the face.
    const double max_shift =
        0.5 * std::sqrt(std::max(0.0, cell.second_moment / cell.area - centroid.squaredNorm()));
    out[i] = centroid + (shift.norm() > max_shift ? max_shift / shift.norm() : 1.0) * shift;
  }
  return out;
}

/// Projects each target onto the surface of its own cell; NaN targets are skipped.
std::vector<Vector3d> onSurface(const SubTriangles& pool, const std::vector<std::uint32_t>& nearest,
                                const std::vector<Vector3d>& target) {
  std::vector<Vector3d> out(target.size());
  struct Best {
    double distance2{kInfinity};
    double far2{kInfinity};  ///< squared distance of a centroid beyond which the whole sub-triangle is
                             ///< farther than the best one
  };
  std::vector<Best> bests(target.size());
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    const Vector3d& to = target[nearest[i]];
    Best& best = bests[nearest[i]];
    if (!((piece.centroid() - to).squaredNorm() < best.far2)) return;
    const Vector3d p = closestPoint(piece.whole(), to);
    const double d2 = (p - to).squaredNorm();
    if (d2 >= best.distance2) return;
    const double limit = std::sqrt(d2) + pool.centroidRadius();
    best = {d2, limit * limit};
    out[nearest[i]] = p;
  });
  return out;
}

/// Distance of the points in `selected` from the sharp edges of their own cells; infinite if there are none.
std::vector<double> rimDistances(const SubTriangles& pool, const std::vector<std::uint32_t>& nearest,
                                 const std::vector<Vector3d>& points, const std::vector<bool>& selected) {
  std::vector<double> out(points.size(), kInfinity);
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    if (piece.sharp() == 0 || !selected[nearest[i]]) return;
    const Vector3d& p = points[nearest[i]];
    double& nearest_edge = out[nearest[i]];
    for (int e = 0; e < 3; ++e) {
      if ((piece.sharp() >> e & 1u) == 0) continue;
      const Vector3d start = piece.corner(e), edge = piece.corner((e + 1) % 3) - start, from = p - start;
      const double t = std::clamp(from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      nearest_edge = std::min(nearest_edge, (from - t * edge).norm());
    }
  });
  return out;
}

/// Outward unit normal of a shape at p; `near` selects the face if p is on an edge.
Vector3d shapeNormal(const geometry::Shape& shape, const Vector3d& p, const Vector3d& near) {
  struct Visitor {
    const Vector3d &p, &near;
    Vector3d operator()(const geometry::Sphere&) const { return p.normalized(); }
    Vector3d operator()(const geometry::Ellipsoid& e) const {
      return p.cwiseQuotient(e.semi_axes.cwiseProduct(e.semi_axes)).normalized();
    }
    Vector3d operator()(const geometry::Cuboid&) const {
      int axis = 0;
      near.cwiseAbs().maxCoeff(&axis);
      return std::copysign(1.0, near[axis]) * Vector3d::Unit(axis);
    }
    Vector3d operator()(const geometry::Cylinder&) const {
      if (std::abs(near.z()) > std::sqrt(0.5)) return {0.0, 0.0, std::copysign(1.0, near.z())};
      return Vector3d(p.x(), p.y(), 0.0).normalized();
    }
    Vector3d operator()(const geometry::Capsule& c) const {
      return (p - Vector3d(0.0, 0.0, std::clamp(p.z(), -0.5 * c.length, 0.5 * c.length))).normalized();
    }
  };
  return std::visit(Visitor{p, near}, shape);
}

/// Projects a point onto a shape's surface and sets the normal there.
void projectOntoShape(const geometry::Surface& surface, CorrectionPoint& point) {
  point.position = surface.closest(point.position).point;
  point.normal = -shapeNormal(*surface.shape(), point.position, -point.normal);
}

void restoreTotalArea(std::vector<CorrectionPoint>& points) {
  double current = 0.0, initial = 0.0;
  for (const CorrectionPoint& p : points) current += p.area, initial += p.initial_area;
  for (CorrectionPoint& p : points) p.area *= initial / current;
}

/// Points per area at each sub-triangle, as a multiple of the usual density, limited by kMaxExtra.
std::vector<float> pointDensity(const SubTriangles& pool) {
  std::vector<float> density(pool.size(), 1.0f);
  if (pool.isUniform()) return density;
  double area = 0.0, extra = 0.0;
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    density[i] = 1.0f / (pool.pitch(i) * pool.pitch(i));
    area += piece.area();
    extra += piece.area() * double(density[i] - 1.0f);
  });
  if (extra > (kMaxExtra - 1.0) * area) {
    const float share = static_cast<float>((kMaxExtra - 1.0) * area / extra);
    for (float& d : density) d = 1.0f + share * (d - 1.0f);
  }
  return density;
}

std::vector<Vector3f> scaledNormals(const std::vector<Cell>& cells, double length) {
  std::vector<Vector3f> out;
  for (const Cell& cell : cells) out.push_back((length * cell.normal.normalized()).cast<float>());
  return out;
}

/// Partition of a surface among points.
struct Partition {
  std::vector<std::uint32_t> nearest;  ///< cell of each sub-triangle
  std::vector<Cell> cells;
  std::vector<std::uint32_t> order;  ///< order of the cells in the shell
};

Partition makePartition(const SubTriangles& pool, double spacing) {
  const double normal_length = kNormalLength * spacing;
  const std::vector<float> density = pointDensity(pool);
  ShellSampler sampler(pool, density, normal_length, kCell * spacing);
  sampler.selectCentres(kStop * spacing);
  std::vector<Cell> cells = gatherCells(pool, density, sampler.nearest(), sampler.count());
  std::vector<Vector3f> centred;
  for (const Vector3d& p : targets(cells)) centred.push_back(p.cast<float>());
  sampler.fillHoles(std::move(centred), scaledNormals(cells, normal_length), kFill * spacing);
  cells = gatherCells(pool, density, sampler.nearest(), sampler.count());
  std::vector<std::uint32_t> order = sampler.order();
  return {sampler.releaseNearest(), std::move(cells), std::move(order)};
}

}  // namespace

Pointshell makePointshell(const geometry::Surface& surface, double spacing, int threads) {
  if (!(spacing > 0.0) || !std::isfinite(spacing)) {
    throw UsageError("point spacing is " + std::to_string(spacing) + " m, expected a positive length");
  }
  const geometry::Shape* shape = surface.shape();
  const geometry::TriangleMesh mesh = surface.mesh(kShellSagitta * spacing);
  const PitchField field(mesh, spacing);
  const SubTriangles pool(mesh, kMaxEdge * spacing, kPointArea / kPiecesPerPoint * spacing * spacing, field);
  if (pool.size() == 0) throw UsageError("a surface without area has no shell points");
  Partition partition = makePartition(pool, spacing);
  std::vector<std::uint32_t>& nearest = partition.nearest;
  std::vector<Cell>& cells = partition.cells;
  const std::vector<Vector3d> points = onSurface(pool, nearest, targets(cells));

  double pool_area = 0.0;
  for (const Cell& cell : cells) pool_area += cell.area;
  const double area_scale = shape != nullptr ? surface.area() / pool_area : 1.0;
  std::vector<CorrectionPoint> corrected;
  corrected.reserve(points.size());
  std::vector<std::uint32_t> cell_of, index_of(points.size(), 0);
  for (const std::uint32_t k : partition.order) {
    if (cells[k].area <= 0.0) continue;
    index_of[k] = static_cast<std::uint32_t>(corrected.size());
    cell_of.push_back(k);
    // Bumps within a cell cancel; what remains is the area times the mean normal.
    const double area = shape != nullptr ? area_scale * cells[k].area : cells[k].normal.norm();
    corrected.push_back({points[k], -cells[k].normal.normalized(), area, points[k], area,
                         QuadratureCorrection::kMaxShift * spacing});
    if (shape != nullptr) projectOntoShape(surface, corrected.back());
  }
  cells = {};
  if (!field.isUniform()) {
    const QuadratureCorrection correction(*halfSpaceOverlap(surface, kFineSagitta * spacing),
                                          field.sharpEdges(), corrected, spacing, threads);
    std::vector<bool> pressed(points.size(), false);
    for (std::size_t i = 0; i < corrected.size(); ++i) pressed[cell_of[i]] = correction.isPressed(i);
    const std::vector<double> from_rim = rimDistances(pool, nearest, points, pressed);
    for (std::size_t i = 0; i < corrected.size(); ++i)
      corrected[i].max_shift = std::min(corrected[i].max_shift, 0.5 * from_rim[cell_of[i]]);
    correction.adjust(corrected, QuadratureCorrection::Variables::kPositionAndArea);
    // Projected back onto the surface.
    std::vector<Vector3d> moved(points.size(), Vector3d::Constant(kNaN));
    for (std::size_t i = 0; i < corrected.size(); ++i) {
      if (pressed[cell_of[i]]) moved[cell_of[i]] = corrected[i].position;
    }
    moved = onSurface(pool, nearest, moved);
    for (std::size_t i = 0; i < corrected.size(); ++i) {
      if (!pressed[cell_of[i]]) continue;
      corrected[i].position = moved[cell_of[i]];
      if (shape != nullptr) projectOntoShape(surface, corrected[i]);
    }
    correction.adjust(corrected, QuadratureCorrection::Variables::kArea);
    restoreTotalArea(corrected);
  }

  Pointshell shell;
  shell.spacing = spacing;
  std::vector<Vector3f> positions;
  for (const CorrectionPoint& p : corrected) {
    positions.push_back(p.position.cast<float>());
    shell.x.push_back(positions.back().x());
    shell.y.push_back(positions.back().y());
    shell.z.push_back(positions.back().z());
    shell.nx.push_back(static_cast<float>(p.normal.x()));
    shell.ny.push_back(static_cast<float>(p.normal.y()));
    shell.nz.push_back(static_cast<float>(p.normal.z()));
    shell.area.push_back(static_cast<float>(p.area));
  }
  for (std::uint32_t& k : nearest) k = index_of[k];
  // A shape's surface is within the sagitta of its mesh.
  shell.covering_radius =
      coveringRadius(pool, positions, nearest) + (shape != nullptr ? kShellSagitta * spacing : 0.0);
  return shell;
}

}  // namespace abstand::shell
