#include "core/robot_file/urdf_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "core/base/number.hpp"
#include "core/math/turn_between.hpp"
#include "core/robot_file/urdf_model.hpp"

namespace abstand::robot_file {
namespace {

constexpr double kLargestMimic = 1e6;

/// Builds a tree of frames from links and joints.
class UrdfBuilder {
 public:
  UrdfBuilder(const UrdfText& text, const UrdfModel& model, const std::string& file)
      : text_(text),
        model_(model),
        file_(file),
        dof_of_(text.joints.size(), -1),
        joints_from_(text.links.size()) {
    for (std::size_t i = 0; i < text.links.size(); ++i) {
      link_at_.emplace(text.links[i].name, i);
      names_.insert(text.links[i].name);
    }
    std::vector<bool> is_child(text.links.size(), false);
    for (std::size_t j = 0; j < text.joints.size(); ++j) {
      joint_at_.emplace(text.joints[j].name, j);
      joints_from_[link_at_.at(text.joints[j].parent)].push_back(j);
      is_child[link_at_.at(text.joints[j].child)] = true;
      if (!text.joints[j].mimic.empty()) continue;
      dof_of_[j] = mechanism_.dof;
      mechanism_.dof += dofs(model.joints[j].type);
    }
    root_ = static_cast<std::size_t>(std::find(is_child.begin(), is_child.end(), false) - is_child.begin());
  }

  Robot build() {
    mechanism::MechanismFrame root;
    place(root_, root, -1);
    // Depth-first, parents first, children in file order.
    std::vector<std::pair<std::size_t, int>> waiting;
    const auto await = [&](std::size_t link, int frame) {
      const auto& joints = joints_from_[link];
      for (auto j = joints.rbegin(); j != joints.rend(); ++j) waiting.emplace_back(*j, frame);
    };
    await(root_, 0);
    while (!waiting.empty()) {
      const auto [j, parent] = waiting.back();
      waiting.pop_back();
      const std::size_t link = link_at_.at(text_.joints[j].child);
      join(j, link, parent);
      await(link, static_cast<int>(mechanism_.frames.size()) - 1);
    }
    mechanism_.name = text_.name;
    mechanism_.prepare();
    std::stable_sort(geometry_.begin(), geometry_.end(), [](const LinkGeometry& l, const LinkGeometry& r) {
      return std::pair(l.pos.line, l.pos.column) < std::pair(r.pos.line, r.pos.column);
    });
    return {file_, std::move(mechanism_), std::move(geometry_), text_.warnings, std::move(unread_)};
  }

 private:
  static int dofs(UrdfJointType type) {
    switch (type) {
      case UrdfJointType::kFixed:
        return 0;
      case UrdfJointType::kPlanar:
        return 3;
      case UrdfJointType::kFloating:
        return 6;
      default:
        return 1;
    }
  }

  int add(mechanism::MechanismFrame f, int parent) {
    f.id = static_cast<int>(mechanism_.frames.size()) + 1;
    f.parent = parent;
    f.has_dh = false;
    mechanism_.frames.push_back(std::move(f));
    return static_cast<int>(mechanism_.frames.size()) - 1;
  }

  /// Adds the frame of a link; `f` has its joint.
  void place(std::size_t link, mechanism::MechanismFrame f, int parent) {
    f.name = text_.links[link].name;
    f.inertia = model_.links[link].inertia;
    const int frame = add(std::move(f), parent);
    const auto keep = [&](GeometryUse use, const std::vector<UrdfGeometry>& bodies,
                          const std::vector<UrdfPlace>& places) {
      for (std::size_t i = 0; i < bodies.size(); ++i)
        geometry_.push_back({frame, use, bodies[i].mesh, bodies[i].scale, bodies[i].shape, bodies[i].X_LG,
                             SourcePos{file_, places[i].line, places[i].column}});
    };
    if (!text_.links[link].unread.empty()) unread_.push_back({frame, text_.links[link].unread});
    keep(GeometryUse::kCollision, model_.links[link].collisions, text_.links[link].collisions);
    keep(GeometryUse::kVisual, model_.links[link].visuals, text_.links[link].visuals);
  }

  /// JOINT.VALUE, modified if a frame already has that name.
  std::string newName(const std::string& name) {
    std::string unique = name;
    while (!names_.insert(unique).second) unique += '_';
    return unique;
  }

