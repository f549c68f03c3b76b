// The formats of recordings, in the order in which they are tried.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

struct RecordingFormat {
  const char* name;  ///< what the user may ask for
  const char* sign;  ///< how a file shows it, for messages
  bool (*looksLike)(std::string_view bytes);
  /// Reads a whole file. Throws ParseError, UsageError.
  Recording (*read)(std::string bytes, const std::filesystem::path& file, const RecordingOptions& options);
};

/// No two of them know the same file.
std::span<const RecordingFormat> allRecordingFormats();

}  // namespace abstand::tracking
