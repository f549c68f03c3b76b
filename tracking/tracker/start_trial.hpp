// Selection of the first body of a person whom a first pass has learned.
#pragma once

#include <memory>
#include <vector>

#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// The search for a body is random, and an image can be explained by a wrong pose, which only motion refutes.
/// Several candidates are therefore tracked: searched for with different seeds, kEvery apart, and one that
/// starts on the path of the first pass. The one that explains the last kCounted of the trial best is the
/// person's. One thread. Allocates.
class StartTrial {
 public:
  static constexpr std::size_t kSearches = 4;
  static constexpr double kEvery = 0.1, kCounted = 0.4;  ///< s

  /// A body at a moment.
  struct Seen {
    std::size_t number;
    TrackedBody body;
  };
  struct Candidate {
    TrackedPerson tracker;
    std::vector<Seen> seen{};  ///< by increasing number, from the first one in which it was found
    double cost{0.0};          ///< sum of the last images
  };

  /// `start` (s): of the first candidate; `end`: of the last image of the person; `usual_cost`: median of
  /// Misfit::cost.
  StartTrial(const TrackedPerson::Options& options, std::shared_ptr<const KnownBody> known, double start,
             double end, double usual_cost);

  /// The person at a moment, `t` (s) not before the start. Returns whether it was the last one of the trial.
  bool see(std::size_t number, double t, std::span<const PersonImage> images);
  /// After the last one: the best candidate.
  Candidate& best();

 private:
  TrackedPerson::Options options_;
  std::shared_ptr<const KnownBody> known_;
  struct Start {
    double t;  ///< s
    bool on_path;
  };
  std::vector<Start> starts_;
  double counted_from_{-kInfinity}, end_;  ///< s
  double lost_cost_;
  std::vector<Candidate> candidates_;
};

}  // namespace abstand::tracking
