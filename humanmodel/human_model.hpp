// The parametric human: fourteen rigid parts from stature, mass and sex.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry/shape.hpp"
#include "humanmodel/body_part.hpp"
#include "humanmodel/clothing.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::humanmodel {

enum class Sex { kFemale, kMale };
enum class HumanPreset { kThesis, kAnthropometric };

/// User overrides of one part; unset values follow the preset. Metres, 0.005 to 3. Breadth is the extent from
/// left to right (y), depth from back to front (x); for the foot depth is its height (z). For a hand, whose
/// thumb points forward, depth is across the palm. `contour` (girth) alone scales breadth and depth together;
/// with one of them it determines the other; all three are refused. A new shape keeps girth and ratio of
/// breadth to depth.
struct PartOverride {
  std::optional<double> length, contour, breadth, depth;
  std::optional<std::string> shape;  ///< "ellipsoid" or "cuboid"
};

inline constexpr double kUsualStature = 1.75;  ///< m, default stature

struct HumanOptions {
  std::optional<double> height;  ///< stature, m, 0.5 to 2.5; without: that of the percentile, otherwise
                                 ///< kUsualStature
  std::optional<double> mass;    ///< kg, 10 to 300; without: from the body mass index (that of the
                                 ///< percentile's stature and mass, otherwise the mean of the sex)
  std::optional<Sex> sex;        ///< without: mean of both; percentiles of both together
  /// Per cent, 1 to 99 (ANSUR II 2012), only with kAnthropometric: girths, breadths and depths enclose those
  /// of this percentage of the people of that stature (and mass, if given), as sectionsOfPercentile. Lengths
  /// stay means. Without: mean sizes.
  std::optional<double> percentile;
  HumanPreset preset{HumanPreset::kAnthropometric};
  std::map<BodyPart, PartOverride> overrides;
  Clothing clothing;  ///< m, 0 to kMaxClothing; changes the shapes alone
};

/// One part in its own frame P: origin at the centre of the shape, z from the distal to the proximal joint
/// (up, standing with the arms down; for the foot z is up and x points to the toes), x forward, y left. The
/// torso extends from the neck (proximal) to the pelvis (distal), the head from the vertex to the neck.
struct HumanPart {
  BodyPart part{};
  geometry::Shape shape;  ///< Ellipsoid or Cuboid, with clothing
  geometry::Shape bare;   ///< without clothing
  /// m, along the segment: from joint to joint for arms and legs, wrist to finger tip, heel to toe, neck to
  /// vertex, the whole trunk. The thesis's shapes have exactly this length. An anthropometric ellipsoid
  /// extends beyond its joints, since a wrist or a knee has thickness where an ellipsoid would end in a
  /// point.
  double length{0.0};
  /// m, girth at the thickest place: of the elliptic cross-section, or 2 (breadth + depth) of a cuboid.
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
  /// Rest pose: standing, arms down, facing +x, feet on z = 0, pelvis above the origin. Every part's frame P
  /// then has the world's axes. The vertex is at `height` unless lengths were overridden.
  SkeletonFrame rest;

  const HumanPart& part(BodyPart p) const { return parts[static_cast<std::size_t>(p)]; }
};

/// Throws UsageError for a stature, mass, percentile, override or clothing out of range, for a mass that does
/// not fit the stature (body mass index outside of 8 to 100 kg/m^2), and for a percentile with kThesis.
HumanModel makeHuman(const HumanOptions& options);

}  // namespace abstand::humanmodel
