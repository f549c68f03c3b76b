// Where depth images show the robots and objects of a scene, for reports.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tracking/tracker/displaced_things.hpp"

namespace abstand::cli {

/// `removed`: from the images of the camera; `share`: of the pixels without a nearer surface that have their
/// depth, NaN: nothing was compared. Of things in their place, `displacement` is the noise of the depths.
nlohmann::ordered_json thingsJson(bool removed, double share, const tracking::DisplacedThings& displaced);

/// "found in 93 % of their pixels, displaced by up to 62 mm"; empty: nothing was compared.
std::string thingsText(double share, const tracking::DisplacedThings& displaced);

}  // namespace abstand::cli
