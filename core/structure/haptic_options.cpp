// User options of a haptic structure.
#include "core/structure/haptic_options.hpp"

#include <cmath>
#include <string>

#include "core/base/error.hpp"

namespace abstand::structure {
namespace {

// m: from a grain of dust to a hall.
constexpr double kMinPitch = 1e-5;
constexpr double kMaxPitch = 10.0;
constexpr int kMaxOuterLayers = 10'000;

void requireLength(const char* name, double value) {
  if (std::isfinite(value) && value >= kMinPitch && value <= kMaxPitch) return;
  throw UsageError(std::string(name) + " is " + std::to_string(value) + " m; it must lie between " +
                   std::to_string(kMinPitch) + " and " + std::to_string(kMaxPitch) + " m");
}

}  // namespace

std::string_view fieldName(FieldKind kind) {
  switch (kind) {
    case FieldKind::kLayered:
      return "layered";
    case FieldKind::kFloat:
      return "float";
    case FieldKind::kMixed:
      return "mixed";
  }
  return "";
}

std::optional<FieldKind> parseFieldKind(std::string_view text) {
  for (const FieldKind kind : {FieldKind::kLayered, FieldKind::kFloat, FieldKind::kMixed}) {
    if (text == fieldName(kind)) return kind;
  }
  return std::nullopt;
}

void HapticOptions::validate() const {
  requireLength("the voxel size", voxel_size);
  requireLength("the point spacing", point_spacing);
  if (outer_layers < 0 || outer_layers > kMaxOuterLayers) {
    throw UsageError("the number of outer layers is " + std::to_string(outer_layers) +
                     "; it must lie between 0 and " + std::to_string(kMaxOuterLayers));
  }
}

}  // namespace abstand::structure
