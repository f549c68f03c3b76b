// Distances of single bodies and pairs over time.
#include "ui/model/watched_series.hpp"

#include <QMimeData>
#include <algorithm>
#include <cmath>

#include "core/safety/clearance_verdict.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/recording_review.hpp"

namespace abstand::ui {

namespace {

const QString& mimeType() {
  static const QString type = QStringLiteral("application/x-abstand-watched");
  return type;
}

}  // namespace

QMimeData* mimeOf(const std::vector<Watched>& watched) {
  QByteArray text;
  for (const Watched& each : watched)
    text += (each.kind == Watched::Kind::kBody ? "body " : "pair ") + QByteArray::number(each.index) + '\n';
  auto* data = new QMimeData;
  data->setData(mimeType(), text);
  return data;
}

std::vector<Watched> watchedIn(const QMimeData& data) {
  std::vector<Watched> found;
  for (const QByteArray& line : data.data(mimeType()).split('\n')) {
    bool good = false;
    const int index = line.mid(5).toInt(&good);
    if (!good) continue;
    if (line.startsWith("body ")) found.push_back({Watched::Kind::kBody, index});
    if (line.startsWith("pair ")) found.push_back({Watched::Kind::kPair, index});
  }
  return found;
}

void WatchedSeries::open(const view::SceneOutline& outline, bool certified) {
  outline_ = &outline;
  certified_ = certified;
  entries_.clear();
  Q_EMIT changed();
}

QString WatchedSeries::nameOf(const Watched& what) const {
  const auto body = [this](int object) {
    return QString::fromStdString(outline_->objects[static_cast<std::size_t>(object)].name);
  };
  if (what.kind == Watched::Kind::kBody) return body(what.index);
  const auto [a, b] = outline_->pairs[static_cast<std::size_t>(what.index)];
  return tr("%1 – %2").arg(body(a), body(b));
}

std::vector<int> WatchedSeries::pairsOf(const Watched& what) const {
  if (what.kind == Watched::Kind::kPair) return {what.index};
  std::vector<int> all, of_people;
  for (std::size_t i = 0; i < outline_->pairs.size(); ++i) {
    const auto& [a, b] = outline_->pairs[i];
    if (a != what.index && b != what.index) continue;
    all.push_back(static_cast<int>(i));
    if (pairClassOf(*outline_, outline_->pairs[i]) == PairClass::kPersonRobot)
      of_people.push_back(static_cast<int>(i));
  }
  return of_people.empty() ? all : of_people;
}

WatchedSeries::Entry& WatchedSeries::entry(const Watched& what) {
  for (Entry& each : entries_)
    if (each.what == what) return each;
  Entry& made = entries_.emplace_back();
  made.what = what;
  made.name = nameOf(what);
  made.pairs = pairsOf(what);
  made.series = FrameSeries(outline_->start, outline_->end, outline_->frame_period, Keep::kSmallest);
  return made;
}

void WatchedSeries::forgetUnused() {
  entries_.remove_if([](const Entry& each) { return !each.pinned && !each.selected; });
}

void WatchedSeries::pin(const std::vector<Watched>& watched) {
  if (!outline_) return;
  for (const Watched& what : watched) {
    const std::size_t size =
        what.kind == Watched::Kind::kBody ? outline_->objects.size() : outline_->pairs.size();
    const auto pinned =
        std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return e.pinned; });
    if (what.index < 0 || static_cast<std::size_t>(what.index) >= size ||
        static_cast<std::size_t>(pinned) >= kMaxPinned)
      continue;
    entry(what).pinned = true;
  }
  Q_EMIT changed();
}

void WatchedSeries::unpinAll() {
  for (Entry& each : entries_) each.pinned = false;
  forgetUnused();
  Q_EMIT changed();
}

void WatchedSeries::setSelected(const std::vector<int>& objects, int pair) {
  if (!outline_) return;
  for (Entry& each : entries_) each.selected = false;
  if (pair >= 0)
    entry({Watched::Kind::kPair, pair}).selected = true;
  else if (objects.size() <= kMaxSelected)
    for (const int object : objects) entry({Watched::Kind::kBody, object}).selected = true;
  forgetUnused();
  Q_EMIT changed();
}

double WatchedSeries::valueOf(const view::SceneSnapshot& snapshot, const Entry& of) const {
  double least = kNaN;
  for (const int index : of.pairs) {
    const auto i = static_cast<std::size_t>(index);
    if (i >= snapshot.pairs.size() || snapshot.pairs[i].paused) continue;
    const query::PairResult& result = snapshot.pairs[i].result;
    const auto [a, b] = outline_->pairs[i];
    const double uncertainty = snapshot.objects[static_cast<std::size_t>(a)].pose_uncertainty +
                               snapshot.objects[static_cast<std::size_t>(b)].pose_uncertainty;
    least =
        std::fmin(least, certified_ ? safety::certifiedClearance({result.distance, result.bound, uncertainty})
                                    : result.distance);
  }
  return least;
}

void WatchedSeries::add(const view::SceneSnapshot& snapshot) {
  for (Entry& each : entries_)
    if (!each.part) each.series.add(snapshot.t, valueOf(snapshot, each));
}

void WatchedSeries::add(const RecordingReview& review) {
  const margin::ClearanceStore* store = review.store();
  if (!certified_ || !store) return;
  for (Entry& each : entries_) {
    if (each.what.kind != Watched::Kind::kBody) continue;
    const auto& parts = store->layout().parts;
    if (!std::exchange(each.looked_for_part, true)) {
      const auto found = std::find_if(parts.begin(), parts.end(), [&](const auto& part) {
        return static_cast<int>(part.object) == each.what.index;
      });
      if (found != parts.end()) each.part = static_cast<std::size_t>(found - parts.begin());
    }
    if (!each.part) continue;
    for (; each.frames < store->frames(); ++each.frames)
      each.series.add(store->t(each.frames), store->nearest(*each.part, each.frames).clearance);
  }
}

std::vector<WatchedSeries::Line> WatchedSeries::lines() const {
  std::vector<Line> lines;
  for (const bool pinned : {true, false})
    for (const Entry& each : entries_)
      if (each.pinned == pinned) lines.push_back({each.name, &each.series, pinned});
  return lines;
}

}  // namespace abstand::ui
