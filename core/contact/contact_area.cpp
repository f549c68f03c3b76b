#include "core/contact/contact_area.hpp"

#include <cmath>

#include "core/contact/contact_patch.hpp"
#include "core/contact/contact_shadow.hpp"

namespace abstand::contact {
namespace {

/// Indentation into the triangles that surely does not exceed the one into the shape around them.
double certainIndentation(const ContactSurface& surface, const ContactPlace& place) {
  // With a curved person, a point within the sagitta may lie up to sqrt(2) times it behind; twice is safe.
  return place.indentation - (std::isinf(place.body_radius) ? 1.0 : 2.0) * surface.sagitta();
}

bool isPlace(const ContactPlace& place) {
  return place.p_B.allFinite() && place.n_B.allFinite() && std::abs(place.n_B.norm() - 1.0) < 1e-6 &&
         std::isfinite(place.indentation) && place.body_radius > 0.0;
}

double perOrInfinite(double force, double extent) {
  if (!(force > 0.0)) return force <= 0.0 ? 0.0 : kInfinity;
  return extent > 0.0 ? force / extent : kInfinity;
}

}  // namespace

double ContactArea::meanPressure(double force) const { return perOrInfinite(force, area); }

double ContactArea::peakPressure(double force) const { return perOrInfinite(force, volume / indentation); }

ContactArea contactArea(const ContactSurface& surface, const ContactPlace& place) {
  ContactArea result;
  result.indentation = place.indentation;
  result.foremost_B = place.p_B;
  result.certified = surface.watertight();
  if (!isPlace(place)) return result;
  const double x = certainIndentation(surface, place);
  if (!(x > 0.0)) return result;

  const ContactPatch& patch = contactPatch(surface, place, x);
  result.foremost_B = patch.foremost_B;
  result.offset = patch.offset;
  const PatchExtent extent = visibleExtent(patch);
  result.triangles = extent.pieces;
  result.area = extent.area;
  result.volume = extent.volume;
  return result;
}

}  // namespace abstand::contact
