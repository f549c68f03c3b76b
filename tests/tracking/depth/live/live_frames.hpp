// What tests of live cameras share.
#pragma once

#include <dlfcn.h>

#include <vector>

#include "tracking/depth/live/live_depth.hpp"

namespace abstand::testing {

inline constexpr double kPatience = 30.0;  // s, for an image; far more than any busy machine needs

/// False where there is none. The library of a test's program stands for the system's: the loader knows it by
/// its name from then on.
inline bool loadDriver(const char* library) {
  return *library != '\0' && ::dlopen(library, RTLD_NOW) != nullptr;
}

inline std::vector<tracking::LiveFrame> watch(tracking::LiveDepth& camera) {
  std::vector<tracking::LiveFrame> frames;
  tracking::LiveFrame frame;
  while (camera.next(frame, kPatience) == tracking::LiveDepth::Outcome::kFrame) frames.push_back(frame);
  return frames;
}

}  // namespace abstand::testing
