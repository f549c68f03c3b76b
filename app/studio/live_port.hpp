// The window's view of a live session.
#pragma once

#include <memory>

#include "app/loop/live_session.hpp"
#include "ui/model/session_port.hpp"

namespace abstand {

/// Hands the window's wishes to the loop's thread as values.
class LivePort final : public ui::SessionPort {
 public:
  LivePort(std::unique_ptr<LiveSession> live, std::vector<SceneNote> notes)
      : live_(std::move(live)), notes_(std::move(notes)) {}

  const SceneOutline& outline() const override { return live_->outline(); }
  const std::vector<SceneNote>& notes() const override { return notes_; }
  bool takeSnapshot(SceneSnapshot& out) override { return live_->takeSnapshot(out); }
  void drainPlot(std::vector<PlotSample>& out) override { live_->drainPlot(out); }
  void play(bool on) override { live_->send(command::Play{on}); }
  void step(int frames) override { live_->send(command::Step{frames}); }
  void seek(double t) override { live_->send(command::Seek{t}); }
  void setSpeed(double factor) override { live_->send(command::Speed{factor}); }
  void setLoop(bool on) override { live_->send(command::Loop{on}); }
  void setReact(bool on) override { live_->send(command::React{on}); }
  void resetStops() override { live_->send(command::ResetStops{}); }
  void setMargin(int object, double metres) override { live_->send(command::Margin{object, metres}); }
  void setTorques(bool on) override { live_->send(command::Torques{on}); }
  void setGroup(int group, PairGroupState state) override { live_->send(command::SetGroup{group, state}); }
  void addPair(int group, int pair) override { live_->send(command::AddPair{group, pair}); }
  void removePair(int pair) override { live_->send(command::RemovePair{pair}); }

 private:
  std::unique_ptr<LiveSession> live_;
  std::vector<SceneNote> notes_;
};

}  // namespace abstand
