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
constexpr float kEnough = 0.001f;
constexpr double kFirstStep = 1.0, kLastStep = 0.1;
/// Weight of moves against area changes: moving by this share of the spacing counts as changing the area by
/// 100 %.
constexpr float kMove = 0.7f;
/// Points outside by up to this share of the spacing are included, as they may enter while being moved.
constexpr double kMargin = 0.1;
/// Share of the trace added to the diagonal of the 3 x 3 systems: a single face gives a rank-1 system.
constexpr double kDamping = 1e-3;

std::vector<Vector3d> pressDirections(const std::vector<SharpEdge>& sharp_edges, double spacing) {
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

constexpr std::size_t kBalanceLanes = 4;

/// Working copy of a point in float, relative to the mean position, in units of the spacing.
struct Active {
  Four now;    ///< position and area
  Four still;  ///< normal and initial area
  Four home;   ///< initial position and largest distance from it
};

Four four(const Vector3d& v, double w) { return Four{float(v.x()), float(v.y()), float(v.z()), float(w)}; }

/// Four points as a structure of arrays.
struct Columns {
  Four x, y, z, w;
  Columns(Four a, Four b, Four c, Four d) : x(a), y(b), z(c), w(d) { transpose(x, y, z, w); }
};

/// Force of a half-space, and the Gram matrix of its derivatives by the points' changes; both act along the
/// point normals.
struct Pressed {
  Vector3f force;
  Matrix3d gram;
};

/// Also sets `depths`.
Pressed measure(const std::vector<Active>& active, std::span<const std::uint32_t> inside, const Vector3f& u,
                float level, float move2, std::vector<float>& depths) {
  Four fx{}, fy{}, fz{}, g00{}, g01{}, g02{}, g11{}, g12{}, g22{};
  for (std::size_t k = 0; k < inside.size(); k += kBalanceLanes) {
    const Active &a = active[inside[k]], &b = active[inside[k + 1]], &c = active[inside[k + 2]],
                 &d = active[inside[k + 3]];
    const Columns now(a.now, b.now, c.now, d.now), still(a.still, b.still, c.still, d.still);
    const Four nx = still.x, ny = still.y, nz = still.z, home = still.w;
    const Four depth = max(level - u.x() * now.x - u.y() * now.y - u.z() * now.z, Four{});
    storeFour(depth, &depths[k]);
    const Four push = now.w * depth;
    fx += push * nx, fy += push * ny, fz += push * nz;
    const Four un = u.x() * nx + u.y() * ny + u.z() * nz;
    const Four g = depth > 0.0f ? home * home * (depth * depth + move2 * (1.0f - un * un)) : Four{};
    const Four gx = g * nx, gy = g * ny;
    g00 += gx * nx, g01 += gx * ny, g02 += gx * nz, g11 += gy * ny, g12 += gy * nz, g22 += g * nz * nz;
  }
  Pressed pressed;
  pressed.force = {sumOf(fx), sumOf(fy), sumOf(fz)};
  const double xy = double(sumOf(g01)), xz = double(sumOf(g02)), yz = double(sumOf(g12));
  pressed.gram << double(sumOf(g00)), xy, xz, xy, double(sumOf(g11)), yz, xz, yz, double(sumOf(g22));
  return pressed;
}

/// Applies the Kaczmarz step `pull`: changes areas, and positions if move2 is not 0.
void mend(std::span<const std::uint32_t> inside, const std::vector<float>& depths, const Vector3f& u,
          const Vector3f& pull, float move2, std::vector<Active>& active) {
  for (std::size_t k = 0; k < inside.size(); k += kBalanceLanes) {
    const Four depth = load(&depths[k]);
    const FourInts in = depth > 0.0f;
    if (bits(in) == 0) continue;
    Active &a = active[inside[k]], &b = active[inside[k + 1]], &c = active[inside[k + 2]],
           &d = active[inside[k + 3]];
    Columns now(a.now, b.now, c.now, d.now);
    const Columns still(a.still, b.still, c.still, d.still);
    const Four g = still.w * (still.x * pull.x() + still.z * pull.z() + still.y * pull.y());
    const Four area = min(max(now.w + still.w * depth * g, QuadratureCorrection::kMinArea * still.w),
                          QuadratureCorrection::kMaxArea * still.w);
    now.w = in ? area : now.w;
    if (move2 > 0.0f) {
      const Columns home(a.home, b.home, c.home, d.home);
      const Four un = u.x() * still.x + u.z() * still.z + u.y() * still.y, back = move2 * g;
      const Four x = now.x - home.x - back * (u.x() - un * still.x),
                 y = now.y - home.y - back * (u.y() - un * still.y),
                 z = now.z - home.z - back * (u.z() - un * still.z);
      const Four length2 = x * x + z * z + y * y, one = splat(1.0f);
      const Four shorter = length2 > home.w * home.w ? home.w / sqrt(length2) : one;
      now.x = in ? home.x + x * shorter : now.x;
      now.y = in ? home.y + y * shorter : now.y;
      now.z = in ? home.z + z * shorter : now.z;
    }
    transpose(now.x, now.y, now.z, now.w);
    a.now = now.x, b.now = now.y, c.now = now.z, d.now = now.w;
  }
}

/// Half-spaces of one direction: exact forces and points.
struct Presses {
  double level[kDepths];
  Vector3d force[kDepths];
  double weight[kDepths];
  std::vector<std::uint32_t> points[kDepths];
};

}  // namespace

