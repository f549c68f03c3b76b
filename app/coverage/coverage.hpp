// What a depth camera would not see of the people of a scene, over a recording.
#pragma once

#include <functional>
#include <optional>

#include "app/coverage/cause.hpp"
#include "app/coverage/sensor.hpp"
#include "app/session/session.hpp"

namespace abstand::coverage {

struct CoverageOptions {
  Sensor sensor;
  double rate{10.0};                 ///< Hz, of the sampled times
  std::optional<double> start, end;  ///< s
  int columns{320};                  ///< of the images in which occluders are drawn, at most
  /// Sampled times done, and all; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
  std::function<bool()> interrupted;
};

/// A body part of a person.
struct PartCoverage {
  std::string name;            ///< as in the scene: PERSON/PART
  std::vector<Shares> shares;  ///< of its camera-facing surface, for each of Coverage::times
};

struct Coverage {
  int columns{0}, rows{0};    ///< of the images in which occluders were drawn
  std::vector<double> times;  ///< s
  std::vector<PartCoverage> parts;
  bool interrupted{false};  ///< times and parts are those until then
};

/// Robots and objects follow their recorded motion, without reactions. A body part whose pose the recording
/// does not show at a time is kUnknown. Throws UsageError for a scene without people, a range without a time,
/// and options out of range.
Coverage evaluateCoverage(session::Session& session, const CoverageOptions& options);

}  // namespace abstand::coverage
