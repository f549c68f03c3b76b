#include "tracking/bvh_recording.hpp"

#include "core/base/data_folder.hpp"
#include "tracking/bvh_pose.hpp"
#include "tracking/bvh_reader.hpp"
#include "tracking/conversion.hpp"
#include "tracking/joint_map.hpp"
#include "tracking/message_text.hpp"

namespace abstand {
namespace {

JointMatch matchNames(const std::vector<std::string>& names, const RecordingOptions& options,
                      const std::string& file) {
  const auto maps = options.joint_map.empty() ? loadJointMaps(dataFolder() / "joint_maps")
                                              : std::vector<JointMap>{loadJointMap(options.joint_map)};
  JointMatch match = chooseJointMap(maps, names);
  if (match.mapped == 0) {
    std::string some;
    for (std::size_t i = 0; i < names.size() && i < 3; ++i) some += (i > 0 ? ", " : "") + inQuotes(names[i]);
    throw ParseError(
        {file},
        "found joints that no joint map knows (" + some + "...), expected names of a known convention",
        "write a joint map for them as data/joint_maps/README.md says");
  }
  return match;
}

SkeletonFrame pick(const std::vector<Vector3d>& p, const JointMatch& match) {
  SkeletonFrame frame;
  for (std::size_t j = 0; j < kJointCount; ++j)
    if (match.joint[j] >= 0) frame.set(static_cast<Joint>(j), p[static_cast<std::size_t>(match.joint[j])]);
  return frame;
}

}  // namespace

bool looksLikeBvh(std::string_view text) {
  TextCursor in(text, "");
  in.take("\xEF\xBB\xBF");
  return in.take("hierarchy");
}

Recording readBvhRecording(std::string text, const std::string& file, const RecordingOptions& options) {
  BvhReader reader(std::move(text), file);
  RawRecording raw;
  raw.format = "bvh";
  raw.rate = 1.0 / reader.head().frame_time;
  for (const auto& joint : reader.hierarchy().joints) raw.joints.push_back(joint.name);
  raw.match = matchNames(raw.joints, options, file);

  BvhPose pose(reader.hierarchy());
  raw.rest = pick(pose.positions(), raw.match);
  while (const auto values = reader.next()) {
    pose.set(*values);
    raw.frames.push_back(pick(pose.positions(), raw.match));
    raw.frames.back().t = static_cast<double>(raw.frames.size() - 1) * reader.head().frame_time;
  }
  raw.warnings = reader.warnings();
  return convert(std::move(raw), options);
}

}  // namespace abstand
