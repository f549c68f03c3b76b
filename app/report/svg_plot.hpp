// Plots as SVG fragments.
#pragma once

#include <string>

#include "core/verify/check.hpp"

namespace abstand::report {

/// Lines with axes, ticks and a legend. Colours come from the page's style (classes s0 to s8, axis, grid), so
/// that it follows light and dark mode; attributes give the light ones to converters without style support.
/// Self-contained.
std::string svgPlot(const verify::Plot& plot);

/// Start tag of a drawing of this size in pixels: style class (or none), and a title for screen readers.
std::string svgBegin(const std::string& style, double width, double height, const std::string& title);

/// A coordinate in a drawing, rounded to a tenth of a pixel.
std::string pixels(double v);

}  // namespace abstand::report
