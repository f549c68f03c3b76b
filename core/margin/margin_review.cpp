#include "core/margin/margin_review.hpp"

#include <algorithm>

#include "core/margin/inside_frames.hpp"
#include "core/margin/outcome_stream.hpp"

namespace abstand::margin {
namespace {

/// Finds the intrusions of one part, chunk by chunk.
class IntrusionFinder {
 public:
  IntrusionFinder(std::size_t part, const ReviewOptions& options, std::vector<ReviewEvent>& events)
      : part_(part), limit_(options.margins.limit), stream_(options.margins), events_(events) {
    stream_.on_stop = [this](const Stop& stop) {
      ReviewEvent event;
      event.part = static_cast<std::uint16_t>(part_);
      event.begin = begin_;
      event.end = frame_;
      event.t0 = stop.begin;
      event.t1 = stop.end;
      event.min_clearance = stop.min_clearance;
      event.braking = stop.braking;
      event.false_stop = stop.false_stop;
      event.missed = stop.missed;
      events_.push_back(event);
    };
  }

  void take(const ClearanceChunk& chunk, const InsideFrames& inside) {
    const ClearanceChunk::Summary& all = chunk.summary(part_);
    const double least = std::min(all.least, all.between);
    const double first = chunk.t(0), last = chunk.t(chunk.frames() - 1);
    if (!inside.some && !stream_.stopping() && all.between > limit_) {
      stream_.addOutside({first, last, least, kInfinity, {}, 0});
      frame_ += chunk.frames();
      return;
    }
    if (inside.all && (least > limit_ || stream_.touched())) {
      if (!stream_.stopping()) begin_ = frame_;
      stream_.addInside({first, last, least, chunk.braking(part_, 0), {}, 0});
      frame_ += chunk.frames();
      return;
    }
    for (std::size_t i = 0; i < chunk.frames(); ++i, ++frame_) takeFrame(chunk, i, inside.at(i));
  }

  /// After the last chunk.
  void finish() { stream_.finish(); }

 private:
  void takeFrame(const ClearanceChunk& chunk, std::size_t i, bool inside) {
    if (inside && !stream_.stopping()) begin_ = frame_;
    const double between = chunk.between(part_, i);
    stream_.add({chunk.t(i), inside, chunk.clearance(part_, i), between, chunk.braking(part_, i)});
    if (inside || between > limit_) return;
    ReviewEvent event;
    event.kind = ReviewEvent::Kind::kBetweenFrames;
    event.part = static_cast<std::uint16_t>(part_);
    event.begin = frame_;
    event.end = frame_ + 1;
    event.min_clearance = event.braking = between;
    event.missed = true;
    events_.push_back(event);
  }

  std::size_t part_;
  double limit_;
  OutcomeStream stream_;
  std::vector<ReviewEvent>& events_;
  std::size_t frame_{0}, begin_{0};
};

/// Finds stretches inside the wider margins that never come inside the narrower ones.
class NearFinder {
 public:
  NearFinder(std::size_t part, std::vector<ReviewEvent>& events) : part_(part), events_(events) {}

  void take(const ClearanceChunk& chunk, const InsideFrames& inside, const InsideFrames& near) {
    if (!near.some || inside.all) {
      near.some ? spoil() : end();
      frame_ += chunk.frames();
      return;
    }
    for (std::size_t i = 0; i < chunk.frames(); ++i, ++frame_) {
      if (!near.at(i)) {
        end();
        continue;
      }
      if (!open_) begin_ = frame_, open_ = true, spoiled_ = false;
      spoiled_ = spoiled_ || inside.at(i);
    }
  }
  void end() {
    if (open_ && !spoiled_) {
      ReviewEvent event;
      event.kind = ReviewEvent::Kind::kNear;
      event.part = static_cast<std::uint16_t>(part_);
      event.begin = begin_;
      event.end = frame_;
      events_.push_back(event);
    }
    open_ = false;
  }

 private:
  void spoil() { open_ = spoiled_ = true; }

  std::size_t part_;
  std::vector<ReviewEvent>& events_;
  std::size_t frame_{0}, begin_{0};
  bool open_{false}, spoiled_{false};
};

/// All parts together.
class WholeBody {
 public:
  explicit WholeBody(const MarginOptions& options) : limit_(options.limit), stream_(options) {}

