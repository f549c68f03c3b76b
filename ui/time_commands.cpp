// The commands of the clock.
#include "ui/time_commands.hpp"

#include "ui/document/document.hpp"
#include "ui/model/play_rules.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/run_history.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr double kZoomSteps = 2.0, kPanShare = 0.5;
}  // namespace

TimeCommands::TimeCommands(const Actions& actions, const Clock& clock, QObject* parent)
    : QObject(parent), my_{clock} {
  connectTransport(actions);
  connectRange(actions);
  connectEvents(actions);
  auto* rules = new PlayRules(my_.playback, my_.axis, my_.review, this);
  connect(actions[Id::kPauseOnEvent], &QAction::toggled, rules, &PlayRules::setPauseOnEvents);
  connect(rules, &PlayRules::pausedAt, this,
          [this](double t) { Q_EMIT said(tr("Paused at an event, %1").arg(secondsWithUnit(t))); });
  connect(&my_.playback, &Playback::timeChanged, &my_.axis, &TimeAxis::reveal);
}

void TimeCommands::connectTransport(const Actions& actions) {
  QAction* play = actions[Id::kPlay];
  connect(play, &QAction::triggered, this, [this] { my_.playback.setPlaying(!my_.playback.playing()); });
  connect(&my_.playback, &Playback::playingChanged, this, [play](bool playing) {
    play->setIcon(icon(playing ? Glyph::kPause : Glyph::kPlay));
    play->setText(playing ? tr("&Pause") : tr("&Play"));
  });
  const auto on = [&](Id id, auto&& command) { connect(actions[id], &QAction::triggered, this, command); };
  on(Id::kStepForward, [this] { my_.playback.stepFrames(1); });
  on(Id::kStepBack, [this] { my_.playback.stepFrames(-1); });
  on(Id::kForwardSecond, [this] { my_.playback.jump(1.0); });
  on(Id::kBackSecond, [this] { my_.playback.jump(-1.0); });
  on(Id::kToStart, [this] { my_.playback.toStart(); });
  on(Id::kToEnd, [this] { my_.playback.toEnd(); });
  on(Id::kFaster, [this] { my_.playback.faster(); });
  on(Id::kSlower, [this] { my_.playback.slower(); });
  connect(actions[Id::kLoop], &QAction::toggled, &my_.playback, &Playback::setLoop);
}

void TimeCommands::connectRange(const Actions& actions) {
  const auto on = [&](Id id, auto&& command) { connect(actions[id], &QAction::triggered, this, command); };
  const auto keep_range = [this](const QString& text) {
    my_.document.edit(text, [this](Work& work) { work.range = my_.axis.range(); });
  };
  on(Id::kSetIn, [=, this] {
    my_.axis.setIn(my_.playback.time());
    keep_range(tr("set IN"));
  });
  on(Id::kSetOut, [=, this] {
    my_.axis.setOut(my_.playback.time());
    keep_range(tr("set OUT"));
  });
  on(Id::kClearRange, [=, this] {
    my_.axis.setRange({});
    keep_range(tr("clear IN and OUT"));
  });
  on(Id::kZoomTimeIn, [this] { my_.axis.zoomSteps(kZoomSteps, my_.playback.time()); });
  on(Id::kZoomTimeOut, [this] { my_.axis.zoomSteps(-kZoomSteps, my_.playback.time()); });
  on(Id::kZoomTimeAll, [this] { my_.axis.showAll(); });
  on(Id::kPanTimeBack, [this] { my_.axis.pan(-kPanShare); });
  on(Id::kPanTimeForward, [this] { my_.axis.pan(kPanShare); });
}

void TimeCommands::connectEvents(const Actions& actions) {
  struct Keys {
    Id next, previous;
    std::optional<EventKind> kind;
  };
  for (const Keys& keys : {Keys{Id::kNextContact, Id::kPreviousContact, {}},
                           Keys{Id::kNextTouch, Id::kPreviousTouch, EventKind::kContact},
                           Keys{Id::kNextIntrusion, Id::kPreviousIntrusion, EventKind::kInside},
                           Keys{Id::kNextNearMiss, Id::kPreviousNearMiss, EventKind::kNear},
                           Keys{Id::kNextStop, Id::kPreviousStop, EventKind::kStop},
                           Keys{Id::kNextLoss, Id::kPreviousLoss, EventKind::kLost}}) {
    connect(actions[keys.next], &QAction::triggered, this, [=, this] { goToEvent(true, keys.kind); });
    connect(actions[keys.previous], &QAction::triggered, this, [=, this] { goToEvent(false, keys.kind); });
  }
}

/// Of what was played, where there is no analysis.
std::optional<double> TimeCommands::playedEvent(bool next, std::optional<EventKind> kind) const {
  if (my_.review.available()) return {};
  const EventKinds kinds = kind ? onlyKind(*kind) : my_.review.shownKinds();
  const bool touches = kinds[static_cast<std::size_t>(EventKind::kContact)];
  const bool inside = kinds[static_cast<std::size_t>(EventKind::kInside)];
  const double now = my_.playback.time();
  return next ? my_.history.nextContact(now, touches, inside)
              : my_.history.previousContact(now, touches, inside);
}

void TimeCommands::goToEvent(bool next, std::optional<EventKind> kind) {
  const double now = my_.playback.time();
  const EventKinds kinds = kind ? onlyKind(*kind) : my_.review.shownKinds();
  std::optional<double> t = next ? my_.review.nextEvent(now, kinds) : my_.review.previousEvent(now, kinds);
  if (const auto played = playedEvent(next, kind); played && (!t || (next ? *played < *t : *played > *t)))
    t = played;
  if (t) {
    my_.playback.seek(*t);
    return;
  }
  const QString name = kind ? kindText(*kind) : QString();
  if (kind)
    Q_EMIT said(next ? tr("No later event known of this kind: %1").arg(name)
                     : tr("No earlier event known of this kind: %1").arg(name));
  else
    Q_EMIT said(next ? tr("No later event known") : tr("No earlier event known"));
}

}  // namespace abstand::ui
