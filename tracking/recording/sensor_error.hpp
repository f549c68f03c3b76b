// Published errors of sensors that state none in their files.
#pragma once

namespace abstand::tracking {

/// Standard deviation (m) of each axis of a joint, definitions of joints included.
struct SensorError {
  double tracked, inferred;
  const char* source;
};

/// Mean over the standard deviation of an axis, of the length of an isotropic normal vector in space:
/// sqrt(8 / pi).
inline constexpr double kMeanOfSpread = 1.5957691216057308;
/// m, largest of the mean distances of most joints of a Kinect from those of optical motion capture, 0.05 to
/// 0.10 m (Wang, Kurillo, Ofli, Bajcsy 2015, ICHI).
inline constexpr double kKinectMeanError = 0.10;
/// m, by which Kinects place hidden joints wrongly, 0.05 to 0.1 m (Obdrzalek et al. 2012, EMBC); independent
/// of the former.
inline constexpr double kKinectHiddenError = 0.10;

/// Kinects of both generations.
inline constexpr SensorError kKinectError{
    kKinectMeanError / kMeanOfSpread,
    1.4142135623730951 * kKinectHiddenError / kMeanOfSpread,  // both errors are equal
    "Wang et al. 2015, Obdrzalek et al. 2012"};

}  // namespace abstand::tracking
