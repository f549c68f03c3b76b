// What all readers of recordings have in common: named points, frame by frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/body_size.hpp"
#include "tracking/recording/file_warning.hpp"
#include "tracking/recording/up_axis.hpp"

namespace abstand::tracking {

/// One moment of a file, in the file's axes and units. A point that is missing holds NaN.
struct PointFrame {
  double t{0.0};  ///< s
  std::vector<Vector3d> p;
  std::vector<humanmodel::JointState> state;
  std::vector<double> spread;  ///< standard deviation along the worst axis; 0, or nothing: not known

  /// All `points` missing, at t = 0.
  void clear(std::size_t points) {
    t = 0.0;
    p.assign(points, Vector3d::Constant(kNaN));
    state.assign(points, humanmodel::JointState::kMissing);
    spread.assign(points, 0.0);
  }
  double spreadOf(std::size_t point) const { return point < spread.size() ? spread[point] : 0.0; }
  void set(std::size_t point, const Vector3d& p_FP,
           humanmodel::JointState s = humanmodel::JointState::kTracked) {
    p[point] = p_FP;
    state[point] = s;
  }
};

/// What a file, or its format, says of itself.
struct PointFacts {
  std::string format;
  double rate{0.0};              ///< Hz; 0: the median step of t says it
  std::string rate_reason;       ///< why these times
  bool from_first_frame{false};  ///< t counts from something else than the start: the first t is taken off
  bool of_markers{false};        ///< the points may lie on the skin; names that no map knows are no error
  bool is_canonical{false};      ///< names are canonical joints, m, z up
  std::optional<UnitChoice> unit;
  std::optional<UpChoice> up;
  std::vector<std::string> notes;  ///< what else a user may want to know
};

/// Values beyond this (units of the file) are refused: no body is measured so, and sums of them stay finite.
inline constexpr double kLargestCoordinate = 1e9;

/// A file, opened. Not to be shared between threads. Memory grows with what a file holds, never with what it
/// claims. Errors are ParseError, with line and column, or the offset of a binary file.
class PointReader {
 public:
  virtual ~PointReader() = default;
  virtual const PointFacts& facts() const = 0;
  virtual std::span<const std::string> names() const = 0;
  /// The next frame into `frame`, t rising; false after the last one.
  virtual bool next(PointFrame& frame) = 0;
  /// Places in a pose that the file calls its rest pose; empty where it has none.
  virtual std::vector<Vector3d> rest() const { return {}; }
  /// Complete after next() gave false.
  virtual std::vector<FileWarning> warnings() const { return {}; }
};

}  // namespace abstand::tracking
