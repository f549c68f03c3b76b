#include "core/mechanism/link_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <sstream>

namespace abstand::mechanism {
namespace {

// Share of the largest entry: rounding by printed digits and a rotation.
constexpr double kInertiaRounding = 1e-6;

/// Inertia of a unit point mass at r, about the origin.
Matrix3d ofPoint(const Vector3d& r) { return r.squaredNorm() * Matrix3d::Identity() - r * r.transpose(); }

std::string words(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace

LinkInertia inertiaOfSolid(const geometry::MassProperties& solid, double density, const Transform& X_FS) {
  return seenFrom(X_FS, {density * solid.volume, solid.com, density * solid.inertia});
}

LinkInertia seenFrom(const Transform& X_AF, const LinkInertia& body) {
  const Matrix3d R = X_AF.linear();
  return {body.mass, X_AF * body.com_F, R * body.inertia_F * R.transpose()};
}

LinkInertia together(const LinkInertia& a, const LinkInertia& b) {
  if (b.mass == 0.0 && b.inertia_F.isZero(0.0)) return a;
  if (a.mass == 0.0 && a.inertia_F.isZero(0.0)) return b;
  LinkInertia whole;
  whole.mass = a.mass + b.mass;
  if (whole.mass > 0.0) whole.com_F = (a.mass * a.com_F + b.mass * b.com_F) / whole.mass;
  whole.inertia_F = a.inertia_F + a.mass * ofPoint(a.com_F - whole.com_F) + b.inertia_F +
                    b.mass * ofPoint(b.com_F - whole.com_F);
  return whole;
}

std::string inertiaFault(const LinkInertia& body) {
  if (!std::isfinite(body.mass) || body.mass < 0.0)
    return "found mass " + words(body.mass) + ", expected a number of kg, 0 or more";
  if (!body.com_F.allFinite()) return "found a centre of mass that is not finite, expected metres";
  const Matrix3d& I = body.inertia_F;
  if (!I.allFinite()) return "found an inertia that is not finite, expected kg m^2";
  const double size = I.cwiseAbs().maxCoeff();
  if ((I - I.transpose()).cwiseAbs().maxCoeff() > kInertiaRounding * size)
    return "found an inertia that is not symmetric, expected a symmetric one";
  const double smallest = Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues()[0];
  if (smallest < -kInertiaRounding * size)
    return "found a principal moment of inertia of " + words(smallest) + " kg m^2, expected 0 or more";
  if (body.mass == 0.0 && size > 0.0) return "found an inertia without a mass, expected both or none";
  return {};
}

}  // namespace abstand::mechanism
