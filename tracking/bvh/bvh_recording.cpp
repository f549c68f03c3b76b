#include "tracking/bvh/bvh_recording.hpp"

#include "tracking/markers/point_recording.hpp"

namespace abstand::tracking {

bool looksLikeBvh(std::string_view text) {
  TextCursor in(text, "");
  in.consume("\xEF\xBB\xBF");
  return in.consume("hierarchy");
}

BvhPoints::BvhPoints(std::string text, std::string file)
    : reader_(std::move(text), std::move(file)), pose_(reader_.hierarchy()) {
  facts_.format = "bvh";
  facts_.rate = 1.0 / reader_.head().frame_time;
  facts_.rate_reason = "the frame time of the file";
  for (const auto& joint : reader_.hierarchy().joints) names_.push_back(joint.name);
}

std::vector<Vector3d> BvhPoints::rest() const { return BvhPose(reader_.hierarchy()).positions(); }

bool BvhPoints::next(PointFrame& frame) {
  const auto values = reader_.next();
  if (!values) return false;
  pose_.set(*values);
  frame.t = static_cast<double>(reader_.framesRead() - 1) * reader_.head().frame_time;
  frame.p = pose_.positions();
  frame.state.assign(frame.p.size(), humanmodel::JointState::kTracked);
  return true;
}

Recording readBvhRecording(std::string text, const std::string& file, const RecordingOptions& options) {
  BvhPoints points(std::move(text), file);
  return readPoints(points, file, options);
}

}  // namespace abstand::tracking
