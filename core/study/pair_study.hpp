// Which pairs of bodies can collide at all, over all joint values of their mechanisms.
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

/// A mechanism that takes part. The study's q holds the values of all of them, one after the other.
struct StudyMechanism {
  const mechanism::Mechanism* mechanism;
  Transform X_WB{Transform::Identity()};
};

struct StudyBody {
  std::shared_ptr<const structure::HapticStructure> structure;
  int mechanism{-1};                      ///< index, or -1: it stands still
  int frame{-1};                          ///< index into the mechanism's frames, -1: its base
  Transform X_FL{Transform::Identity()};  ///< body in its frame; in the world when it stands still
};

struct StudyOptions {
  long samples{10000};
  std::uint64_t seed{1};
  int searches{8};                                         ///< for counter-examples, a pair
  double clearance{0.0};                                   ///< m; nearer than this counts as a collision
  int threads{0};                                          ///< 0: all cores
  std::function<void(std::size_t, std::size_t)> progress;  ///< done, all; may be empty
  std::function<bool()> interrupted;                       ///< may be empty
  /// Throws UsageError.
  void validate() const;
};

/// What was found of one pair.
struct StudiedPair {
  int a{0}, b{0};  ///< indices of the bodies, a < b
  PairVerdict verdict{PairVerdict::kNever};
  double distance{kInfinity};   ///< m, signed, the smallest found
  double bound{0.0};            ///< m; at that posture the true distance is not below distance - bound
  std::vector<double> posture;  ///< q there
  std::vector<int> dofs;        ///< those that move the two against each other
  long samples{0};              ///< random postures tried
  long hits{0};                 ///< of them, with distance - bound not above the clearance
  bool by_search{false};        ///< the collision was found by a search, after the samples found none
};

/// Samples the joint space uniformly and says of each pair: never (no posture came within the clearance),
/// always (the bodies overlapped in every posture), or sometimes. A pair is sampled until the first posture
/// that hits and one that does not are found. Before a pair is called never, counter-examples are searched
/// from its closest postures: down the gradient of the distance, which is n . (v_b - v_a) with the normal n
/// and the velocities of the nearest points, J^T n; where that ends, along single joints in ever smaller
/// steps.
///
/// Sampling proves nothing: what is rare in the joint space can be missed. The smallest distance that was
/// found is kept as evidence.
///
/// The result depends on the seed, not on the number of threads. Throws UsageError for bad options. When
/// interrupted it gives what was sampled so far; pairs of which more had to be sampled or searched are
/// undecided.
std::vector<StudiedPair> studyPairs(const std::vector<StudyMechanism>& mechanisms,
                                    const std::vector<StudyBody>& bodies,
                                    const std::vector<std::pair<int, int>>& pairs,
                                    const StudyOptions& options);

}  // namespace abstand::study
