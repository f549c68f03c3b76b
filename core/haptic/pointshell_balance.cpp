// Fine adjustment of a pointshell: presses into walls and row-action least squares.
#include "core/haptic/pointshell_balance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/parallel.hpp"

namespace abstand {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kDirections = 800;  ///< all around: one every 7 degrees
/// Spacings, in steps of equal ratio between them; shifted from direction to direction.
constexpr double kShallowest = 0.55, kDeepest = 2.2;
constexpr int kDepths = 6;
/// The steps of the directions about a crease: between its two normals, and along it. Two directions closer
/// than kSameDirection count as one.
constexpr double kBetween[] = {0.05, 0.25, 0.5, 0.75, 0.95};
constexpr double kAlong[] = {0.0, 0.03, -0.03, 0.08, -0.08};
constexpr double kSameDirection = 0.05;
/// Half-spaces with more points than this are right enough as they are; every kCoarse-th direction is kept
/// all the same, up to kMostCoarse points, so that nothing drifts.
constexpr std::size_t kMostPoints = 100, kMostCoarse = 1500, kCoarse = 16;
/// Points in all half-spaces; beyond, some are left out, so that a large body takes no longer.
constexpr std::size_t kMostVisits = 600'000;
constexpr int kSweeps = 5;
constexpr double kFirstStep = 1.0, kLastStep = 0.1;
/// Moving by this part of the spacing counts as much as changing the area by its whole.
constexpr double kMove = 0.7;
/// Points as much outside as this part of the spacing may still come in while they are moved.
constexpr double kMargin = 0.1;
/// Part of the trace that is added to the 3 x 3 systems, as a face alone gives only one direction of force.
constexpr double kDamping = 1e-3;
/// An overlap whose force is a smaller part than this of the sum without signs is no overlap: the two sides
/// of a sheet.
constexpr double kSheet = 1e-3;

std::vector<Vector3d> pressDirections(const std::vector<Crease>& creases) {
  std::vector<Vector3d> out;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const double turn = 2.0 * kPi * kGolden * i;
    out.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  std::set<std::array<int, 3>> seen;
  for (const Crease& crease : creases) {
    for (const double between : kBetween) {
      for (const double along : kAlong) {
        const Vector3d outwards =
            ((1.0 - between) * crease.normal[0] + between * crease.normal[1]).normalized();
        const Vector3d u = -(outwards + along * crease.along()).normalized();
        const Vector3i key = (u / kSameDirection).array().round().cast<int>();
        if (seen.insert({key.x(), key.y(), key.z()}).second) out.push_back(u);
      }
    }
  }
  return out;
}

/// Integral of depth times inward normal over the part of a triangle whose depth is positive, and of the
/// depth alone.
void addClipped(const Vector3d (&corner)[3], const double (&depth)[3], Vector3d& force, double& size) {
  const Vector3d cross = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  // Corners of the clipped polygon in barycentric coordinates of the second and third corner.
  struct {
    double b, c, d;
  } polygon[4];
  constexpr double kB[3] = {0.0, 1.0, 0.0}, kC[3] = {0.0, 0.0, 1.0};
  int n = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (depth[i] > 0.0) polygon[n++] = {kB[i], kC[i], depth[i]};
    if ((depth[i] > 0.0) != (depth[j] > 0.0)) {
      const double t = depth[i] / (depth[i] - depth[j]);
      polygon[n++] = {kB[i] + t * (kB[j] - kB[i]), kC[i] + t * (kC[j] - kC[i]), 0.0};
    }
  }
  double integral = 0.0;  // over the unit triangle, times 6
  for (int k = 1; k + 1 < n; ++k) {
    const auto &p = polygon[0], &q = polygon[k], &r = polygon[k + 1];
    integral += ((q.b - p.b) * (r.c - p.c) - (q.c - p.c) * (r.b - p.b)) * (p.d + q.d + r.d);
  }
  force -= integral / 6.0 * cross;
  size += integral / 6.0 * cross.norm();
}

