#include "core/contact/predicted_pressure.hpp"

#include "core/math/transform.hpp"

namespace abstand::contact {

PredictedPressure predictPressure(const RegionLimits& region, const PredictedContact& contact,
                                  const ContactArea& area, ContactKind kind) {
  PredictedPressure p;
  p.mean = area.meanPressure(contact.force);
  p.peak = area.peakPressure(contact.force);
  if (!contact.excluded)
    p.allowed = region.pressure() * (kind == ContactKind::kTransient ? region.transient.value : 1.0);
  p.share = contact.excluded ? kInfinity : p.peak / p.allowed;
  return p;
}

std::string_view limitText(LimitKind kind) {
  switch (kind) {
    case LimitKind::kForce:
      return "force";
    case LimitKind::kPressure:
      return "pressure";
    case LimitKind::kExcluded:
      break;
  }
  return "contact excluded";
}

NearestLimit nearestLimit(const PredictedContact& contact) {
  if (contact.excluded) return {LimitKind::kExcluded, kInfinity};
  return {LimitKind::kForce, contact.share};
}

NearestLimit nearestLimit(const PredictedContact& contact, const PredictedPressure& pressure) {
  const NearestLimit force = nearestLimit(contact);
  if (force.kind == LimitKind::kExcluded || !(pressure.share > force.share)) return force;
  return {LimitKind::kPressure, pressure.share};
}

}  // namespace abstand::contact
