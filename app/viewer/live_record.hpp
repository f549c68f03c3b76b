// What came from a server so far: the state of the connection, and the last ten minutes.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "app/moment/moment_packet.hpp"
#include "app/viewer/moment_ring.hpp"

namespace abstand::viewer {

enum class LinkState {
  kConnecting,  ///< no connection yet, or none again
  kConnected,   ///< frames come
  kOtherScene,  ///< the server has another scene now, which is not followed
  kFile         ///< moments of a file; there is no connection
};

/// s. Without a frame for this time nothing is known of the present. The server sends a frame at least every
/// 0.1 s while its loop lives.
inline constexpr double kStaleAfter = 0.5;

struct LinkStatus {
  LinkState state{LinkState::kConnecting};
  double rate{0.0};              ///< Hz, moments that arrived in the last second
  double moment_age{kInfinity};  ///< s since the last moment arrived
  double frame_age{kInfinity};   ///< s since the last frame arrived
  long damaged{0};               ///< connections that were ended because of damaged frames
  std::uint32_t left_out{0};     ///< moments that the server left out because we were too slow
  /// What is shown is no longer known to hold.
  bool stale() const {
    return state != LinkState::kFile && !(state == LinkState::kConnected && frame_age <= kStaleAfter);
  }
};

/// Times are those of the first server's clock; those of a server that was started again continue them. One
/// writer (the link) and one reader (the window), on two threads, which lock for short copies. `now`: s, any
/// steady clock, the same for all calls.
class LiveRecord {
 public:
  /// Hz. A person's hand moves 7 cm between two of them at 2 m/s.
  static constexpr double kKeptRate = 30.0;

  explicit LiveRecord(const RingLimits& limits = {}) : limits_(limits), ring_(limits) {}

  /// The writer's. A connection (or a file) begins; false: its scene is another one than before.
  bool begin(const moment::SceneCard& card, LinkState state, double now);
  void end(LinkState state, bool damaged);
  /// A frame with its content, as readMoment() accepted it; false: it is not later than the newest.
  bool add(std::span<const std::byte> frame, const moment::Moment& moment, double now);
  void alive(double now);

  /// The reader's. Of the first server; nothing before it has answered.
  std::optional<moment::SceneCard> card() const;
  LinkStatus status(double now) const;

  struct Span {
    double first{0.0}, last{0.0};  ///< s; the newest moment is at `last`
    std::size_t kept{0}, bytes{0};
    double rate{kKeptRate};  ///< Hz, of the moments that are kept
  };
  Span span() const;
  struct Copy {
    long number{-1};  ///< of the newest moment
    double t{kNaN};   ///< s
    std::vector<std::byte> frame;
  };
  /// The newest moment, if it is not the one in `copy`.
  bool copyNewest(Copy& copy) const;
  /// The kept moment at or before `t`, or `steps` later (negative: earlier), within those that are kept.
  /// False if there are none.
  bool copyAt(double t, int steps, Copy& copy) const;
  /// All kept frames one after the other, some at a time: those from `number` on, about 1 MB. Returns the
  /// number to go on with; nothing is appended at the end.
  std::size_t copyFrames(std::size_t number, std::vector<std::byte>& out) const;

  /// Sets the logs of all robots: the changes of their stop states from one moment that arrived to the next.
  /// What changed twice between two moments is one change.
  void copyLogs(std::vector<view::RobotSnapshot>& robots) const;
  /// Appends the samples of moments since the last call.
  void drainPlot(std::vector<view::PlotSample>& out);
  /// The next drainPlot() gives those of the last ten minutes again.
  void replayPlot();

 private:
  void logStops(const moment::Moment& moment);
  view::PlotSample sampleOf(const moment::Moment& moment, double t);
  void addSample(const moment::Moment& moment, double t);

  mutable std::mutex mutex_;
  const RingLimits limits_;
  MomentRing ring_;
  double kept_rate_{kKeptRate}, due_{-kInfinity};
  std::size_t frame_bytes_{0};  ///< of the largest moment
  std::optional<moment::SceneCard> card_;
  std::uint64_t server_{0};
  double offset_{0.0};  ///< s, from the clock of the present server
  bool rebase_{false};  ///< the next moment is the first of another server
  Copy newest_;
  LinkState state_{LinkState::kConnecting};
  double last_frame_{-kInfinity};   ///< s, when it arrived
  std::deque<double> arrivals_;     ///< s, of the moments of the last second
  double last_moment_{-kInfinity};  ///< s, when it arrived
  long damaged_{0};
  std::uint32_t left_out_{0};
  struct Stops {
    safety::StopLog log;
    safety::StopState state;
    double since;  ///< s
  };
  std::vector<Stops> stops_;  ///< of each robot; empty before the first moment
  struct {
    std::vector<view::PairClass> classes;  ///< of the card's pairs
    std::vector<double> margins;           ///< m, of the objects, as of the moment before
    long edits{0};                         ///< so many times they changed
  } sampling_;
  std::deque<view::PlotSample> samples_;
  std::size_t drained_{0};  ///< of samples_
};

}  // namespace abstand::viewer
