// The table that the project ships, for the parts of the human model.
#pragma once

#include <string_view>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

const ContactLimits& shippedLimits();
/// Of the shipped table; the region has to be there.
const RegionLimits& shipped(std::string_view region);

}  // namespace abstand::contact
