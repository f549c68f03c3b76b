// Visible area and volume of a patch.
#pragma once

#include "core/contact/contact_patch.hpp"

namespace abstand::contact {

struct PatchExtent {
  double area{0.0};       ///< m^2
  double volume{0.0};     ///< m^3
  std::size_t pieces{0};  ///< of the patch, with a part deeper than 0 that faces the person
};

/// The extent of what of the patch lies deeper than 0 and faces the person, without what lies behind other
/// surface. Between two sheets that both face the person there is one that faces away, as the body is closed;
/// what lies behind such a sheet is left out. Where several hide the same place it is taken off as often:
/// never more than the true extent.
PatchExtent visibleExtent(const ContactPatch& patch);

}  // namespace abstand::contact
