// Body plan of a preset: sizes of all kinds of parts and positions of the joints.
#pragma once

#include <array>

#include "humanmodel/cross_section.hpp"
#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Size of a part. Lengths in m.
struct Segment {
  PartShape shape{PartShape::kEllipsoid};
  double length{0.0}, breadth{0.0}, depth{0.0};  ///< as in HumanPart
  /// Girth of an ellipsoid at its two joints, as a share of its largest girth: 0 means that it ends in a
  /// point at the joint; larger values extend it beyond the joint. Below 1. Not used for cuboids and feet.
  double proximal_share{0.0}, distal_share{0.0};
};

/// A body before overrides, symmetric.
struct BodyPlan {
  std::array<Segment, kPartKindCount> segments;
  double ankle_height{0.0};    ///< m
  double toe_height{0.0};      ///< m, of the toe joint
  double heel_share{0.0};      ///< heel behind the ankle, share of the foot's length
  double hip_share{0.0};       ///< height of the hip joints above the torso's lower end, share of the torso's
                               ///< length
  double shoulder_share{0.0};  ///< height of the shoulder joints, likewise
  double shoulder_half{0.0};   ///< m, half the distance between the shoulder joints of a slim torso
  double shoulder_reach{0.0};  ///< m, largest distance of a shoulder joint from the torso's side

  Segment& operator[](PartKind kind) { return segments[index(kind)]; }
  const Segment& operator[](PartKind kind) const { return segments[index(kind)]; }
};

/// Table B.1 of the thesis, with its torso and head rows exchanged.
BodyPlan thesisPlan(double height);

/// Body plan from ANSUR II by stature `height` (m), mass (kg; without: mean body mass index) and sex. With a
/// percentile, girths, breadths and depths are those of sectionsOfPercentile; lengths are means.
BodyPlan anthropometricPlan(double height, std::optional<double> mass, std::optional<Sex> sex,
                            std::optional<double> percentile);

/// The segment with the user's overrides; `name` is used in messages. Throws UsageError.
Segment overridden(const Segment& segment, const PartOverride& requested, std::string_view name);

}  // namespace abstand::humanmodel
