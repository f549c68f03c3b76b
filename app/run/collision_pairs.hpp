// Which pairs of a session's bodies can collide, as a file for people and for scenes.
#pragma once

#include "app/session/session.hpp"
#include "core/robot_file/srdf_file.hpp"
#include "core/study/pair_study.hpp"

namespace abstand::run {

/// One pair of the session's objects.
struct CollisionPair {
  study::StudiedPair
      study;            ///< a and b are numbers of objects; nothing but the verdict where it was not sampled
  std::string posture;  ///< "joint=value;..." of the joints that move the two against each other
};

/// All pairs of links of mechanisms with each other and with single objects, in scene order. People are left
/// out: they are anywhere. Adjacent pairs and those that the scene's `exclude`, or a file or SRDF with the
/// verdict user, takes out are not sampled. Pairs that an interrupt left open are undecided.
std::vector<CollisionPair> collisionPairs(const session::Session& session,
                                          const study::StudyOptions& options);

/// The file of pairs (core/study/pairs_file.hpp).
std::string pairsText(const session::Session& session, const std::vector<CollisionPair>& pairs,
                      const study::StudyOptions& options);

/// The pairs of links of a session's only mechanism that need no check: those of which no two bodies may
/// collide. Throws UsageError when there are more mechanisms.
robot_file::Srdf srdfOf(const session::Session& session, const std::vector<CollisionPair>& pairs);

}  // namespace abstand::run
