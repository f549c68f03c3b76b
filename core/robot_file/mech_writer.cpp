// Writes a robot as a mechanism file.
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/utf8.hpp"
#include "core/math/roll_pitch_yaw.hpp"
#include "core/robot_file/mech_extras.hpp"
#include "core/robot_file/robot_writer.hpp"

namespace abstand::robot_file {
namespace {

constexpr double kRounding = 1e-15;  // m or rad

std::string length(double v) { return " " + formatDouble(neatNumber(v, kRounding)); }
std::string plain(double v) { return " " + formatDouble(v); }
std::string angle(double v) {
  return " " +
         formatDouble(neatNumber(v * 180.0 / kPi, std::max(kRounding, 4e-16 * std::abs(v)) * 180.0 / kPi));
}
std::string limit(double v, bool is_length) {
  if (!std::isfinite(v)) return " none";
  return is_length ? length(v) : angle(v);
}

std::string poseText(const Transform& X) {
  std::string s;
  for (int row = 0; row < 3; ++row) {
    s += ' ';
    for (int column = 0; column < 4; ++column) s += length(X(row, column));
  }
  return s;
}

std::string mapping(const mechanism::Mechanism& m) {
  std::vector<std::string> lines(static_cast<std::size_t>(m.dof));
  std::string mimics;
  for (const auto& f : m.frames) {
    if (f.dof < 0) continue;
    std::string line = std::to_string(f.dof) + " " + std::to_string(f.id);
    const bool turns = f.type != mechanism::JointType::kPrismatic;
    if (f.offset != 0.0 || f.scale != 1.0)
      line += (turns ? angle(f.offset) : length(f.offset)) + plain(f.scale);
    auto& leader = lines[static_cast<std::size_t>(f.dof)];
    if (leader.empty() && !f.mimic)
      leader = "    dof " + line + "\n";
    else
      mimics += "    mimic " + line + "\n";
  }
  std::string s;
  for (const auto& line : lines) s += line;
  return s.empty() ? "" : "\nmapping\n" + s + mimics + "end_mapping\n";
}

std::string chains(const mechanism::Mechanism& m) {
  std::string s;
  int last = -1;  // frame that the next row would follow
  bool open = false;
  for (std::size_t i = 0; i < m.frames.size(); ++i) {
    const auto& f = m.frames[i];
    ABSTAND_CHECK(f.has_dh);
    if (!open || f.parent != last) {
      if (open) s += "end_chain\n";
      s += "\nchain\n";
      if (f.parent >= 0)
        s += "    reference " + std::to_string(m.frames[static_cast<std::size_t>(f.parent)].id) + "\n";
      open = true;
    }
    const bool moves = f.dof >= 0;
    s += "    frame " + std::to_string(f.id) + length(f.a) + angle(f.alpha);
    s += moves && f.type == mechanism::JointType::kPrismatic ? " d" : length(f.d);
    s += moves && f.type == mechanism::JointType::kRevolute ? " theta\n" : angle(f.theta) + "\n";
    last = static_cast<int>(i);
  }
  return s + "end_chain\n";
}

std::string geometryLine(const LinkGeometry& g, const mechanism::Mechanism& m) {
  std::string s = g.use == GeometryUse::kVisual ? "    visual " : "    collision ";
  s += std::to_string(g.frame < 0 ? 0 : m.frames[static_cast<std::size_t>(g.frame)].id);
  if (!g.shape)
    s += " mesh " + mechWord(g.mesh) + plain(g.scale.x()) + plain(g.scale.y()) + plain(g.scale.z());
  else
    s += " " + std::string(geometry::shapeName(*g.shape)) +
         std::visit(
             [](const auto& shape) {
               using T = std::decay_t<decltype(shape)>;
               if constexpr (std::is_same_v<T, geometry::Sphere>)
                 return plain(shape.radius);
               else if constexpr (std::is_same_v<T, geometry::Cuboid>)
                 return plain(shape.size.x()) + plain(shape.size.y()) + plain(shape.size.z());
               else if constexpr (std::is_same_v<T, geometry::Ellipsoid>)
                 return plain(shape.semi_axes.x()) + plain(shape.semi_axes.y()) + plain(shape.semi_axes.z());
               else
                 return plain(shape.radius) + plain(shape.length);
             },
             *g.shape);
  return s + " " + poseText(g.X_FG) + "\n";
}

std::string environment(const char* name, const std::string& comment, const std::string& lines) {
  if (lines.empty()) return "";
  return std::string("\n") + name + "\n    # " + comment + "\n" + lines + "end_" + name + "\n";
}

}  // namespace

std::string mechText(const Robot& robot) {
  const mechanism::Mechanism& m = robot.mechanism;
  std::string s = "# " + (isPlainText(m.name) ? m.name : std::string("robot")) +
                  ": modified (Craig) Denavit-Hartenberg convention.\n\nunits\n    length m\n    angle "
                  "degrees\nend_units\n";
  s += mapping(m) + chains(m);
  std::string names, limits, bodies, geometry;
  for (const auto& f : m.frames) {
    const std::string id = std::to_string(f.id);
    if (f.has_center) s += "\nlink\n    id " + id + "\n    center" + poseText(f.X_FC) + "\nend_link\n";
    if (f.name != id || !f.joint.empty())
      names +=
          "    name " + id + " " + mechWord(f.name) + (f.joint.empty() ? "" : " " + mechWord(f.joint)) + "\n";
    const mechanism::JointLimits& l = f.limits;
    const bool slides = f.type == mechanism::JointType::kPrismatic;
    if (f.dof >= 0 && (std::isfinite(l.lower) || std::isfinite(l.upper) || std::isfinite(l.velocity) ||
                       std::isfinite(l.effort) || std::isfinite(l.acceleration)))
      limits += "    limit " + id + limit(l.lower, slides) + limit(l.upper, slides) +
                limit(l.velocity, slides) + (std::isfinite(l.effort) ? plain(l.effort) : " none") +
                (std::isfinite(l.acceleration) ? limit(l.acceleration, slides) : "") + "\n";
    const Matrix3d& I = f.inertia.inertia_F;
    if (f.inertia.mass > 0.0 || !I.isZero(0.0))
      bodies += "    body " + id + plain(f.inertia.mass) + plain(f.inertia.com_F.x()) +
                plain(f.inertia.com_F.y()) + plain(f.inertia.com_F.z()) + plain(I(0, 0)) + plain(I(1, 1)) +
                plain(I(2, 2)) + plain(I(0, 1)) + plain(I(0, 2)) + plain(I(1, 2)) + "\n";
  }
  for (const auto& g : robot.geometry) geometry += geometryLine(g, m);
  return s + environment("names", "frame, name, joint", names) +
         environment("limits", "frame, lower, upper, velocity, effort", limits) +
         environment("inertia", "frame, mass, centre of mass, ixx iyy izz ixy ixz iyz", bodies) +
         environment("geometry", "frame, kind, sizes, rows of [R|t]", geometry);
}

}  // namespace abstand::robot_file
