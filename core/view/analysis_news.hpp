// What the analysis of a whole recording has found since somebody asked last.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/margin/clearance_chunk.hpp"
#include "core/view/moment_poses.hpp"

namespace abstand::view {

struct AnalysisNews {
  enum class State : std::uint8_t {
    kOpening,  ///< files are being read
    kRunning,
    kDone,
    kFailed,  ///< see `problem`; what came before stays right
    kLive,    ///< of moments that a server sends, without end; nothing is known between them
  };
  State state{State::kOpening};
  std::string problem;                                ///< one line
  std::size_t done{0}, frames{0};                     ///< frames that were run; in all, 0: not known yet
  std::shared_ptr<const margin::StoreLayout> layout;  ///< null: not known yet; another one: the
                                                      ///< analysis has begun again, and `chunks` are all
  /// `chunks` are all that there are: what came before is no longer valid.
  bool all{false};
  /// Those that are new, in order of time.
  std::vector<std::shared_ptr<const margin::ClearanceChunk>> chunks;
  /// Some hundred moments, evenly over the recording, for small pictures; those that are new, in order of
  /// time.
  std::vector<MomentPoses> poses;
};

}  // namespace abstand::view
