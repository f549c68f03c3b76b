// Cross-sections of a body where girths are measured.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Where a girth is measured; on limbs at the thickest place.
enum class GirthPlace {
  kChest,
  kWaist,
  kButtock,
  kHead,
  kNeck,
  kBiceps,
  kForearm,
  kHand,
  kThigh,
  kCalf,
  kFoot,  ///< girth of the ball of the foot; breadth and height of the whole foot
  kCount
};
inline constexpr std::size_t kGirthPlaceCount = static_cast<std::size_t>(GirthPlace::kCount);

/// m. Breadth and depth as in HumanPart, girth as measured.
struct Section {
  double breadth{0.0}, depth{0.0}, girth{0.0};
};

struct BodySections {
  std::array<Section, kGirthPlaceCount> sections;
  Section& operator[](GirthPlace place) { return sections[static_cast<std::size_t>(place)]; }
  const Section& operator[](GirthPlace place) const { return sections[static_cast<std::size_t>(place)]; }
};

/// Sections of the mean person of a stature (m) and, if given, a body mass (kg); see measuresOf.
BodySections meanSections(double height, std::optional<double> mass, std::optional<Sex> sex);

/// The largest girth (m) of a section with the proportions of `mean` inside `given`: mean girth times the
/// smaller of the ratios of breadth and of depth.
double largestGirthInside(const Section& given, const Section& mean);

}  // namespace abstand::humanmodel
