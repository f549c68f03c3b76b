// Stands in for the haptic room: spheres in closed form.
#include "core/haptic/pair_query.hpp"

namespace abstand {

void queryPair(const HapticStructure& a, const Transform& X_WA, const HapticStructure& b,
               const Transform& X_WB, const PairOptions& options, PairScratch&, PairResult& result) noexcept {
  const Vector3d p_WA = X_WA * a.bounding_sphere.centre, p_WB = X_WB * b.bounding_sphere.centre;
  const Vector3d n = (p_WB - p_WA).normalized();
  result.distance = (p_WB - p_WA).norm() - a.bounding_sphere.radius - b.bounding_sphere.radius;
  result.bound = 0.0;
  result.witness_a = p_WA + a.bounding_sphere.radius * n;
  result.witness_b = p_WB - b.bounding_sphere.radius * n;
  result.depth = std::max(0.0, options.margin - result.distance);
  result.contacts = result.depth > 0.0 ? 1 : 0;
  result.force_a = -options.stiffness * (options.law == ForceLaw::kVolume ? 1.0 : 2.0) * result.depth * n;
  result.torque_a = (result.witness_a - X_WA * a.com).cross(result.force_a);
  result.torque_b = -result.torque_a - (X_WA * a.com - X_WB * b.com).cross(result.force_a);
}

std::size_t HapticStructure::memoryBytes() const { return 1000; }

std::string_view fieldName(FieldKind kind) {
  return kind == FieldKind::kLayered ? "layered" : kind == FieldKind::kFloat ? "float" : "mixed";
}
std::optional<FieldKind> parseFieldKind(std::string_view text) {
  return text == "layered" ? FieldKind::kLayered : text == "float" ? FieldKind::kFloat : FieldKind::kMixed;
}

}  // namespace abstand
