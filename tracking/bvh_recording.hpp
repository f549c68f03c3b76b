// A BVH file as a recording.
#pragma once

#include <string>
#include <string_view>

#include "tracking/recording.hpp"

namespace abstand {

/// True where the text begins like a BVH file.
bool looksLikeBvh(std::string_view text);

/// Reads a whole BVH text. `file` names it in messages. Throws ParseError for the text and the joint maps,
/// UsageError for the options.
Recording readBvhRecording(std::string text, const std::string& file, const RecordingOptions& options);

}  // namespace abstand
