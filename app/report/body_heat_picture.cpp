#include "app/report/body_heat_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/report/room_heat_picture.hpp"
#include "app/report/svg_plot.hpp"
#include "core/text/escaped_xml.hpp"
#include "humanmodel/body_cells.hpp"
#include "humanmodel/poser.hpp"

namespace abstand::report {
namespace {

constexpr int kOutlineCorners = 48;
constexpr double kBodyViewWidth = 180.0, kBodyViewHeight = 400.0, kViewTitle = 22.0;  // pixels
constexpr double kHeatLegend = 50.0;                                                  // pixels
constexpr double kAboveHead = 0.03;                                                   // m

/// View direction -`towards`; `right` and `towards` in the world, z up.
struct BodyView {
  const char* title;
  Vector3d towards, right;
};
const BodyView kBodyViews[] = {{"front", Vector3d::UnitX(), Vector3d::UnitY()},
                               {"back", -Vector3d::UnitX(), -Vector3d::UnitY()},
                               {"left side", Vector3d::UnitY(), -Vector3d::UnitX()},
                               {"right side", -Vector3d::UnitY(), Vector3d::UnitX()}};

/// A standing person with the values of each part's cells.
struct StandingPerson {
  humanmodel::HumanModel model{humanmodel::makeHuman({})};
  humanmodel::HumanPose pose;
  std::vector<std::map<std::size_t, const margin::ExposureTime*>> cells{humanmodel::kBodyPartCount};
  std::vector<double> not_seen;  ///< s, of each part

  explicit StandingPerson(const tune::ExposureTable& table) : not_seen(humanmodel::kBodyPartCount, 0.0) {
    humanmodel::Poser(model).pose(model.rest, pose);
    for (const auto& c : table.body_cells)
      if (const auto part = humanmodel::parsePart(c.part)) cells[humanmodel::index(*part)][c.cell] = &c.spent;
    for (const tune::ExposureRow& row : table.parts)
      if (const auto part = humanmodel::parsePart(row.part))
        not_seen[humanmodel::index(*part)] = row.not_seen;
  }
  Vector3d at(const humanmodel::HumanPart& part, const Vector3d& u) const {
    return pose.X_WP[humanmodel::index(part.part)] * humanmodel::surfacePoint(part.shape, u);
  }
};

/// World to pixels.
struct BodyFrame {
  const BodyView& view;
  double left, height;
  std::string at(const Vector3d& p) const {
    const double scale = kBodyViewHeight / height;
    return pixels(left + 0.5 * kBodyViewWidth + scale * view.right.dot(p)) + "," +
           pixels(kViewTitle + kBodyViewHeight - scale * p.z()) + " ";
  }
};

/// Outline of a convex part: support points of its surface in directions perpendicular to the view.
std::string partOutline(const StandingPerson& person, const humanmodel::HumanPart& part,
                        const BodyFrame& frame) {
  const Vector3d half = 0.5 * geometry::bounds(part.shape).extent();
  const bool box = std::holds_alternative<geometry::Cuboid>(part.shape);
  const Transform& X_WP = person.pose.X_WP[humanmodel::index(part.part)];
  std::string points;
  for (int i = 0; i < kOutlineCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kOutlineCorners;
    const Vector3d n_W = std::cos(angle) * frame.view.right + std::sin(angle) * Vector3d::UnitZ();
    const Vector3d n = X_WP.linear().transpose() * n_W;
    // Support points: of an ellipsoid h (h n) / |h n|, of a box its corner.
    const Vector3d stretched = half.cwiseProduct(n);
    const Vector3d p = box ? Vector3d(half.cwiseProduct(n.cwiseSign()))
                           : Vector3d(half.cwiseProduct(stretched.normalized()));
    points += frame.at(X_WP * p);
  }
  return points;
}

std::string partPicture(const StandingPerson& person, const humanmodel::HumanPart& part,
                        const BodyFrame& frame, const HeatScale& scale) {
  const std::size_t index = humanmodel::index(part.part);
  const std::string points = partOutline(person, part, frame);
  std::string svg = "<polygon class=\"skin\" points=\"" + points + "\"/>\n";
  for (const auto& [cell, spent] : person.cells[index]) {
    const auto corners = humanmodel::cellCorners(cell);
    std::array<Vector3d, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = person.at(part, corners[i]);
    // Skips cells on the far side.
    if (!((p[2] - p[0]).cross(p[3] - p[1]).dot(frame.view.towards) > 0.0)) continue;
    svg += "<polygon class=\"h" + std::to_string(scale.classOf(spent->weighted)) + "\" points=\"";
    for (const Vector3d& corner : p) svg += frame.at(corner);
    svg += "\"/>\n";
  }
  return svg + "<polygon class=\"outline" + (person.not_seen[index] > 0.0 ? " unseen" : "") + "\" points=\"" +
         points + "\"><title>" + std::string(humanmodel::partName(part.part)) + "</title></polygon>\n";
}

std::string bodyView(const StandingPerson& person, const BodyFrame& frame, const HeatScale& scale) {
  std::vector<const humanmodel::HumanPart*> parts;
  for (const humanmodel::HumanPart& p : person.model.parts) parts.push_back(&p);
  const auto depth = [&](const humanmodel::HumanPart* p) {
    return frame.view.towards.dot(person.pose.X_WP[humanmodel::index(p->part)].translation());
  };
  // Painter's algorithm: nearer parts cover those behind.
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const auto* a, const auto* b) { return depth(a) < depth(b); });
  std::string svg;
  for (const humanmodel::HumanPart* p : parts) svg += partPicture(person, *p, frame, scale);
  return svg + "<text text-anchor=\"middle\" x=\"" + pixels(frame.left + 0.5 * kBodyViewWidth) +
         "\" y=\"14\">" + frame.view.title + "</text>\n";
}

}  // namespace

