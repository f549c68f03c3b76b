#include "tracking/markers/stature_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr std::size_t kCheckedMoments = 24;
constexpr double kFitsDiffer = 0.07;  // as for the stature along the bones

double legOf(const BodyRig& rig) {
  return farJoint(rig, kThighLeft).norm() + farJoint(rig, kCalfLeft).norm();
}

/// Evenly spaced moments with markers.
std::pair<std::vector<double>, std::vector<MarkerPlaces>> someMoments(const StatedStature& stated) {
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < stated.moments.size(); ++i)
    if (std::ranges::any_of(stated.moments[i], [](const Vector3d& p) { return std::isfinite(p.x()); }))
      seen.push_back(i);
  std::pair<std::vector<double>, std::vector<MarkerPlaces>> some;
  const std::size_t count = std::min(kCheckedMoments, seen.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = seen[i * seen.size() / count];
    some.first.push_back(stated.t[at]);
    some.second.push_back(stated.moments[at]);
  }
  return some;
}

std::string inMetres(double length) { return text::rounded(length, 2) + " m"; }

}  // namespace

std::string doubtOfStature(const StatedStature& stated) {
  const auto has = [&](RigSegment left, RigSegment right) {
    return std::ranges::any_of(stated.found,
                               [&](const FoundMarker& m) { return m.segment == left || m.segment == right; });
  };
  if (!has(kThighLeft, kThighRight) || !has(kCalfLeft, kCalfRight)) return {};
  const auto some = someMoments(stated);
  const auto fit = [&](std::optional<double> stature) {
    return solveMarkers(stated.base, stated.found, some.first, some.second, stature);
  };
  const MarkerSolution with = fit(stated.stature), without = fit(std::nullopt);
  const std::string begin =
      "the file states a stature of " + inMetres(stated.stature) + ", which is used, but ";
  const double leg = legOf(with.body.rig);
  const double by_legs = leg * stated.base.height / legOf(stated.base), free = without.body.rig.height;
  const auto off = [&](double stature) { return stature / stated.stature - 1.0; };
  if (std::min(off(by_legs), off(free)) > kFitsDiffer || std::max(off(by_legs), off(free)) < -kFitsDiffer)
    return begin + "the markers fit a person of " + inMetres(free) + " without it, and legs of " +
           inMetres(leg) + " (thigh and calf) are those of " + inMetres(by_legs);
  return {};
}

}  // namespace abstand::tracking
