// Following people in front of a camera that looks now.
#pragma once

#include <optional>

#include "app/cli/command_line.hpp"
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::cli {

struct LiveTrackArguments {
  std::string camera;  ///< as kKinectSource
  tracking::DepthStreamOptions stream;
  tracking::TrackedPerson::Options person;
  std::function<void(const tracking::ClipMoment&)> watch;  ///< may be empty
  std::optional<double> seconds;                           ///< since the first image; none: Ctrl-C ends it
  std::filesystem::path out;                               ///< CSV of one person; empty: none
  std::size_t chosen{0};                                   ///< who is written, 0: found in most images
  std::string send;                                        ///< HOST:PORT or "-"; empty: nowhere
  std::vector<std::string> names;                          ///< of people who are sent
};

/// The exit code. Throws ParseError and UsageError.
int runLiveTrack(const CommandLine& line, const LiveTrackArguments& args);

}  // namespace abstand::cli
