#include "ui/model/moment_sample.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::ui {

view::PlotSample momentSample(const view::SceneSnapshot& snapshot, int joint) {
  view::PlotSample sample;
  sample.t = snapshot.t;
  const auto nearest = static_cast<std::size_t>(snapshot.nearest_pair);
  sample.min_distance = snapshot.nearest_pair >= 0 && nearest < snapshot.pairs.size()
                            ? snapshot.pairs[nearest].result.distance
                            : kNaN;
  for (const view::PairSnapshot& pair : snapshot.pairs)
    if (!pair.paused && pair.result.contacts > 0)
      sample.peak_force = std::max(sample.peak_force, pair.result.force_a.norm());
  if (joint >= 0) {
    const auto j = static_cast<std::size_t>(joint);
    sample.peak_torque = j < snapshot.joint_torques.size() ? snapshot.joint_torques[j] : view::TorqueParts{};
    return sample;
  }
  sample.peak_torque = {kNaN, kNaN, kNaN, kNaN};
  for (const view::TorqueParts& parts : snapshot.joint_torques) {
    const auto raise = [](double& most, double value) { most = std::fmax(most, std::abs(value)); };
    raise(sample.peak_torque.contact, parts.contact);
    raise(sample.peak_torque.reaction, parts.reaction);
    raise(sample.peak_torque.gravity, parts.gravity);
    raise(sample.peak_torque.motion, parts.motion);
  }
  return sample;
}

}  // namespace abstand::ui
