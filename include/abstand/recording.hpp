// Recorded motion of a person.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "abstand/skeleton.hpp"

namespace abstand {

/// Properties of a file that override the automatic detection.
struct RecordingOptions {
  std::string format{"auto"};  ///< "auto", "bvh", "c3d", ...: docs/recordings.md
  std::string units{"auto"};   ///< "auto", "m", "cm", "mm", "inches", or metres per unit
  std::string up{"auto"};      ///< "auto", "x", "y", "z", "-x", "-y", "-z"
  double rate{0.0};            ///< Hz; 0: as in the file
};

/// Motion of a person, from BVH, Acclaim, C3D, TRC, Kinect, CSV or JSON lines. Canonical joints, m, z up.
/// Constant, shared by copies; any thread.
class Recording {
 public:
  /// Detects the format by content. Throws std::runtime_error, one line `FILE:LINE: error: WHAT`.
  static Recording open(const std::filesystem::path& file, const RecordingOptions& options = {});

  const std::vector<Skeleton>& frames() const;  ///< at least one; t increases
  /// The frame at or just before t (s), clamped at both ends.
  const Skeleton& at(double t) const;
  double duration() const;                           ///< s, from the first frame to the last
  double stature() const;                            ///< m, estimated from the bone lengths; 0: unknown
  const std::string& format() const;                 ///< detected format
  const std::string& units() const;                  ///< detected units, "cm"
  const std::string& up() const;                     ///< axis of the file that points up, "y"
  const std::vector<std::string>& warnings() const;  ///< one sentence each

 private:
  struct Impl;
  explicit Recording(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace abstand