  void take(const ClearanceChunk& chunk, const std::vector<const InsideFrames*>& parts) {
    const std::size_t from = chunk.judged();
    if (from >= chunk.frames()) return;
    any_ = true;
    const double first = chunk.t(0), last = chunk.t(chunk.frames() - 1);
    const double least = std::min(chunk.least(), chunk.minBetween());
    const bool none = std::none_of(parts.begin(), parts.end(), [](const auto* p) { return p->some; });
    const bool all = std::any_of(parts.begin(), parts.end(), [](const auto* p) { return p->all; });
    if (from == 0 && none && !stream_.stopping() && chunk.minBetween() > limit_) {
      stream_.addOutside({first, last, least, kInfinity, {}, 0});
      return;
    }
    if (from == 0 && all && (least > limit_ || stream_.touched())) {
      stream_.addInside({first, last, least, chunk.leastBraking(0), {}, 0});
      return;
    }
    std::bitset<ClearanceChunk::kFrames> frames;
    for (const InsideFrames* part : parts)
      if (part->some && !part->all) frames |= part->frames;
    for (std::size_t i = from; i < chunk.frames(); ++i)
      stream_.add({chunk.t(i), all || frames[i], chunk.leastClearance(i), chunk.minBetween(i),
                   chunk.leastBraking(i)});
  }
  MarginOutcome finish() { return any_ ? stream_.finish() : MarginOutcome{}; }

 private:
  double limit_;
  OutcomeStream stream_;
  bool any_{false};
};

void complete(const ClearanceStore& store, ReviewEvent& event) {
  using Kind = ReviewEvent::Kind;
  event.nearest = store.leastFrame(event.part, event.begin, event.end);
  const ClearanceChunk::Nearest nearest = store.nearest(event.part, event.nearest);
  event.link = nearest.link;
  event.t_nearest = store.t(event.nearest);
  if (event.kind == Kind::kIntrusion) return;
  event.t0 = store.t(event.begin);
  event.t1 = store.t(std::min(event.end, store.frames() - 1));
  if (event.kind == Kind::kNear) event.min_clearance = nearest.clearance;
}

}  // namespace

void MarginReviewer::judge(std::size_t index, const ClearanceStore& store, const ReviewOptions& options) {
  Part& part = parts_[index];
  part.chunks = store.chunks().size();
  part.inside.clear();
  part.events.clear();
  IntrusionFinder intrusions(index, options, part.events);
  NearFinder nears(index, part.events);
  for (const auto& chunk : store.chunks()) {
    const InsideFrames inside = insideFrames(*chunk, index, part.inner);
    intrusions.take(*chunk, inside);
    nears.take(*chunk, inside, inside.all ? inside : insideFrames(*chunk, index, part.outer));
    part.inside.push_back(inside);
  }
  intrusions.finish();
  nears.end();
  for (ReviewEvent& event : part.events) complete(store, event);
}

const MarginReview& MarginReviewer::review(const ClearanceStore& store, std::span<const double> margins,
                                           const ReviewOptions& options) {
  const std::vector<PartMargins> inner = partMargins(store.layout(), margins);
  const std::vector<PartMargins> outer = partMargins(store.layout(), margins, options.near_factor);
  parts_.resize(inner.size());
  review_ = {};
  review_.frames = store.frames();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[k];
    if (part.chunks != store.chunks().size() || part.inner != inner[k] || part.outer != outer[k]) {
      part.inner = inner[k];
      part.outer = outer[k];
      judge(k, store, options);
    }
    review_.events.insert(review_.events.end(), part.events.begin(), part.events.end());
  }
  WholeBody whole(options.margins);
  std::vector<const InsideFrames*> inside(parts_.size());
  for (std::size_t c = 0; c < store.chunks().size(); ++c) {
    for (std::size_t k = 0; k < parts_.size(); ++k) inside[k] = &parts_[k].inside[c];
    whole.take(*store.chunks()[c], inside);
  }
  review_.outcome = whole.finish();
  std::stable_sort(review_.events.begin(), review_.events.end(),
                   [](const auto& a, const auto& b) { return a.t0 != b.t0 ? a.t0 < b.t0 : a.part < b.part; });
  return review_;
}

MarginReview review(const ClearanceStore& store, std::span<const double> margins,
                    const ReviewOptions& options) {
  return MarginReviewer().review(store, margins, options);
}

}  // namespace abstand::margin
