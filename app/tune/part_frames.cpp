#include "app/tune/part_frames.hpp"

#include <algorithm>

#include "app/tune/result_file.hpp"
#include "core/margin/safe_margin.hpp"

namespace abstand::tune {

PartFrames::PartFrames(const TunedRecording& recording) {
  const std::vector<PartClearance>& parts = recording.pass.parts;
  if (recording.file.empty() || parts.empty() || parts.front().track.frames() == recording.frames)
    parts_ = {std::shared_ptr<void>(), &parts};
  else
    parts_ = std::make_shared<const std::vector<PartClearance>>(readFrames(recording));
}

void HeldFrames::take(TunedRecording& recording) {
  held_ += recording.frames * recording.pass.parts.size();
  if (held_ <= max_) return;
  for (PartClearance& part : recording.pass.parts) dropFrames(part);
}

std::size_t firstJudgedFrame(const PartFrames& frames, const margin::MarginOptions& options) {
  std::size_t first = 0;
  for (const PartClearance& p : frames.parts())
    first = std::max(first, margin::firstJudgedFrame(p.track, options));
  return first;
}

}  // namespace abstand::tune
