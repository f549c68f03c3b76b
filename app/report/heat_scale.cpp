#include "app/report/heat_scale.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/svg_plot.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::report {
namespace {

constexpr double kBoxWidth = 52.0, kBoxHeight = 12.0;
// Relative: a border that the largest value reaches up to rounding counts as reached.
constexpr double kBorderRounding = 1e-9;

/// Border `index`: ... 0.5, 1, 2, 5, 10 ...; index 0 is 1.
double borderAt(int index) {
  static constexpr double kSteps[] = {1.0, 2.0, 5.0};
  const int decade = index >= 0 ? index / 3 : -((2 - index) / 3);
  return kSteps[index - 3 * decade] * std::pow(10.0, decade);
}

}  // namespace

HeatScale::HeatScale(double largest) {
  if (!(largest > 0.0) || !std::isfinite(largest)) return;
  int top = 3 * static_cast<int>(std::floor(std::log10(largest))) + 3;
  while (borderAt(top) > largest * (1.0 + kBorderRounding)) --top;
  for (int i = top - (kClasses - 2); i <= top; ++i) borders_.push_back(borderAt(i));
}

int HeatScale::classOf(double seconds) const {
  if (!(seconds > 0.0) || empty()) return -1;
  const double value = seconds * (1.0 + kBorderRounding);
  return static_cast<int>(std::upper_bound(borders_.begin(), borders_.end(), value) - borders_.begin());
}

/// Colour map "inferno" of matplotlib (van der Walt and Smith 2015, CC0), monotonic for colour-blind readers
/// and in print.
mesh_file::Rgb HeatScale::colour(int heat_class) {
  static constexpr mesh_file::Rgb kColours[kClasses] = {
      {0xf6, 0xd7, 0x46}, {0xfc, 0xa5, 0x0a}, {0xf3, 0x78, 0x19}, {0xdd, 0x51, 0x3a},
      {0xbc, 0x37, 0x54}, {0x93, 0x26, 0x67}, {0x6a, 0x17, 0x6e}, {0x42, 0x0a, 0x68}};
  if (heat_class < 0) return {0xd0, 0xd0, 0xd0};
  return kColours[std::min(heat_class, kClasses - 1)];
}

std::string HeatScale::legend() const {
  std::string svg;
  for (int c = 0; c < kClasses && !empty(); ++c)
    svg += "<rect class=\"h" + std::to_string(c) + "\" x=\"" + pixels(kBoxWidth * c) + "\" y=\"0\" width=\"" +
           pixels(kBoxWidth) + "\" height=\"" + pixels(kBoxHeight) + "\"/>";
  for (std::size_t b = 0; b < borders_.size(); ++b)
    svg += "<text text-anchor=\"middle\" x=\"" + pixels(kBoxWidth * static_cast<double>(b + 1)) + "\" y=\"" +
           pixels(kBoxHeight + 14.0) + "\">" + verify::shortNumber(borders_[b]) + "</text>";
  return svg + "<text x=\"" + pixels(kBoxWidth * kClasses + 10.0) + "\" y=\"" + pixels(kBoxHeight - 1.0) +
         "\">s, weighted</text>";
}

}  // namespace abstand::report
