// Tracks people in front of live cameras.
#pragma once

#include <optional>

#include "app/cli/command_line.hpp"
#include "app/cli/live_cameras.hpp"
#include "app/cli/live_things.hpp"
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::cli {

struct LiveTrackArguments {
  std::vector<LiveSource> cameras;  ///< 1 to BodyObservation::kMaxViews
  LiveThingsArguments things;
  tracking::TrackedPerson::Options person;
  std::function<void(const tracking::ClipMoment&)> watch;  ///< may be empty
  std::optional<double> seconds;                           ///< from the first image; nullopt: until Ctrl-C
  std::filesystem::path out;                               ///< CSV of one person; empty: none
  std::size_t chosen{0};                                   ///< person that is written, 0: the one found in
                                                           ///< most images
  std::string send;                                        ///< HOST:PORT or "-"; empty: nowhere
  std::vector<std::string> names;                          ///< of the people that are sent
};

/// Returns the exit code. Throws ParseError and UsageError.
int runLiveTrack(const CommandLine& line, const LiveTrackArguments& args);

}  // namespace abstand::cli