/// A step coprime to n, so that i * step mod n visits all, neighbours far apart in time.
std::size_t stride(std::size_t n) {
  std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(kGolden * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

}  // namespace

ShellBalance::ShellBalance(const TriangleMesh& mesh, const std::vector<Crease>& creases, double spacing,
                           int threads)
    : spacing_(spacing) {
  const std::vector<Vector3d> directions = pressDirections(creases);
  std::vector<std::array<Press, kDepths>> found(directions.size());
  parallelFor(threads, directions.size(), [&](std::size_t k) {
    const Vector3d& u = directions[k];
    std::vector<double> height(mesh.vertices.size());
    double lowest = kInfinity;
    for (std::size_t v = 0; v < height.size(); ++v) {
      height[v] = u.dot(mesh.vertices[v]);
      lowest = std::min(lowest, height[v]);
    }
    const double shift = std::fmod(kGolden * static_cast<double>(k), 1.0);
    double size[kDepths] = {};
    for (int d = 0; d < kDepths; ++d) {
      const double depth = kShallowest * std::pow(kDeepest / kShallowest, (d + shift) / kDepths);
      found[k][d] = {u, lowest + depth * spacing, Vector3d::Zero(), std::min(1.0, std::pow(depth, 1.5)),
                     k % kCoarse == 0};
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.triangles[t];
      const double low = std::min({height[v[0]], height[v[1]], height[v[2]]});
      if (low >= found[k][kDepths - 1].level) continue;
      const Vector3d corner[3] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
      for (int d = 0; d < kDepths; ++d) {
        const double level = found[k][d].level;
        if (low >= level) continue;
        addClipped(corner, {level - height[v[0]], level - height[v[1]], level - height[v[2]]},
                   found[k][d].force, size[d]);
      }
    }
    for (int d = 0; d < kDepths; ++d) {
      if (!(found[k][d].force.norm() > kSheet * size[d])) found[k][d].weight = 0.0;
    }
  });
  for (const auto& presses : found) {
    for (const Press& press : presses) {
      if (press.weight > 0.0) presses_.push_back(press);
    }
  }
}

void ShellBalance::adjust(std::vector<BalancePoint>& points, Freedom freedom, int threads) const {
  // The points that each half-space holds.
  std::vector<std::vector<std::uint32_t>> inside(presses_.size());
  parallelFor(threads, presses_.size(), [&](std::size_t r) {
    const Press& press = presses_[r];
    const double level = press.level + (freedom == Freedom::kArea ? 0.0 : kMargin * spacing_);
    const std::size_t most = press.coarse ? kMostCoarse : kMostPoints;
    for (std::uint32_t i = 0; i < points.size() && inside[r].size() <= most; ++i) {
      if (press.direction.dot(points[i].position) < level) inside[r].push_back(i);
    }
    if (inside[r].size() > most) inside[r].clear();
  });
  std::vector<std::uint32_t> rows;
  std::size_t visits = 0;
  for (std::size_t i = 0, r = 0, step = stride(presses_.size()); i < presses_.size(); ++i) {
    r = (r + step) % presses_.size();
    if (inside[r].empty() || visits > kMostVisits) continue;
    rows.push_back(static_cast<std::uint32_t>(r));
    visits += inside[r].size();
  }

  const double move2 = freedom == Freedom::kArea ? 0.0 : kMove * kMove * spacing_ * spacing_;
  std::vector<double> depth;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double step = kFirstStep + (kLastStep - kFirstStep) * sweep / (kSweeps - 1);
    for (const std::uint32_t r : rows) {
      const Press& press = presses_[r];
      const Vector3d& u = press.direction;
      depth.clear();
      Vector3d force = Vector3d::Zero();
      // What unit changes of each point do to the force, squared: along its normal, as everything it does.
      double g00 = 0.0, g01 = 0.0, g02 = 0.0, g11 = 0.0, g12 = 0.0, g22 = 0.0;
      for (const std::uint32_t i : inside[r]) {
        const BalancePoint& p = points[i];
        const double d = press.level - u.dot(p.position);
        depth.push_back(d);
        if (d <= 0.0) continue;
        const Vector3d& n = p.normal;
        force += p.area * d * n;
        const double un = u.dot(n);
        const double g = p.home_area * p.home_area * (d * d + move2 * (1.0 - un * un));
        g00 += g * n.x() * n.x(), g01 += g * n.x() * n.y(), g02 += g * n.x() * n.z();
        g11 += g * n.y() * n.y(), g12 += g * n.y() * n.z(), g22 += g * n.z() * n.z();
      }
      const double damping = kDamping * (g00 + g11 + g22);
      if (!(damping > 0.0)) continue;
      Matrix3d gram;
      gram << g00 + damping, g01, g02, g01, g11 + damping, g12, g02, g12, g22 + damping;
      const Vector3d pull = step * press.weight * (gram.inverse() * (press.force - force));
      for (std::size_t k = 0; k < inside[r].size(); ++k) {
        if (depth[k] <= 0.0) continue;
        BalancePoint& p = points[inside[r][k]];
        const double g = p.home_area * p.normal.dot(pull);
        p.area = std::clamp(p.area + p.home_area * depth[k] * g, kLeastArea * p.home_area,
                            kMostArea * p.home_area);
        if (move2 == 0.0) continue;
        const Vector3d moved = p.position - move2 * g * (u - u.dot(p.normal) * p.normal) - p.home;
        const double length = moved.norm();
        p.position = p.home + (length > p.reach ? p.reach / length : 1.0) * moved;
      }
    }
  }
}

}  // namespace abstand
