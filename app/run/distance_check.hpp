// Checks distances of pairs against a limit over time.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/run/run_scene.hpp"
#include "app/run/swept_check.hpp"
#include "core/safety/clearance_verdict.hpp"

namespace abstand::run {

/// A stretch of frames in which a pair violated its limit. Times in s, distances in m.
struct Violation {
  std::string a, b;
  double start{0.0}, end{0.0};
  double min_distance{0.0};
  double limit{0.0};
  double uncertainty{0.0};  ///< m, largest pose uncertainty added to the limit; infinite: a body was not seen
                            ///< at all
  std::string recording;
};

struct CheckResult {
  std::vector<Violation> violations;  ///< distance < limit + uncertainty
  std::vector<Violation> unproven;    ///< otherwise: distance - bound < limit + uncertainty
  std::vector<std::string> stale;
  std::vector<Reservation> reservations;            ///< reasons to doubt the verdict; some of them fail the
                                                    ///< check
  std::optional<RunSummary::Extreme> min_distance;  ///< over all recordings, at the frames
  std::array<std::optional<RunSummary::Extreme>, kPairClasses.size()> min_distance_by_class;
  std::size_t frames{0};
  long swept_queries{0};  ///< between frames
};

/// True if no limit was violated and nothing was unknown; with `strict`, everything must be proven and no
/// reservation may be strict.
bool passed(const CheckResult& result, bool strict);

/// Watches the pairs of a scene frame by frame.
class DistanceCheck {
 public:
  /// `with_margins`: the limit of a pair is max(limit, sum of its two margins). `swept`: also between frames.
  DistanceCheck(const scene::Scene& scene, double limit, bool with_margins, bool swept,
                std::string recording);

  void frame(double t, const std::vector<query::PairResult>& results);
  /// Ends open violations and adds everything to `all`, in order of time.
  void finish(const RunSummary& summary, CheckResult& all);

 private:
  struct Open {
    bool active{false};
    Violation violation;
  };
  /// State of one pair in a frame.
  struct Sample {
    std::size_t pair;
    double t, distance, uncertainty;
  };
  safety::ClearanceVerdict verdictOf(const query::PairResult& result, std::size_t pair) const;
  void watch(Open& open, std::vector<Violation>& closed, const Sample& at, bool broken);

  const scene::Scene& scene_;
  kernels::PairScratch scratch_;
  std::string recording_;
  std::optional<SweptCheck> swept_;
  std::vector<double> limits_;
  std::vector<double> uncertainties_;  ///< m, of each pair in the last frame
  std::vector<double> widened_;  ///< limits plus the larger pose uncertainty of this frame and the last one
  std::vector<Open> broken_, unproven_;
  std::vector<Violation> closed_broken_, closed_unproven_;
};

/// Reads `NAME: metres` lines (a YAML map) and sets the objects' margins. Throws ParseError.
void applyMargins(scene::Scene& scene, const std::filesystem::path& file);

}  // namespace abstand::run
