// Quadrature correction of a pointshell by the Kaczmarz method.
#include "core/shell/quadrature_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "core/base/parallel.hpp"
#include "core/math/four.hpp"

namespace abstand::shell {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kDirections = 1000;  ///< uniform over the sphere: one about every 6 degrees
/// In spacings; depths are a geometric sequence, shifted from direction to direction.
constexpr double kShallowest = 0.75, kDeepest = 2.2;
constexpr int kDepths = 5;
/// Steps of the directions about a sharp edge: between its two normals, and along the edge. Directions closer
/// than kSameDirection count as one.
constexpr double kBetween[] = {0.05, 0.25, 0.5, 0.75, 0.95};
constexpr double kAlong[] = {0.0, 0.03, -0.03, 0.055, -0.055, 0.09, -0.09};
constexpr double kSameDirection = 0.05;
/// Shortest total length (spacings) of sharp edges of one direction that get half-space directions of their
/// own: a plane may touch along such edges.
constexpr double kLongSharpEdge = 3.0;
/// Half-spaces with more points than this are accurate enough; to prevent drift, every kCoarse-th direction
/// is kept anyway, up to kMaxCoarse points.
constexpr std::size_t kMaxPoints = 400, kMaxCoarse = 1500, kCoarse = 16;
/// Limit of points in all half-spaces together; beyond, some half-spaces are skipped, which limits the time
/// for a large body.
constexpr std::size_t kMaxVisits = 600'000;
constexpr int kSweeps = 5, kAreaSweeps = 3;
/// Relative force error that is not corrected.
constexpr float kForceTolerance = 0.001f;
constexpr double kFirstStep = 1.0, kLastStep = 0.1;
/// Weight of moves against area changes: moving by this share of the spacing counts as changing the area by
/// 100 %.
constexpr float kMoveWeight = 0.7f;
/// Points outside by up to this share of the spacing are included, as they may enter while being moved.
constexpr double kMargin = 0.1;
/// Share of the trace added to the diagonal of the 3 x 3 systems: a single face gives a rank-1 system.
constexpr double kDamping = 1e-3;

std::vector<Vector3d> halfSpaceDirections(const std::vector<SharpEdge>& sharp_edges, double spacing) {
  std::vector<Vector3d> out;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const double turn = 2.0 * kPi * kGolden * i;
    out.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  std::map<std::array<int, 6>, double> length;
  const auto key = [](const SharpEdge& sharp_edge) {
    std::array<int, 6> k;
    for (int i = 0; i < 6; ++i)
      k[i] = static_cast<int>(std::lround(sharp_edge.normal[i / 3][i % 3] / kSameDirection));
    return k;
  };
  for (const SharpEdge& sharp_edge : sharp_edges)
    length[key(sharp_edge)] += (sharp_edge.end[1] - sharp_edge.end[0]).norm();
  std::set<std::array<int, 3>> seen;
  for (const SharpEdge& sharp_edge : sharp_edges) {
    if (length[key(sharp_edge)] < kLongSharpEdge * spacing) continue;
    for (const double between : kBetween) {
      for (const double along : kAlong) {
        const Vector3d outwards =
            ((1.0 - between) * sharp_edge.normal[0] + between * sharp_edge.normal[1]).normalized();
        const Vector3d u = -(outwards + along * sharp_edge.along()).normalized();
        const Vector3i rounded = (u / kSameDirection).array().round().cast<int>();
        if (seen.insert({rounded.x(), rounded.y(), rounded.z()}).second) out.push_back(u);
      }
    }
  }
  return out;
}

/// A step coprime to n, so that i * step mod n visits every index, neighbours at distant times.
std::size_t stride(std::size_t n) {
  std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(kGolden * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

constexpr std::size_t kCorrectionLanes = 4;

/// Working copy of a point in float, relative to the mean position, in units of the spacing.
struct Active {
  Four current;    ///< position and area
  Four reference;  ///< normal and initial area
  Four initial;    ///< initial position and largest distance from it
};

Four four(const Vector3d& v, double w) { return Four{float(v.x()), float(v.y()), float(v.z()), float(w)}; }

/// Four points as a structure of arrays.
struct Columns {
  Four x, y, z, w;
  Columns(Four a, Four b, Four c, Four d) : x(a), y(b), z(c), w(d) { transpose(x, y, z, w); }
};

/// Force of a half-space, and the Gram matrix of its derivatives by the points' changes; both act along the
/// point normals.
struct HalfSpaceForce {
  Vector3f force;
  Matrix3d gram;
};

/// Also sets `depths`.
HalfSpaceForce measure(const std::vector<Active>& active, std::span<const std::uint32_t> inside,
                       const Vector3f& u, float level, float move2, std::vector<float>& depths) {
  Four fx{}, fy{}, fz{}, g00{}, g01{}, g02{}, g11{}, g12{}, g22{};
  for (std::size_t k = 0; k < inside.size(); k += kCorrectionLanes) {
    const Active &a = active[inside[k]], &b = active[inside[k + 1]], &c = active[inside[k + 2]],
                 &d = active[inside[k + 3]];
    const Columns current(a.current, b.current, c.current, d.current),
        reference(a.reference, b.reference, c.reference, d.reference);
    const Four nx = reference.x, ny = reference.y, nz = reference.z, initial_area = reference.w;
    const Four depth = max(level - u.x() * current.x - u.y() * current.y - u.z() * current.z, Four{});
    storeFour(depth, &depths[k]);
    const Four push = current.w * depth;
    fx += push * nx, fy += push * ny, fz += push * nz;
    const Four un = u.x() * nx + u.y() * ny + u.z() * nz;
    const Four g =
        depth > 0.0f ? initial_area * initial_area * (depth * depth + move2 * (1.0f - un * un)) : Four{};
    const Four gx = g * nx, gy = g * ny;
    g00 += gx * nx, g01 += gx * ny, g02 += gx * nz, g11 += gy * ny, g12 += gy * nz, g22 += g * nz * nz;
  }
  HalfSpaceForce measured;
  measured.force = {sumOf(fx), sumOf(fy), sumOf(fz)};
  const double xy = double(sumOf(g01)), xz = double(sumOf(g02)), yz = double(sumOf(g12));
  measured.gram << double(sumOf(g00)), xy, xz, xy, double(sumOf(g11)), yz, xz, yz, double(sumOf(g22));
  return measured;
}

/// Applies the Kaczmarz step `multiplier`: changes areas, and positions if move2 is not 0.
void applyCorrection(std::span<const std::uint32_t> inside, const std::vector<float>& depths,
                     const Vector3f& u, const Vector3f& multiplier, float move2,
                     std::vector<Active>& active) {
  for (std::size_t k = 0; k < inside.size(); k += kCorrectionLanes) {
    const Four depth = load(&depths[k]);
    const FourInts in = depth > 0.0f;
    if (bits(in) == 0) continue;
    Active &a = active[inside[k]], &b = active[inside[k + 1]], &c = active[inside[k + 2]],
           &d = active[inside[k + 3]];
    Columns current(a.current, b.current, c.current, d.current);
    const Columns reference(a.reference, b.reference, c.reference, d.reference);
    const Four g = reference.w * (reference.x * multiplier.x() + reference.z * multiplier.z() +
                                  reference.y * multiplier.y());
    const Four area =
        min(max(current.w + reference.w * depth * g, QuadratureCorrection::kMinArea * reference.w),
            QuadratureCorrection::kMaxArea * reference.w);
    current.w = in ? area : current.w;
    if (move2 > 0.0f) {
      const Columns initial(a.initial, b.initial, c.initial, d.initial);
      const Four un = u.x() * reference.x + u.z() * reference.z + u.y() * reference.y,
                 shift_length = move2 * g;
      const Four x = current.x - initial.x - shift_length * (u.x() - un * reference.x),
                 y = current.y - initial.y - shift_length * (u.y() - un * reference.y),
                 z = current.z - initial.z - shift_length * (u.z() - un * reference.z);
      const Four length2 = x * x + z * z + y * y, one = splat(1.0f);
      const Four shorter = length2 > initial.w * initial.w ? initial.w / sqrt(length2) : one;
      current.x = in ? initial.x + x * shorter : current.x;
      current.y = in ? initial.y + y * shorter : current.y;
      current.z = in ? initial.z + z * shorter : current.z;
    }
    transpose(current.x, current.y, current.z, current.w);
    a.current = current.x, b.current = current.y, c.current = current.z, d.current = current.w;
  }
}

/// Half-spaces of one direction: exact forces and points.
struct DirectionSamples {
  double level[kDepths];
  Vector3d force[kDepths];
  double weight[kDepths];
  std::vector<std::uint32_t> points[kDepths];
};

}  // namespace

QuadratureCorrection::QuadratureCorrection(const HalfSpaceOverlap& body,
                                           const std::vector<SharpEdge>& sharp_edges,
                                           const std::vector<CorrectionPoint>& points, double spacing,
                                           int threads)
    : spacing_(spacing), pressed_(points.size(), false) {
  const std::vector<Vector3d> directions = halfSpaceDirections(sharp_edges, spacing);
  std::vector<Vector3f> positions;
  for (const CorrectionPoint& p : points) positions.push_back(p.position.cast<float>());
  const PointsBelow points_below(positions);
  std::vector<DirectionSamples> found(directions.size());
  parallelFor(threads, directions.size(), [&](std::size_t k) {
    const Vector3d& u = directions[k];
    const Vector3f uf = u.cast<float>();
    DirectionSamples& samples = found[k];
    const double lowest = body.lowest(u);
    const double shift = std::fmod(kGolden * static_cast<double>(k), 1.0);
    const std::size_t max_points = k % kCoarse == 0 ? kMaxCoarse : kMaxPoints;
    int depths = 0;
    for (; depths < kDepths; ++depths) {
      const double depth = kShallowest * std::pow(kDeepest / kShallowest, (depths + shift) / kDepths);
      const double level = lowest + depth * spacing;
      std::vector<std::uint32_t>& inside = samples.points[depths];
      points_below.find(uf, static_cast<float>(level + kMargin * spacing), max_points, inside);
      if (inside.size() > max_points) inside.clear();
      if (inside.empty() && depths > 0) break;
      samples.level[depths] = level;
      samples.weight[depths] = std::min(1.0, std::pow(depth, 1.5));
    }
    if (depths == 0) return;
    const auto count = static_cast<std::size_t>(depths);
    body.forces(u, {samples.level, count}, {samples.force, count});
    for (std::size_t d = 0; d < count; ++d)
      if (samples.force[d].isZero(0.0)) samples.points[d].clear();
  });

  order_ = points_below.order();
  std::vector<std::uint32_t> position_of(points.size());
  for (std::uint32_t k = 0; k < order_.size(); ++k) position_of[order_[k]] = k;
  // Neighbouring directions are processed at distant times, so that no place is corrected twice in a row.
  const std::size_t n = directions.size() * kDepths, step = stride(n);
  for (std::size_t i = 0, r = 0; i < n && points_.size() <= kMaxVisits; ++i, r = (r + step) % n) {
    const DirectionSamples& samples = found[r / kDepths];
    const std::size_t d = r % kDepths;
    const std::vector<std::uint32_t>& inside = samples.points[d];
    if (inside.empty()) continue;
    half_spaces_.push_back({directions[r / kDepths], samples.level[d], samples.force[d], samples.weight[d],
                            static_cast<std::uint32_t>(points_.size()),
                            static_cast<std::uint32_t>(inside.size())});
    for (const std::uint32_t point : inside) {
      points_.push_back(position_of[point]);
      pressed_[point] = true;
    }
    while (points_.size() % kCorrectionLanes != 0)
      points_.push_back(static_cast<std::uint32_t>(points.size()));
    half_spaces_.back().count = static_cast<std::uint32_t>(points_.size()) - half_spaces_.back().first;
  }
}

void QuadratureCorrection::adjust(std::vector<CorrectionPoint>& points, Variables variables) const {
  const double s = spacing_, s2 = s * s;
  Vector3d middle = Vector3d::Zero();
  for (const CorrectionPoint& p : points) middle += p.initial_position / static_cast<double>(points.size());
  std::vector<Active> active;
  active.reserve(points.size() + 1);
  for (const std::uint32_t i : order_) {
    const CorrectionPoint& p = points[i];
    active.push_back({four((p.position - middle) / s, p.area / s2), four(p.normal, p.initial_area / s2),
                      four((p.initial_position - middle) / s, p.max_shift / s)});
  }
  // Padding of the presses.
  active.push_back(Active{});

  const float move2 = variables == Variables::kArea ? 0.0f : kMoveWeight * kMoveWeight;
  const int sweeps = variables == Variables::kArea ? kAreaSweeps : kSweeps;
  std::vector<float> depths;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const double step = kFirstStep + (kLastStep - kFirstStep) * sweep / (sweeps - 1);
    for (const HalfSpaceSample& sample : half_spaces_) {
      const std::span<const std::uint32_t> inside(&points_[sample.first], sample.count);
      const Vector3f u = sample.direction.cast<float>();
      const float level = static_cast<float>((sample.level - sample.direction.dot(middle)) / s);
      depths.resize(sample.count);
      const HalfSpaceForce measured = measure(active, inside, u, level, move2, depths);
      const Vector3f target = (sample.force / (s2 * s)).cast<float>();
      const Vector3f error = target - measured.force;
      if (error.squaredNorm() <= kForceTolerance * kForceTolerance * target.squaredNorm()) continue;
      Matrix3d gram = measured.gram;
      const double damping = kDamping * gram.trace();
      if (!(damping > 0.0)) continue;
      gram.diagonal().array() += damping;
      const Vector3f multiplier =
          (step * sample.weight * (gram.inverse() * error.cast<double>())).cast<float>();
      applyCorrection(inside, depths, u, multiplier, move2, active);
    }
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::uint32_t i = order_[k];
    if (!pressed_[i]) continue;
    const Active& a = active[k];
    points[i].area = s2 * double(a.current[3]);
    if (move2 > 0.0f)
      points[i].position =
          middle + s * Vector3d(double(a.current[0]), double(a.current[1]), double(a.current[2]));
  }
}

}  // namespace abstand::shell
