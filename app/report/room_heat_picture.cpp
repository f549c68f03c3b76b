#include "app/report/room_heat_picture.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/svg_plot.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::report {
namespace {

constexpr double kPanelWidth = 360.0, kMaxPanelHeight = 420.0;                               // pixels
constexpr double kPanelLeft = 44.0, kPanelTop = 24.0, kPanelBottom = 40.0, kPanelGap = 8.0;  // pixels
constexpr double kLegendHeight = 50.0;                                                       // pixels
constexpr double kAroundCells = 0.1;  // m, border around the drawing
// Largest number of ticks of an axis.
constexpr double kMaxTicks = 7.0;

struct FloorExtent {
  Eigen::Vector2d lower{kInfinity, kInfinity}, upper{-kInfinity, -kInfinity};
  void add(const Eigen::Vector2d& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
};

Eigen::Vector2d cornerOf(const tune::FloorCell& c, int dx, int dy) {
  return {tune::kFloorCell * (c.x + dx), tune::kFloorCell * (c.y + dy)};
}

FloorExtent extentOf(const tune::ExposureTable& table) {
  FloorExtent e;
  for (const tune::FloorCell& c : table.floor_cells) e.add(cornerOf(c, 0, 0)), e.add(cornerOf(c, 1, 1));
  for (const auto& o : table.outlines)
    for (const Eigen::Vector2d& corner : o.corners) e.add(corner);
  e.lower.array() -= kAroundCells;
  e.upper.array() += kAroundCells;
  return e;
}

/// World to pixels, in one of the two panels.
class FloorPanel {
 public:
  FloorPanel(const FloorExtent& extent, double left) : extent_(extent), left_(left + kPanelLeft) {
    const Eigen::Vector2d size = extent.upper - extent.lower;
    scale_ = std::min((kPanelWidth - kPanelLeft - kPanelGap) / size.x(), kMaxPanelHeight / size.y());
  }
  double x(double v) const { return left_ + scale_ * (v - extent_.lower.x()); }
  double y(double v) const { return kPanelTop + scale_ * (extent_.upper.y() - v); }
  double right() const { return x(extent_.upper.x()); }
  double bottom() const { return y(extent_.lower.y()); }
  double left() const { return left_; }

  std::string frame(const std::string& title) const {
    std::string svg = text(left_, kPanelTop - 9.0, "start", title);
    const Eigen::Vector2d size = extent_.upper - extent_.lower;
    const double raw = size.maxCoeff() / kMaxTicks, decade = std::pow(10.0, std::floor(std::log10(raw)));
    const double step = decade * (raw < 2.0 * decade ? 2.0 : raw < 5.0 * decade ? 5.0 : 10.0);
    for (double k = std::ceil(extent_.lower.x() / step); k * step <= extent_.upper.x(); k += 1.0)
      svg += line(x(k * step), kPanelTop, x(k * step), bottom()) +
             text(x(k * step), bottom() + 15.0, "middle", verify::shortNumber(k * step + 0.0));
    for (double k = std::ceil(extent_.lower.y() / step); k * step <= extent_.upper.y(); k += 1.0)
      svg += line(left_, y(k * step), right(), y(k * step)) +
             text(left_ - 5.0, y(k * step) + 4.0, "end", verify::shortNumber(k * step + 0.0));
    svg += text(0.5 * (left_ + right()), bottom() + 31.0, "middle", "x [m]");
    const double middle = 0.5 * (kPanelTop + bottom()), at = left_ - 32.0;
    return svg + "<text text-anchor=\"middle\" x=\"" + pixels(at) + "\" y=\"" + pixels(middle) +
           "\" transform=\"rotate(-90 " + pixels(at) + " " + pixels(middle) + ")\">y [m]</text>\n";
  }

 private:
  static std::string line(double x1, double y1, double x2, double y2) {
    return "<line class=\"grid\" x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) +
           "\" y2=\"" + pixels(y2) + "\"/>";
  }
  static std::string text(double x, double y, const char* anchor, const std::string& text) {
    return "<text text-anchor=\"" + std::string(anchor) + "\" x=\"" + pixels(x) + "\" y=\"" + pixels(y) +
           "\">" + text::escapedXml(text) + "</text>\n";
  }

