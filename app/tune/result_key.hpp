// What a result of a recording depends on.
#pragma once

#include <filesystem>
#include <string>

#include "app/tune/recording_tune.hpp"
#include "core/base/content_hash.hpp"

namespace abstand::tune {

/// Of the layout of result files.
inline constexpr long long kResultFormat = 4;

/// Which sources made a result: those of another version may say something else.
std::string resultVersion();

/// Program, scene, recording, options and whatever else `settings` says. Results with one key are the same.
/// Throws ParseError for a file that cannot be read.
ContentKey resultKey(const scene_file::SceneDescription& scene, const std::filesystem::path& recording,
                     const TuneOptions& options, const std::string& settings);

}  // namespace abstand::tune
