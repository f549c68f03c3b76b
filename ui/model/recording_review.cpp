// The whole recording under the present margins.
#include "ui/model/recording_review.hpp"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/margin/part_curve.hpp"

#include "ui/model/stop_text.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr qint64 kRest = 4;        // times what judging costs, between two of them
constexpr qint64 kStopsMs = 1000;  // between two times that a stop which goes on is taken over

RecordingEvent eventOf(const margin::ReviewEvent& of) {
  using Kind = margin::ReviewEvent::Kind;
  RecordingEvent event;
  event.kind = of.kind == Kind::kIntrusion       ? EventKind::kInside
               : of.kind == Kind::kBetweenFrames ? EventKind::kBetweenFrames
                                                 : EventKind::kNear;
  event.part = of.part;
  event.link = of.link;
  event.t0 = of.t0;
  event.t1 = of.t1;
  event.t_nearest = of.t_nearest;
  event.frame = of.nearest;
  event.min_clearance = of.min_clearance;
  event.false_stop = of.false_stop;
  event.missed = of.missed;
  return event;
}

}  // namespace

RecordingReview::RecordingReview(QObject* parent) : QObject(parent), later_{new QTimer(this)} {
  later_->setSingleShot(true);
  later_->setInterval(0);
  connect(later_, &QTimer::timeout, this, &RecordingReview::judge);
  judge();
}

void RecordingReview::open(AnalysisPort* port, const view::SceneOutline& outline,
                           std::vector<double> margins) {
  port_ = port;
  left_out_ = 0;
  margins_ = std::move(margins);
  margins_.resize(outline.objects.size(), 0.0);
  pair_of_.clear();
  for (std::size_t p = 0; p < outline.pairs.size(); ++p)
    pair_of_[std::minmax(outline.pairs[p].first, outline.pairs[p].second)] = static_cast<int>(p);
  start_ = outline.start;
  end_ = outline.end;
  period_ = outline.frame_period;
  events_.stops.clear();
  forget();
  judge();
}

void RecordingReview::forget() {
  ++opened_;
  state_ = {};
  done_ = frames_ = 0;
  problem_.clear();
  forgetStore();
}

void RecordingReview::forgetStore() {
  store_.reset();
  events_.scan.clear();
  nearest_ = FrameSeries(start_, end_, period_, Keep::kSmallest);
  poses_.clear();
  reviewer_ = {};
}

void RecordingReview::setSettings(const WhatIfSettings& settings) {
  if (settings_ == settings) return;
  settings_ = settings;
  reviewer_ = {};
  judge();
}

void RecordingReview::setLeftOut(int pairs) {
  if (left_out_ == pairs) return;
  left_out_ = pairs;
  ++revision_;
  Q_EMIT changed();
}

void RecordingReview::pull() {
  view::AnalysisNews news;
  if (!port_ || !port_->takeNews(news)) return;
  if (store_ && &store_->layout() != news.layout.get()) forget();
  state_ = news.state;
  done_ = news.done;
  frames_ = news.frames;
  problem_ = QString::fromStdString(news.problem);
  if (news.all) forgetStore();
  if (!store_ && news.layout) store_.emplace(news.layout);
  for (auto& chunk : news.chunks) {
    for (std::size_t i = 0; i < chunk->frames(); ++i) nearest_.add(chunk->t(i), chunk->leastClearance(i));
    store_->add(std::move(chunk));
  }
  std::move(news.poses.begin(), news.poses.end(), std::back_inserter(poses_));
  if (state_ != view::AnalysisNews::State::kRunning || judged_.elapsed() >= kRest * cost_ms_) {
    judge();
  } else {
    ++revision_;
    Q_EMIT changed();
  }
}

const view::MomentPoses* RecordingReview::posesNear(double t) const {
  if (poses_.size() < 2) return nullptr;
  auto after = std::lower_bound(poses_.begin(), poses_.end(), t,
                                [](const view::MomentPoses& poses, double time) { return poses.t < time; });
  if (after == poses_.end() || (after != poses_.begin() && t - std::prev(after)->t < after->t - t)) --after;
  const double between = poses_[1].t - poses_[0].t;
  return std::abs(after->t - t) <= 0.5 * between + period_ ? &*after : nullptr;
}

void RecordingReview::setSpan(double start, double end) {
  start_ = start;
  end_ = end;
}

void RecordingReview::setMargin(int object, double metres) {
  const auto i = static_cast<std::size_t>(object);
  if (i >= margins_.size() || margins_[i] == metres) return;
  margins_[i] = metres;
  if (store_ && !later_->isActive()) later_->start();
}

