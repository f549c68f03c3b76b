// Noise of a depth camera, for gates and weights.
#pragma once

namespace abstand::tracking {

/// m, standard deviation of a Kinect's depth at the depth z (m), with its steps (kinect_noise.hpp).
inline double depthNoiseAt(double z) { return 0.002 + 0.002 * z * z; }

}  // namespace abstand::tracking
