#include "core/robot_file/mech_extras.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/number.hpp"
#include "core/base/utf8.hpp"
#include "core/text/message_text.hpp"

namespace abstand::robot_file {
namespace {

constexpr double kMaxExtra = 1e6;
constexpr double kPoseTolerance = 1e-3;  // as for the centres of links
constexpr std::size_t kPoseNumbers = 12;

const std::vector<std::string> kShapes{"mesh", "sphere", "cuboid", "cylinder", "capsule", "ellipsoid"};

/// Number of values or words of a geometry between its kind and its pose.
std::size_t sizesOf(std::string_view kind) {
  if (kind == "sphere") return 1;
  if (kind == "cuboid" || kind == "ellipsoid") return 3;
  return kind == "mesh" ? 4 : 2;
}

}  // namespace

std::string mechWord(const std::string& text) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string word;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7f || c == '#' || c == '%')
      (word += '%') += {kHex[byte >> 4], kHex[byte & 15]};
    else
      word += c;
  }
  return word;
}

std::optional<std::string> fromMechWord(std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != '%') {
      text += word[i];
      continue;
    }
    unsigned byte = 0;
    const char* const first = word.data() + i + 1;
    if (i + 2 >= word.size() || std::from_chars(first, first + 2, byte, 16).ptr != first + 2 || byte < 0x20)
      return std::nullopt;
    text += static_cast<char>(byte);
    i += 2;
  }
  return text;
}

bool MechExtras::read(const MechLine& begin) {
  const auto environment = begin.words[0].text;
  const bool is_geometry = environment == "geometry";
  std::vector<Item>* const items = is_geometry                ? &geometries_
                                   : environment == "names"   ? &names_
                                   : environment == "limits"  ? &limits_
                                   : environment == "inertia" ? &bodies_
                                                              : nullptr;
  if (!items) return false;
  reader_.expectAlone(begin);
  const std::vector<std::string> commands = is_geometry ? std::vector<std::string>{"collision", "visual"}
                                            : environment == "names"  ? std::vector<std::string>{"name"}
                                            : environment == "limits" ? std::vector<std::string>{"limit"}
                                                                      : std::vector<std::string>{"body"};
  while (const MechLine* line = reader_.command(begin, commands)) {
    if (line->words.size() < 2) reader_.expectValues(*line, 1, "a frame and what belongs to it");
    items->push_back({line, reader_.integer(*line, 1, is_geometry ? 0 : 1, "the id of a frame")});
  }
  return true;
}

void MechExtras::apply(const MechUnits& units, Robot& robot) const {
  std::set<double> named, limited, weighed;
  const auto once = [&](const Item& item, std::set<double>& seen) {
    if (!seen.insert(item.frame.value).second)
      reader_.fail(item.frame,
                   "found frame " + formatDouble(item.frame.value) + " a second time, expected it once");
  };
  // Geometry and limits refer to ids; names are applied last, so that messages use ids.
  for (const Item& item : limits_) {
    once(item, limited);
    limit(item, units, robot.mechanism);
  }
  for (const Item& item : bodies_) {
    once(item, weighed);
    body(item, units, robot.mechanism);
  }
  for (const Item& item : geometries_) geometry(item, units, robot);
  for (const Item& item : names_) {
    once(item, named);
    name(item, robot);
  }
}

mechanism::MechanismFrame& MechExtras::frameOf(const Item& item, mechanism::Mechanism& mechanism) const {
  const int index = mechanism.indexOf(static_cast<int>(item.frame.value));
  if (index < 0)
    reader_.fail(item.frame, "found the frame " + formatDouble(item.frame.value) +
                                 ", expected a frame that a chain defines");
  return mechanism.frames[static_cast<std::size_t>(index)];
}

double MechExtras::si(const MechNumber& n, double unit) const {
  const double value = n.value * unit;
  if (std::abs(value) > kMaxExtra)
    reader_.fail(n, "found " + formatDouble(n.value) + ", expected at most " +
                        formatDouble(kMaxExtra / unit) + " in size");
  return value;
}

