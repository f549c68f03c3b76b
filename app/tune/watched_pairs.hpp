// Pairs for which margins are computed.
#pragma once

#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::tune {

/// A pair of a person's part, or of a tool in a hand, and a robot's link.
struct WatchedPair {
  PairId id;
  std::size_t part{0}, link{0};  ///< object indices in the scene
  std::size_t robot{0};          ///< mechanism index in the session
  bool part_is_a{false};
  humanmodel::BodyPart body_part{humanmodel::BodyPart::kTorso};  ///< of a tool: the hand that holds it
  bool tool{false};                                              ///< `part` is a tool
};

/// Every pair of a person's part with a robot's link, in the order of the scene's pairs.
std::vector<WatchedPair> watchedPairs(const session::Session& session);

/// "hand_right", or "hand_right (operator/driver)" if the tool in this hand is nearer than the hand.
std::string partText(const std::string& part, const std::string& tool);

/// Lets the scene check no other pairs: nobody asks for their distances.
void pauseOthers(const std::vector<WatchedPair>& watched, session::Session& session);

}  // namespace abstand::tune
