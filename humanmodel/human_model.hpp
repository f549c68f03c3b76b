// The parametric human: fourteen rigid parts from the height.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry/shape.hpp"
#include "humanmodel/body_part.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::humanmodel {

enum class Sex { kFemale, kMale };
enum class HumanPreset { kThesis, kAnthropometric };

/// What a user may override of one part; what is not set follows the preset. Metres, 0.005 to 3.
/// Breadth is the extent from left to right (y), depth from back to front (x); for the foot depth is its
/// height (z). For a hand, whose thumb points forward, depth lies across the palm.
/// The contour alone scales breadth and depth together; with one of them it gives the other; all three at
/// once are too many and are refused. A new shape keeps the contour and the ratio of breadth to depth.
struct PartOverride {
  std::optional<double> length, contour, breadth, depth;
  std::optional<std::string> shape;  ///< "ellipsoid" or "cuboid"
};

inline constexpr double kUsualStature = 1.75;  ///< m, of a person of whom nothing else is said

struct HumanOptions {
  std::optional<double> height;  ///< m, 0.5 to 2.5; without: that of the percentile, else kUsualStature
  std::optional<double> mass;    ///< kg, 10 to 300; without: that of the percentile, else from height and sex
  std::optional<Sex> sex;        ///< without: the mean of both, a percentile that of both together
  /// Per cent, 1 to 99 (ANSUR II 2012), only with kAnthropometric: girths, breadths and depths that enclose
  /// those of so many of the people of that height (and mass, where it is given), as sectionsOfPercentile.
  /// Lengths stay means. Without: mean sizes.
  std::optional<double> percentile;
  HumanPreset preset{HumanPreset::kAnthropometric};
  std::map<BodyPart, PartOverride> overrides;
};

/// One part in its own frame P: origin at the centre of the shape, z from the distal to the proximal joint
/// (up, when standing with the arms down; for the foot z is up and x points to the toes), x forward, y left.
/// The torso hangs from the neck (proximal) to the pelvis (distal), the head from the vertex to the neck.
struct HumanPart {
  BodyPart part{};
  geometry::Shape shape;  ///< Ellipsoid or Cuboid
  /// m, along the segment: from joint to joint for arms and legs, wrist to finger tip, heel to toe, neck to
  /// vertex, the whole trunk. The thesis's shapes are exactly so long. An anthropometric ellipsoid reaches
  /// past its joints, since at a wrist or a knee a body has thickness where an ellipsoid would end in a
  /// point.
  double length{0.0};
  /// m, circumference at the thickest place: of the elliptic cross-section, or 2 (breadth + depth) of a
  /// cuboid.
  double contour{0.0};
  double breadth{0.0}, depth{0.0};        ///< m, full extents of the cross-section, as in PartOverride
  double mass{0.0};                       ///< kg
  Vector3d com{Vector3d::Zero()};         ///< in P, m
  Matrix3d inertia{Matrix3d::Zero()};     ///< about the centre of mass, axes of P, kg m^2
  Joint proximal{}, distal{};             ///< the canonical joints that carry it
  Vector3d p_proximal{Vector3d::Zero()};  ///< in P
  Vector3d p_distal{Vector3d::Zero()};    ///< in P
};

/// Constant after construction.
struct HumanModel {
  HumanOptions options;
  double height{0.0}, mass{0.0};
  std::vector<HumanPart> parts;  ///< in the order of BodyPart
  /// Standing, arms down, facing +x, feet on z = 0, pelvis over the origin. Every part's frame P then has the
  /// world's axes. The top of the head is at `height` unless lengths were overridden.
  SkeletonFrame rest;

  const HumanPart& part(BodyPart p) const { return parts[static_cast<std::size_t>(p)]; }
};

/// Throws UsageError for a height, mass, percentile or override out of range, for a mass that does not fit
/// the height (body mass index outside 8 to 100 kg/m^2), and for a percentile with kThesis.
HumanModel makeHuman(const HumanOptions& options);

}  // namespace abstand::humanmodel
