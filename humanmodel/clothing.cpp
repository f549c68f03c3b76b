#include "humanmodel/clothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::humanmodel {
namespace {

struct Preset {
  std::string_view name;
  std::array<double, kPartKindCount> thickness;  ///< m, in the order of PartKind
};

// Assumptions of this project: jacket and trousers with folds, a lined coat, a helmet's shell with its
// distance to the head, the sole of a safety shoe.
constexpr std::array<Preset, 6> kPresets{{
    //               torso  head   biceps forearm hand   thigh  calf   foot
    {"work_clothes", {0.015, 0.000, 0.010, 0.010, 0.000, 0.010, 0.010, 0.000}},
    {"winter_clothes", {0.040, 0.010, 0.025, 0.025, 0.000, 0.020, 0.020, 0.000}},
    {"gloves", {0.000, 0.000, 0.000, 0.000, 0.003, 0.000, 0.000, 0.000}},
    {"thick_gloves", {0.000, 0.000, 0.000, 0.005, 0.010, 0.000, 0.000, 0.000}},
    {"helmet", {0.000, 0.040, 0.000, 0.000, 0.000, 0.000, 0.000, 0.000}},
    {"safety_shoes", {0.000, 0.000, 0.000, 0.000, 0.000, 0.000, 0.000, 0.025}},
}};

constexpr auto kPresetNames = [] {
  std::array<std::string_view, kPresets.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kPresets[i].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> clothingPresets() { return kPresetNames; }

bool addClothingPreset(std::string_view name, Clothing& clothing) {
  const auto preset =
      std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& p) { return p.name == name; });
  if (preset == kPresets.end()) return false;
  Clothing worn;
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    if (const double t = preset->thickness[index(kindOf(part))]; t > 0.0) worn[part] = t;
  }
  addClothing(worn, clothing);
  return true;
}

void addClothing(const Clothing& more, Clothing& clothing) {
  for (const auto& [part, thickness] : more) {
    double& here = clothing[part];
    here = std::max(here, thickness);
  }
}

geometry::Shape widened(const geometry::Shape& shape, double thickness) {
  if (!(thickness > 0.0)) return shape;
  if (const auto* cuboid = std::get_if<geometry::Cuboid>(&shape))
    return geometry::Cuboid{cuboid->size + Vector3d::Constant(2.0 * thickness)};
  const Vector3d a = std::get<geometry::Ellipsoid>(shape).semi_axes;
  const double p = a.norm() / (thickness * std::sqrt(3.0));
  const Vector3d squares =
      (1.0 + 1.0 / p) * a.cwiseAbs2() + Vector3d::Constant((1.0 + p) * thickness * thickness);
  return geometry::Ellipsoid{squares.cwiseSqrt()};
}

}  // namespace abstand::humanmodel
