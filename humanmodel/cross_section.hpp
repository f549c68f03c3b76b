// Cross-sections of parts: breadth, depth and girth.
#pragma once

namespace abstand::humanmodel {

enum class PartShape { kEllipsoid, kCuboid };

/// Perimeter of the ellipse (complete elliptic integral of the second kind) or of the rectangle with these
/// full extents, in their unit. A circle of radius b gives 2 pi b, a rectangle 2 (breadth + depth).
double contourOf(PartShape shape, double breadth, double depth);

/// The other extent of a cross-section with one extent `extent` and the girth `contour`, which must exceed 2
/// extent, that of a strip without thickness.
double extentFor(PartShape shape, double contour, double extent);

}  // namespace abstand::humanmodel
