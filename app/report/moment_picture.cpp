#include "app/report/moment_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/report/svg_plot.hpp"
#include "app/run/pair_class.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::report {
namespace {

constexpr int kDirections = 48;                                          // of an outline
constexpr double kViewWidth = 360.0, kViewHeight = 300.0, kEdge = 10.0;  // pixels
// m, range of the half extent shown around the nearest points.
constexpr double kMinHalfExtent = 0.6, kMaxHalfExtent = 1.3;

/// Axes of a view in the world.
struct View {
  const char* title;
  Vector3d right, up;
};
const View kViews[] = {{"from above", Vector3d::UnitX(), Vector3d::UnitY()},
                       {"from the side", Vector3d::UnitX(), Vector3d::UnitZ()}};

/// World to pixels.
class Frame {
 public:
  Frame(const View& view, const Vector3d& centre, double half, double left)
      : view_(view), centre_(centre), scale_((kViewHeight - 2.0 * kEdge) / (2.0 * half)), left_(left) {}
  std::string at(const Vector3d& p) const {
    const Vector3d d = p - centre_;
    return pixels(left_ + 0.5 * kViewWidth + scale_ * view_.right.dot(d)) + "," +
           pixels(0.5 * kViewHeight - scale_ * view_.up.dot(d));
  }

 private:
  const View& view_;
  Vector3d centre_;
  double scale_, left_;
};

/// Vertices of the body's convex outline in a view, in order.
std::string outline(const scene::Object& object, const View& view, const Frame& frame) {
  std::string points;
  const Matrix3d R = object.X_WB.linear();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Vector3d n_W = std::cos(angle) * view.right + std::sin(angle) * view.up;
    points += frame.at(object.X_WB * object.spec.structure->support.extreme(R.transpose() * n_W).point) + " ";
  }
  return points;
}

/// Class in the page's style, and the same as attributes (svg_plot.cpp).
std::string styleOf(run::Side side, bool strong) {
  const char *name = "thing", *fill = "#888888", *stroke = "#888888";
  if (side == run::Side::kPerson) name = "person", fill = "#e69f00", stroke = "#b36b00";
  if (side == run::Side::kRobot) name = "robot", fill = "#56b4e9", stroke = "#2271a8";
  return std::string("class=\"") + name + (strong ? " strong" : "") + "\" fill=\"" + fill +
         "\" fill-opacity=\"0.33\" stroke=\"" + stroke + "\" stroke-width=\"" + (strong ? "2.4" : "0.8") +
         "\"";
}

}  // namespace

std::string momentPicture(const session::Session& session, const MomentBodies& bodies) {
  const scene::Scene& scene = session.scene();
  ObjectId part{0}, link{0};
  if (!scene.find(bodies.part, &part) || !scene.find(bodies.link, &link)) return {};
  Vector3d on_part = scene.object(part).X_WB.translation(), on_link = scene.object(link).X_WB.translation();
  for (const PairId id : scene.pairsOf(part)) {
    const scene::Pair& pair = scene.pairs()[id.index()];
    if (pair.a != link && pair.b != link) continue;
    on_part = pair.a == part ? pair.result.witness_a : pair.result.witness_b;
    on_link = pair.a == part ? pair.result.witness_b : pair.result.witness_a;
  }
  const Vector3d centre = 0.5 * (on_part + on_link);
  const double half = std::clamp((on_part - on_link).norm() * 1.5, kMinHalfExtent, kMaxHalfExtent);
  std::string svg =
      svgBegin("moment", 2.0 * kViewWidth, kViewHeight + 18.0, bodies.part + " and " + bodies.link);
  for (int v = 0; v < 2; ++v) {
    const View& view = kViews[v];
    const double left = v * kViewWidth;
    const Frame frame(view, centre, half, left);
    // A page has several pictures: the place makes the id its own, and equal ones clip alike.
    const std::string clip = "clip-" + pixels(1e3 * centre.x()) + "_" + pixels(1e3 * centre.y()) + "_" +
                             pixels(1e3 * centre.z()) + "-" + std::to_string(v);
    svg += "<clipPath id=\"" + clip + "\"><rect x=\"" + pixels(left + 2.0) + "\" y=\"0\" width=\"" +
           pixels(kViewWidth - 4.0) + "\" height=\"" + pixels(kViewHeight) +
           "\"/></clipPath>\n<g clip-path=\"url(#" + clip + ")\">\n";
    for (const scene::Object& object : scene.objects()) {
      const bool strong = object.spec.name == bodies.part || object.spec.name == bodies.link;
      svg += "<polygon " + styleOf(run::sideOf(session.description(), object.spec.group), strong) +
             " points=\"" + outline(object, view, frame) + "\"><title>" + text::escapedXml(object.spec.name) +
             "</title></polygon>\n";
    }
    svg += "<polyline class=\"gap\" fill=\"none\" stroke=\"#b34700\" stroke-width=\"2.5\" points=\"" +
           frame.at(on_part) + " " + frame.at(on_link) + "\"/>\n</g>\n<text x=\"" + pixels(left + 8.0) +
           "\" y=\"" + pixels(kViewHeight + 13.0) + "\">" + view.title + "; " + pixels(2.0 * half) +
           " m high</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace abstand::report
