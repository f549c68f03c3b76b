// Plots as SVG fragments.
#include "app/report/svg_plot.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/escaped_xml.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::report {
namespace {

constexpr double kWidth = 720, kHeight = 320;
constexpr double kLeft = 64, kRight = 190, kTop = 26,
                 kBottom = 44;  // margins; the legend is on the right
/// Line colours and dashes as in the page's style (page.cpp), for converters that ignore it within a drawing.
/// The style has precedence over attributes.
struct LineLook {
  const char *colour, *dashes;
};
constexpr LineLook kLooks[] = {{"#0072b2", ""},        {"#d55e00", "7 3"},     {"#009e73", "2 3"},
                               {"#cc79a7", "9 3 2 3"}, {"#b58900", ""},        {"#56b4e9", "7 3"},
                               {"#7a5195", "2 3"},     {"#555555", "9 3 2 3"}, {"#aa0000", ""}};
constexpr std::size_t kColours = std::size(kLooks);
constexpr std::size_t kMaxPoints = 400;

/// Values along one side of the plot, from `from` to `to` pixels.
class Axis {
 public:
  Axis(bool logarithmic, double from, double to) : logarithmic_(logarithmic), from_(from), to_(to) {}

  bool shows(double v) const { return std::isfinite(v) && (!logarithmic_ || v > 0.0); }
  void include(double v) {
    if (!shows(v)) return;
    least_ = std::min(least_, scaled(v));
    most_ = std::max(most_, scaled(v));
  }
  /// Adds a margin for constant lines; rounds to whole decades.
  void settle() {
    if (!(least_ <= most_)) least_ = most_ = 0.0;
    if (logarithmic_) {
      least_ = std::floor(least_ + 1e-9);
      most_ = std::max(least_ + 1.0, std::ceil(most_ - 1e-9));
      return;
    }
    const double room = std::max(0.03 * (most_ - least_), 1e-3 * std::max(std::abs(most_), 1e-6));
    least_ -= room;
    most_ += room;
  }
  double pixel(double v) const { return from_ + (to_ - from_) * (scaled(v) - least_) / (most_ - least_); }
  std::vector<double> ticks() const {
    std::vector<double> ticks;
    if (logarithmic_) {
      const double step = std::ceil((most_ - least_) / 8.0);
      for (double e = least_; e <= most_ + 1e-9; e += step) ticks.push_back(std::pow(10.0, e));
      return ticks;
    }
    const double raw = (most_ - least_) / 5.0, decade = std::pow(10.0, std::floor(std::log10(raw)));
    const double step = decade * (raw < 2.0 * decade ? 2.0 : raw < 5.0 * decade ? 5.0 : 10.0);
    for (double k = std::ceil(least_ / step); k * step <= most_; k += 1.0)
      ticks.push_back(k * step + 0.0);  // avoids -0
    return ticks;
  }

 private:
  double scaled(double v) const { return logarithmic_ ? std::log10(v) : v; }

  bool logarithmic_;
  double from_, to_;
  double least_{kInfinity}, most_{-kInfinity};
};

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  const char* colour = std::string_view(style) == "grid" ? "#d5d5d5" : "#1b1b1b";
  return "<line class=\"" + std::string(style) + "\" stroke=\"" + colour + "\" x1=\"" + pixels(x1) +
         "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) + "\"/>";
}

std::string label(double x, double y, const char* anchor, const std::string& text,
                  const std::string& more = {}) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
         text::escapedXml(text) + "</text>";
}

std::string polylineBegin(std::size_t colour) {
  const LineLook& look = kLooks[colour];
  return "<polyline class=\"s" + std::to_string(colour) + "\" fill=\"none\" stroke=\"" + look.colour +
         "\" stroke-width=\"1.6\"" +
         (*look.dashes ? " stroke-dasharray=\"" + std::string(look.dashes) + "\"" : std::string()) +
         " points=\"";
}

std::string polyline(const verify::Series& series, const Axis& x, const Axis& y, std::size_t colour) {
  std::string points;
  const std::size_t stride = series.x.size() / kMaxPoints + 1;
  for (std::size_t i = 0; i < series.x.size(); i += stride) {
    if (!x.shows(series.x[i]) || !y.shows(series.y[i])) continue;
    points += pixels(x.pixel(series.x[i])) + "," + pixels(y.pixel(series.y[i])) + " ";
  }
  return polylineBegin(colour) + points + "\"/>\n";
}

}  // namespace

std::string pixels(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", v);
  return text;
}

std::string svgBegin(const std::string& style, double width, double height, const std::string& title) {
  return "<svg" + (style.empty() ? std::string() : " class=\"" + style + "\"") +
         " role=\"img\" viewBox=\"0 0 " + pixels(width) + " " + pixels(height) + "\" aria-label=\"" +
         text::escapedXml(title) + "\" fill=\"#1b1b1b\" font-family=\"sans-serif\" font-size=\"12\">\n";
}

std::string svgPlot(const verify::Plot& plot) {
  Axis x(plot.log_x, kLeft, kWidth - kRight), y(plot.log_y, kHeight - kBottom, kTop);
  for (const verify::Series& series : plot.series) {
    for (const double v : series.x) x.include(v);
    for (const double v : series.y) y.include(v);
  }
  x.settle();
  y.settle();

  const double left = kLeft, right = kWidth - kRight, top = kTop, bottom = kHeight - kBottom;
  std::string svg =
      svgBegin("", kWidth, kHeight, plot.title) + label(left, top - 10, "start", plot.title) + "\n";
  for (const double v : x.ticks())
    svg += line(x.pixel(v), top, x.pixel(v), bottom, "grid") +
           label(x.pixel(v), bottom + 16, "middle", verify::shortNumber(v)) + "\n";
  for (const double v : y.ticks())
    svg += line(left, y.pixel(v), right, y.pixel(v), "grid") +
           label(left - 6, y.pixel(v) + 4, "end", verify::shortNumber(v)) + "\n";
  svg += line(left, bottom, right, bottom, "axis") + line(left, top, left, bottom, "axis");
  svg += label(0.5 * (left + right), kHeight - 8, "middle", plot.x_label);
  const double middle = 0.5 * (top + bottom);
  svg += label(14, middle, "middle", plot.y_label, " transform=\"rotate(-90 14 " + pixels(middle) + ")\"") +
         "\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const std::size_t colour = i % kColours;
    const double at = top + 8 + 18 * static_cast<double>(i);
    svg += polyline(plot.series[i], x, y, colour);
    svg += polylineBegin(colour) + pixels(right + 12) + "," + pixels(at) + " " + pixels(right + 36) + "," +
           pixels(at) + "\"/>" + label(right + 42, at + 4, "start", plot.series[i].name) + "\n";
  }
  return svg + "</svg>\n";
}

}  // namespace abstand::report
