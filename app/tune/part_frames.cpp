#include "app/tune/part_frames.hpp"

#include <algorithm>

#include "core/margin/safe_margin.hpp"

namespace abstand::tune {
namespace {

bool isInMemory(const TunedRecording& recording) {
  const std::vector<PartClearance>& parts = recording.pass.parts;
  return recording.file.empty() || parts.empty() || parts.front().track.frames() == recording.frames;
}

}  // namespace

PartFrames::PartFrames(const TunedRecording& recording) {
  if (isInMemory(recording)) {
    parts_ = {std::shared_ptr<void>(), &recording.pass.parts};
    return;
  }
  auto parts = std::make_shared<std::vector<PartClearance>>(recording.pass.parts);
  FrameReader(recording).read(*parts);
  parts_ = std::move(parts);
}

PartByPart::PartByPart(const TunedRecording& recording) : recording_{recording} {
  if (!isInMemory(recording)) file_.emplace(recording);
}

const PartClearance& PartByPart::part(std::size_t p) {
  if (!file_) return recording_.pass.parts.at(p);
  read_ = recording_.pass.parts.at(p);
  file_->read(p, read_);
  return read_;
}

void WholeBody::take(const margin::ClearanceTrack& part, const margin::MarginOptions& options) {
  first = std::max(first, margin::firstJudgedFrame(part, options));
  if (track.frames() == 0)
    track = part;
  else
    margin::takeLeast(part, track);
}

WholeBody wholeBody(const TunedRecording& recording, const margin::MarginOptions& options) {
  WholeBody body;
  PartByPart parts(recording);
  for (std::size_t p = 0; p < parts.size(); ++p) body.take(parts.part(p).track, options);
  return body;
}

void HeldFrames::take(TunedRecording& recording) {
  held_ += recording.frames * recording.pass.parts.size();
  if (held_ <= max_) return;
  for (PartClearance& part : recording.pass.parts) dropFrames(part);
}

}  // namespace abstand::tune
