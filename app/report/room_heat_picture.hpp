// Drawing of exposure on the floor of the room.
#pragma once

#include <string>

#include "app/report/heat_scale.hpp"
#include "app/tune/exposure_table.hpp"

namespace abstand::report {

/// SVG of the floor from above, x to the right, y up: cells of the nearest points on people on the left and
/// on robots on the right, coloured by weighted exposure, over the robots' outlines. Empty if there are no
/// cells. Colours follow the page's style.
std::string roomHeatPicture(const tune::ExposureTable& table);

/// Colour scale up to the largest weighted exposure (s) of floor and body cells.
HeatScale roomScale(const tune::ExposureTable& table);

/// Flat squares at z = 0 of the people's layer: coloured by weighted exposure, with `weighted_s` and a
/// `below_..._mm_s` for each band at each vertex.
mesh_file::ColouredMesh roomHeatMesh(const tune::ExposureTable& table);

/// Names of the vertex values.
std::vector<std::string> exposureNames();
std::vector<double> exposureValues(const margin::ExposureTime& spent);

}  // namespace abstand::report
