// What happens in a recording: touches, intrusions into margins, near misses, stops, lost tracking.
#pragma once

#include <QColor>
#include <QString>
#include <bitset>
#include <cstddef>
#include <string>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// In the order of their weight.
enum class EventKind {
  kLost,           ///< body parts are not seen, or their poses are stale or were rejected
  kNear,           ///< nearer than kNearFactor times the margin, never inside it
  kInside,         ///< inside the margin; whether something touches is an event of its own
  kBetweenFrames,  ///< outside of the margin in two frames between which a touch is not excluded
  kContact,        ///< touching, as PairLevel::kTouching
  kStop,           ///< a robot stood, as far as it was played
};
inline constexpr std::size_t kEventKinds = 6;

/// A set of kinds, by their numbers.
using EventKinds = std::bitset<kEventKinds>;
inline EventKinds onlyKind(EventKind kind) { return EventKinds{}.set(static_cast<std::size_t>(kind)); }
inline EventKinds allKinds() { return EventKinds{}.set(); }

struct RecordingEvent {
  EventKind kind{EventKind::kInside};
  int part{-1}, link{-1};                 ///< indices of StoreLayout; the link that was nearest; -1: of kStop
  std::size_t parts{1};                   ///< of kLost: so many of the person, `part` the first of them
  double t0{0.0}, t1{0.0};                ///< s, begin and end
  double t_nearest{0.0};                  ///< s, of the least clearance; of kLost and kStop the begin
  std::size_t frame{0};                   ///< of the store at t_nearest; not of kStop
  double min_clearance{kNaN};             ///< m, certified; -infinity: not known; NaN: of kStop
  bool false_stop{false}, missed{false};  ///< as of margin::ReviewEvent
  int pair{-1};                           ///< of SceneOutline::pairs: what a stop is about; -1: nothing
  QString robot, story;                   ///< of kStop: its name, and why it stood

  /// s: where keys go and markers stand.
  double mark() const { return kind == EventKind::kNear ? t_nearest : t0; }
};

/// "operator" of a part's full name, "operator/hand_left".
std::string personOf(const std::string& part);

/// "touching", "inside margin", "near miss", "touch between frames", "robot stopped", "tracking lost".
QString kindText(EventKind kind);
/// As levelColour() of the same state.
QColor kindColour(EventKind kind);

}  // namespace abstand::ui