void RecordingReview::judge() {
  later_->stop();
  static const margin::MarginReview kNothing;
  judged_.start();
  review_ = store_ ? &reviewer_.review(*store_, margins_, {options(), kNearFactor}) : &kNothing;
  if (state_ == view::AnalysisNews::State::kLive) {
    // Nothing is known between moments, nor how the robot would have braked: no stop is said to be false or
    // missed.
    live_ = *review_;
    for (margin::ReviewEvent& event : live_.events) event.false_stop = event.missed = false;
    live_.outcome = {};
    review_ = &live_;
  }
  gatherEvents();
  cost_ms_ = judged_.restart();
  ++revision_;
  Q_EMIT changed();
}

double RecordingReview::progress() const {
  using State = view::AnalysisNews::State;
  if (state_ == State::kDone || state_ == State::kLive) return 1.0;
  return frames_ > 0 ? static_cast<double>(done_) / static_cast<double>(frames_) : 0.0;
}

std::optional<double> RecordingReview::commonMargin() const {
  std::optional<double> common;
  if (!store_) return common;
  for (const auto& [part, link] : store_->layout().pairs) {
    const double margin = marginOf(part, link);
    if (common && *common != margin) return {};
    common = margin;
  }
  return common;
}

double RecordingReview::marginOf(std::size_t part, std::size_t link) const {
  const margin::StoreLayout& layout = store_->layout();
  return margins_[layout.parts[part].object] + margins_[layout.links[link].object];
}

margin::PartMargins RecordingReview::linkMargins(std::size_t part) const {
  std::vector<double> margins = margins_;
  margins[store_->layout().parts[part].object] = 0.0;
  return margin::partMargins(store_->layout(), margins)[part];
}

margin::MarginOutcome RecordingReview::outcomeOf(std::size_t part, double margin) const {
  std::vector<double> margins = margins_;
  margins[store_->layout().parts[part].object] = margin;
  return margin::partOutcome(*store_, part, margin::partMargins(store_->layout(), margins)[part], options());
}

int RecordingReview::pairOf(std::size_t part, std::size_t link) const {
  const margin::StoreLayout& layout = store_->layout();
  const auto found = pair_of_.find(
      std::minmax(static_cast<int>(layout.parts[part].object), static_cast<int>(layout.links[link].object)));
  return found == pair_of_.end() ? -1 : found->second;
}

std::optional<double> RecordingReview::nextEvent(double t, EventKinds kinds) const {
  std::optional<double> next;
  for (const RecordingEvent& event : events_.all) {
    const double at = event.mark();
    if (kinds[static_cast<std::size_t>(event.kind)] && at > t + 0.5 * period_ && (!next || at < *next))
      next = at;
  }
  return next;
}

std::optional<double> RecordingReview::previousEvent(double t, EventKinds kinds) const {
  std::optional<double> last;
  for (const RecordingEvent& event : events_.all) {
    const double at = event.mark();
    if (kinds[static_cast<std::size_t>(event.kind)] && at < t - 0.5 * period_ && (!last || at > *last))
      last = at;
  }
  return last;
}

void RecordingReview::showKinds(EventKinds kinds) {
  if (std::exchange(events_.shown, kinds) == kinds) return;
  ++revision_;
  Q_EMIT changed();
}

void RecordingReview::setStops(const std::vector<StopSpan>& stops, const view::SceneOutline& outline) {
  // While a robot stands its stop only grows longer.
  const bool same =
      stops.size() == events_.stops.size() &&
      std::equal(stops.begin(), stops.end(), events_.stops.begin(),
                 [](const StopSpan& a, const RecordingEvent& b) { return a.range.from == b.t0; });
  if (same && (stops.empty() || stops.back().range.to == events_.stops.back().t1)) return;
  if (same && events_.stops_told.isValid() && events_.stops_told.elapsed() < kStopsMs) return;
  events_.stops_told.start();
  events_.stops.clear();
  for (const StopSpan& stop : stops) {
    RecordingEvent event;
    event.kind = EventKind::kStop;
    event.t0 = event.t_nearest = stop.range.from;
    event.t1 = stop.range.to;
    event.pair = stop.cause.pair;
    const auto robot = static_cast<std::size_t>(stop.robot);
    if (robot < outline.reacting.size()) event.robot = QString::fromStdString(outline.reacting[robot]);
    event.story = spanText(stop, outline);
    events_.stops.push_back(event);
  }
  gatherEvents();
  ++revision_;
  Q_EMIT changed();
}

void RecordingReview::gatherEvents() {
  std::vector<RecordingEvent>& all = events_.all;
  all.clear();
  for (const margin::ReviewEvent& event : review_->events) all.push_back(eventOf(event));
  if (store_) {
    events_.scan.update(*store_);
    events_.scan.append(*store_, all);
  }
  all.insert(all.end(), events_.stops.begin(), events_.stops.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const RecordingEvent& a, const RecordingEvent& b) { return a.t0 < b.t0; });
}

}  // namespace abstand::ui
