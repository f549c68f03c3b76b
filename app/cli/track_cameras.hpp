// Depth recordings of several cameras for `abstand track`.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "tracking/tracker/known_objects.hpp"

namespace abstand::cli {

/// Opened recordings, the clocks of the further ones against that of the first.
class TrackCameras {
 public:
  struct Arguments {
    std::vector<std::filesystem::path> depth;
    std::vector<std::filesystem::path> camera;  ///< none, or one for each recording
    std::vector<std::string> clock;             ///< s for each further recording; empty or "auto": estimated
    double rate{0.0};                           ///< Hz; 0: as in the files
    bool mirror{false};
  };
  /// Throws UsageError and ParseError.
  explicit TrackCameras(const Arguments& arguments);

  /// Estimates the clocks that were not given. Tracks the first seconds of each recording.
  void compareClocks(const tracking::ClipTrackerOptions& options);

  /// Compares the robots and objects of a scene with the images of each camera. Returns the images of all
  /// with the band around them that their largest displacement needs. Throws ParseError.
  tracking::KnownThings compareThings(const tracking::KnownObjects& objects);

  std::span<const tracking::ClipCamera> cameras() const { return cameras_; }
  /// s of processor time of compareClocks().
  double clockSeconds() const { return clock_seconds_; }
  /// Facts of the first recording.
  const tracking::DepthFacts& facts() const { return streams_.front()->facts(); }
  /// An array with an object for each recording.
  nlohmann::ordered_json json(const tracking::ClipTrack& track) const;
  /// A line for each of several recordings; empty for one.
  std::string text(const tracking::ClipTrack& track) const;
  /// Reservations about clocks, displaced things and absent images, one sentence each.
  std::vector<std::string> warnings(const tracking::ClipTrack& track) const;

 private:
  std::vector<std::filesystem::path> names_;
  std::vector<std::unique_ptr<tracking::DepthStream>> streams_;
  std::vector<tracking::ClipCamera> cameras_;
  std::vector<std::string> clock_reasons_;  ///< for each recording
  std::vector<bool> clock_known_;
  double clock_seconds_{0.0};
  std::vector<tracking::ObjectsInImages> things_;  ///< in each recording; empty: none are known
};

}  // namespace abstand::cli
