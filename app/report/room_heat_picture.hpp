// Where in the room people were near robots, as a drawing.
#pragma once

#include <string>

#include "app/report/heat_scale.hpp"
#include "app/tune/exposure_table.hpp"

namespace abstand::report {

/// SVG of the floor from above, x to the right, y up: the cells of the nearest points on people on the left
/// and on robots on the right, coloured by weighted exposure, over the robots' outlines. Empty without a
/// cell. Colours follow the page's style.
std::string roomHeatPicture(const tune::ExposureTable& table);

/// s: of the cells of the floor and of the body, with the largest weighted exposure.
HeatScale roomScale(const tune::ExposureTable& table);

/// Flat squares at z = 0 with the layer of people: colours by weighted exposure, and at each vertex
/// `weighted_s` and a `below_..._mm_s` for each band.
mesh_file::ColouredMesh roomHeatMesh(const tune::ExposureTable& table);

/// Names and values of a mesh's vertices.
std::vector<std::string> exposureNames();
std::vector<double> exposureValues(const margin::ExposureTime& spent);

}  // namespace abstand::report
