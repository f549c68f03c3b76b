// Recordings beside moving robots, over which margins are judged.
#pragma once

#include <functional>

#include "app/tune/recording_tune.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::testing {

struct MarginClip {
  std::string name;
  tune::BrakingOptions braking;
  double limit{0.0}, restart_time{0.0};  ///< m, s
  std::optional<double> start, end;      ///< s, of the recording
  std::function<std::unique_ptr<session::Session>(const ScratchFolder&)> open;

  tune::TuneOptions tune() const;
  run::RunOptions run() const;
};

/// Twenty clips need no file from elsewhere. People who walk at a ball on a rail:
std::vector<MarginClip> walkingClips();
/// who reach into the path of an arm of two joints:
std::vector<MarginClip> reachingClips();
/// and beside the shipped robots.
std::vector<MarginClip> robotClips();

/// Real captures beside a ball that goes to and fro through them; those whose files are absent are left out.
std::vector<MarginClip> capturedClips();

}  // namespace abstand::testing