HeatScale bodyScale(const tune::ExposureTable& table) {
  double largest = 0.0;
  for (const auto& c : table.body_cells) largest = std::max(largest, c.spent.weighted);
  return HeatScale(largest);
}

std::string bodyHeatPicture(const tune::ExposureTable& table) {
  if (table.body_cells.empty()) return {};
  const StandingPerson person(table);
  const HeatScale scale = bodyScale(table);
  const double height = kViewTitle + kBodyViewHeight + 8.0;
  std::string svg = "<svg class=\"heat\" role=\"img\" viewBox=\"0 0 " + pixels(4.0 * kBodyViewWidth) + " " +
                    pixels(height + kHeatLegend) + "\" aria-label=\"exposure on the body\">\n";
  for (int v = 0; v < 4; ++v)
    svg += bodyView(person, {kBodyViews[v], v * kBodyViewWidth, person.model.height + kAboveHead}, scale);
  return svg + "<g transform=\"translate(44 " + pixels(height + 8.0) + ")\">" + scale.legend() +
         "</g>\n</svg>\n";
}

mesh_file::ColouredMesh bodyHeatMesh(const tune::ExposureTable& table) {
  mesh_file::ColouredMesh mesh;
  mesh.names = exposureNames();
  mesh.names.push_back("not_seen_s");
  mesh.comments = {"abstand: exposure on the body, seconds"};
  const StandingPerson person(table);
  const HeatScale scale = bodyScale(table);
  const margin::ExposureTime none;
  for (const humanmodel::HumanPart& part : person.model.parts) {
    const auto& cells = person.cells[humanmodel::index(part.part)];
    for (std::size_t cell = 0; cell < humanmodel::kCellCount; ++cell) {
      const auto found = cells.find(cell);
      const margin::ExposureTime& spent = found == cells.end() ? none : *found->second;
      std::array<Vector3d, 4> corners = humanmodel::cellCorners(cell);
      for (Vector3d& corner : corners) corner = person.at(part, corner);
      std::vector<double> values = exposureValues(spent);
      values.push_back(person.not_seen[humanmodel::index(part.part)]);
      mesh.addQuad(corners, HeatScale::colour(scale.classOf(spent.weighted)), values);
    }
  }
  return mesh;
}

}  // namespace abstand::report
