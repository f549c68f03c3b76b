// The table of de Leva 1996 and its mapping to part frames.
#include "humanmodel/segment_inertia.hpp"

namespace abstand::humanmodel {
namespace {

/// Shares of body mass and of segment length; centre of mass from the proximal end.
struct InertiaRow {
  double mass, com, sagittal, transverse, longitudinal;
};
using Table = std::array<InertiaRow, kPartKindCount>;

constexpr Table kMen{{{.4346, .5138, .328, .306, .169},
                      {.0694, .5002, .303, .315, .261},
                      {.0271, .5772, .285, .269, .158},
                      {.0162, .4574, .276, .265, .121},
                      {.0061, .7900, .628, .513, .401},
                      {.1416, .4095, .329, .329, .149},
                      {.0433, .4459, .255, .249, .103},
                      {.0137, .4415, .257, .245, .124}}};
constexpr Table kWomen{{{.4257, .4964, .307, .292, .147},
                        {.0668, .4841, .271, .295, .261},
                        {.0255, .5754, .278, .260, .148},
                        {.0138, .4559, .261, .257, .094},
                        {.0056, .7474, .531, .454, .335},
                        {.1478, .3612, .369, .364, .162},
                        {.0481, .4416, .271, .267, .093},
                        {.0129, .4014, .299, .279, .124}}};

// Wrist to third knuckle as a share of wrist to finger tip (de Leva, table 4: 86.2 of 187.9 mm; the same for
// women).
constexpr double kKnuckleShare = 0.459;

InertiaRow rowOf(PartKind kind, std::optional<Sex> sex) {
  const InertiaRow& m = kMen[index(kind)];
  const InertiaRow& f = kWomen[index(kind)];
  if (sex) return *sex == Sex::kMale ? m : f;
  return {0.5 * (m.mass + f.mass), 0.5 * (m.com + f.com), 0.5 * (m.sagittal + f.sagittal),
          0.5 * (m.transverse + f.transverse), 0.5 * (m.longitudinal + f.longitudinal)};
}

}  // namespace

void assignInertia(double mass, std::optional<Sex> sex, std::vector<HumanPart>& parts) {
  // The rounded shares sum to 1.0000 (men) and 0.9999 (women).
  double sum = 0.0;
  for (const HumanPart& part : parts) sum += rowOf(kindOf(part.part), sex).mass;

  for (HumanPart& part : parts) {
    const PartKind kind = kindOf(part.part);
    const InertiaRow row = rowOf(kind, sex);
    part.mass = mass * row.mass / sum;

    Vector3d p_start = part.p_proximal, p_end = part.p_distal;
    if (kind == PartKind::kFoot) {
      p_start = {-0.5 * part.length, 0.0, 0.0};
      p_end = -p_start;
    }
    if (kind == PartKind::kHand) p_end = p_start + kKnuckleShare * (p_end - p_start);
    part.com = p_start + row.com * (p_end - p_start);

    Vector3d radii{row.sagittal, row.transverse, row.longitudinal};
    if (kind == PartKind::kFoot) radii = {row.longitudinal, row.transverse, row.sagittal};
    if (kind == PartKind::kHand) radii = {row.transverse, row.sagittal, row.longitudinal};
    radii *= (p_end - p_start).norm();
    part.inertia = (part.mass * radii.cwiseAbs2()).asDiagonal();
  }
}

}  // namespace abstand::humanmodel
