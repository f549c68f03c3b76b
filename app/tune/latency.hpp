// What a person may have moved since a pose that arrives late.
#pragma once

#include <vector>

#include "app/session/session.hpp"

namespace abstand::tune {

/// m, for each object of the scene: `latency` (s) times the speed of a part or tool of a person; 0 for others
/// and for people without a recording.
///
/// A pose that is stamped t shows the person at some time from t - latency to t. Since then no point of the
/// part has moved farther than latency * v, with v the larger one of the part's speed bound (max_speed of the
/// scene; without it 2.0 m/s, ISO 13855:2010's hand) and the highest speed of its fastest point anywhere in
/// the recording, so that people who are faster than the bound are covered as well. The speed holds for the
/// whole recording: nothing has to be known of accelerations.
std::vector<double> latencyUncertainty(const session::Session& session, double latency);

}  // namespace abstand::tune
