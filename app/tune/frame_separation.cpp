#include "app/tune/frame_separation.hpp"

namespace abstand::tune {

std::vector<std::optional<SeparationMoment>> frameSeparation(const PassResult& pass,
                                                             const margin::PairFrame& frame,
                                                             const safety::SeparationOptions& options) {
  std::vector<std::optional<SeparationMoment>> moments(pass.parts.size());
  for (std::size_t i = 0; i < pass.pairs.size(); ++i) {
    SeparationMoment pair;
    pair.t = frame.t;
    pair.link = pass.pairs[i].link;
    pair.clearance = frame.clearance[i];
    pair.robot_speed = frame.robot_speed[i];
    pair.person_speed = frame.person_speed[i];
    const auto judged = separationMoment(pair, options);
    std::optional<SeparationMoment>& worst = moments[pass.pairs[i].part];
    if (judged && (!worst || judged->missing() > worst->missing())) worst = judged;
  }
  return moments;
}

}  // namespace abstand::tune
