// Sections of the mean person.
#include "humanmodel/body_sections.hpp"

#include <algorithm>

#include "core/math/transform.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/cross_section.hpp"

namespace abstand::humanmodel {
namespace {

// Height of the instep above the sole: that of the ankle, share of stature.
constexpr double kFootHeight = .042;

Section roundSection(double girth) { return {girth / kPi, girth / kPi, girth}; }

}  // namespace

BodySections meanSections(double height, std::optional<double> mass, std::optional<Sex> sex) {
  using enum GirthPlace;
  const BodyMeasures m = measuresOf(height, mass ? *mass : meanBodyMassIndex(sex) * (height * height), sex);
  BodySections s;
  s[kChest] = {m.chest_breadth, m.chest_depth, m.chest_girth};
  s[kWaist] = {m.waist_breadth, m.waist_depth, m.waist_girth};
  s[kButtock] = {m.hip_breadth, m.buttock_depth, m.buttock_girth};
  // Measured breadth and depth of the head give the ratio, its girth the size.
  const double head_scale = m.head_girth / contourOf(PartShape::kEllipsoid, m.head_breadth, m.head_depth);
  s[kHead] = {m.head_breadth * head_scale, m.head_depth * head_scale, m.head_girth};
  s[kNeck] = roundSection(m.neck_girth);
  s[kBiceps] = roundSection(m.biceps_girth);
  s[kForearm] = roundSection(m.forearm_girth);
  // The palm of a hanging arm faces the thigh: its breadth lies along x.
  s[kHand] = {extentFor(PartShape::kEllipsoid, m.hand_girth, m.hand_breadth), m.hand_breadth, m.hand_girth};
  s[kThigh] = roundSection(m.thigh_girth);
  s[kCalf] = roundSection(m.calf_girth);
  s[kFoot] = {m.foot_breadth, height * kFootHeight, m.ball_girth};
  return s;
}

double largestGirthInside(const Section& given, const Section& mean) {
  return mean.girth * std::min(given.breadth / mean.breadth, given.depth / mean.depth);
}

}  // namespace abstand::humanmodel