QuadratureCorrection::QuadratureCorrection(const HalfSpaceOverlap& body,
                                           const std::vector<SharpEdge>& sharp_edges,
                                           const std::vector<BalancePoint>& points, double spacing,
                                           int threads)
    : spacing_(spacing), pressed_(points.size(), false) {
  const std::vector<Vector3d> directions = pressDirections(sharp_edges, spacing);
  std::vector<Vector3f> places;
  for (const BalancePoint& p : points) places.push_back(p.position.cast<float>());
  const PointsBelow points_below(places);
  std::vector<Presses> found(directions.size());
  parallelFor(threads, directions.size(), [&](std::size_t k) {
    const Vector3d& u = directions[k];
    const Vector3f uf = u.cast<float>();
    Presses& presses = found[k];
    const double lowest = body.lowest(u);
    const double shift = std::fmod(kGolden * static_cast<double>(k), 1.0);
    const std::size_t most = k % kCoarse == 0 ? kMaxCoarse : kMaxPoints;
    int depths = 0;
    for (; depths < kDepths; ++depths) {
      const double depth = kShallowest * std::pow(kDeepest / kShallowest, (depths + shift) / kDepths);
      const double level = lowest + depth * spacing;
      std::vector<std::uint32_t>& inside = presses.points[depths];
      points_below.find(uf, static_cast<float>(level + kMargin * spacing), most, inside);
      if (inside.size() > most) inside.clear();
      if (inside.empty() && depths > 0) break;
      presses.level[depths] = level;
      presses.weight[depths] = std::min(1.0, std::pow(depth, 1.5));
    }
    if (depths == 0) return;
    const auto count = static_cast<std::size_t>(depths);
    body.forces(u, {presses.level, count}, {presses.force, count});
    for (std::size_t d = 0; d < count; ++d)
      if (presses.force[d].isZero(0.0)) presses.points[d].clear();
  });

  order_ = points_below.order();
  std::vector<std::uint32_t> place(points.size());
  for (std::uint32_t k = 0; k < order_.size(); ++k) place[order_[k]] = k;
  // Neighbouring directions are processed at distant times, so that no place is corrected twice in a row.
  const std::size_t n = directions.size() * kDepths, step = stride(n);
  for (std::size_t i = 0, r = 0; i < n && points_.size() <= kMaxVisits; ++i, r = (r + step) % n) {
    const Presses& presses = found[r / kDepths];
    const std::size_t d = r % kDepths;
    const std::vector<std::uint32_t>& inside = presses.points[d];
    if (inside.empty()) continue;
    presses_.push_back({directions[r / kDepths], presses.level[d], presses.force[d], presses.weight[d],
                        static_cast<std::uint32_t>(points_.size()),
                        static_cast<std::uint32_t>(inside.size())});
    for (const std::uint32_t point : inside) {
      points_.push_back(place[point]);
      pressed_[point] = true;
    }
    while (points_.size() % kBalanceLanes != 0) points_.push_back(static_cast<std::uint32_t>(points.size()));
    presses_.back().count = static_cast<std::uint32_t>(points_.size()) - presses_.back().first;
  }
}

void QuadratureCorrection::adjust(std::vector<BalancePoint>& points, Freedom freedom) const {
  const double s = spacing_, s2 = s * s;
  Vector3d middle = Vector3d::Zero();
  for (const BalancePoint& p : points) middle += p.home / static_cast<double>(points.size());
  std::vector<Active> active;
  active.reserve(points.size() + 1);
  for (const std::uint32_t i : order_) {
    const BalancePoint& p = points[i];
    active.push_back({four((p.position - middle) / s, p.area / s2), four(p.normal, p.home_area / s2),
                      four((p.home - middle) / s, p.reach / s)});
  }
  // Padding of the presses.
  active.push_back(Active{});

  const float move2 = freedom == Freedom::kArea ? 0.0f : kMove * kMove;
  const int sweeps = freedom == Freedom::kArea ? kAreaSweeps : kSweeps;
  std::vector<float> depths;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const double step = kFirstStep + (kLastStep - kFirstStep) * sweep / (sweeps - 1);
    for (const Press& press : presses_) {
      const std::span<const std::uint32_t> inside(&points_[press.first], press.count);
      const Vector3f u = press.direction.cast<float>();
      const float level = static_cast<float>((press.level - press.direction.dot(middle)) / s);
      depths.resize(press.count);
      const Pressed pressed = measure(active, inside, u, level, move2, depths);
      const Vector3f wanted = (press.force / (s2 * s)).cast<float>();
      const Vector3f error = wanted - pressed.force;
      if (error.squaredNorm() <= kEnough * kEnough * wanted.squaredNorm()) continue;
      Matrix3d gram = pressed.gram;
      const double damping = kDamping * gram.trace();
      if (!(damping > 0.0)) continue;
      gram.diagonal().array() += damping;
      const Vector3f pull = (step * press.weight * (gram.inverse() * error.cast<double>())).cast<float>();
      mend(inside, depths, u, pull, move2, active);
    }
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::uint32_t i = order_[k];
    if (!pressed_[i]) continue;
    const Active& a = active[k];
    points[i].area = s2 * double(a.now[3]);
    if (move2 > 0.0f)
      points[i].position = middle + s * Vector3d(double(a.now[0]), double(a.now[1]), double(a.now[2]));
  }
}

}  // namespace abstand::shell
