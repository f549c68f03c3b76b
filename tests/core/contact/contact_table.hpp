// The table that the project ships, for the parts of the human model.
#pragma once

#include <string_view>
#include <vector>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// "torso", "head", ...: all fourteen.
const std::vector<std::string_view>& modelParts();
const ContactLimits& shippedLimits();
/// Of the shipped table; the region has to be there.
const RegionLimits& shipped(std::string_view region);

}  // namespace abstand::contact
