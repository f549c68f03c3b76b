// Writes a robot as a URDF.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/roll_pitch_yaw.hpp"
#include "core/robot_file/robot_writer.hpp"
#include "core/robot_file/urdf_model.hpp"
#include "core/robot_file/xml_values.hpp"

namespace abstand::robot_file {
namespace {

constexpr double kUrdfRounding = 1e-15;

Vector3d neat(const Vector3d& v) {
  return {neatNumber(v.x(), kUrdfRounding), neatNumber(v.y(), kUrdfRounding),
          neatNumber(v.z(), kUrdfRounding)};
}

std::string originText(const Transform& X) {
  return "<origin xyz=\"" + xmlNumbers(neat(X.translation())) + "\" rpy=\"" +
         xmlNumbers(neatRollPitchYaw(X.linear())) + "\"/>";
}

struct ShapeElement {
  std::string operator()(const geometry::Sphere& s) const {
    return "<sphere radius=\"" + formatDouble(s.radius) + "\"/>";
  }
  std::string operator()(const geometry::Cuboid& s) const {
    return "<box size=\"" + xmlNumbers(s.size) + "\"/>";
  }
  std::string operator()(const geometry::Cylinder& s) const {
    return "<cylinder radius=\"" + formatDouble(s.radius) + "\" length=\"" + formatDouble(s.length) + "\"/>";
  }
  std::string operator()(const geometry::Ellipsoid&) const { return refuse("an ellipsoid"); }
  std::string operator()(const geometry::Capsule&) const { return refuse("a capsule"); }
  [[noreturn]] static std::string refuse(const char* what) {
    throw UsageError(std::string("found ") + what +
                     " among the geometry, expected what URDF has: mesh, box, sphere, cylinder");
  }
};

class UrdfWriter {
 public:
  explicit UrdfWriter(const Robot& robot) : robot_(robot), m_(robot.mechanism) {
    for (const auto& f : m_.frames) links_.insert(f.name);
    scale_.assign(static_cast<std::size_t>(m_.dof), 1.0);
    leader_.assign(static_cast<std::size_t>(m_.dof), nullptr);
    for (const auto& f : m_.frames)
      if (f.dof >= 0 && !f.mimic && !leader_[static_cast<std::size_t>(f.dof)]) lead(f);
    // A dof moved by mimic joints only is led by the first of them.
    for (const auto& f : m_.frames)
      if (f.dof >= 0 && !leader_[static_cast<std::size_t>(f.dof)]) lead(f);
  }

  UrdfWritten write() {
    text_ = "<?xml version=\"1.0\"?>\n<robot name=\"" + xmlEscaped(m_.name) + "\">\n";
    int roots = 0;
    bool carries_geometry = false;
    for (const auto& f : m_.frames) roots += f.parent < 0 ? 1 : 0;
    for (const auto& g : robot_.geometry) carries_geometry = carries_geometry || g.frame < 0;
    const auto& first = m_.frames.front();
    const bool has_root = roots == 1 && !carries_geometry && first.type == mechanism::JointType::kFixed &&
                          first.X_PJ.matrix() == Transform::Identity().matrix();
    if (!has_root) {
      while (!links_.insert(base_).second) base_ += '_';
      link(-1);
    }
    for (std::size_t i = 0; i < m_.frames.size(); ++i) link(static_cast<int>(i));
    // Degrees of freedom are numbered in file order.
    for (const auto* f : leader_) joint(*f);
    for (std::size_t i = has_root ? 1 : 0; i < m_.frames.size(); ++i)
      if (!leads(m_.frames[i])) joint(m_.frames[i]);
    text_ += "</robot>\n";
    return {std::move(text_), std::move(scale_)};
  }

 private:
  void lead(const mechanism::MechanismFrame& f) {
    leader_[static_cast<std::size_t>(f.dof)] = &f;
    scale_[static_cast<std::size_t>(f.dof)] = f.scale;
  }
  bool leads(const mechanism::MechanismFrame& f) const {
    return f.dof >= 0 && leader_[static_cast<std::size_t>(f.dof)] == &f;
  }

  void link(int index) {
    const std::string& name = index < 0 ? base_ : m_.frames[static_cast<std::size_t>(index)].name;
    text_ += "  <link name=\"" + xmlEscaped(name) + "\">\n";
    if (index >= 0) inertial(m_.frames[static_cast<std::size_t>(index)].inertia);
    for (const auto& g : robot_.geometry) {
      if (g.frame != index) continue;
      const std::string kind = g.use == GeometryUse::kVisual ? "visual" : "collision";
      text_ += "    <" + kind + ">" + originText(g.X_FG) + "<geometry>";
      text_ += g.shape
                   ? std::visit(ShapeElement{}, *g.shape)
                   : "<mesh filename=\"" + xmlEscaped(g.mesh) + "\" scale=\"" + xmlNumbers(g.scale) + "\"/>";
      text_ += "</geometry></" + kind + ">\n";
    }
    text_ += "  </link>\n";
  }

