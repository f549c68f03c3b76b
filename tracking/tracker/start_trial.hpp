// Selection of the first body of a person whom a first pass has learned.
#pragma once

#include <memory>
#include <vector>

#include "tracking/tracker/kept_images.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// The search for a body is random, and an image can be explained by a wrong pose, which only motion refutes.
/// Several candidates are therefore tracked: searched for with different seeds, kEvery apart, and one that
/// starts on the path of the first pass. The one that explains the last kCounted of the trial best is the
/// person's; it is tracked backwards, too. If the first pass decided which way the person faces, bodies that
/// face the other way are candidates as well. If one explains the images much better, the product of the
/// ratios of both passes decides; if it does not, that of a longer trial; if that does not either, both
/// bodies are the person's. One thread. Allocates.
class StartTrial {
 public:
  static constexpr std::size_t kSearches = 4;
  static constexpr double kEvery = 0.1, kCounted = 0.4;  ///< s
  static constexpr double kCountedLonger = 1.5;          ///< s, of a longer trial
  /// Times the cost of the best candidate, below which one that faces the other way counts.
  static constexpr double kRefuted = 1.0 / Facing::kSureAway;

  /// `start` (s): images before, which show a part of the person, are tracked as far as possible, and nobody
  /// is searched for in them; `usual_cost`: median of Misfit::cost.
  StartTrial(const TrackedPerson::Options& options, std::shared_ptr<const KnownBody> known, double start,
             double usual_cost);

  /// s, of the last image that is needed.
  double end() const { return counted_from_ + counted_; }
  /// Adds moments by increasing time; before run(), at least one that is not before the start.
  void add(std::vector<KeptMoment> moments);
  std::span<const KeptMoment> moments() const { return moments_; }

  struct Result {
    std::unique_ptr<TrackedPerson> tracker{};  ///< after the last image
    std::vector<TrackedBody> bodies{};         ///< of each moment; not found where it was lost
    double cost{kInfinity};                    ///< sum of the last moments
    bool contradicts_first{false};             ///< both directions are followed
  };
  /// The best candidate in the moments.
  Result run() const;
  /// A trial that contradicts the first pass takes longer. Returns whether it did not before.
  bool extend();

 private:
  struct Start {
    double t;  ///< s
    bool on_path;
    std::size_t seed;  ///< added to the usual one
  };
  void compete(const Start& start, const std::shared_ptr<const KnownBody>& known, int vain,
               Result& best) const;
  void continueBefore(Result& best) const;
  bool mayFaceOtherWay() const;
  Result bestOfOtherWay(double cost) const;
  void revise(Result other, Result& best) const;
  double costOf(const TrackedBody& body) const;

  TrackedPerson::Options options_;
  std::shared_ptr<const KnownBody> known_;
  double start_, counted_from_{-kInfinity};  ///< s
  double counted_{kCounted};                 ///< s
  double lost_cost_;
  std::vector<Start> starts_;
  std::vector<KeptMoment> moments_;
};

}  // namespace abstand::tracking
