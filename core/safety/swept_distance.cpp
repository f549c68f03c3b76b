#include "core/safety/swept_distance.hpp"

namespace abstand::safety {

void SweptOptions::validate() const {
  config::requireNumbers(*this);
  config::requireNumber(kName, "max_samples", max_samples, {2, kMaxSweptSamples});
}

}  // namespace abstand::safety
