#include "core/safety/swept_distance.hpp"

namespace abstand {

void SweptOptions::validate() const {
  requireNumbers(*this);
  requireNumber(kName, "most_samples", most_samples, {2, kMaxSweptSamples});
}

}  // namespace abstand
