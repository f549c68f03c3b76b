#include "tracking/bvh/bvh_recording.hpp"

#include "core/text/message_text.hpp"
#include "tracking/markers/point_recording.hpp"

namespace abstand::tracking {

namespace {

/// Lost bones of the hierarchy; with `repair` they are put in.
std::vector<LostBone> findLostBones(BvhHierarchy& hierarchy, bool repair) {
  if (repair) return repairLostBones(hierarchy);
  BvhHierarchy as_in_file = hierarchy;
  return repairLostBones(as_in_file);
}

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

/// Warns of bones that are missing and stay so.
void warnOfLostBones(const std::vector<LostBone>& lost, RecordingReport& report) {
  for (const LostBone& bone : lost) {
    const std::string length = text::rounded(1000.0 * report.scale * bone.length, 0) + " mm";
    report.warnings.push_back("not repaired: the file lacks " +
                              (bone.is_hand ? "the wrist bone after " + text::inQuotes(bone.joint) +
                                                  ": this hand is some " + length + " too near to the elbow"
                                            : "a bone after " + text::inQuotes(bone.joint) +
                                                  ": neck, head and arms are some " + length + " too low"));
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
      lost_(findLostBones(hierarchy_, repair)),
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
  if (options.repair)
    describeRepairs(points.lost(), recording.report);
  else
    warnOfLostBones(points.lost(), recording.report);
  return recording;
}

}  // namespace abstand::tracking