void MechExtras::name(const Item& item, Robot& robot) const {
  const MechLine& line = *item.line;
  if (line.words.size() != 4) reader_.expectValues(line, 2, "a frame, its name and, if wanted, its joint's");
  auto& frame = frameOf(item, robot.mechanism);
  for (std::size_t i = 2; i < line.words.size(); ++i) {
    const auto text = fromMechWord(line.words[i].text);
    if (!text || text->empty() || !isPlainText(*text))
      reader_.fail(line.line, line.words[i].column,
                   "found " + text::inQuotes(line.words[i].text) + ", expected a name with %20 for a blank");
    if (i == 2)
      for (const auto& other : robot.mechanism.frames)
        if (other.name == *text && &other != &frame)
          reader_.fail(line.line, line.words[i].column,
                       "found the name " + abstand::text::inQuotes(*text) +
                           " that another frame has, expected unique names");
    (i == 2 ? frame.name : frame.joint) = *text;
  }
}

double MechExtras::limitOr(const Item& item, std::size_t i, const char* what, double unit,
                           double none) const {
  if (item.line->words[i].text == "none") return none;
  if (!parseDouble(item.line->words[i].text))
    reader_.unknown(*item.line, i, std::string(what) + ": a finite number, or the word none", {"none"});
  return si(reader_.number(*item.line, i, what), unit);
}

void MechExtras::limit(const Item& item, const MechUnits& units, mechanism::Mechanism& mechanism) const {
  const bool accelerates = item.line->words.size() == 7;
  if (!accelerates)
    reader_.expectValues(*item.line, 5,
                         "frame, lower, upper, velocity, effort (and, if known, acceleration)");
  auto& frame = frameOf(item, mechanism);
  if (frame.type == mechanism::JointType::kFixed)
    reader_.fail(item.frame, "found frame " + frame.name + ", which is constant, expected one that moves");
  const double unit = frame.type == mechanism::JointType::kPrismatic ? units.length : units.angle;
  mechanism::JointLimits& l = frame.limits;
  l.lower = limitOr(item, 2, "the lower limit", unit, -kInfinity);
  l.upper = limitOr(item, 3, "the upper limit", unit, kInfinity);
  l.velocity = limitOr(item, 4, "the velocity", unit, kInfinity);
  l.effort = limitOr(item, 5, "the effort", 1.0, kInfinity);
  if (accelerates) l.acceleration = limitOr(item, 6, "the acceleration", unit, kInfinity);
  const auto refuse = [&](std::size_t i, const char* expected) {
    reader_.fail(item.line->line, item.line->words[i].column,
                 "found " + text::inQuotes(item.line->words[i].text) + ", expected " + expected);
  };
  if (l.lower > l.upper) refuse(3, "an upper limit not below the lower one");
  if (l.velocity < 0.0) refuse(4, "a velocity from 0 on");
  if (l.effort < 0.0) refuse(5, "an effort from 0 on");
  if (!(l.acceleration > 0.0)) refuse(6, "an acceleration above 0");
}

void MechExtras::body(const Item& item, const MechUnits& units, mechanism::Mechanism& mechanism) const {
  reader_.expectValues(*item.line, 11, "frame, mass, centre of mass x y z, ixx iyy izz ixy ixz iyz");
  auto& inertia = frameOf(item, mechanism).inertia;
  const auto at = [&](std::size_t i, double unit) {
    return si(reader_.number(*item.line, i, "a number"), unit);
  };
  inertia.mass = at(2, 1.0);
  if (inertia.mass < 0.0)
    reader_.fail(item.line->line, item.line->words[2].column,
                 "found a negative mass, expected one from 0 on");
  inertia.com_F = {at(3, units.length), at(4, units.length), at(5, units.length)};
  const double xx = at(6, 1.0), yy = at(7, 1.0), zz = at(8, 1.0), xy = at(9, 1.0), xz = at(10, 1.0),
               yz = at(11, 1.0);
  inertia.inertia_F << xx, xy, xz, xy, yy, yz, xz, yz, zz;
}

