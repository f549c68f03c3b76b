// Finds the pairs of bodies that can collide, over all joint values of their mechanisms.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/mechanism/joint_range.hpp"
#include "core/mechanism/mechanism.hpp"
#include "core/structure/haptic_structure.hpp"
#include "core/study/pairs_file.hpp"

namespace abstand::study {

/// A mechanism of the study. The study's q is the concatenation of the values of all of them.
struct StudyMechanism {
  const mechanism::Mechanism* mechanism;
  Transform X_WB{Transform::Identity()};
};

struct StudyBody {
  std::shared_ptr<const structure::HapticStructure> structure;
  int mechanism{-1};                      ///< index, or -1: fixed in the world
  int frame{-1};                          ///< index into the mechanism's frames, -1: its base
  Transform X_FL{Transform::Identity()};  ///< body in its frame; in the world if it is fixed
};

struct StudyOptions {
  long samples{10000};
  std::uint64_t seed{1};
  int searches{8};                                         ///< searches for counter-examples, for each pair
  double clearance{0.0};                                   ///< m; smaller distances count as a collision
  int threads{0};                                          ///< 0: all cores
  std::function<void(std::size_t, std::size_t)> progress;  ///< work done, and total; may be empty
  std::function<bool()> interrupted;                       ///< may be empty
  /// Throws UsageError.
  void validate() const;
};

/// Result for one pair.
struct StudiedPair {
  int a{0}, b{0};  ///< indices of the bodies, a < b
  PairVerdict verdict{PairVerdict::kNever};
  double distance{kInfinity};   ///< m, signed, smallest one found
  double bound{0.0};            ///< m; in that posture the true distance is not below distance - bound
  std::vector<double> posture;  ///< q of that posture
  std::vector<int> dofs;        ///< dofs that move the two relative to each other
  long samples{0};              ///< random postures tried
  long hits{0};                 ///< samples with distance - bound not above the clearance
  bool by_search{false};        ///< the collision was found by a search, after the samples found none
};

/// Samples the joint space uniformly and classifies each pair: never (no posture came within the clearance),
/// always (the bodies overlapped in every posture), or sometimes. A pair is sampled until one posture with
/// and one without a collision are found. Before a pair is classified as never, counter-examples are searched
/// from its closest postures: gradient descent of the distance with the gradient n . (v_b - v_a), n the
/// normal and v the velocities of the witness points, J^T n; then coordinate search along single joints with
/// decreasing steps.
///
/// Sampling proves nothing: rare collisions in the joint space can be missed. The smallest distance found is
/// kept as evidence.
///
/// The result depends on the seed, not on the number of threads. Throws UsageError for invalid options. If
/// interrupted, returns the results so far; pairs that would have needed more samples or searches are
/// undecided.
std::vector<StudiedPair> studyPairs(const std::vector<StudyMechanism>& mechanisms,
                                    const std::vector<StudyBody>& bodies,
                                    const std::vector<std::pair<int, int>>& pairs,
                                    const StudyOptions& options);

}  // namespace abstand::study
