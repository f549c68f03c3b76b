// Certified lower bound of the distance of two non-convex bodies, from the hulls of their parts.
#include "core/query/parts_apart.hpp"

#include <algorithm>
#include <bit>

#include "core/kernels/search_kernels.hpp"
#include "core/query/separation.hpp"

namespace abstand::query {
namespace {

// m; spheres are transformed in float, for bodies within some metres.
constexpr double kSphereRounding = 2e-6;
constexpr int kSteps = 3;
constexpr std::size_t kMax = structure::SurfaceParts::kMax;

// Decodes the bits of SearchKernels::meeting.
std::size_t partOfPoints(int bit) { return static_cast<std::size_t>(bit) % kMax; }
std::size_t partOfField(int bit) { return static_cast<std::size_t>(bit) / kMax; }

Vector3d centre(const kernels::SphereGroup& s, std::size_t i) { return {s.x[i], s.y[i], s.z[i]}; }

/// Upper bound of the support function of a part (m times the length of g).
double partSupport(const structure::HapticStructure& body, std::size_t part, const Vector3d& g,
                   bool closely) {
  if (body.parts.size() > 1) return body.parts.hull(part).support(g);
  return closely ? body.support.closeUpper(g) : body.support.upper(g);
}

/// The same, and the point.
double partFarthest(const structure::HapticStructure& body, std::size_t part, const Vector3d& g,
                    structure::ExtremePoint& extreme) {
  return body.parts.size() > 1 ? body.parts.hull(part).farthest(g, extreme)
                               : body.support.farthest(g, extreme);
}

/// Support values of the parts of one body along one direction, computed on demand.
class SupportValues {
 public:
  SupportValues(const structure::HapticStructure& body, const Vector3d& g, bool closely)
      : body_(body), g_(g), closely_(closely) {}
  double operator()(std::size_t part) {
    if (!(computed_ >> part & 1)) {
      computed_ |= 1u << part;
      values_[part] = partSupport(body_, part, g_, closely_);
    }
    return values_[part];
  }

 private:
  const structure::HapticStructure& body_;
  const Vector3d g_;
  const bool closely_;
  double values_[kMax];
  unsigned computed_{0};
};

/// Surfaces that are apart may be nested. This excludes it for a surface of one component that extends beyond
/// the other's bounding sphere: on a minimal sphere, in every direction from the centre, some point of the
/// body lies no lower than the centre.
bool extendsBeyond(const structure::HapticStructure& body, const structure::HapticStructure& other,
                   double between_centres2) {
  const double r = body.bounding_sphere.radius, other_r = other.bounding_sphere.radius + kSphereRounding;
  return body.pieces.empty() && between_centres2 + r * r > other_r * other_r;
}

}  // namespace

structure::ExtremePoint partExtreme(const structure::HapticStructure& body, std::size_t part,
                                    const Vector3d& g) noexcept {
  return body.parts.size() == 1 ? body.support.extreme(g) : body.parts.hull(part).extreme(g);
}

FacingParts::FacingParts(const structure::HapticStructure& P, const structure::HapticStructure& F,
                         const Transform& X_FP, double by, bool closely, PartAxes& axes) noexcept
    : P_(P), F_(F), X_FP_(X_FP), by_(by + kPlaneRounding), closely_(closely), axes_(axes) {
  const double between_centres2 = (X_FP * P.bounding_sphere.centre - F.bounding_sphere.centre).squaredNorm();
  may_contain_ = !extendsBeyond(P, F, between_centres2) || !extendsBeyond(F, P, between_centres2);
  if (may_contain_) return;
  facing_ = kernels::searchKernels().meeting(P.treeView(X_FP).X_FP, P.parts.spheres(), F.parts.spheres(),
                                             F.parts.size(), static_cast<float>(by + kSphereRounding));
}

double FacingParts::slab(const Vector3d& n, std::size_t i, std::size_t j) const noexcept {
  return n.dot(X_FP_.translation()) - partSupport(P_, i, X_FP_.linear().transpose() * -n, closely_) -
         partSupport(F_, j, n, closely_);
}

// Frank-Wolfe iteration (1956): moves v to the nearest point of the segment to the support points, until a
// slab across v is wide enough or v is too short.
bool FacingParts::partsApart(const Parts& parts) noexcept {
  const auto [i, j] = parts;
  for (const Vector3d& n : axes_.n)
    if (!n.isZero() && slab(n, i, j) >= by_) return true;
  // At distances where 0.01 mm matters, hulls of parts rarely decide.
  if (closely_) return false;
  Vector3d v = X_FP_ * centre(P_.parts.spheres(), i) - centre(F_.parts.spheres(), j);
  for (int step = 0; step < kSteps; ++step) {
    const double length = v.norm();
    if (!(length >= by_)) return false;
    const Vector3d n = v / length;
    structure::ExtremePoint on_points, on_field;
    const double width = n.dot(X_FP_.translation()) -
                         partFarthest(P_, i, X_FP_.linear().transpose() * -n, on_points) -
                         partFarthest(F_, j, n, on_field);
    if (width >= by_) {
      axes_.n[axes_.next] = n;
      axes_.next = (axes_.next + 1) % PartAxes::kMax;
      return true;
    }
    const Vector3d direction = X_FP_ * on_points.point - on_field.point - v;
    const double length2 = direction.squaredNorm();
    if (!(length2 > 0.0)) return false;
    v += std::clamp(-v.dot(direction) / length2, 0.0, 1.0) * direction;
  }
  return false;
}

bool FacingParts::apart(const Vector3d& n, Parts& between) noexcept {
  between = {};
  if (may_contain_) return false;
  SupportValues of_points(P_, X_FP_.linear().transpose() * -n, closely_), of_field(F_, n, closely_);
  const double along = n.dot(X_FP_.translation());
  double smallest = kInfinity;
  std::uint64_t open = 0;
  int nearest = 0;
  for (std::uint64_t left = facing_; left != 0; left &= left - 1) {
    const int bit = std::countr_zero(left);
    const double slab = along - of_points(partOfPoints(bit)) - of_field(partOfField(bit));
    if (slab >= by_) continue;
    open |= std::uint64_t{1} << bit;
    if (slab < smallest) smallest = slab, nearest = bit;
  }
  // The nearest pair along n first, as it is the most likely to fail.
  for (int bit = nearest; open != 0; bit = std::countr_zero(open)) {
    between = {partOfPoints(bit), partOfField(bit)};
    if (!partsApart(between)) return false;
    open &= ~(std::uint64_t{1} << bit);
  }
  return true;
}

}  // namespace abstand::query
