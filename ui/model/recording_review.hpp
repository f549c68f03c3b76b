// The whole recording under the present margins: what lanes, events and markers are drawn from.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <map>
#include <optional>

#include "core/margin/margin_review.hpp"
#include "core/view/snapshot.hpp"
#include "ui/model/analysis_port.hpp"
#include "ui/model/contact_scan.hpp"
#include "ui/model/frame_series.hpp"
#include "ui/model/stop_spans.hpp"
#include "ui/model/what_if_settings.hpp"

class QTimer;

namespace abstand::ui {

/// Gathers what an analysis finds and judges it anew when margins change. Times are those of the recording,
/// in seconds; objects and pairs are those of the outline. GUI thread only.
class RecordingReview : public QObject {
  Q_OBJECT

 public:
  explicit RecordingReview(QObject* parent = nullptr);

  /// Forgets everything. Null: there is no analysis. The port must outlive its stay here. `margins`: m, of
  /// each object.
  void open(AnalysisPort* port, const view::SceneOutline& outline, std::vector<double> margins);
  /// Of a session that goes on without end: the times of the outline now, s.
  void setSpan(double start, double end);
  /// Takes what the analysis has found since. While more is to come, it is judged as often as costs a fifth
  /// of the time at most; what was not judged yet has no events.
  void pull();
  /// m. Judges anew before the next turn of the event loop, once for all changes before it.
  void setMargin(int object, double metres);

  /// Judges anew; who fills the port runs the analysis again where its distances depend on them.
  void setSettings(const WhatIfSettings& settings);
  const WhatIfSettings& settings() const { return settings_; }
  /// What margins are judged with.
  margin::MarginOptions options() const { return {settings_.limit, settings_.restart_time}; }
  /// Pairs of people and robots that the user does not check: the port leaves them out.
  void setLeftOut(int pairs);
  int leftOut() const { return left_out_; }

  bool available() const { return port_ != nullptr; }
  view::AnalysisNews::State state() const { return state_; }
  /// 0 to 1, of the frames.
  double progress() const;
  const QString& problem() const { return problem_; }

  /// Null: nothing is known yet.
  const margin::ClearanceStore* store() const { return store_ ? &*store_ : nullptr; }
  const margin::MarginReview& review() const { return *review_; }
  /// All events in order of time, those of the review among them.
  const std::vector<RecordingEvent>& events() const { return events_.all; }
  /// What robots that react did when it was played.
  void setStops(const std::vector<StopSpan>& stops, const view::SceneOutline& outline);
  /// The kinds that markers show and keys go to; all at first.
  void showKinds(EventKinds kinds);
  EventKinds shownKinds() const { return events_.shown; }
  /// m: the least certified clearance of people and robots in each frame, as far as it is known. Its address
  /// stays.
  const FrameSeries& nearest() const { return nearest_; }
  /// m: of all pairs, where they have the same margin.
  std::optional<double> commonMargin() const;
  /// Of a part and a link of the store, m.
  double marginOf(std::size_t part, std::size_t link) const;
  /// Of an object, m.
  double objectMargin(int object) const { return margins_[static_cast<std::size_t>(object)]; }
  /// The margins of a part's pairs, were that of the part itself 0.
  margin::PartMargins linkMargins(std::size_t part) const;
  /// Of a part alone, with this margin (m) and the present ones of the links.
  margin::MarginOutcome outcomeOf(std::size_t part, double margin) const;
  /// The known moment that is nearest to `t` (s); null: none is as near as half the time between two of them.
  const view::MomentPoses* posesNear(double t) const;
  /// Index of the outline's pairs, or -1.
  int pairOf(std::size_t part, std::size_t link) const;
  /// Grows whenever changed() is emitted.
  long revision() const { return revision_; }
  /// Grows with every open(), and when the analysis begins again: the store is another one.
  long opened() const { return opened_; }

  /// Where an event of these kinds after `t` begins, or the last one before it; near misses count at their
  /// nearest.
  std::optional<double> nextEvent(double t, EventKinds kinds) const;
  std::optional<double> previousEvent(double t, EventKinds kinds) const;
  /// Of the kinds that are shown.
  std::optional<double> nextEvent(double t) const { return nextEvent(t, events_.shown); }
  std::optional<double> previousEvent(double t) const { return previousEvent(t, events_.shown); }

 Q_SIGNALS:
  void changed();

 private:
  void judge();
  void gatherEvents();
  void forget();
  /// Everything that was taken from the store, which is another one from now on.
  void forgetStore();

  AnalysisPort* port_{nullptr};
  view::AnalysisNews::State state_{};
  std::size_t done_{0}, frames_{0};
  QString problem_;
  std::vector<double> margins_;
  std::map<std::pair<int, int>, int> pair_of_;
  std::optional<margin::ClearanceStore> store_;
  FrameSeries nearest_;
  std::vector<view::MomentPoses> poses_;  ///< in order of time
  margin::MarginReviewer reviewer_;
  const margin::MarginReview* review_;
  struct {
    ContactScan scan;
    std::vector<RecordingEvent> stops;  ///< as played
    std::vector<RecordingEvent> all;    ///< in order of time
    EventKinds shown{allKinds()};
    QElapsedTimer stops_told;  ///< since they were taken over
  } events_;
  margin::MarginReview live_;                   ///< of moments of a server
  double start_{0.0}, end_{0.0}, period_{0.0};  ///< s, of the outline
  WhatIfSettings settings_;
  int left_out_{0};
  long revision_{0}, opened_{0};
  QElapsedTimer judged_;
  qint64 cost_ms_{0};  ///< of judging
  QTimer* later_;
};

}  // namespace abstand::ui
