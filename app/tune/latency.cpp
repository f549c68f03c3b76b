#include "app/tune/latency.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/part_uncertainty.hpp"

namespace abstand::tune {

std::vector<double> latencyUncertainty(const session::Session& session, double latency) {
  const scene::Scene& scene = session.scene();
  std::vector<double> uncertainty(scene.objectCount(), 0.0);
  if (!(latency > 0.0)) return uncertainty;
  for (const auto& human : session.humans()) {
    if (!human->recording()) continue;
    const std::vector<session::HumanDriver::Body> bodies = human->bodies();
    const std::vector<double> recorded = human->recordedSpeeds(scene);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const double bound = scene.object(bodies[i].object).max_speed;
      const double speed = std::isfinite(bound) && bound > 0.0 ? bound : humanmodel::kPersonSpeed;
      uncertainty[bodies[i].object.index()] = latency * std::max(speed, recorded[i]);
    }
  }
  return uncertainty;
}

}  // namespace abstand::tune
