#include "core/scene/robot_links.hpp"

#include <algorithm>
#include <span>

namespace abstand {
namespace {

using Bodies = std::vector<const LinkGeometry*>;

/// Chooses and finds the geometry of one frame after the other.
class LinkChooser {
 public:
  LinkChooser(const Robot& robot, const std::string& mechanism, GeometryUse wanted,
              const PackagePaths& packages)
      : robot_(robot), mechanism_(mechanism), wanted_(wanted), finder_(robot.file, packages) {}

  RobotLinks run() {
    const int frames = static_cast<int>(robot_.mechanism.frames.size());
    std::vector<Bodies> collisions(static_cast<std::size_t>(frames) + 1), visuals = collisions;
    for (const auto& g : robot_.geometry)
      (g.use == GeometryUse::kCollision ? collisions : visuals)[static_cast<std::size_t>(g.frame + 1)]
          .push_back(&g);
    for (int frame = -1; frame < frames; ++frame)
      choose(frame, collisions[static_cast<std::size_t>(frame + 1)],
             visuals[static_cast<std::size_t>(frame + 1)]);
    if (!missing_.empty()) refuse();
    for (const auto& remark : finder_.remarks()) out_.remarks.push_back(robot_.file.string() + ": " + remark);
    return std::move(out_);
  }

 private:
  void choose(int frame, const Bodies& collisions, const Bodies& visuals) {
    const bool take_visuals = collisions.empty() || (wanted_ == GeometryUse::kVisual && !visuals.empty());
    if (take_visuals) {
      bool all = true;
      for (const LinkGeometry* g : visuals) all = (g->shape || finder_.find(g->mesh)) && all;
      if (!all && !collisions.empty()) {
        remark(frame, "not all visual meshes are there, so its collision geometry is taken");
        return place(frame, collisions);
      }
      return place(frame, visuals);
    }
    place(frame, collisions);
  }

  std::string nameOf(int frame) const {
    return frame < 0 ? "0" : robot_.mechanism.frames[static_cast<std::size_t>(frame)].name;
  }
  void remark(int frame, const std::string& text) {
    out_.remarks.push_back(robot_.file.string() + ": " + nameOf(frame) + ": " + text);
  }

  void place(int frame, const Bodies& bodies) {
    int count = 0;
    for (const LinkGeometry* g : bodies) {
      LinkDescription link;
      link.frame = nameOf(frame);
      link.name = mechanism_ + "/" + (frame < 0 ? "base" : link.frame);
      link.scale = g->scale;
      link.shape = g->shape;
      link.X_FL = g->X_FG;
      link.pos = g->pos;
      if (!g->shape) {
        const auto file = finder_.find(g->mesh);
        if (!file && g->use == GeometryUse::kCollision) {
          missing_.push_back(g);
          continue;
        }
        if (!file) {
          remark(frame, "found no file " + g->mesh + ": the link is left out");
          continue;
        }
        link.mesh = *file;
      }
      if (++count > 1) link.name += "/" + std::to_string(count);
      out_.links.push_back(std::move(link));
    }
  }

  [[noreturn]] void refuse() const {
    std::vector<std::string> names;
    for (const LinkGeometry* g : missing_)
      if (std::find(names.begin(), names.end(), g->mesh) == names.end()) names.push_back(g->mesh);
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    throw ParseError(
        missing_.front()->pos,
        "found no file for " + std::to_string(names.size()) + " collision mesh" +
            (names.size() == 1 ? "" : "es") + ", expected all of them: " + list,
        "say where packages are with --package-path FOLDER, the folder that holds the package's");
  }

  const Robot& robot_;
  const std::string& mechanism_;
  GeometryUse wanted_;
  MeshFinder finder_;
  RobotLinks out_;
  std::vector<const LinkGeometry*> missing_;
};

}  // namespace

RobotLinks robotLinks(const Robot& robot, const std::string& mechanism, GeometryUse wanted,
                      const PackagePaths& packages) {
  return LinkChooser(robot, mechanism, wanted, packages).run();
}

}  // namespace abstand
