// What the review of a recording says, in words.
#include "ui/model/event_text.hpp"

#include <cmath>

#include "core/safety/clearance_verdict.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

/// Outside of what has been analysed.
bool isMissing(const margin::ClearanceStore* store, double t) {
  if (!store || store->empty() || t < store->t(0)) return true;
  const std::size_t last = store->frames() - 1;
  const double period = last > 0 ? store->t(last) - store->t(last - 1) : 0.0;
  return t > store->t(last) + period;
}

/// As short as it is exact.
QString assumedNumber(double value) { return QLocale().toString(value, 'g', 6); }

}  // namespace

QString partText(const margin::ClearanceStore& store, std::size_t part) {
  const auto& parts = store.layout().parts;
  const std::string& name = parts[part].name;
  const std::string person = personOf(name);
  for (const auto& other : parts)
    if (personOf(other.name) != person) return QString::fromStdString(name);
  return QString::fromStdString(name.substr(name.rfind('/') + 1));
}

QString linkText(const margin::ClearanceStore& store, std::size_t link) {
  return QString::fromStdString(store.layout().links[link].name);
}

QString subjectText(const RecordingReview& review, const RecordingEvent& event) {
  if (event.kind == EventKind::kStop) return event.robot;
  if (!review.store() || event.part < 0) return {};
  const QString part = partText(*review.store(), static_cast<std::size_t>(event.part));
  return event.parts > 1 ? tr("%1 and %2 more").arg(part).arg(event.parts - 1) : part;
}

QString stopText(const RecordingEvent& event) {
  if (event.kind != EventKind::kInside && event.kind != EventKind::kBetweenFrames) return {};
  if (event.missed) return tr("⚠ missed");
  return event.false_stop ? tr("false") : QString();
}

QString eventText(const RecordingReview& review, const RecordingEvent& event) {
  if (event.kind == EventKind::kStop) return event.story;
  if (event.part < 0) return {};
  const QString span = tr("%1 from %2 to %3: %4")
                           .arg(subjectText(review, event), secondsWithUnit(event.t0),
                                secondsWithUnit(event.t1), kindText(event.kind));
  return span + QLatin1Char('\n') + momentText(review, static_cast<std::size_t>(event.part), event.t_nearest);
}

QString momentText(const RecordingReview& review, std::size_t part, double t) {
  const margin::ClearanceStore* store = review.store();
  if (isMissing(store, t)) return tr("%1: not analysed yet").arg(secondsWithUnit(t));
  const margin::ClearanceChunk::Nearest nearest = store->nearest(part, store->frameAt(t));
  const QString head =
      tr("%1, frame %2: %3").arg(secondsWithUnit(t)).arg(store->frameAt(t) + 1).arg(partText(*store, part));
  if (std::isinf(nearest.clearance)) return tr("%1 not seen").arg(head);
  const double margin = review.marginOf(part, nearest.link);
  const QString verdict =
      safety::isTouching(nearest.distance, nearest.distance - nearest.clearance - nearest.uncertainty)
          ? tr("touching, margin %1")
      : nearest.clearance < margin ? tr("inside the margin of %1")
                                   : tr("margin %1");
  return tr("%1 – %2: %3 ± %4, so at least %5; %6%7")
      .arg(head, linkText(*store, nearest.link), lengthText(nearest.distance),
           lengthText(nearest.distance - nearest.clearance), lengthText(nearest.clearance),
           verdict.arg(lengthText(margin)), nearest.unknown ? tr("; the pose is lost") : QString());
}

QString nearestMomentText(const RecordingReview& review, double t) {
  const margin::ClearanceStore* store = review.store();
  if (isMissing(store, t)) return tr("%1: not analysed yet").arg(secondsWithUnit(t));
  const std::size_t frame = store->frameAt(t);
  std::size_t nearest = 0;
  for (std::size_t part = 1; part < store->layout().parts.size(); ++part)
    if (store->nearest(part, frame).clearance < store->nearest(nearest, frame).clearance) nearest = part;
  return momentText(review, nearest, t);
}

QString outcomeText(const margin::MarginOutcome& outcome) {
  const int stops = static_cast<int>(outcome.stops);
  return QCoreApplication::translate("abstand::ui", "%n stops, %1 % of the time; %2 false, %3 missed",
                                     nullptr, stops)
      .arg(fixed(100.0 * outcome.stoppedShare(), 1))
      .arg(outcome.false_stops)
      .arg(outcome.missed_stops);
}

QString leftOutText(const RecordingReview& review) {
  return review.leftOut() > 0 ? QCoreApplication::translate("abstand::ui", "%n unchecked pairs left out",
                                                            nullptr, review.leftOut())
                              : QString();
}

QString whatIfText(const RecordingReview& review) {
  QString text;
  const bool live = review.state() == view::AnalysisNews::State::kLive;
  if (live) text = tr("Moments as they arrived; nothing is said about the time between them");
  if (!live && review.store() && !review.store()->empty()) {
    text = outcomeText(review.review().outcome);
    if (review.progress() < 1.0) text = tr("So far: %1").arg(text);
  }
  const QString left_out = leftOutText(review);
  if (left_out.isEmpty()) return text;
  return text.isEmpty() ? left_out : tr("%1; %2").arg(text, left_out);
}

QString whatIfTip(const RecordingReview& review) {
  const WhatIfSettings& with = review.settings();
  QString tip =
      tr("Outcome of the present margins over the whole recording, as recorded and without\n"
         "reactions: protective stops, and the share of time in which the robot would have stood.\n"
         "False: even without the stop nobody would have been touched.\n"
         "Missed: a touch before the robot stands is not excluded, or nobody told the robot.\n"
         "The same numbers as those of \"abstand tune\".");
  tip += QLatin1Char('\n') +
         tr("Assumed (Margins > What-if assumptions): reaction time %1 s, deceleration %2 rad/s² or m/s²,\n"
            "limit %3, restart time %4 s, calibration error %5, age of poses %6 s.")
             .arg(assumedNumber(with.reaction_time), assumedNumber(with.deceleration),
                  lengthText(with.limit, 0), assumedNumber(with.restart_time),
                  lengthText(with.calibration_error, 0), assumedNumber(with.latency));
  if (review.leftOut() > 0)
    tip += QLatin1Char('\n') + QCoreApplication::translate(
                                   "abstand::ui",
                                   "%n pairs of people and robots are not checked, and are not part of it.",
                                   nullptr, review.leftOut());
  return tip;
}

QString analysisText(const RecordingReview& review) {
  using State = view::AnalysisNews::State;
  if (!review.available()) return {};
  switch (review.state()) {
    case State::kOpening:
      return tr("Analysis: reading files");
    case State::kRunning:
      return tr("Analysis %1 %").arg(static_cast<int>(100.0 * review.progress()));
    case State::kFailed:
      return tr("⚠ Analysis failed");
    case State::kLive:
    case State::kDone:
      break;
  }
  return {};
}

}  // namespace abstand::ui
