// What the analysis of a whole recording has found since somebody asked last.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/margin/clearance_chunk.hpp"

namespace abstand::view {

struct AnalysisNews {
  enum class State : std::uint8_t {
    kOpening,  ///< files are being read
    kRunning,
    kDone,
    kFailed,  ///< see `problem`; what came before stays right
  };
  State state{State::kOpening};
  std::string problem;                                ///< one line
  std::size_t done{0}, frames{0};                     ///< frames that were run; in all, 0: not known yet
  std::shared_ptr<const margin::StoreLayout> layout;  ///< null: not known yet; never changes again
  /// Those that are new, in order of time.
  std::vector<std::shared_ptr<const margin::ClearanceChunk>> chunks;
};

}  // namespace abstand::view
