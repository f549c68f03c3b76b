// What the 3D view writes over its picture: closest points, names, legend.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/model/body_state.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/inspected_subject.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/model/pair_sentence.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/style/format.hpp"
#include "ui/viewport/viewport_impl.hpp"

namespace abstand::ui {

namespace {

constexpr std::size_t kClosestPairs = 4;  // lines; more hide the scene
constexpr std::size_t kBodyLabels = 4;
constexpr double kPokeMetresPerNewton = 1.0 / 400.0;  // the spring of a poke: its arrow ends at the pointer
constexpr double kFarLine = 1.5;                      // m; farther apart nothing is near

OverlayLabel::Style styleOf(PairLevel level) {
  switch (level) {
    case PairLevel::kTouching:
      return OverlayLabel::Style::kContact;
    case PairLevel::kInside:
      return OverlayLabel::Style::kInside;
    case PairLevel::kNear:
    case PairLevel::kLost:
      return OverlayLabel::Style::kNear;
    case PairLevel::kPaused:
    case PairLevel::kApart:
    case PairLevel::kUnknown:
      break;
  }
  return OverlayLabel::Style::kPlain;
}

QPointF axis(const Camera& camera, const Vector3d& direction) {
  const Vector3d s = camera.onScreen(direction);
  return {s.x(), s.y()};
}

}  // namespace

void Viewport::Impl::fillOverlay() {
  OverlayContent& content = overlay->content();
  content.labels.clear();
  content.segments.clear();
  content.legend.clear();
  content.handles.reset();
  shown.step = snapshot.step;
  if (!outline) return;
  camera.update();
  content.axes = {axis(camera, Vector3d::UnitX()), axis(camera, Vector3d::UnitY()),
                  axis(camera, Vector3d::UnitZ())};
  if (snapshot.pairs.size() == outline->pairs.size() && snapshot.objects.size() == outline->objects.size()) {
    if (options.closest) addClosest();
    if (options.labels) addRobotLabels();
    if (options.labels) addBodyLabels();
  }
  addPoke();
  addHandles();
  if (mouse.pull)
    content.segments.push_back(
        {camera.project(mouse.pull->first), camera.project(mouse.pull->second), QColor(kAccent), true});
  addLegend();
}

void Viewport::Impl::addClosest() {
  if (closest_.order.size() != snapshot.pairs.size()) {
    closest_.order.resize(snapshot.pairs.size());
    std::iota(closest_.order.begin(), closest_.order.end(), 0);
  }
  const auto distance = [&](int pair) {
    const view::PairSnapshot& p = snapshot.pairs[static_cast<std::size_t>(pair)];
    return std::isnan(p.result.distance) || p.paused ? kInfinity : p.result.distance;
  };
  // A hidden body has an outline while it touches something or is inside a margin; else a line would end in
  // the air.
  const auto drawn = [&](int object) { return objects.isVisible(object) || isBroken(stateOf(object).level); };
  const auto hidden = [&](int pair) {
    const auto& [a, b] = outline->pairs[static_cast<std::size_t>(pair)];
    return !drawn(a) || !drawn(b);
  };
  // The selected pair comes first, and those that hold a robot, then those of people and robots, then the
  // others, each by distance; pairs of hidden bodies come last. What is inside its margin goes before what is
  // not.
  const auto holds = [&](int pair) {
    return std::any_of(snapshot.robots.begin(), snapshot.robots.end(), [&](const view::RobotSnapshot& robot) {
      return robot.state != safety::StopState::kRunning && robot.cause.pair == pair;
    });
  };
  closest_.keys.resize(closest_.order.size());
  for (std::size_t i = 0; i < closest_.keys.size(); ++i) {
    const auto pair = static_cast<int>(i);
    const PairLevel level = pairLevel(snapshot, snapshot.pairs[i], outline->pairs[i]);
    const bool first = isBroken(level) || pairClassOf(*outline, outline->pairs[i]) == PairClass::kPersonRobot;
    const double d = distance(pair);
    closest_.keys[i] = hidden(pair)                              ? kInfinity
                       : pair == selection.pair() || holds(pair) ? -kInfinity
                       : first || !(d < kFarLine)                ? d
                                                                 : d + kFarLine;
  }
  const auto key = [&](int pair) { return closest_.keys[static_cast<std::size_t>(pair)]; };
  const std::size_t lines = std::min(kClosestPairs, closest_.order.size());
  std::partial_sort(closest_.order.begin(), closest_.order.begin() + static_cast<std::ptrdiff_t>(lines),
                    closest_.order.end(),
                    [&](int a, int b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  OverlayContent& content = overlay->content();
  for (std::size_t k = 0; k < lines; ++k) {
    const int pair = closest_.order[k];
    const view::PairSnapshot& now = snapshot.pairs[static_cast<std::size_t>(pair)];
    const query::PairResult& result = now.result;
    if (now.paused || hidden(pair)) continue;
    if (!(result.distance < kFarLine) && pair != selection.pair() && !holds(pair)) continue;
    if (!result.witness_a.allFinite() || !result.witness_b.allFinite()) continue;
    double depth_a = 0.0, depth_b = 0.0;
    const QPointF a = camera.project(result.witness_a, &depth_a);
    const QPointF b = camera.project(result.witness_b, &depth_b);
    if (depth_a <= 0.0 || depth_b <= 0.0) continue;
    const PairLevel level = pairLevel(snapshot, now, outline->pairs[static_cast<std::size_t>(pair)]);
    const auto style = styleOf(level);
    content.segments.push_back({a, b, levelColour(level), style == OverlayLabel::Style::kNear});
    if (k > 0 && pair != selection.pair()) continue;
    const double unknown = poseUncertainty(snapshot, outline->pairs[static_cast<std::size_t>(pair)]);
    content.labels.push_back({0.5 * (a + b), distanceText(result.distance, unknown), style, true});
  }
}

void Viewport::Impl::addRobotLabels() {
  OverlayContent& content = overlay->content();
  const auto add = [&](const std::string& robot, const QString& text, OverlayLabel::Style style) {
    // Above its highest link.
    const view::ObjectSnapshot* highest = nullptr;
    for (std::size_t i = 0; i < outline->objects.size(); ++i)
      if (outline->objects[i].group == robot &&
          (!highest || snapshot.objects[i].p_WCom.z() > highest->p_WCom.z()))
        highest = &snapshot.objects[i];
    double depth = 0.0;
    if (!highest) return;
    const QPointF at = camera.project(highest->p_WCom, &depth);
    if (depth > 0.0) content.labels.push_back({at, text, style});
  };
  for (std::size_t r = 0; r < std::min(outline->reacting.size(), snapshot.robots.size()); ++r) {
    const QString why = stopText(*outline, snapshot, r);
    if (why.isEmpty()) continue;
    const QString name = QString::fromStdString(outline->reacting[r]);
    const bool stopped = isStop(snapshot.robots[r].state);
    QString text = (stopped ? Viewport::tr("⚠ %1, %2") : Viewport::tr("▲ %1, %2")).arg(name, why);
    if (snapshot.robots[r].state == safety::StopState::kWaitingForReset && !content.reset_key.isEmpty())
      text += Viewport::tr(" (reset: %1)").arg(content.reset_key);
    add(outline->reacting[r], text, stopped ? OverlayLabel::Style::kContact : OverlayLabel::Style::kNear);
  }
  for (std::size_t r = 0; r < outline->robots.size(); ++r)
    if (isByHand(snapshot, static_cast<int>(r)))
      add(outline->robots[r].name,
          Viewport::tr("%1 is posed by hand").arg(QString::fromStdString(outline->robots[r].name)),
          OverlayLabel::Style::kPlain);
}

/// The force that the user applies, as an arrow on the screen with its size.
void Viewport::Impl::addPoke() {
  const view::PokeSnapshot& poke = snapshot.movers.poke;
  if (poke.object < 0 || !poke.p_W.allFinite() || !poke.force_W.allFinite()) return;
  double depth = 0.0, tip_depth = 0.0;
  const QPointF from = camera.project(poke.p_W, &depth);
  const QPointF to = camera.project(poke.p_W + kPokeMetresPerNewton * poke.force_W, &tip_depth);
  if (depth <= 0.0 || tip_depth <= 0.0) return;
  OverlayContent& content = overlay->content();
  content.segments.push_back({from, to, QColor(kViolet), false, true});
  content.labels.push_back(
      {to, Viewport::tr("Poke: %1 N").arg(fixed(poke.force_W.norm(), 0)), OverlayLabel::Style::kPlain, true});
}

BodyState Viewport::Impl::stateOf(int object) const {
  const auto i = static_cast<std::size_t>(object);
  return i < shown.bodies.size() ? shown.bodies[i] : BodyState{};
}

/// What touches is named before what is only inside a margin.
void Viewport::Impl::addBodyLabels() {
  OverlayContent& content = overlay->content();
  // The names of a whole robot would hide it.
  const bool few_chosen = selection.objects().size() <= kBodyLabels;
  const std::size_t bodies =
      std::min({snapshot.objects.size(), outline->objects.size(), shown.bodies.size()});
  std::size_t named = 0;
  for (const PairLevel level : {PairLevel::kTouching, PairLevel::kInside, PairLevel::kApart})
    for (std::size_t i = 0; i < bodies; ++i) {
      const BodyState& state = shown.bodies[i];
      const bool broken = isBroken(state.level);
      if (broken ? state.level != level : level != PairLevel::kApart) continue;
      const bool chosen = few_chosen && selection.contains(static_cast<int>(i));
      if (!chosen && (!broken || named >= kBodyLabels)) continue;
      double depth = 0.0;
      const QPointF at = camera.project(snapshot.objects[i].p_WCom, &depth);
      if (depth <= 0.0) continue;
      const QString name = QString::fromStdString(clearName(*outline, i));
      if (!broken) {
        content.labels.push_back({at, name, OverlayLabel::Style::kPlain});
        continue;
      }
      ++named;
      content.labels.push_back(
          {at, Viewport::tr("⚠ %1: %2").arg(name, state.words(options.min_force)), styleOf(state.level)});
    }
}

void Viewport::Impl::addLegend() {
  auto& legend = overlay->content().legend;
  const auto add = [&](LegendLine::Mark mark, QRgb colour, const ArrowScale& scale, const QString& text,
                       int decimals) {
    if (scale.metres <= 0.0) return;
    legend.push_back(
        {mark, QColor(colour), text.arg(lengthText(scale.metres, 0), fixed(scale.value, decimals))});
  };
  add(LegendLine::Mark::kArrow, kContactForce, arrows.forceScale(), Viewport::tr("Contact force: %1 ≙ %2 N"),
      1);
  add(LegendLine::Mark::kThinArrow, kVirtualForce, arrows.virtualScale(),
      Viewport::tr("Virtual (margin) force: %1 ≙ %2 N"), 1);
  add(LegendLine::Mark::kCurvedArrow, kBlue, arrows.torqueScale(), Viewport::tr("Torque: %1 ≙ %2 N·m"), 2);
  add(LegendLine::Mark::kCurvedArrow, kViolet, arrows.jointTorqueScale(),
      Viewport::tr("Joint torque of contacts and margins: %1 ≙ %2 N·m"), 2);
  add(LegendLine::Mark::kArrow, kViolet, arrows.jointForceScale(),
      Viewport::tr("Joint force of contacts and margins: %1 ≙ %2 N"), 1);
  add(LegendLine::Mark::kThinArrow, kCyan, arrows.velocityScale(), Viewport::tr("Velocity: %1 ≙ %2 m/s"), 2);
  if (depth_views.cloud.shown() == 0) return;
  const auto dot = [&](const CloudPoint& point, const QString& text) {
    if (depth_views.cloud.has(point))
      legend.push_back({LegendLine::Mark::kDot, QColor(colourOf(point, depth_views.cloud.colours())), text});
  };
  if (depth_views.cloud.colours() == CloudColours::kParts) {
    dot({{}, CloudPart::kPerson, {}}, Viewport::tr("Depth: person"));
    dot({{}, CloudPart::kRobot, {}}, Viewport::tr("Depth: robot"));
    return dot({}, Viewport::tr("Depth: other"));
  }
  dot({{}, CloudPart::kPerson, JointLook::kTracked}, Viewport::tr("Depth: joint tracked"));
  dot({{}, CloudPart::kPerson, JointLook::kInferred}, Viewport::tr("Depth: joint inferred"));
  dot({{}, CloudPart::kPerson, JointLook::kUnknown}, Viewport::tr("Depth: joint unknown"));
  dot({}, Viewport::tr("Depth: other"));
}

}  // namespace abstand::ui
