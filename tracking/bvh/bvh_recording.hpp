// A BVH file as named points.
#pragma once

#include <string>
#include <string_view>

#include "tracking/bvh/bvh_pose.hpp"
#include "tracking/bvh/bvh_reader.hpp"
#include "tracking/bvh/lost_bones.hpp"
#include "tracking/recording/point_reader.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// True if the text begins like a BVH file.
bool looksLikeBvh(std::string_view text);

/// Positions of joints and end sites; frame times are t = i * frame time.
class BvhPoints : public PointReader {
 public:
  /// With `repair`, lost bones are put in (repairLostBones).
  BvhPoints(std::string text, std::string file, bool repair = false);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  std::vector<Vector3d> rest() const override;
  std::vector<int> parents() const override;
  bool next(PointFrame& frame) override;
  /// Bones that the file has lost, whether they were put in or not.
  const std::vector<LostBone>& lost() const { return lost_; }
  std::vector<FileWarning> warnings() const override { return reader_.warnings(); }

 private:
  BvhReader reader_;
  BvhHierarchy hierarchy_;  ///< that of the reader, repaired if wanted
  std::vector<LostBone> lost_;
  BvhPose pose_;
  PointFacts facts_;
  std::vector<std::string> names_;
};

/// Reads a whole BVH text. `file` is its name in messages. Throws ParseError for the text and the joint maps,
/// UsageError for the options.
Recording readBvhRecording(std::string text, const std::string& file, const RecordingOptions& options);

}  // namespace abstand::tracking
