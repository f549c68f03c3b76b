// Formats of recordings, in the order in which they are tried.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

struct RecordingFormat {
  const char* name;  ///< name in the user's options
  const char* sign;  ///< how files are recognised, for messages
  bool (*looksLike)(std::string_view bytes);
  /// Reads a whole file. Throws ParseError, UsageError.
  Recording (*read)(std::string bytes, const std::filesystem::path& file, const RecordingOptions& options);
};

/// All formats; a file matches at most one.
std::span<const RecordingFormat> allRecordingFormats();

}  // namespace abstand::tracking
