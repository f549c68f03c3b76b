#include "ui/model/contact_scan.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace abstand::ui {

namespace {

/// The store rounds uncertainties up, to numbers of eleven significant bits: by less than this share, or this
/// length (m), the step of the smallest numbers.
constexpr double kRoundingShare = 1.0 / 1024.0, kSmallestStep = 1.0 / 16777216.0;

bool isTouch(const margin::ClearanceChunk::Nearest& nearest) {
  return nearest.clearance + nearest.uncertainty * (1.0 - kRoundingShare) - kSmallestStep <= 0.0;
}

}  // namespace

void ContactScan::clear() {
  parts_.clear();
  chunks_ = frames_ = 0;
}

void ContactScan::extend(std::vector<Stretch>& stretches, std::size_t frame, double clearance) {
  if (stretches.empty() || stretches.back().end != frame)
    stretches.push_back({frame, frame, frame, clearance});
  Stretch& last = stretches.back();
  last.end = frame + 1;
  if (clearance < last.least) {
    last.least = clearance;
    last.nearest = frame;
  }
}

void ContactScan::update(const margin::ClearanceStore& store) {
  parts_.resize(store.layout().parts.size());
  for (; chunks_ < store.chunks().size(); ++chunks_) {
    const margin::ClearanceChunk& chunk = *store.chunks()[chunks_];
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const auto& all = chunk.summary(k);
      // Where the certified clearance is positive nothing touches.
      if (all.least > 0.0 && !all.unknown) continue;
      for (std::size_t f = 0; f < chunk.frames(); ++f) {
        const margin::ClearanceChunk::Nearest nearest = chunk.nearest(k, f);
        if (nearest.unknown) extend(parts_[k].losses, frames_ + f, nearest.clearance);
        // Where nothing is seen there is no distance.
        if (nearest.clearance > -kInfinity && isTouch(nearest))
          extend(parts_[k].contacts, frames_ + f, nearest.clearance);
      }
    }
    frames_ += chunk.frames();
  }
}

void ContactScan::append(const margin::ClearanceStore& store, std::vector<RecordingEvent>& events) const {
  if (frames_ == 0) return;
  const auto event = [&](EventKind kind, std::size_t part, const Stretch& stretch) {
    RecordingEvent made;
    made.kind = kind;
    made.part = static_cast<int>(part);
    made.frame = kind == EventKind::kLost ? stretch.begin : stretch.nearest;
    made.link = store.nearest(part, made.frame).link;
    made.t0 = store.t(stretch.begin);
    made.t1 = store.t(std::min(stretch.end, frames_ - 1));
    made.t_nearest = store.t(made.frame);
    made.min_clearance = stretch.least;
    return made;
  };
  using Key = std::tuple<std::string, std::size_t, std::size_t>;
  std::map<Key, std::size_t> lost;  // person, begin and end: number of the event
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    for (const Stretch& stretch : parts_[k].contacts)
      events.push_back(event(EventKind::kContact, k, stretch));
    const std::string person = personOf(store.layout().parts[k].name);
    for (const Stretch& stretch : parts_[k].losses) {
      const auto [at, made] = lost.emplace(Key{person, stretch.begin, stretch.end}, events.size());
      if (made)
        events.push_back(event(EventKind::kLost, k, stretch));
      else
        ++events[at->second].parts;
    }
  }
}

}  // namespace abstand::ui
