// The clock as the window sees it.
#include "ui/model/playback.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::ui {

namespace {

// Snapshots are taken 30 to 60 times a second: a session that has not obeyed after a second will not.
constexpr int kPatience = 30;

constexpr std::array<double, 9> kSpeeds{0.05, 0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0};

}  // namespace

void Playback::setPort(SessionPort* port) {
  port_ = port;
  patience_ = 0;
  const bool was_playing = std::exchange(playing_, false);
  if (port_) {
    const view::SceneOutline& outline = port_->outline();
    start_ = outline.start;
    end_ = std::max(outline.start, outline.end);
    period_ = outline.frame_period > 0.0 ? outline.frame_period : 0.01;
    port_->setSpeed(speed_);
    port_->setLoop(loop_);
  } else {
    start_ = end_ = 0.0;
  }
  time_ = start_;
  Q_EMIT rangeChanged();
  Q_EMIT timeChanged(time_);
  if (was_playing) Q_EMIT playingChanged(false);
}

void Playback::setSpan(double start, double end) {
  start_ = start;
  end_ = std::max(start, end);
  Q_EMIT rangeChanged();
}

void Playback::onSnapshot(const view::SceneSnapshot& snapshot) {
  if (patience_ > 0) {
    const bool obeyed = std::abs(snapshot.t - awaited_) < 0.5 * period_ && snapshot.playing == play_asked_;
    if (!obeyed && --patience_ > 0) return;
    patience_ = 0;
  }
  if (snapshot.playing != playing_) {
    playing_ = snapshot.playing;
    Q_EMIT playingChanged(playing_);
  }
  show(snapshot.t);
}

long Playback::frame() const { return std::lround((time_ - start_) / period_); }
long Playback::frameCount() const { return std::lround((end_ - start_) / period_) + 1; }

void Playback::setPlaying(bool on) {
  if (!port_) return;
  // Play at the end begins again.
  if (on && !playing_ && end_ > start_ && time_ > end_ - 0.5 * period_) seek(start_);
  port_->play(on);
  patience_ = 0;
  if (on == playing_) return;
  playing_ = on;
  Q_EMIT playingChanged(on);
}

void Playback::stepFrames(int frames) {
  if (!port_) return;
  if (playing_) {
    playing_ = false;
    Q_EMIT playingChanged(false);
  }
  port_->step(frames);
  const double t = start_ + static_cast<double>(frame() + frames) * period_;
  await(end_ > start_ ? std::clamp(t, start_, end_) : t);
}

void Playback::seek(double t) {
  if (!port_) return;
  if (end_ > start_) t = std::clamp(t, start_, end_);
  port_->seek(t);
  if (playing_) {
    // The clock runs on from there; no time to wait for can be named.
    show(t);
  } else {
    await(t);
  }
}

void Playback::setSpeed(double factor) {
  factor = std::clamp(factor, kMinSpeed, kMaxSpeed);
  if (factor == speed_) return;
  speed_ = factor;
  if (port_) port_->setSpeed(factor);
  Q_EMIT speedChanged(factor);
}

void Playback::faster() {
  const auto next = std::upper_bound(kSpeeds.begin(), kSpeeds.end(), speed_ + 1e-9);
  if (next != kSpeeds.end()) setSpeed(*next);
}

void Playback::slower() {
  const auto here = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), speed_ - 1e-9);
  if (here != kSpeeds.begin()) setSpeed(*std::prev(here));
}

void Playback::setLoop(bool on) {
  loop_ = on;
  if (port_) port_->setLoop(on);
}

void Playback::show(double t) {
  if (t == time_) return;
  time_ = t;
  Q_EMIT timeChanged(t);
}

void Playback::await(double t) {
  awaited_ = t;
  play_asked_ = playing_;
  patience_ = kPatience;
  show(t);
}

}  // namespace abstand::ui
