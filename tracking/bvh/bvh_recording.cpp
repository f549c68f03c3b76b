#include "tracking/bvh/bvh_recording.hpp"

#include "core/text/message_text.hpp"
#include "tracking/markers/point_recording.hpp"

namespace abstand::tracking {

namespace {

void describeRepairs(const std::vector<LostBone>& repairs, RecordingReport& report) {
  for (const LostBone& bone : repairs) {
    const std::string length = text::rounded(1000.0 * report.scale * bone.length, 1) + " mm";
    report.repairs.push_back(bone.is_hand
                                 ? "the file lacks the wrist bone after " + text::inQuotes(bone.joint) +
                                       ": " + length + ", half a forearm, are inserted"
                                 : "the file lacks a bone after " + text::inQuotes(bone.joint) +
                                       ", which puts neck and arms too low: " + length +
                                       ", the length of the adjacent spine bones, are inserted");
    report.notes.push_back(report.repairs.back() + " (--no-repair leaves the file as it is)");
  }
}

}  // namespace

bool looksLikeBvh(std::string_view text) {
  TextCursor in(text, "");
  in.consume("\xEF\xBB\xBF");
  return in.consume("hierarchy");
}

BvhPoints::BvhPoints(std::string text, std::string file, bool repair)
    : reader_(std::move(text), std::move(file)),
      hierarchy_(reader_.hierarchy()),
      repairs_(repair ? repairLostBones(hierarchy_) : std::vector<LostBone>()),
      pose_(hierarchy_) {
  facts_.format = "bvh";
  facts_.rate = 1.0 / reader_.head().frame_time;
  facts_.rate_reason = "the frame time of the file";
  for (const auto& joint : reader_.hierarchy().joints) names_.push_back(joint.name);
}

std::vector<Vector3d> BvhPoints::rest() const { return BvhPose(hierarchy_).positions(); }

std::vector<int> BvhPoints::parents() const {
  std::vector<int> parents;
  for (const auto& joint : reader_.hierarchy().joints) parents.push_back(joint.parent);
  return parents;
}

bool BvhPoints::next(PointFrame& frame) {
  const auto values = reader_.next();
  if (!values) return false;
  pose_.set(*values);
  frame.t = static_cast<double>(reader_.framesRead() - 1) * reader_.head().frame_time;
  frame.p = pose_.positions();
  frame.turn = pose_.rotations();
  frame.state.assign(frame.p.size(), humanmodel::JointState::kTracked);
  return true;
}

Recording readBvhRecording(std::string text, const std::string& file, const RecordingOptions& options) {
  BvhPoints points(std::move(text), file, options.repair);
  Recording recording = readPoints(points, file, options);
  describeRepairs(points.repairs(), recording.report);
  return recording;
}

}  // namespace abstand::tracking
