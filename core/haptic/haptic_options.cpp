#include "core/haptic/haptic_options.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand {
namespace {

constexpr std::array<std::pair<FieldKind, std::string_view>, 3> kFieldNames{
    {{FieldKind::kLayered, "layered"}, {FieldKind::kFloat, "float"}, {FieldKind::kMixed, "mixed"}}};

// A grain of dust and a hall: nothing sensible lies outside.
constexpr double kSmallest = 1e-5, kLargest = 10.0;
constexpr int kMostLayers = 10000;

void requireLength(double value, const char* name) {
  if (!(value >= kSmallest && value <= kLargest))
    throw UsageError(std::string(name) + ": found " + formatDouble(value) + " m, expected " +
                     formatDouble(kSmallest) + " to " + formatDouble(kLargest));
}

}  // namespace

std::string_view fieldName(FieldKind kind) {
  for (const auto& [k, name] : kFieldNames)
    if (k == kind) return name;
  return "";
}

std::optional<FieldKind> parseFieldKind(std::string_view text) {
  for (const auto& [kind, name] : kFieldNames)
    if (name == text) return kind;
  return std::nullopt;
}

void HapticOptions::validate() const {
  requireLength(voxel_size, "voxel size");
  requireLength(point_spacing, "point spacing");
  if (outer_layers < 0 || outer_layers > kMostLayers)
    throw UsageError("outer layers: found " + std::to_string(outer_layers) + ", expected 0 to " +
                     std::to_string(kMostLayers));
}

}  // namespace abstand
