#include "app/scene_file/robot_links.hpp"

#include <algorithm>
#include <span>

namespace abstand::scene_file {
namespace {

using LinkBodies = std::vector<const robot_file::LinkGeometry*>;

constexpr std::size_t kMaxNames = 16;  // in one line

std::string frameName(const robot_file::Robot& robot, int frame) {
  return frame < 0 ? "0" : robot.mechanism.frames[static_cast<std::size_t>(frame)].name;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMaxNames; ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > kMaxNames) text += " and " + std::to_string(names.size() - kMaxNames) + " more";
  return text;
}

/// Selects and locates the geometry of the frames, one by one.
class LinkChooser {
 public:
  LinkChooser(const robot_file::Robot& robot, const std::string& mechanism, robot_file::GeometryUse wanted,
              const robot_file::PackagePaths& packages, const std::vector<std::string>& bodiless)
      : robot_(robot),
        mechanism_(mechanism),
        wanted_(wanted),
        finder_(robot.file, packages),
        bodiless_(bodiless) {}

  RobotLinks run() {
    const int frames = static_cast<int>(robot_.mechanism.frames.size());
    std::vector<LinkBodies> collisions(static_cast<std::size_t>(frames) + 1), visuals = collisions;
    for (const auto& g : robot_.geometry)
      (g.use == robot_file::GeometryUse::kCollision ? collisions
                                                    : visuals)[static_cast<std::size_t>(g.frame + 1)]
          .push_back(&g);
    for (int frame = -1; frame < frames; ++frame)
      choose(frame, collisions[static_cast<std::size_t>(frame + 1)],
             visuals[static_cast<std::size_t>(frame + 1)]);
    for (const robot_file::UnreadGeometry& g : robot_.unread) addUnread(g);
    if (!missing_.empty()) refuse();
    if (!replaced_.empty())
      out_.remarks.push_back(robot_.file.string() + ": some visual meshes are missing, so the collision " +
                             "geometry is used: " + replaced_);
    for (const auto& remark : finder_.remarks()) out_.remarks.push_back(robot_.file.string() + ": " + remark);
    return std::move(out_);
  }

 private:
  void choose(int frame, const LinkBodies& collisions, const LinkBodies& visuals) {
    if (std::find(bodiless_.begin(), bodiless_.end(), frameName(robot_, frame)) != bodiless_.end()) return;
    const bool take_visuals =
        collisions.empty() || (wanted_ == robot_file::GeometryUse::kVisual && !visuals.empty());
    if (take_visuals) {
      bool all = true;
      for (const robot_file::LinkGeometry* g : visuals) all = (g->shape || finder_.find(g->mesh)) && all;
      if (!all && !collisions.empty()) {
        replaced_ += (replaced_.empty() ? "" : ", ") + frameName(robot_, frame);
        return place(frame, collisions);
      }
      return place(frame, visuals);
    }
    place(frame, collisions);
  }

  void place(int frame, const LinkBodies& bodies) {
    int count = 0;
    for (const robot_file::LinkGeometry* g : bodies) {
      LinkDescription link;
      link.frame = frameName(robot_, frame);
      link.name = mechanism_ + "/" + (frame < 0 ? "base" : link.frame);
      link.scale = g->scale;
      link.shape = g->shape;
      link.X_FL = g->X_FG;
      link.pos = g->pos;
      if (!g->shape) {
        const auto file = finder_.find(g->mesh);
        if (!file && g->use == robot_file::GeometryUse::kCollision) {
          missing_.push_back(g);
          continue;
        }
        if (!file) {
          const std::string& name = link.frame;
          if (out_.missing.empty() || out_.missing.back().frame != name)
            out_.missing.push_back({name, "found no file " + g->mesh});
          continue;
        }
        link.mesh = *file;
      }
      if (++count > 1) link.name += "/" + std::to_string(count);
      out_.links.push_back(std::move(link));
    }
  }

  /// A frame with only unreadable geometry has no body.
  void addUnread(const robot_file::UnreadGeometry& g) {
    const std::string name = frameName(robot_, g.frame);
    const auto is_it = [&](const auto& other) { return other.frame == name; };
    const bool has_body = std::any_of(out_.links.begin(), out_.links.end(), is_it);
    const bool said = std::any_of(out_.missing.begin(), out_.missing.end(), is_it);
    const bool named = std::find(bodiless_.begin(), bodiless_.end(), name) != bodiless_.end();
    if (!has_body && !said && !named) out_.missing.push_back({name, g.reason});
  }

  [[noreturn]] void refuse() const {
    std::vector<std::string> names;
    for (const robot_file::LinkGeometry* g : missing_)
      if (std::find(names.begin(), names.end(), g->mesh) == names.end()) names.push_back(g->mesh);
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    throw ParseError(missing_.front()->pos,
                     "found no file for " + std::to_string(names.size()) + " collision mesh" +
                         (names.size() == 1 ? "" : "es") + ", expected all of them: " + list,
                     "give the folder that contains the package with --package-path FOLDER");
  }

  const robot_file::Robot& robot_;
  const std::string& mechanism_;
  robot_file::GeometryUse wanted_;
  robot_file::MeshFinder finder_;
  const std::vector<std::string>& bodiless_;
  RobotLinks out_;
  std::string replaced_;  ///< frames whose collision geometry replaces their visual one
  std::vector<const robot_file::LinkGeometry*> missing_;
};

}  // namespace

RobotLinks robotLinks(const robot_file::Robot& robot, const std::string& mechanism,
                      robot_file::GeometryUse wanted, const robot_file::PackagePaths& packages,
                      const std::vector<std::string>& bodiless) {
  return LinkChooser(robot, mechanism, wanted, packages, bodiless).run();
}

std::vector<std::string> framesWithGeometry(const robot_file::Robot& robot,
                                            const std::vector<std::string>& bodiless) {
  std::vector<std::string> frames;
  std::vector<int> shown;
  for (const robot_file::LinkGeometry& g : robot.geometry) shown.push_back(g.frame);
  for (const robot_file::UnreadGeometry& g : robot.unread) shown.push_back(g.frame);
  for (const int frame : shown) {
    const std::string name = frameName(robot, frame);
    const auto among = [&](const auto& list) {
      return std::find(list.begin(), list.end(), name) != list.end();
    };
    if (!among(frames) && !among(bodiless)) frames.push_back(name);
  }
  return frames;
}

std::string missingBodiesText(const MechanismDescription& mechanism) {
  if (mechanism.missing.empty()) return {};
  std::vector<std::string> frames, reasons;
  for (const BodilessLink& link : mechanism.missing) {
    frames.push_back(link.frame);
    if (std::find(reasons.begin(), reasons.end(), link.reason) == reasons.end())
      reasons.push_back(link.reason);
  }
  return std::to_string(frames.size()) + " of " + std::to_string(mechanism.frames_with_geometry) +
         " links of " + mechanism.name + " have no body, or not all of it: " + joined(frames) + " (" +
         joined(reasons) + "); name the links that have none on purpose under `bodiless`";
}

void takeLinks(RobotLinks links, MechanismDescription& mechanism, std::vector<std::string>& remarks) {
  mechanism.links = std::move(links.links);
  mechanism.missing = std::move(links.missing);
  if (!mechanism.missing.empty()) remarks.push_back(missingBodiesText(mechanism));
  remarks.insert(remarks.end(), links.remarks.begin(), links.remarks.end());
}

}  // namespace abstand::scene_file
