// Common interface of all recording readers: named points, frame by frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/body_size.hpp"
#include "tracking/recording/file_warning.hpp"
#include "tracking/recording/sensor_error.hpp"
#include "tracking/recording/subject_facts.hpp"
#include "tracking/recording/up_axis.hpp"

namespace abstand::tracking {

/// One frame of a file, in the file's axes and units. Missing points are NaN.
struct PointFrame {
  double t{0.0};  ///< s
  std::vector<Vector3d> p;
  std::vector<humanmodel::JointState> state;
  std::vector<double> spread;  ///< standard deviation along the worst axis; 0 or empty: unknown
  /// As SkeletonFrame::covariance, in the file's axes and units squared; empty: no point has one.
  std::vector<Matrix3d> covariance;
  /// As SkeletonFrame::lateral, in the file's axes; empty: none is stated.
  std::vector<Eigen::Vector3f> lateral;
  /// For each point the rotation, in the file's axes, of what starts at it since turnRest(); empty: the file
  /// states no orientations.
  std::vector<Matrix3d> turn;

  /// Sets all `points` to missing, t = 0.
  void clear(std::size_t points) {
    t = 0.0;
    p.assign(points, Vector3d::Constant(kNaN));
    state.assign(points, humanmodel::JointState::kMissing);
    spread.assign(points, 0.0);
    covariance.clear();
    lateral.clear();
    turn.clear();
  }
  double spreadOf(std::size_t point) const { return point < spread.size() ? spread[point] : 0.0; }
  Matrix3d covarianceOf(std::size_t point) const {
    return point < covariance.size() ? covariance[point] : Matrix3d::Zero();
  }
  void set(std::size_t point, const Vector3d& p_FP,
           humanmodel::JointState s = humanmodel::JointState::kTracked) {
    p[point] = p_FP;
    state[point] = s;
  }
};

/// Properties stated by a file or its format.
struct PointFacts {
  std::string format;
  double rate{0.0};              ///< Hz; 0: from the median step of t
  std::string rate_reason;       ///< source of the times
  bool from_first_frame{false};  ///< t has an arbitrary origin: the first t is subtracted
  bool of_markers{false};        ///< the points may be on the skin; unknown names are not an error
  bool is_canonical{false};      ///< names are canonical joints; m, z up
  std::optional<UnitChoice> unit;
  std::optional<UpChoice> up;
  std::vector<StatedSubject> subjects;
  std::optional<SensorError> sensor;  ///< of joints for which the file states no spread
  std::vector<std::string> notes;     ///< further remarks for the user
};

/// Limit of coordinates in units of the file; keeps sums finite.
inline constexpr double kLargestCoordinate = 1e9;

/// Reader of one file. Not shared between threads. Memory grows with the content of a file, never with what
/// it states. Errors are ParseErrors with line and column, or the offset in a binary file.
class PointReader {
 public:
  virtual ~PointReader() = default;
  virtual const PointFacts& facts() const = 0;
  virtual std::span<const std::string> names() const = 0;
  /// Reads the next frame, with increasing t; false after the last one.
  virtual bool next(PointFrame& frame) = 0;
  /// Positions in the file's rest pose; empty if it has none.
  virtual std::vector<Vector3d> rest() const { return {}; }
  /// Positions in the pose in which all PointFrame::turn are the identity; complete after the
  /// first next().
  virtual std::vector<Vector3d> turnRest() const { return rest(); }
  /// For each name the index of its parent, smaller than the own, or -1; empty if the file has no hierarchy.
  virtual std::vector<int> parents() const { return {}; }
  /// Complete after next() has returned false.
  virtual std::vector<FileWarning> warnings() const { return {}; }
};

}  // namespace abstand::tracking