  void inertial(const mechanism::LinkInertia& i) {
    if (i.mass <= 0.0 && i.inertia_F.isZero(0.0)) return;
    const Matrix3d& I = i.inertia_F;
    const auto moment = [&](const char* key, double v) {
      return std::string(" ") + key + "=\"" + formatDouble(v) + "\"";
    };
    text_ += "    <inertial><origin xyz=\"" + xmlNumbers(i.com_F) + "\"/><mass value=\"" +
             formatDouble(i.mass) + "\"/><inertia" + moment("ixx", I(0, 0)) + moment("iyy", I(1, 1)) +
             moment("izz", I(2, 2)) + moment("ixy", I(0, 1)) + moment("ixz", I(0, 2)) +
             moment("iyz", I(1, 2)) + "/></inertial>\n";
  }

  std::string jointName(const mechanism::MechanismFrame& f) const {
    return f.joint.empty() ? f.name + "_joint" : f.joint;
  }

  void joint(const mechanism::MechanismFrame& f) {
    const bool moves = f.type != mechanism::JointType::kFixed;
    const bool slides = f.type == mechanism::JointType::kPrismatic;
    Transform X = f.X_PJ;
    double offset = f.offset;
    if (leads(f) || f.dof < 0) {  // a leading joint has no offset in a URDF
      if (slides)
        X.translate(offset * f.axis);
      else if (moves)
        X.rotate(Eigen::AngleAxisd(offset, f.axis));
      offset = 0.0;
    }
    const bool limited = std::isfinite(f.limits.lower) || std::isfinite(f.limits.upper);
    const char* type = !moves || f.dof < 0 ? "fixed"
                       : slides            ? "prismatic"
                       : limited           ? "revolute"
                                           : "continuous";
    const std::string& parent = f.parent < 0 ? base_ : m_.frames[static_cast<std::size_t>(f.parent)].name;
    text_ += "  <joint name=\"" + xmlEscaped(jointName(f)) + "\" type=\"" + type + "\">\n    " +
             originText(X) + "\n    <parent link=\"" + xmlEscaped(parent) + "\"/><child link=\"" +
             xmlEscaped(f.name) + "\"/>\n";
    if (f.dof >= 0) {
      text_ += "    <axis xyz=\"" + xmlNumbers(f.axis) + "\"/>\n";
      limit(f, leads(f) ? f.offset : 0.0, slides || limited);
      if (!leads(f)) {
        const mechanism::MechanismFrame& leader = *leader_[static_cast<std::size_t>(f.dof)];
        text_ += "    <mimic joint=\"" + xmlEscaped(jointName(leader)) + "\" multiplier=\"" +
                 formatDouble(f.scale / leader.scale) + "\" offset=\"" + formatDouble(offset) + "\"/>\n";
      }
    }
    text_ += "  </joint>\n";
  }

  void limit(const mechanism::MechanismFrame& f, double offset, bool ends) {
    const auto known = [](double v, double otherwise) {
      return formatDouble(std::isfinite(v) ? v : otherwise);
    };
    const mechanism::JointLimits& l = f.limits;
    if (!ends && !std::isfinite(l.velocity) && !std::isfinite(l.effort)) return;
    text_ += "    <limit";
    if (ends)
      text_ += " lower=\"" + known(neatNumber(l.lower - offset, kUrdfRounding), -kUrdfNoLimit) +
               "\" upper=\"" + known(neatNumber(l.upper - offset, kUrdfRounding), kUrdfNoLimit) + "\"";
    text_ += " velocity=\"" + known(l.velocity, kUrdfNoLimit) + "\" effort=\"" +
             known(l.effort, kUrdfNoLimit) + "\"/>\n";
  }

  const Robot& robot_;
  const mechanism::Mechanism& m_;
  std::string text_, base_{"base"};
  std::unordered_set<std::string> links_;
  std::vector<double> scale_;
  std::vector<const mechanism::MechanismFrame*> leader_;  ///< for each dof
};

}  // namespace

UrdfWritten urdfText(const Robot& robot) { return UrdfWriter(robot).write(); }

}  // namespace abstand::robot_file
