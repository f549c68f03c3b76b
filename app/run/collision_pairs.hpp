// Studies which pairs of a session's bodies can collide, and writes the file of pairs.
#pragma once

#include "app/session/session.hpp"
#include "core/robot_file/srdf_file.hpp"
#include "core/study/pair_study.hpp"

namespace abstand::run {

/// One pair of the session's objects.
struct CollisionPair {
  study::StudiedPair
      study;            ///< a and b are object indices; only the verdict is set if the pair was not sampled
  std::string posture;  ///< "joint=value;..." of the joints that move the two relative to each other
};

/// All pairs of links of mechanisms with each other and with single objects, in scene order. People are left
/// out, as they can be anywhere. Not sampled: adjacent pairs, and those removed by the scene's `exclude`, or
/// by a file or SRDF with the verdict user. Pairs not finished at an interrupt are undecided.
std::vector<CollisionPair> collisionPairs(const session::Session& session,
                                          const study::StudyOptions& options);

/// The file of pairs (core/study/pairs_file.hpp).
std::string pairsText(const session::Session& session, const std::vector<CollisionPair>& pairs,
                      const study::StudyOptions& options);

/// The pairs of links of a session's only mechanism that need no check: no two of their bodies can collide.
/// Throws UsageError if there are several mechanisms.
robot_file::Srdf srdfOf(const session::Session& session, const std::vector<CollisionPair>& pairs);

}  // namespace abstand::run
