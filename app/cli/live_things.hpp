// The scene's robots and objects before a live camera.
#pragma once

#include "app/cli/command_line.hpp"
#include "app/live_depth/served_things.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::cli {

struct LiveThingsArguments {
  std::filesystem::path scene;  ///< empty: none
  robot_file::PackagePaths packages;
  std::string server;  ///< HOST:PORT of `abstand serve`; empty: none
};

/// Removes them from the images that show them, and says where that changes. Without a scene it does nothing.
class LiveThings {
 public:
  /// Throws ParseError and UsageError.
  LiveThings(const CommandLine& line, const LiveThingsArguments& args);

  /// Before the images that came at `came` are tracked.
  void update(std::chrono::steady_clock::time_point came);
  /// For LiveTrackerOptions.
  tracking::KnownThings known();
  tracking::KnownThings atRest();
  /// What changed since the last call, one sentence each. `names`: of the cameras.
  std::vector<std::string> news(std::span<const tracking::ShownThings> shown,
                                std::span<const std::string> names);
  /// All of news() so far.
  const std::vector<std::string>& reported() const { return reported_; }
  /// Of one camera; null without a scene.
  nlohmann::ordered_json json(const tracking::ShownThings& shown) const;
  /// One line; empty without a scene.
  std::string text(std::span<const tracking::ShownThings> shown) const;

 private:
  std::optional<live_depth::ServedThings> things_;
  std::vector<std::uint8_t> said_shown_;  ///< of each camera
  std::vector<double> said_bands_;        ///< m, of each camera
  std::vector<std::string> reported_;
};

}  // namespace abstand::cli
