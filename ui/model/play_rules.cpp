// Where play goes back or pauses by itself.
#include "ui/model/play_rules.hpp"

#include <QScopedValueRollback>

#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {

namespace {

constexpr int kReturnPatience = 30;  // about half a second of snapshots

}  // namespace

PlayRules::PlayRules(Playback& playback, const TimeAxis& axis, const RecordingReview& review, QObject* parent)
    : QObject(parent), playback_(playback), axis_(axis), review_(review) {
  connect(&playback_, &Playback::timeChanged, this, &PlayRules::follow);
}

void PlayRules::follow(double t) {
  const double before = std::exchange(last_, t);
  if (following_ || !playback_.playing()) {
    patience_ = 0;
    return;
  }
  const QScopedValueRollback guard(following_, true);
  if (pause_on_events_ && t > before) {
    const auto event = review_.nextEvent(before);
    if (event && *event <= t + 0.5 * playback_.framePeriod()) {
      playback_.setPlaying(false);
      playback_.seek(*event);
      last_ = *event;
      Q_EMIT pausedAt(*event);
      return;
    }
  }
  const auto& range = axis_.range();
  if (!playback_.loop() || !range) return;
  // Before IN: the recording itself has begun again.
  const bool outside = t >= range->to || t < range->from - 0.5 * playback_.framePeriod();
  if (!outside) patience_ = 0;
  if (!outside || patience_-- > 0) return;
  patience_ = kReturnPatience;
  playback_.seek(range->from);
  last_ = range->from;
}

}  // namespace abstand::ui
