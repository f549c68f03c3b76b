// Fine adjustment of a pointshell: presses into walls and row-action least squares.
#include "core/haptic/pointshell_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/base/parallel.hpp"

namespace abstand {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kDirections = 1000;  ///< all around: one every 6 degrees
/// Spacings, in steps of equal ratio between them; shifted from direction to direction.
constexpr double kShallowest = 0.75, kDeepest = 2.2;
constexpr int kDepths = 5;
/// The steps of the directions about a crease: between its two normals, and along it. Two directions closer
/// than kSameDirection count as one.
constexpr double kBetween[] = {0.05, 0.25, 0.5, 0.75, 0.95};
constexpr double kAlong[] = {0.0, 0.03, -0.03, 0.055, -0.055, 0.09, -0.09};
constexpr double kSameDirection = 0.05;
/// A wall may lie along creases of equal directions that are so long together (spacings); a shorter one is no
/// more than any other place of the surface.
constexpr double kLongCrease = 3.0;
/// Half-spaces with more points than this are right enough as they are; every kCoarse-th direction is kept
/// all the same, up to kMostCoarse points, so that nothing drifts.
constexpr std::size_t kMostPoints = 400, kMostCoarse = 1500, kCoarse = 16;
/// Points in all half-spaces; beyond, some are left out, so that a large body takes no longer.
constexpr std::size_t kMostVisits = 600'000;
constexpr int kSweeps = 5, kAreaSweeps = 3;
/// Relative error of a force that is left as it is.
constexpr float kEnough = 0.001f;
constexpr double kFirstStep = 1.0, kLastStep = 0.1;
/// Moving by this part of the spacing counts as much as changing the area by its whole.
constexpr float kMove = 0.7f;
/// Points as much outside as this part of the spacing may still come in while they are moved.
constexpr double kMargin = 0.1;
/// Part of the trace that is added to the 3 x 3 systems, as a face alone gives only one direction of force.
constexpr double kDamping = 1e-3;

std::vector<Vector3d> pressDirections(const std::vector<Crease>& creases, double spacing) {
  std::vector<Vector3d> out;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const double turn = 2.0 * kPi * kGolden * i;
    out.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  std::map<std::array<int, 6>, double> length;
  const auto key = [](const Crease& crease) {
    std::array<int, 6> k;
    for (int i = 0; i < 6; ++i)
      k[i] = static_cast<int>(std::lround(crease.normal[i / 3][i % 3] / kSameDirection));
    return k;
  };
  for (const Crease& crease : creases) length[key(crease)] += (crease.end[1] - crease.end[0]).norm();
  std::set<std::array<int, 3>> seen;
  for (const Crease& crease : creases) {
    if (length[key(crease)] < kLongCrease * spacing) continue;
    for (const double between : kBetween) {
      for (const double along : kAlong) {
        const Vector3d outwards =
            ((1.0 - between) * crease.normal[0] + between * crease.normal[1]).normalized();
        const Vector3d u = -(outwards + along * crease.along()).normalized();
        const Vector3i rounded = (u / kSameDirection).array().round().cast<int>();
        if (seen.insert({rounded.x(), rounded.y(), rounded.z()}).second) out.push_back(u);
      }
    }
  }
  return out;
}

/// A step coprime to n, so that i * step mod n visits all, neighbours far apart in time.
std::size_t stride(std::size_t n) {
  std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(kGolden * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

constexpr std::size_t kLanes = 4;
using Lanes = Eigen::Array<float, kLanes, 1>;

/// What one direction's half-spaces should give, and their points.
struct Presses {
  double level[kDepths];
  Vector3d force[kDepths];
  double weight[kDepths];
  std::vector<std::uint32_t> points[kDepths];
};

}  // namespace

ShellBalance::ShellBalance(const HalfSpaceOverlap& body, const std::vector<Crease>& creases,
                           const std::vector<BalancePoint>& points, double spacing, int threads)
    : spacing_(spacing), pressed_(points.size(), false) {
  const std::vector<Vector3d> directions = pressDirections(creases, spacing);
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
    const std::size_t most = k % kCoarse == 0 ? kMostCoarse : kMostPoints;
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

  // Neighbouring directions far apart in time, so that one place is not mended twice in a row.
  const std::size_t n = directions.size() * kDepths, step = stride(n);
  for (std::size_t i = 0, r = 0; i < n && points_.size() <= kMostVisits; ++i, r = (r + step) % n) {
    const Presses& presses = found[r / kDepths];
    const std::size_t d = r % kDepths;
    const std::vector<std::uint32_t>& inside = presses.points[d];
    if (inside.empty()) continue;
    presses_.push_back({directions[r / kDepths], presses.level[d], presses.force[d], presses.weight[d],
                        static_cast<std::uint32_t>(points_.size()),
                        static_cast<std::uint32_t>(inside.size())});
    points_.insert(points_.end(), inside.begin(), inside.end());
    for (const std::uint32_t point : inside) pressed_[point] = true;
    while (points_.size() % kLanes != 0) points_.push_back(static_cast<std::uint32_t>(points.size()));
    presses_.back().count = static_cast<std::uint32_t>(points_.size()) - presses_.back().first;
  }
}

void ShellBalance::adjust(std::vector<BalancePoint>& points, Freedom freedom) const {
  // In float, about the middle of the points, with the spacing as unit. In fours: place and area, normal and
  // the area at first, the place at first and the reach.
  struct Active {
    Eigen::Array4f now, still, home;
  };
  const double s = spacing_, s2 = s * s;
  Vector3d middle = Vector3d::Zero();
  for (const BalancePoint& p : points) middle += p.home / static_cast<double>(points.size());
  const auto four = [](const Vector3d& v, double w) {
    return Eigen::Array4f(float(v.x()), float(v.y()), float(v.z()), float(w));
  };
  std::vector<Active> active;
  active.reserve(points.size() + 1);
  for (const BalancePoint& p : points) {
    active.push_back({four((p.position - middle) / s, p.area / s2), four(p.normal, p.home_area / s2),
                      four((p.home - middle) / s, p.reach / s)});
  }
  // Padding of the presses.
  active.push_back({Eigen::Array4f::Zero(), Eigen::Array4f::Zero(), Eigen::Array4f::Zero()});

  const float move2 = freedom == Freedom::kArea ? 0.0f : kMove * kMove;
  const int sweeps = freedom == Freedom::kArea ? kAreaSweeps : kSweeps;
  std::vector<float> depths;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const double step = kFirstStep + (kLastStep - kFirstStep) * sweep / (sweeps - 1);
    for (const Press& press : presses_) {
      const std::uint32_t* inside = &points_[press.first];
      const Vector3f u = press.direction.cast<float>();
      const float level = static_cast<float>((press.level - press.direction.dot(middle)) / s);
      depths.resize(press.count);
      // What the force is, and what unit changes of each point do to it, squared: along its normal, as
      // everything it does.
      Lanes fx = Lanes::Zero(), fy = fx, fz = fx, g00 = fx, g01 = fx, g02 = fx, g11 = fx, g12 = fx, g22 = fx;
      for (std::uint32_t k = 0; k < press.count; k += kLanes) {
        const Active &a = active[inside[k]], &b = active[inside[k + 1]], &c = active[inside[k + 2]],
                     &d = active[inside[k + 3]];
        const auto now = [&](int i) { return Lanes(a.now[i], b.now[i], c.now[i], d.now[i]); };
        const auto still = [&](int i) { return Lanes(a.still[i], b.still[i], c.still[i], d.still[i]); };
        const Lanes nx = still(0), ny = still(1), nz = still(2), home = still(3);
        const Lanes depth = (level - u.x() * now(0) - u.y() * now(1) - u.z() * now(2)).max(0.0f);
        Lanes::Map(&depths[k]) = depth;
        const Lanes push = now(3) * depth;
        fx += push * nx, fy += push * ny, fz += push * nz;
        const Lanes un = u.x() * nx + u.y() * ny + u.z() * nz;
        const Lanes g =
            (depth > 0.0f).select(home * home * (depth * depth + move2 * (1.0f - un * un)), Lanes::Zero());
        const Lanes gx = g * nx, gy = g * ny;
        g00 += gx * nx, g01 += gx * ny, g02 += gx * nz, g11 += gy * ny, g12 += gy * nz, g22 += g * nz * nz;
      }
      const Vector3f wanted = (press.force / (s2 * s)).cast<float>();
      const Vector3f error = wanted - Vector3f(fx.sum(), fy.sum(), fz.sum());
      if (error.squaredNorm() <= kEnough * kEnough * wanted.squaredNorm()) continue;
      Matrix3d gram;
      gram << g00.sum(), g01.sum(), g02.sum(), g01.sum(), g11.sum(), g12.sum(), g02.sum(), g12.sum(),
          g22.sum();
      const double damping = kDamping * gram.trace();
      if (!(damping > 0.0)) continue;
      gram.diagonal().array() += damping;
      const Vector3f pull = (step * press.weight * (gram.inverse() * error.cast<double>())).cast<float>();
      const Eigen::Array4f pull4(pull.x(), pull.y(), pull.z(), 0.0f), u4(u.x(), u.y(), u.z(), 0.0f);
      for (std::uint32_t k = 0; k < press.count; ++k) {
        if (depths[k] <= 0.0f) continue;
        Active& p = active[inside[k]];
        const float home_area = p.still[3], g = home_area * (p.still * pull4).sum();
        const float area =
            std::clamp(p.now[3] + home_area * depths[k] * g, kLeastArea * home_area, kMostArea * home_area);
        if (move2 > 0.0f) {
          Eigen::Array4f moved = p.now - p.home - move2 * g * (u4 - (u4 * p.still).sum() * p.still);
          moved[3] = 0.0f;
          const float length2 = moved.square().sum(), reach = p.home[3];
          if (length2 > reach * reach) moved *= reach / std::sqrt(length2);
          p.now = p.home + moved;
        }
        p.now[3] = area;
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!pressed_[i]) continue;
    const Active& a = active[i];
    points[i].area = s2 * double(a.now[3]);
    if (move2 > 0.0f) points[i].position = middle + s * a.now.head<3>().matrix().cast<double>();
  }
}

}  // namespace abstand