Transform MechExtras::pose(const Item& item, std::size_t first, const MechUnits& units) const {
  Transform X = Transform::Identity();
  for (std::size_t i = 0; i < kPoseNumbers; ++i) {
    const MechNumber n = reader_.number(*item.line, first + i, "an entry of [R|t]");
    const int row = static_cast<int>(i / 4), column = static_cast<int>(i % 4);
    X(row, column) = si(n, column == 3 ? units.length : 1.0);
  }
  if (!isPose(X, kPoseTolerance))
    reader_.fail(item.line->line, item.line->words[first].column,
                 "found a matrix that is no pose, expected the rows of [R|t] with a rotation R");
  X.linear() = Quaterniond(X.linear()).normalized().toRotationMatrix();
  return X;
}

void MechExtras::addShape(const Item& item, const MechUnits& units, LinkGeometry& geometry) const {
  const MechLine& line = *item.line;
  const auto kind = line.words[2].text;
  const auto size = [&](std::size_t i) {
    const MechNumber n = reader_.number(line, 2 + i, "a size");
    const double value = si(n, units.length);
    if (value < geometry::kMinDimension && !(kind == "capsule" && i == 2 && value == 0.0))
      reader_.fail(n,
                   "found the size " + text::inQuotes(line.words[2 + i].text) + ", expected a positive one");
    return value;
  };
  if (kind == "sphere") geometry.shape = geometry::Sphere{size(1)};
  if (kind == "cuboid") geometry.shape = geometry::Cuboid{{size(1), size(2), size(3)}};
  if (kind == "ellipsoid") geometry.shape = geometry::Ellipsoid{{size(1), size(2), size(3)}};
  if (kind == "cylinder") geometry.shape = geometry::Cylinder{size(1), size(2)};
  if (kind == "capsule") geometry.shape = geometry::Capsule{size(1), size(2)};
}

void MechExtras::geometry(const Item& item, const MechUnits& units, Robot& robot) const {
  const MechLine& line = *item.line;
  if (line.words.size() < 3) reader_.expectValues(line, 2, "frame, kind, sizes, and the rows of [R|t]");
  const auto kind = line.words[2].text;
  if (std::find(kShapes.begin(), kShapes.end(), kind) == kShapes.end())
    reader_.unknown(line, 2, "mesh, sphere, cuboid, cylinder, capsule or ellipsoid", kShapes);
  reader_.expectValues(line, 2 + sizesOf(kind) + kPoseNumbers,
                       kind == "mesh" ? "frame, mesh, file, three scales, and the rows of [R|t]"
                                      : "frame, kind, sizes, and the rows of [R|t]");
  LinkGeometry g;
  g.pos = {reader_.fileName(), line.line, line.words[0].column};
  g.use = line.words[0].text == "visual" ? GeometryUse::kVisual : GeometryUse::kCollision;
  if (item.frame.value != 0.0)
    g.frame = static_cast<int>(&frameOf(item, robot.mechanism) - robot.mechanism.frames.data());
  if (kind == "mesh") {
    const auto file = fromMechWord(line.words[3].text);
    if (!file || file->empty() || !isPlainText(*file))
      reader_.fail(line.line, line.words[3].column,
                   "found " + text::inQuotes(line.words[3].text) + ", expected a file with %20 for a blank");
    g.mesh = *file;
    for (std::size_t i = 0; i < 3; ++i) {
      const MechNumber n = reader_.number(line, 4 + i, "a scale");
      g.scale[static_cast<int>(i)] = si(n, 1.0);
      if (n.value == 0.0) reader_.fail(n, "found the scale 0, expected another number");
    }
  } else {
    addShape(item, units, g);
  }
  g.X_FG = pose(item, 3 + sizesOf(kind), units);
  robot.geometry.push_back(std::move(g));
}

}  // namespace abstand::robot_file