  struct Value {
    const char* name;
    mechanism::JointType type;
    Vector3d axis;
  };

  /// A joint with several values: a massless frame for each value but the last, which has the link's frame.
  void joinBy(std::span<const Value> values, std::size_t j, std::size_t link, int parent) {
    const UrdfJoint& joint = model_.joints[j];
    for (std::size_t k = 0; k < values.size(); ++k) {
      mechanism::MechanismFrame f;
      f.type = values[k].type;
      f.axis = values[k].axis;
      f.dof = dof_of_[j] + static_cast<int>(k);
      if (k == 0) f.X_PJ = joint.X_PJ;
      f.joint = text_.joints[j].name + "." + values[k].name;
      f.limits.velocity = joint.limits.velocity;
      f.limits.effort = joint.limits.effort;
      if (k + 1 == values.size()) return place(link, std::move(f), parent);
      f.name = newName(f.joint);
      parent = add(std::move(f), parent);
    }
  }

  void join(std::size_t j, std::size_t link, int parent) {
    const UrdfJoint& joint = model_.joints[j];
    constexpr auto kAlong = mechanism::JointType::kPrismatic, kAbout = mechanism::JointType::kRevolute;
    if (joint.type == UrdfJointType::kPlanar) {
      const Matrix3d R = turnBetween(Vector3d::UnitZ(), joint.axis).toRotationMatrix();
      const std::array<Value, 3> values{
          {{"x", kAlong, R.col(0)}, {"y", kAlong, R.col(1)}, {"yaw", kAbout, joint.axis}}};
      return joinBy(values, j, link, parent);
    }
    if (joint.type == UrdfJointType::kFloating) {
      const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
      const std::array<Value, 6> values{{{"x", kAlong, x},
                                         {"y", kAlong, y},
                                         {"z", kAlong, z},
                                         {"yaw", kAbout, z},
                                         {"pitch", kAbout, y},
                                         {"roll", kAbout, x}}};
      return joinBy(values, j, link, parent);
    }
    mechanism::MechanismFrame f;
    f.joint = text_.joints[j].name;
    f.X_PJ = joint.X_PJ;
    if (joint.type != UrdfJointType::kFixed) {
      f.type = joint.type == UrdfJointType::kPrismatic ? kAlong : kAbout;
      f.axis = joint.axis;
      f.limits = joint.limits;
      lead(j, f);
    }
    place(link, std::move(f), parent);
  }

  /// Sets the dof that moves joint j: its own, or that of the joint at the end of its chain of mimic joints.
  void lead(std::size_t j, mechanism::MechanismFrame& f) const {
    const UrdfPlace& at = text_.joints[j].place;
    f.mimic = !text_.joints[j].mimic.empty();
    while (!text_.joints[j].mimic.empty()) {
      f.offset += f.scale * model_.joints[j].offset;
      f.scale *= model_.joints[j].multiplier;
      j = joint_at_.at(text_.joints[j].mimic);
    }
    if (std::abs(f.scale) > kLargestMimic || std::abs(f.offset) > kLargestMimic)
      throw ParseError({file_, at.line, at.column},
                       "found mimic joints whose multipliers or offsets pile up beyond " +
                           formatDouble(kLargestMimic) + ", expected less");
    f.dof = model_.joints[j].type == UrdfJointType::kFixed || f.scale == 0.0 ? -1 : dof_of_[j];
  }

  const UrdfText& text_;
  const UrdfModel& model_;
  const std::string& file_;
  mechanism::Mechanism mechanism_;
  std::vector<LinkGeometry> geometry_;
  std::vector<UnreadGeometry> unread_;
  std::vector<int> dof_of_;  ///< first dof of each joint, -1 for a mimic joint
  std::vector<std::vector<std::size_t>> joints_from_;
  std::unordered_map<std::string, std::size_t> link_at_, joint_at_;
  std::unordered_set<std::string> names_;
  std::size_t root_{0};
};

}  // namespace

Robot parseUrdf(const std::string& text, const std::string& file) {
  const UrdfText checked = checkUrdf(text, file);
  return UrdfBuilder(checked, readUrdf(checked, file), file).build();
}

}  // namespace abstand::robot_file
