// Where on the body people were near robots, as a drawing.
#pragma once

#include <string>

#include "app/report/heat_scale.hpp"
#include "app/tune/exposure_table.hpp"

namespace abstand::report {

/// SVG of a standing person of usual stature from the front, the back and both sides, cells coloured by
/// weighted exposure. Parts that were not seen for some of the time have a dashed outline. Empty without a
/// cell. Colours follow the page's style.
std::string bodyHeatPicture(const tune::ExposureTable& table);

/// The same person as a mesh, feet on z = 0, facing +x: cells with vertices of their own, coloured by
/// weighted exposure (grey: none), and at each vertex `weighted_s`, a `below_..._mm_s` for each band, and
/// `not_seen_s` of its part.
mesh_file::ColouredMesh bodyHeatMesh(const tune::ExposureTable& table);

/// s: of the cells of the body, with the largest weighted exposure.
HeatScale bodyScale(const tune::ExposureTable& table);

}  // namespace abstand::report
