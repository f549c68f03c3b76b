// Distances of single bodies and pairs over time, for the plots.
#pragma once

#include <QObject>
#include <QString>
#include <list>
#include <optional>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/frame_series.hpp"

class QMimeData;

namespace abstand::ui {

class RecordingReview;

/// A body or a pair, by its number in the outline.
struct Watched {
  enum class Kind { kBody, kPair };
  Kind kind{Kind::kBody};
  int index{-1};
  bool operator==(const Watched&) const = default;
};

/// For drag and drop within the program.
QMimeData* mimeOf(const std::vector<Watched>& watched);
std::vector<Watched> watchedIn(const QMimeData& data);

/// What is selected, and what the user has pinned beside it. Of a body: to whatever is nearest; of a body
/// part or a link that is checked against people or robots: to the nearest of those. GUI thread only.
class WatchedSeries : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMaxPinned = 4, kMaxSelected = 2;

  struct Line {
    QString name;
    const FrameSeries* series;
    bool pinned;
  };

  using QObject::QObject;

  /// Forgets everything. `certified`: values are certified clearances instead of distances, and those of body
  /// parts come from the review of the whole recording. The outline outlives its stay here.
  void open(const view::SceneOutline& outline, bool certified);
  /// Only the first kMaxPinned are kept. One that is pinned already stays.
  void pin(const std::vector<Watched>& watched);
  void unpinAll();
  /// Instead of what was selected before; more than kMaxSelected: nothing.
  void setSelected(const std::vector<int>& objects, int pair);
  /// One moment that was computed.
  void add(const view::SceneSnapshot& snapshot);
  /// What the review has found since the last call.
  void add(const RecordingReview& review);

  std::vector<Line> lines() const;

 Q_SIGNALS:
  /// lines() are others.
  void changed();

 private:
  struct Entry {
    Watched what;
    QString name;
    bool pinned{false}, selected{false};
    std::vector<int> pairs;           ///< of the outline, whose least value it is
    std::optional<std::size_t> part;  ///< of the review's store
    bool looked_for_part{false};
    std::size_t frames{0};  ///< of the store, taken over
    FrameSeries series;
  };
  Entry& entry(const Watched& what);
  QString nameOf(const Watched& what) const;
  std::vector<int> pairsOf(const Watched& what) const;
  double valueOf(const view::SceneSnapshot& snapshot, const Entry& entry) const;
  void forgetUnused();

  const view::SceneOutline* outline_{nullptr};
  bool certified_{false};
  std::list<Entry> entries_;  // their series keep their addresses
};

}  // namespace abstand::ui
