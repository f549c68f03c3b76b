#include "app/depth/scene_things.hpp"

namespace abstand::depth {
namespace {

constexpr double kSagitta = 5e-4;  // m, of the meshes of shapes

}  // namespace

scene_file::SceneDescription withoutPeople(scene_file::SceneDescription scene) {
  scene.humans.clear();
  scene.threads.clear();
  scene.pairs = {};
  scene.pairs.standard = scene_file::PairDefault::kNone;
  return scene;
}

SceneThings::SceneThings(const session::Session& session, bool with_people) : scene_(session.scene()) {
  for (std::size_t k = 0; k < scene_.objects().size(); ++k) {
    const scene::Object& object = scene_.objects()[k];
    bool is_person = false;
    for (const auto& human : session.description().humans) is_person |= human.name == object.spec.group;
    if (is_person && !with_people) continue;
    bool is_robot = false;
    for (const auto& mechanism : session.description().mechanisms)
      is_robot |= mechanism.name == object.spec.group;
    is_robot_.push_back(is_robot);
    meshes_.emplace_back(k, object.spec.structure->surface->mesh(kSagitta));
  }
}

void SceneThings::draw(const Transform& X_CW, tracking::DepthRender& render) const {
  for (const auto& [k, mesh] : meshes_) render.draw(mesh, X_CW * scene_.objects()[k].X_WB);
}

void SceneThings::drawRobots(const Transform& X_CW, tracking::DepthRender& render) const {
  for (std::size_t k = 0; k < meshes_.size(); ++k)
    if (is_robot_[k]) drawAt(k, X_CW * object(k).X_WB, render);
}

RobotView::RobotView(scene_file::SceneDescription scene, const session::SessionOptions& options)
    : session_(withoutPeople(std::move(scene)), options), things_(session_, false) {}

const tracking::DepthImage& RobotView::at(double t, const tracking::DepthCamera& camera) {
  render_.emplace(camera);
  session_.applyMotion(t);
  render_->clear();
  things_.draw(camera.X_WC.inverse(), *render_);
  return render_->image();
}

const tracking::DepthImage* RobotView::robotsAt(double t, const tracking::DepthCamera& camera) {
  if (session_.description().mechanisms.empty()) return nullptr;
  robots_.emplace(camera);
  session_.applyMotion(t);
  robots_->clear();
  things_.drawRobots(camera.X_WC.inverse(), *robots_);
  return &robots_->image();
}

}  // namespace abstand::depth
