// Predicted contact pressure, from force and shape.
#pragma once

#include "core/contact/contact_area.hpp"
#include "core/contact/predicted_contact.hpp"

namespace abstand::contact {

/// Pressure (Pa) under the force of a PredictedContact. Area and displaced volume are lower bounds
/// (contact_area.hpp), so these are upper bounds within the model.
struct PredictedPressure {
  double mean{0.0};  ///< F / A
  /// F x / V, by a linear elastic foundation: p_i = K_f depth_i with the sum of p_i a_i = F, hence K_f = F /
  /// V. 2 F / A under a shallow cap and a right-angled edge, F / A under a flat face.
  double peak{0.0};
  double allowed{0.0};  ///< the region's smallest pressure, times the factor where transient. 0: excluded
  double share{0.0};    ///< peak / allowed; infinite if excluded, or without certified area
};

/// `area` is that at `contact.indentation`. Limits: ISO/TS 15066:2016, A.2, or the loaded edition. The
/// elastic foundation is our own model; the standard states the limit, not how to compute the pressure. Pure.
PredictedPressure predictPressure(const RegionLimits& region, const PredictedContact& contact,
                                  const ContactArea& area, ContactKind kind);

enum class LimitKind : std::uint8_t { kForce, kPressure, kExcluded };

/// "force", "pressure" or "contact excluded".
std::string_view limitText(LimitKind kind);

/// The limit with the largest share. Force, energy and speed are one limit: their shares follow from each
/// other.
struct NearestLimit {
  LimitKind kind{LimitKind::kForce};
  double share{0.0};  ///< 1: at the limit; above: exceeded
};
NearestLimit nearestLimit(const PredictedContact& contact, const PredictedPressure& pressure);
/// For an unknown shape.
NearestLimit nearestLimit(const PredictedContact& contact);

}  // namespace abstand::contact