  const FloorExtent& extent_;
  double left_, scale_{1.0};
};

std::string robotOutlines(const tune::ExposureTable& table, const FloorPanel& panel, const char* style) {
  std::string svg;
  for (const auto& o : table.outlines) {
    svg += "<polygon class=\"" + std::string(style) + "\" points=\"";
    for (const Eigen::Vector2d& c : o.corners)
      svg += pixels(panel.x(c.x())) + "," + pixels(panel.y(c.y())) + " ";
    svg += "\"><title>" + text::escapedXml(o.link) + "</title></polygon>\n";
  }
  return svg;
}

std::string floorCells(const tune::ExposureTable& table, tune::FloorLayer layer, const FloorPanel& panel,
                       const HeatScale& scale) {
  std::string svg;
  for (const tune::FloorCell& c : table.floor_cells) {
    if (c.layer != layer) continue;
    const Eigen::Vector2d lower = cornerOf(c, 0, 0), upper = cornerOf(c, 1, 1);
    svg += "<rect class=\"h" + std::to_string(scale.classOf(c.spent.weighted)) + "\" x=\"" +
           pixels(panel.x(lower.x())) + "\" y=\"" + pixels(panel.y(upper.y())) + "\" width=\"" +
           pixels(panel.x(upper.x()) - panel.x(lower.x())) + "\" height=\"" +
           pixels(panel.y(lower.y()) - panel.y(upper.y())) + "\"/>\n";
  }
  return svg;
}

}  // namespace

HeatScale roomScale(const tune::ExposureTable& table) {
  double largest = 0.0;
  for (const tune::FloorCell& c : table.floor_cells) largest = std::max(largest, c.spent.weighted);
  return HeatScale(largest);
}

std::string roomHeatPicture(const tune::ExposureTable& table) {
  if (table.floor_cells.empty()) return {};
  const HeatScale scale = roomScale(table);
  const FloorExtent extent = extentOf(table);
  const FloorPanel people(extent, 0.0), robots(extent, kPanelWidth);
  const double height = people.bottom() + kPanelBottom;
  std::string svg = "<svg class=\"heat\" role=\"img\" viewBox=\"0 0 " + pixels(2.0 * kPanelWidth) + " " +
                    pixels(height + kLegendHeight) + "\" aria-label=\"exposure on the floor\">\n";
  for (const FloorPanel* panel : {&people, &robots}) {
    const bool of_people = panel == &people;
    const auto layer = of_people ? tune::FloorLayer::kPeople : tune::FloorLayer::kRobots;
    svg += panel->frame(of_people ? "nearest points on people" : "nearest points on robots") +
           robotOutlines(table, *panel, "robot") + floorCells(table, layer, *panel, scale) +
           robotOutlines(table, *panel, "outline");
  }
  return svg + "<g transform=\"translate(" + pixels(kPanelLeft) + " " + pixels(height + 8.0) + ")\">" +
         scale.legend() + "</g>\n</svg>\n";
}

std::vector<std::string> exposureNames() {
  std::vector<std::string> names{"weighted_s"};
  for (const double band : margin::kExposureBands)
    names.push_back("below_" + std::to_string(static_cast<int>(std::lround(1e3 * band))) + "_mm_s");
  return names;
}

std::vector<double> exposureValues(const margin::ExposureTime& spent) {
  std::vector<double> values{spent.weighted};
  values.insert(values.end(), spent.below.begin(), spent.below.end());
  return values;
}

mesh_file::ColouredMesh roomHeatMesh(const tune::ExposureTable& table) {
  mesh_file::ColouredMesh mesh;
  mesh.names = exposureNames();
  mesh.comments = {"abstand: exposure of people on the floor, seconds"};
  const HeatScale scale = roomScale(table);
  for (const tune::FloorCell& c : table.floor_cells) {
    if (c.layer != tune::FloorLayer::kPeople) continue;
    const auto corner = [&](int dx, int dy) {
      const Eigen::Vector2d p = cornerOf(c, dx, dy);
      return Vector3d(p.x(), p.y(), 0.0);
    };
    mesh.addQuad({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)},
                 HeatScale::colour(scale.classOf(c.spent.weighted)), exposureValues(c.spent));
  }
  return mesh;
}

}  // namespace abstand::report
