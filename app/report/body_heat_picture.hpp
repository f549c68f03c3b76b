// Drawing of exposure on the body surface.
#pragma once

#include <string>

#include "app/report/heat_scale.hpp"
#include "app/tune/exposure_table.hpp"

namespace abstand::report {

/// SVG of a standing person of default stature from the front, the back and both sides, with cells coloured
/// by weighted exposure. Parts not seen for some of the time have a dashed outline. Empty if there are no
/// cells. Colours follow the page's style.
std::string bodyHeatPicture(const tune::ExposureTable& table);

/// The same person as a mesh, feet on z = 0, facing +x: each cell has its own vertices, coloured by weighted
/// exposure (grey: none), with `weighted_s`, a `below_..._mm_s` for each band, and `not_seen_s` of its part
/// at each vertex.
mesh_file::ColouredMesh bodyHeatMesh(const tune::ExposureTable& table);

/// Colour scale up to the largest weighted exposure (s) of the body cells.
HeatScale bodyScale(const tune::ExposureTable& table);

}  // namespace abstand::report
