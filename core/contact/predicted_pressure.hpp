// Pressure of a contact, from its force and the shape of what touches.
#pragma once

#include "core/contact/contact_area.hpp"
#include "core/contact/predicted_contact.hpp"

namespace abstand::contact {

/// Pressure under the force of a PredictedContact, Pa. Area and displaced volume are lower bounds
/// (contact_area.hpp), so that these are upper bounds within the model.
struct PredictedPressure {
  double mean{0.0};  ///< F / A
  /// F x / V, by a linear elastic foundation: p_i = K_f depth_i, with K_f so that the sum of p_i a_i is F,
  /// hence K_f = F / V. 2 F / A under a shallow cap and a right-angled edge, F / A under a flat face.
  double peak{0.0};
  double allowed{0.0};  ///< the region's smallest pressure, times the factor where transient. 0: excluded
  double share{0.0};    ///< peak / allowed; infinite where excluded, or where nothing is certain of the area
};

/// `area` is that of `contact.indentation`. Limits: ISO/TS 15066:2016, A.2, or the edition that was loaded.
/// The foundation is our own model; the standard names the limit, not how to compute the pressure. Pure.
PredictedPressure predictPressure(const RegionLimits& region, const PredictedContact& contact,
                                  const ContactArea& area, ContactKind kind);

enum class LimitKind : std::uint8_t { kForce, kPressure, kExcluded };

/// "force", "pressure" or "contact excluded".
std::string_view limitText(LimitKind kind);

/// The limit that is used most. Force, energy and speed are one limit: their shares follow from each other.
struct NearestLimit {
  LimitKind kind{LimitKind::kForce};
  double share{0.0};  ///< 1: at the limit; above: exceeded
};
NearestLimit nearestLimit(const PredictedContact& contact, const PredictedPressure& pressure);
/// Where the shape is not known.
NearestLimit nearestLimit(const PredictedContact& contact);

}  // namespace abstand::contact
