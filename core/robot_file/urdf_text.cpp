#include "core/robot_file/urdf_text.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "core/base/number.hpp"
#include "core/geometry/shape.hpp"
#include "core/robot_file/urdf_tree.hpp"
#include "core/robot_file/xml_values.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::robot_file {
namespace {

using text::inDoubleQuotes;

constexpr double kAxisTolerance = 1e-3;  // an axis whose length differs from 1 by more than this is an error

const std::array<std::string, 6> kTypes{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};

std::string attribute(const char* key, const std::string& value) {
  return std::string(" ") + key + "=\"" + xmlEscaped(value) + "\"";
}
std::string attribute(const char* key, double value) { return attribute(key, formatDouble(value)); }
std::string attribute(const char* key, const Vector3d& value) { return attribute(key, xmlNumbers(value)); }

/// Reads all elements and writes the supported ones.
class UrdfChecker {
 public:
  explicit UrdfChecker(const std::string& file) : file_(file), values_(file) {}

  UrdfText run(const XmlElement& robot) {
    if (robot.name != "robot")
      values_.fail(robot, "found <" + std::string(robot.name.substr(0, 40)) + ">, expected <robot>: a URDF");
    refuseXacro(robot);
    out_.name = values_.text(robot, "name").value_or("robot");
    std::string& d = out_.document;
    d = "<robot" + attribute("name", out_.name.empty() ? "robot" : out_.name) + ">\n";
    for (const auto& e : robot.children) {
      if (e.name == "link") link(e);
      if (e.name == "joint") joint(e);
    }
    d += "</robot>\n";
    if (out_.links.empty()) values_.fail(robot, "found a robot without a link, expected at least one");
    checkUrdfTree(out_, file_);
    return std::move(out_);
  }

 private:
  /// A file that only declares the xacro namespace is already expanded.
  void refuseXacro(const XmlElement& e) const {
    const auto refuse = [&](const std::string& found) {
      values_.fail(e, "found " + found + ", which is xacro, expected a URDF",
                   "expand it first: xacro FILE > robot.urdf");
    };
    if (e.name.starts_with("xacro:")) refuse("<" + std::string(e.name.substr(0, 40)) + ">");
    for (const auto& [key, value] : e.attributes)
      if (value.find("${") != std::string_view::npos || value.find("$(") != std::string_view::npos)
        refuse(text::inDoubleQuotes(value));
    for (const auto& child : e.children) refuseXacro(child);
  }

  UrdfPlace place(const XmlElement& e) const { return {e.line, e.column}; }
  void warn(const XmlElement& e, const std::string& text) {
    out_.warnings.push_back(values_.warning(e, text));
  }

  std::string newName(const XmlElement& e, std::unordered_set<std::string>& taken) const {
    std::string name = values_.needText(e, "name");
    if (!taken.insert(name).second)
      values_.fail(e, "found the " + std::string(e.name) + " name " + text::inDoubleQuotes(name) +
                          " a second time, expected unique names");
    return name;
  }

  void origin(const XmlElement& parent) {
    const auto* e = parent.child("origin");
    if (!e) return;
    out_.document += "<origin" + attribute("xyz", values_.vector(*e, "xyz").value_or(Vector3d::Zero())) +
                     attribute("rpy", values_.vector(*e, "rpy").value_or(Vector3d::Zero())) + "/>";
  }

  void link(const XmlElement& e) {
    if (out_.links.size() == kMaxUrdfLinks)
      values_.fail(e, "found more than " + std::to_string(kMaxUrdfLinks) + " links, expected fewer");
    UrdfLinkText link;
    link.name = newName(e, link_names_);
    link.place = place(e);
    out_.document += "<link" + attribute("name", link.name) + ">";
    if (const auto* inertial = e.child("inertial")) this->inertial(*inertial);
    for (const auto& child : e.children) {
      if (child.name == "visual") {
        if (const std::string problem = visual(child); problem.empty())
          link.visuals.push_back(place(child));
        else
          link.unread = problem;
      }
      if (child.name == "collision") {
        if (isPoint(child)) {
          warn(child, "found a sphere of radius 0 in <collision>, expected a positive one: ignored");
          continue;
        }
        if (const std::string problem = geometryProblem(child); !problem.empty())
          values_.fail(child, problem);
        body(child);
        link.collisions.push_back(place(child));
      }
    }
    out_.document += "</link>\n";
    out_.links.push_back(std::move(link));
  }

