// What margins would have done over stored clearances, at once.
#pragma once

#include "core/margin/clearance_store.hpp"
#include "core/margin/inside_frames.hpp"
#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// A stretch of frames of one part.
struct ReviewEvent {
  enum class Kind : std::uint8_t {
    kIntrusion,      ///< inside the margin: the robot is told to stop at `begin`
    kBetweenFrames,  ///< at the limit between two frames outside of the margin
    kNear,           ///< outside of the margin, inside its multiple by ReviewOptions::near_factor
  };
  Kind kind{Kind::kIntrusion};
  std::uint16_t part{0}, link{0};           ///< indices of StoreLayout; the link that was nearest
  std::size_t begin{0}, end{0};             ///< frames, `end` the first one after it
  std::size_t nearest{0};                   ///< the frame with the least clearance
  double t0{0.0}, t1{0.0}, t_nearest{0.0};  ///< s
  double min_clearance{0.0};                ///< m, certified, had the robot not stopped; -infinity: not known
  double braking{kInfinity};                ///< m, certified, until the robot is at rest
  bool false_stop{false}, missed{false};    ///< as of Intrusion
};

struct ReviewOptions {
  MarginOptions margins;
  double near_factor{2.0};
};

struct MarginReview {
  std::vector<ReviewEvent> events;  ///< in order of time, then of parts
  /// Of all parts together, from the first frame that can be judged: what `tune` says of the same margins.
  MarginOutcome outcome;
  std::size_t frames{0};  ///< that were judged or passed over
};

/// Judges margins again and again. What a change does not touch is kept: parts whose margins stay, as long as
/// no frames come. One thread.
class MarginReviewer {
 public:
  /// As review(). The store is always the same one and only grows.
  const MarginReview& review(const ClearanceStore& store, std::span<const double> margins,
                             const ReviewOptions& options);

 private:
  struct Part {
    PartMargins inner, outer;
    std::size_t chunks{0};  ///< that were judged
    std::vector<InsideFrames> inside;
    std::vector<ReviewEvent> events;
  };
  void judge(std::size_t index, const ClearanceStore& store, const ReviewOptions& options);

  std::vector<Part> parts_;
  MarginReview review_;
};

/// `margins`: m, of each object of the scene; the margin of a pair is the sum of its two bodies' ones.
MarginReview review(const ClearanceStore& store, std::span<const double> margins,
                    const ReviewOptions& options);

}  // namespace abstand::margin
