#include "app/live_depth/served_things.hpp"

#include <chrono>
#include <thread>

#include "core/base/error.hpp"

namespace abstand::live_depth {
namespace {

constexpr viewer::RingLimits kKept{2.0, std::size_t{64} << 20};
constexpr std::chrono::milliseconds kLook{20};

}  // namespace

ServedThings::ServedThings(const std::string& file, scene_file::SceneDescription scene,
                           const session::SessionOptions& options,
                           const std::optional<serve::Address>& server)
    : session_(depth::withoutPeople(std::move(scene)), options), things_(session_, false) {
  session_.applyMotion(0.0);
  if (server)
    connect(file, *server);
  else if (!session_.description().mechanisms.empty())
    throw UsageError(
        "--scene: found mechanisms and no server that knows their joint values, expected the "
        "address of a running `abstand serve` of this scene (--send or --robots HOST:PORT)");
}

void ServedThings::connect(const std::string& file, const serve::Address& server) {
  server_ = serve::describe(server);
  record_ = std::make_shared<viewer::LiveRecord>(kKept);
  link_ = std::make_unique<viewer::ViewerLink>(server, record_);
  const double until = viewer::steadySeconds() + kAnswerWithin;
  while (!record_->card()) {
    if (viewer::steadySeconds() > until)
      throw UsageError("--scene: found no answer at " + server_ +
                       ", expected a running `abstand serve` with a viewer to spare (--viewers)");
    std::this_thread::sleep_for(kLook);
  }
  const moment::SceneCard card = *record_->card();
  if (card.scene != moment::sceneKey(file))
    throw UsageError("--scene: found a server with another scene at " + server_ + " (" + card.file +
                     "), expected " + file);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < things_.size(); ++k) names.push_back(things_.object(k).spec.name);
  window_.emplace(card, names);
}

void ServedThings::update(double now) {
  if (!window_) return;
  if (window_->update(*record_, now))
    for (Views* views : {&views_, &at_rest_})
      for (auto& [camera, view] : *views) view.is_current = false;
  const bool answers = !record_->status(now).stale();
  note({}, answers, now);
  for (const auto& mechanism : session_.description().mechanisms) {
    bool is_known = true;
    for (std::size_t k = 0; k < things_.size(); ++k)
      if (things_.object(k).spec.group == mechanism.name) is_known &= !window_->poses(k).empty();
    // Without the server, no robot is known: said once.
    if (answers) note(mechanism.name, is_known, now);
  }
}

void ServedThings::note(const std::string& robot, bool is_known, double now) {
  Knowledge& knowledge = knowledge_[robot];
  if (knowledge.is_known != is_known) knowledge.is_known = is_known, knowledge.since = now;
  if (knowledge.is_said == is_known || now - knowledge.since < kSaidAfter) return;
  knowledge.is_said = is_known;
  if (robot.empty())
    news_.push_back(is_known ? "the server at " + server_ + " answers again"
                             : "the server at " + server_ +
                                   " does not answer: the robots are not removed from the images");
  else
    news_.push_back(is_known ? robot + " is removed from the images: its joint values are known"
                             : robot + " is not removed from the images: its joint values are stale");
}

std::vector<std::string> ServedThings::news() { return std::exchange(news_, {}); }

void ServedThings::draw(const Transform& X_CW, tracking::DepthRender& render) const {
  if (!window_) return things_.draw(X_CW, render);
  for (std::size_t k = 0; k < things_.size(); ++k)
    for (const Transform& X_WB : window_->poses(k)) things_.drawAt(k, X_CW * X_WB, render);
}

const tracking::DepthImage* ServedThings::atRest(const tracking::DepthCamera& camera) {
  if (!isKnown() || !window_) return at(camera);
  View& view = at_rest_.try_emplace(&camera, camera).first->second;
  if (!view.is_current) {
    const Transform X_CW = camera.X_WC.inverse();
    view.render.clear();
    view.is_current = true;
    for (std::size_t k = 0; k < things_.size(); ++k)
      if (things_.isRobot(k) && window_->poses(k).size() == 1)
        things_.drawAt(k, X_CW * window_->poses(k).front(), view.render);
  }
  return &view.render.image();
}

const tracking::DepthImage* ServedThings::at(const tracking::DepthCamera& camera) {
  if (!isKnown()) return nullptr;
  View& view = views_.try_emplace(&camera, camera).first->second;
  if (!view.is_current) {
    view.render.clear();
    draw(camera.X_WC.inverse(), view.render);
    view.is_current = true;
  }
  return &view.render.image();
}

}  // namespace abstand::live_depth
