#include "app/depth/scene_things.hpp"

namespace abstand {
namespace {

constexpr double kSagitta = 5e-4;  // m, of the meshes of shapes

SceneDescription thingsAlone(SceneDescription scene) {
  scene.humans.clear();
  scene.threads.clear();
  scene.pairs = {};
  scene.pairs.standard = PairDefault::kNone;
  return scene;
}

}  // namespace

SceneThings::SceneThings(const Session& session, bool with_people) : scene_(session.scene()) {
  for (std::size_t k = 0; k < scene_.objects().size(); ++k) {
    const Object& object = scene_.objects()[k];
    bool is_person = false;
    for (const auto& human : session.description().humans) is_person |= human.name == object.spec.group;
    if (is_person && !with_people) continue;
    meshes_.emplace_back(k, object.spec.structure->surface->mesh(kSagitta));
  }
}

void SceneThings::draw(const Transform& X_CW, DepthRender& render) const {
  for (const auto& [k, mesh] : meshes_) render.draw(mesh, X_CW * scene_.objects()[k].X_WB);
}

RobotView::RobotView(SceneDescription scene, const SessionOptions& options)
    : session_(thingsAlone(std::move(scene)), options), things_(session_, false) {}

const DepthImage& RobotView::at(double t, const DepthCamera& camera) {
  if (!render_) render_.emplace(camera);
  session_.applyMotion(t);
  render_->clear();
  things_.draw(camera.X_WC.inverse(), *render_);
  return render_->image();
}

}  // namespace abstand
