// The parametric human: fourteen rigid parts from the height.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry/shape.hpp"
#include "humanmodel/joints.hpp"

namespace abstand {

enum class BodyPart : std::uint8_t {
  kTorso, kHead, kBicepsLeft, kBicepsRight, kForearmLeft, kForearmRight, kHandLeft, kHandRight,
  kThighLeft, kThighRight, kCalfLeft, kCalfRight, kFootLeft, kFootRight, kCount
};
inline constexpr std::size_t kBodyPartCount = static_cast<std::size_t>(BodyPart::kCount);

/// "torso", "biceps_left", ... as in scene files.
std::string_view partName(BodyPart part);
std::optional<BodyPart> parsePart(std::string_view name);

enum class Sex { kFemale, kMale };
enum class HumanPreset { kThesis, kAnthropometric };

/// What a user may override of one part; what is not set follows the preset. Metres.
struct PartOverride {
  std::optional<double> length, contour, breadth, depth;
  std::optional<std::string> shape;   ///< "ellipsoid" or "cuboid"
};

struct HumanOptions {
  double height{1.75};                       ///< m, 0.5 to 2.5
  std::optional<double> mass;                ///< kg, 10 to 300; without: from height (and sex)
  std::optional<Sex> sex;                    ///< without: the mean of both
  HumanPreset preset{HumanPreset::kAnthropometric};
  std::map<BodyPart, PartOverride> overrides;
};

/// One part in its own frame P: origin at the centre of the shape, z from the distal to the proximal joint
/// (up, when standing with the arms down; for the foot z is up and x points to the toes), x forward, y left.
struct HumanPart {
  BodyPart part{};
  Shape shape;             ///< Ellipsoid or Cuboid
  double length{0.0};      ///< m, along the segment
  double contour{0.0};     ///< m, circumference at the thickest place
  double mass{0.0};        ///< kg
  Vector3d com{Vector3d::Zero()};        ///< in P, m
  Matrix3d inertia{Matrix3d::Zero()};    ///< about the centre of mass, axes of P, kg m^2
  Joint proximal{}, distal{};            ///< the canonical joints that carry it
  Vector3d p_proximal{Vector3d::Zero()}; ///< in P
  Vector3d p_distal{Vector3d::Zero()};   ///< in P
};

/// Constant after construction.
struct HumanModel {
  HumanOptions options;
  double height{0.0}, mass{0.0};
  std::vector<HumanPart> parts;   ///< in the order of BodyPart
  SkeletonFrame rest;             ///< standing, arms down, facing +x, feet on z = 0, pelvis over the origin

  const HumanPart& part(BodyPart p) const { return parts[static_cast<std::size_t>(p)]; }
};

/// Throws UsageError for a height, mass or override out of range.
HumanModel makeHuman(const HumanOptions& options);

}  // namespace abstand
