// Reads the motion of an Acclaim file (AMC), frame by frame.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tracking/acclaim/asf_skeleton.hpp"
#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True if the text begins like an AMC: `#!OML:ASF`, or a line `:FULLY-SPECIFIED` before the first frame.
bool looksLikeAmc(std::string_view text);

/// Values of all channels of a skeleton, frame by frame: a line with the frame number, then one line for each
/// bone. An incomplete last frame is dropped with a warning; any other frame without a bone is a ParseError.
class AmcReader {
 public:
  /// `text` and `skeleton` must outlive this object.
  AmcReader(std::string_view text, std::string file, const AsfSkeleton& skeleton);

  /// Reads a frame: angles in rad, lengths in units of the file; the channels of all bones in the order of
  /// the skeleton. False after the last complete frame.
  bool next(std::vector<double>& values);
  const std::vector<FileWarning>& warnings() const { return warnings_; }

 private:
  bool nextWords();
  bool readBone(std::vector<double>& values);

  std::string file_;
  Lines lines_;
  const AsfSkeleton& skeleton_;
  std::unordered_map<std::string, std::size_t> index_;
  std::vector<std::size_t> first_;  ///< index of each bone's first channel in a frame
  std::size_t channels_{0}, moving_{0}, frames_{0};
  std::vector<std::size_t> frame_of_bone_;  ///< last frame with a line of the bone, from 1
  std::vector<std::string_view> words_;
  bool has_words_{false}, in_degrees_{true}, at_end_{false};
  std::vector<FileWarning> warnings_;
};

}  // namespace abstand::tracking