  void inertial(const XmlElement& e) {
    const auto *mass = e.child("mass"), *inertia = e.child("inertia");
    if (!mass || !inertia)
      return warn(e, std::string("found <inertial> without <") + (mass ? "inertia" : "mass") +
                         ">, expected both: treated as unknown");
    const double m = values_.needNumber(*mass, "value");
    Matrix3d I;
    constexpr std::array<const char*, 6> kKeys{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    constexpr std::array<std::pair<int, int>, 6> kPlaces{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
    std::string moments;
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      const double value = values_.number(*inertia, kKeys[i]).value_or(0.0);
      I(kPlaces[i].first, kPlaces[i].second) = I(kPlaces[i].second, kPlaces[i].first) = value;
      moments += attribute(kKeys[i], value);
    }
    if (m <= 0.0) warn(*mass, "found the mass " + formatDouble(m) + " kg, expected a positive one");
    // Moments of a real body: positive, and none above the sum of the others.
    const Vector3d moment = Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();
    const double slack = 1e-6 * std::max(moment.cwiseAbs().maxCoeff(), 1e-12);
    if (m > 0.0 && (moment.minCoeff() < -slack || moment.maxCoeff() > 0.5 * moment.sum() + slack))
      warn(*inertia,
           "found moments of inertia that no body has, expected them positive, none above the sum of the "
           "others");
    out_.document += "<inertial>";
    origin(e);
    out_.document +=
        "<mass" + attribute("value", std::max(m, 0.0)) + "/><inertia" + moments + "/></inertial>";
  }

  /// True for a sphere of radius 0, used in real files for links without a body: no collision geometry.
  bool isPoint(const XmlElement& e) const {
    const auto* geometry = e.child("geometry");
    if (!geometry || geometry->children.empty() || geometry->children.front().name != "sphere") return false;
    return values_.number(geometry->children.front(), "radius") == 0.0;
  }

  /// Problem of the geometry of a visual or collision; empty if there is none. Invalid numbers throw.
  std::string geometryProblem(const XmlElement& e) const {
    const std::string what = "<" + std::string(e.name) + ">";
    const auto* geometry = e.child("geometry");
    if (!geometry || geometry->children.empty()) return "found " + what + " without a geometry, expected one";
    const XmlElement& shape = geometry->children.front();
    const auto positive = [&](const char* key) {
      const double value = values_.needNumber(shape, key);
      return value >= geometry::kMinDimension ? ""
                                              : std::string("found the ") + key + " " + formatDouble(value) +
                                                    " in " + what + ", expected a positive one";
    };
    if (shape.name == "mesh") {
      values_.needText(shape, "filename");
      const Vector3d scale = values_.vector(shape, "scale").value_or(Vector3d::Ones());
      return (scale.array() != 0.0).all() ? ""
                                          : "found a scale of 0 in " + what + ", expected another number";
    }
    if (shape.name == "sphere") return positive("radius");
    if (shape.name == "cylinder") return positive("radius") + positive("length");
    if (shape.name != "box")
      return "found the geometry " + text::inDoubleQuotes(shape.name) + " in " + what +
             ", expected mesh, box, sphere or cylinder";
    values_.needText(shape, "size");
    const Vector3d size = *values_.vector(shape, "size");
    return size.minCoeff() >= geometry::kMinDimension
               ? ""
               : "found the size " + xmlNumbers(size) + " in " + what + ", expected positive edges";
  }

  /// Problem of a visual that is left out; empty if there is none.
  std::string visual(const XmlElement& e) {
    std::string problem = geometryProblem(e);
    if (problem.empty())
      body(e);
    else
      warn(e, problem + ": ignored");
    return problem;
  }

  void body(const XmlElement& e) {
    const XmlElement& shape = e.child("geometry")->children.front();
    const std::string kind(e.name), name(shape.name);
    std::string attributes;
    for (const char* key : {"radius", "length"})
      if (const auto value =
              name == "sphere" || name == "cylinder" ? values_.number(shape, key) : std::nullopt)
        attributes += attribute(key, *value);
    if (name == "box") attributes = attribute("size", *values_.vector(shape, "size"));
    if (name == "mesh")
      attributes = attribute("filename", values_.needText(shape, "filename")) +
                   attribute("scale", values_.vector(shape, "scale").value_or(Vector3d::Ones()));
    out_.document += "<" + kind + ">";
    origin(e);
    out_.document += "<geometry><" + name + attributes + "/></geometry></" + kind + ">";
  }

  void joint(const XmlElement& e) {
    UrdfJointText joint;
    joint.name = newName(e, joint_names_);
    joint.place = place(e);
    joint.type = values_.needText(e, "type");
    if (std::find(kTypes.begin(), kTypes.end(), joint.type) == kTypes.end()) {
      const std::string near = nearestName(joint.type, {kTypes.begin(), kTypes.end()});
      values_.fail(e,
                   "found the joint type " + text::inDoubleQuotes(joint.type) +
                       ", expected revolute, continuous, prismatic, fixed, floating or planar",
                   near.empty() ? "" : "did you mean " + near + "?");
    }
    joint.parent = end(e, "parent");
    joint.child = end(e, "child");
    out_.document += "<joint" + attribute("name", joint.name) + attribute("type", joint.type) + ">";
    origin(e);
    out_.document +=
        "<parent" + attribute("link", joint.parent) + "/><child" + attribute("link", joint.child) + "/>";
    if (joint.type != "fixed" && joint.type != "floating") axis(e);
    if (joint.type == "revolute" || joint.type == "prismatic" || joint.type == "continuous") {
      limit(e, joint.type);
      mimic(e, joint);
    }
    out_.document += "</joint>\n";
    out_.joints.push_back(std::move(joint));
  }

  std::string end(const XmlElement& joint, const char* which) const {
    const auto* e = joint.child(which);
    if (!e) values_.fail(joint, std::string("found a joint without <") + which + ">, expected one");
    return values_.needText(*e, "link");
  }

  void axis(const XmlElement& joint) {
    const auto* e = joint.child("axis");
    const Vector3d axis = e ? values_.vector(*e, "xyz").value_or(Vector3d::UnitX()) : Vector3d::UnitX();
    const double length = axis.stableNorm();
    if (!(length > 1e-9)) values_.fail(*e, "found the axis " + xmlNumbers(axis) + ", expected a direction");
    if (std::abs(length - 1.0) > kAxisTolerance)
      warn(*e, "found an axis of length " + formatDouble(length) + ", expected 1: made a unit vector");
    out_.document += "<axis" + attribute("xyz", Vector3d(axis / length)) + "/>";
  }

  void limit(const XmlElement& joint, const std::string& type) {
    const auto* e = joint.child("limit");
    if (!e) {
      if (type == "continuous") return;
      values_.fail(joint, "found a " + type + " joint without <limit>, expected one",
                   "a joint without end stops is continuous");
    }
    const double lower = values_.number(*e, "lower").value_or(0.0),
                 upper = values_.number(*e, "upper").value_or(0.0);
    for (const char* key : {"effort", "velocity"})
      if (values_.needNumber(*e, key) < 0.0)
        warn(*e, std::string("found a negative ") + key + " in <limit>, expected its size");
    if (lower > upper && type != "continuous")
      warn(*e, "found lower " + formatDouble(lower) + " above upper " + formatDouble(upper) +
                   ", expected the reverse order: treated as no limit");
    out_.document += "<limit" + attribute("lower", lower) + attribute("upper", upper) +
                     attribute("effort", std::abs(*values_.number(*e, "effort"))) +
                     attribute("velocity", std::abs(*values_.number(*e, "velocity"))) + "/>";
  }

  void mimic(const XmlElement& element, UrdfJointText& joint) {
    const auto* e = element.child("mimic");
    if (!e) return;
    joint.mimic = values_.needText(*e, "joint");
    out_.document += "<mimic" + attribute("joint", joint.mimic) +
                     attribute("multiplier", values_.number(*e, "multiplier").value_or(1.0)) +
                     attribute("offset", values_.number(*e, "offset").value_or(0.0)) + "/>";
  }

  const std::string& file_;
  XmlValues values_;
  UrdfText out_;
  std::unordered_set<std::string> link_names_, joint_names_;
};

}  // namespace

UrdfText checkUrdf(const std::string& text, const std::string& file) {
  const XmlElement root = text::parseXml(text, file);
  return UrdfChecker(file).run(root);
}

}  // namespace abstand::robot_file
