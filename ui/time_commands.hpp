// The commands of the clock: transport, events, and the range between IN and OUT.
#pragma once

#include <QObject>
#include <optional>

#include "ui/model/recording_event.hpp"

namespace abstand::ui {

class Actions;
class Document;
class Playback;
class RecordingReview;
class RunHistory;
class TimeAxis;

/// GUI thread only.
class TimeCommands : public QObject {
  Q_OBJECT

 public:
  struct Clock {
    Playback& playback;
    TimeAxis& axis;
    const RecordingReview& review;
    const RunHistory& history;  ///< where the recording has not been analysed
    Document& document;         ///< keeps the range
  };

  /// All outlive it.
  TimeCommands(const Actions& actions, const Clock& clock, QObject* parent);

 Q_SIGNALS:
  /// For the status bar.
  void said(const QString& text);

 private:
  void connectTransport(const Actions& actions);
  void connectRange(const Actions& actions);
  void connectEvents(const Actions& actions);
  void goToEvent(bool next, std::optional<EventKind> kind);
  std::optional<double> playedEvent(bool next, std::optional<EventKind> kind) const;

  Clock my_;
};

}  // namespace abstand::ui
