// Visible area and volume of a patch.
#pragma once

#include "core/contact/contact_patch.hpp"

namespace abstand::contact {

struct PatchExtent {
  double area{0.0};    ///< m^2
  double volume{0.0};  ///< m^3
};

/// Area and volume of the patch's front without hidden parts. The body is closed, so between two sheets that
/// face the person there is one that faces away; parts behind such a sheet are subtracted. If several hide
/// the same place it is subtracted several times: the result never exceeds the true extent.
PatchExtent visibleExtent(const ContactPatch& patch);

}  // namespace abstand::contact
