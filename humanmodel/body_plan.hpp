// What a preset decides: size of every kind of part and where the joints lie.
#pragma once

#include <array>

#include "humanmodel/cross_section.hpp"
#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Size of a part. Lengths in m.
struct Segment {
  PartShape shape{PartShape::kEllipsoid};
  double length{0.0}, breadth{0.0}, depth{0.0};  ///< as in HumanPart
  /// Girth that an ellipsoid still has at its two joints, as a share of its largest girth: 0 ends it in a
  /// point at the joint, more lets it reach past the joint. Below 1. Cuboids and feet do not use it.
  double proximal_share{0.0}, distal_share{0.0};
};

/// A body before overrides, left and right alike.
struct BodyPlan {
  std::array<Segment, kPartKindCount> segments;
  double ankle_height{0.0};    ///< m
  double toe_height{0.0};      ///< m, of the toe joint
  double heel_share{0.0};      ///< heel behind the ankle, share of the foot's length
  double hip_share{0.0};       ///< hip joints above the torso's lower end, share of the torso's length
  double shoulder_share{0.0};  ///< shoulder joints, likewise
  double shoulder_half{0.0};   ///< m, half the distance between the shoulder joints of a slim torso
  double shoulder_reach{0.0};  ///< m, the most that a shoulder joint stands out from the torso's side

  Segment& operator[](PartKind kind) { return segments[index(kind)]; }
  const Segment& operator[](PartKind kind) const { return segments[index(kind)]; }
};

/// Table B.1 of the thesis, its torso and head rows put right.
BodyPlan thesisPlan(double height);

/// ANSUR II by height (m), mass (kg; without: the mean body mass index) and sex. With a percentile the
/// girths, breadths and depths are those of sectionsOfPercentile; lengths are means.
BodyPlan anthropometricPlan(double height, std::optional<double> mass, std::optional<Sex> sex,
                            std::optional<double> percentile);

/// The segment with the user's wishes; `name` is for messages. Throws UsageError.
Segment overridden(const Segment& segment, const PartOverride& wish, std::string_view name);

}  // namespace abstand::humanmodel
