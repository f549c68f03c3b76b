// Smallest enclosing sphere: a basis of at most four points, updated with the farthest point.
#include "core/geometry/enclosing_sphere.hpp"

#include <array>

namespace abstand::geometry {
namespace {

/// Relative; a point outside by less than this leaves the basis unchanged.
constexpr double kTolerance = 1e-13;

/// At most four points that determine a sphere; the radius is squared.
struct Basis {
  std::array<Vector3d, 4> point;
  int count{0};
  Vector3d centre{Vector3d::Zero()};
  double radius2{-1.0};
};

/// Sphere with all points of the basis on its surface and its centre in their affine hull. False if the
/// points are affinely dependent; a smaller basis gives the sphere then.
bool circumscribe(Basis& basis) {
  const int n = basis.count - 1;
  const Vector3d& origin = basis.point[0];
  Eigen::Matrix<double, 3, 3> q = Matrix3d::Zero();
  for (int i = 0; i < n; ++i) q.col(i) = basis.point[i + 1] - origin;
  Vector3d offset = Vector3d::Zero();
  if (n == 1) {
    offset = 0.5 * q.col(0);
  } else if (n == 2) {
    const Vector3d a = q.col(0), b = q.col(1), normal = a.cross(b);
    if (!(normal.squaredNorm() > 1e-24 * a.squaredNorm() * b.squaredNorm())) return false;
    offset = (a.squaredNorm() * b - b.squaredNorm() * a).cross(normal) / (2.0 * normal.squaredNorm());
  } else if (n == 3) {
    const double volume = q.determinant();
    if (!(std::abs(volume) > 1e-12 * q.col(0).norm() * q.col(1).norm() * q.col(2).norm())) return false;
    offset = (q.col(0).squaredNorm() * q.col(1).cross(q.col(2)) +
              q.col(1).squaredNorm() * q.col(2).cross(q.col(0)) +
              q.col(2).squaredNorm() * q.col(0).cross(q.col(1))) /
             (2.0 * volume);
  }
  basis.centre = origin + offset;
  basis.radius2 = offset.squaredNorm();
  return true;
}

/// Smallest sphere around the points of `old` and `added`. `added` lies outside of old's sphere, so it
/// belongs to the new basis.
Basis extend(const Basis& old, const Vector3d& added) {
  Basis best;
  for (unsigned subset = 0; subset < 1u << old.count; ++subset) {
    Basis trial;
    trial.point[trial.count++] = added;
    for (int i = 0; i < old.count && trial.count < 4; ++i) {
      if ((subset >> i & 1u) != 0) trial.point[trial.count++] = old.point[i];
    }
    if (!circumscribe(trial) || (best.count > 0 && trial.radius2 >= best.radius2)) continue;
    bool holds_all = true;
    for (int i = 0; i < old.count; ++i) {
      holds_all = holds_all && (old.point[i] - trial.centre).squaredNorm() <= trial.radius2 * (1.0 + 1e-12);
    }
    if (holds_all) best = trial;
  }
  return best;
}

}  // namespace

EnclosingSphere minimalSphere(const std::vector<Vector3d>& points) {
  if (points.empty()) return {};
  Basis basis;
  basis.point[0] = basis.centre = points.front();
  basis.count = 1;
  basis.radius2 = 0.0;
  for (;;) {
    double farthest2 = -1.0;
    const Vector3d* farthest = nullptr;
    for (const Vector3d& p : points) {
      const double d2 = (p - basis.centre).squaredNorm();
      if (d2 > farthest2) farthest2 = d2, farthest = &p;
    }
    if (farthest2 > basis.radius2 * (1.0 + kTolerance)) {
      const Basis next = extend(basis, *farthest);
      // The radius grows at every step except for rounding; no growth means convergence.
      if (next.count > 0 && next.radius2 > basis.radius2) {
        basis = next;
        continue;
      }
    }
    return {basis.centre, std::sqrt(farthest2)};
  }
}

}  // namespace abstand::geometry
