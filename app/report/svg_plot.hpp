// A plot as a piece of SVG.
#pragma once

#include <string>

#include "core/verify/check.hpp"

namespace abstand::report {

/// Lines with axes, ticks and a legend; colours come from the page's style (classes s0 to s8, axis, grid), so
/// that it follows light and dark; attributes say the light ones to converters without style. No reference to
/// anything outside.
std::string svgPlot(const verify::Plot& plot);

/// The first line of a drawing of that many pixels: style class (or none), title for those who do not see it.
std::string svgBegin(const std::string& style, double width, double height, const std::string& title);

/// A length or place in a drawing, to a tenth of a pixel.
std::string pixels(double v);

}  // namespace abstand::report
