// SessionPort of a live session.
#pragma once

#include <deque>
#include <memory>

#include "app/analysis/analysis_feed.hpp"
#include "app/loop/live_session.hpp"
#include "app/studio/depth_clouds.hpp"
#include "app/studio/inside_of_body.hpp"
#include "app/studio/robot_reach.hpp"
#include "ui/model/session_port.hpp"

namespace abstand::studio {

/// Holds another feed when the analysis begins again. GUI thread only.
struct FeedSlot {
  std::shared_ptr<analysis::AnalysisFeed> feed;
};

/// From the feed of an analysis to the window.
class FeedPort final : public ui::AnalysisPort {
 public:
  explicit FeedPort(std::shared_ptr<FeedSlot> slot) : slot_(std::move(slot)) {}
  bool takeNews(view::AnalysisNews& out) override { return slot_->feed->take(out); }

 private:
  std::shared_ptr<FeedSlot> slot_;
};

/// By object of the outline; constant.
using Structures = std::vector<std::shared_ptr<const structure::HapticStructure>>;

/// Hands the window's wishes to the loop's thread as values. What the loop has no room for waits here, in
/// order, so that a change of many margins reaches it whole.
class LivePort final : public ui::SessionPort {
 public:
  struct Parts {
    std::unique_ptr<loop::LiveSession> live;
    std::vector<scene::SceneNote> notes;
    std::unique_ptr<FeedPort> analysis;  ///< null: none
    std::shared_ptr<const ui::PreparedMeshes> meshes;
    Structures structures;
    std::vector<DepthPerson> depth;
    RobotReach reach;
  };
  explicit LivePort(Parts parts)
      : live_(std::move(parts.live)),
        notes_(std::move(parts.notes)),
        analysis_(std::move(parts.analysis)),
        meshes_(std::move(parts.meshes)),
        structures_(std::move(parts.structures)),
        reach_(std::move(parts.reach)) {
    if (parts.depth.empty()) return;
    clouds_ = std::make_unique<DepthClouds>(parts.depth, live_->outline());
    depth_ = std::make_unique<DepthPictures>(std::move(parts.depth));
  }

  const view::SceneOutline& outline() const override { return live_->outline(); }
  const std::vector<scene::SceneNote>& notes() const override { return notes_; }
  ui::AnalysisPort* analysis() override { return analysis_.get(); }
  ui::DepthPort* depth() override { return depth_.get(); }
  ui::CloudPort* clouds() override { return clouds_.get(); }
  std::shared_ptr<const ui::PreparedMeshes> meshes() const override { return meshes_; }
  std::optional<ui::BodyInside> inside(int object) const override {
    const auto i = static_cast<std::size_t>(object);
    if (i >= structures_.size()) return {};
    return insideOf(*structures_[i]);
  }
  std::optional<ui::Reached> reach(int object, const Vector3d& p_B, const Vector3d& p_W,
                                   const std::vector<double>& joints) const override {
    return reach_.reach(object, p_B, p_W, joints);
  }
  bool takeSnapshot(view::SceneSnapshot& out) override {
    flush();
    return live_->takeSnapshot(out);
  }
  void drainPlot(std::vector<view::PlotSample>& out) override { live_->drainPlot(out); }
  void play(bool on) override { send(loop::command::Play{on}); }
  void step(int frames) override { send(loop::command::Step{frames}); }
  void seek(double t) override { send(loop::command::Seek{t}); }
  void setSpeed(double factor) override { send(loop::command::Speed{factor}); }
  void setLoop(bool on) override { send(loop::command::Loop{on}); }
  void setReact(bool on) override { send(loop::command::React{on}); }
  void resetStops() override { send(loop::command::ResetStops{}); }
  void setMargin(int object, double metres) override { send(loop::command::Margin{object, metres}); }
  void setClassMargin(view::PairClass pair_class, std::optional<double> metres) override {
    send(loop::command::ClassMargin{pair_class, metres.value_or(-1.0)});
  }
  void setTorques(bool on) override { send(loop::command::Torques{on}); }
  void setGroup(int group, view::PairGroupState state) override {
    send(loop::command::SetGroup{group, state});
  }
  void addPair(int group, int pair) override { send(loop::command::AddPair{group, pair}); }
  void removePair(int pair) override { send(loop::command::RemovePair{pair}); }
  void poseJoint(int joint, double value) override { send(loop::command::PoseJoint{joint, value}); }
  void followMotion(int robot) override { send(loop::command::FollowMotion{robot}); }
  void placeThing(int object, const std::optional<Transform>& X_WB) override {
    send(loop::command::PlaceThing{object, X_WB});
  }
  void setReaction(int robot, const control::ReactionDescription& reaction) override {
    send(live_->laws(robot, reaction));
  }
  void poke(int object, const Vector3d& p_B, const Vector3d& target_W) override {
    send(loop::command::Poke{object, p_B, target_W});
  }
  void endPoke() override { send(loop::command::EndPoke{}); }

 private:
  void send(const loop::Command& command);
  void flush();

  std::unique_ptr<loop::LiveSession> live_;
  std::vector<scene::SceneNote> notes_;
  std::unique_ptr<FeedPort> analysis_;
  std::shared_ptr<const ui::PreparedMeshes> meshes_;
  Structures structures_;
  std::unique_ptr<DepthPictures> depth_;
  std::unique_ptr<DepthClouds> clouds_;
  RobotReach reach_;
  std::deque<loop::Command> waiting_;
};

}  // namespace abstand::studio
