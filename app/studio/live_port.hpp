// SessionPort of a live session.
#pragma once

#include <memory>

#include "app/loop/live_session.hpp"
#include "ui/model/session_port.hpp"

namespace abstand::studio {

/// Passes the window's commands to the loop's thread as values.
class LivePort final : public ui::SessionPort {
 public:
  LivePort(std::unique_ptr<loop::LiveSession> live, std::vector<scene::SceneNote> notes)
      : live_(std::move(live)), notes_(std::move(notes)) {}

  const view::SceneOutline& outline() const override { return live_->outline(); }
  const std::vector<scene::SceneNote>& notes() const override { return notes_; }
  bool takeSnapshot(view::SceneSnapshot& out) override { return live_->takeSnapshot(out); }
  void drainPlot(std::vector<view::PlotSample>& out) override { live_->drainPlot(out); }
  void play(bool on) override { live_->send(loop::command::Play{on}); }
  void step(int frames) override { live_->send(loop::command::Step{frames}); }
  void seek(double t) override { live_->send(loop::command::Seek{t}); }
  void setSpeed(double factor) override { live_->send(loop::command::Speed{factor}); }
  void setLoop(bool on) override { live_->send(loop::command::Loop{on}); }
  void setReact(bool on) override { live_->send(loop::command::React{on}); }
  void resetStops() override { live_->send(loop::command::ResetStops{}); }
  void setMargin(int object, double metres) override { live_->send(loop::command::Margin{object, metres}); }
  void setTorques(bool on) override { live_->send(loop::command::Torques{on}); }
  void setGroup(int group, view::PairGroupState state) override {
    live_->send(loop::command::SetGroup{group, state});
  }
  void addPair(int group, int pair) override { live_->send(loop::command::AddPair{group, pair}); }
  void removePair(int pair) override { live_->send(loop::command::RemovePair{pair}); }

 private:
  std::unique_ptr<loop::LiveSession> live_;
  std::vector<scene::SceneNote> notes_;
};

}  // namespace abstand::studio
