#include "ui/model/moment_sample.hpp"

#include <algorithm>
#include <cmath>

#include "core/view/plot_sampler.hpp"

namespace abstand::ui {

view::PlotSample momentSample(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                              int joint) {
  view::PlotSample sample;
  sample.t = snapshot.t;
  view::fillSample(outline, snapshot, sample);
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
