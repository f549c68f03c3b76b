#include "app/studio/response_probe.hpp"

#include <QEvent>
#include <QTimer>
#include <cmath>

#include "app/studio/probe_figures.hpp"
#include "ui/main_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {
namespace {

constexpr int kSeeks = 40, kMargins = 20;
constexpr int kPauseMs = 60;  // between two, so that what follows from the one before is done
constexpr int kPatienceMs = 2000;
constexpr int kMaxNotShown = 3;                 // then nothing more is asked for
constexpr double kGolden = 0.6180339887498949;  // multiples of it are spread evenly, far from each other
constexpr double kMargin = 0.1, kMarginStep = 0.005;  // m

}  // namespace

ResponseProbe::ResponseProbe(ui::MainWindow& window, QObject* parent) : QObject(parent), window_(window) {
  // Queued after all other receivers of the picture.
  connect(&window_.viewport(), &ui::Viewport::drawn, this, [this] {
    const double off = std::abs(window_.moment().t - wanted_);
    if (waiting_ == Waiting::kPicture && off <= 0.5 * window_.playback().framePeriod()) shown();
  });
  window_.panels().timeline->laneView()->viewport()->installEventFilter(this);
}

void ResponseProbe::start(std::function<void(const QJsonObject&)> done) {
  done_ = std::move(done);
  seek();
}

bool ResponseProbe::eventFilter(QObject* watched, QEvent* event) {
  // Told before the lanes are painted: what they paint is measured by coming back afterwards.
  if (event->type() == QEvent::Paint && waiting_ == Waiting::kLanes &&
      window_.review().revision() > revision_)
    QTimer::singleShot(0, this, [this, asked = attempt_] {
      if (waiting_ == Waiting::kLanes && asked == attempt_) shown();
    });
  return QObject::eventFilter(watched, event);
}

void ResponseProbe::seek() {
  const ui::Playback& clock = window_.playback();
  if (asked_ >= kSeeks || clock.frameCount() < 2) {
    asked_ = 0;
    return moveMargin();
  }
  const double share = std::fmod(kGolden * ++asked_, 1.0);
  const double frame = std::floor(share * static_cast<double>(std::max(0L, clock.frameCount() - 1)));
  wanted_ = clock.start() + frame * clock.framePeriod();
  waiting_ = Waiting::kPicture;
  ++attempt_;
  since_.start();
  window_.playback().seek(wanted_);
  giveUp();
}

void ResponseProbe::moveMargin() {
  const int part = firstPart();
  if (part < 0 || asked_ >= kMargins) return finish();
  waiting_ = Waiting::kLanes;
  revision_ = window_.review().revision();
  ++attempt_;
  since_.start();
  window_.panels().margins->hold(part, kMargin + kMarginStep * ++asked_);
  giveUp();
}

void ResponseProbe::shown() {
  (waiting_ == Waiting::kPicture ? seeks_ : margins_)
      .push_back(1e-9 * static_cast<double>(since_.nsecsElapsed()));
  next();
}

void ResponseProbe::next() {
  const bool was_seek = waiting_ == Waiting::kPicture;
  waiting_ = Waiting::kNothing;
  if (not_shown_ >= kMaxNotShown) return finish();
  QTimer::singleShot(kPauseMs, this, [this, was_seek] { was_seek ? seek() : moveMargin(); });
}

void ResponseProbe::giveUp() {
  QTimer::singleShot(kPatienceMs, this, [this, asked = attempt_] {
    if (waiting_ == Waiting::kNothing || asked != attempt_) return;
    ++not_shown_;
    next();
  });
}

void ResponseProbe::finish() {
  window_.panels().margins->release();
  QJsonObject figures{{"not_shown", not_shown_}};
  if (!seeks_.empty()) figures["seek_ms"] = spread(seeks_, 1e3);
  if (!margins_.empty()) figures["margin_ms"] = spread(margins_, 1e3);
  done_(figures);
}

int ResponseProbe::firstPart() const {
  const margin::ClearanceStore* store = window_.review().store();
  if (!store || store->layout().parts.empty()) return -1;
  const int object = static_cast<int>(store->layout().parts.front().object);
  return window_.panels().margins->row(object) ? object : -1;
}

}  // namespace abstand::studio
