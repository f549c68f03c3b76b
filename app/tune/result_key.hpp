// Hash key of a result: everything it depends on.
#pragma once

#include <filesystem>
#include <string>

#include "app/tune/recording_tune.hpp"
#include "core/base/content_hash.hpp"

namespace abstand::tune {

/// Version of the layout of result files.
inline constexpr long long kResultFormat = 9;

/// Version of the sources that made a result; other versions may give other results.
std::string resultVersion();

/// Hash of program, scene, recording, options and `settings`. Equal keys mean equal results. Throws
/// ParseError for an unreadable file.
ContentKey resultKey(const scene_file::SceneDescription& scene, const std::filesystem::path& recording,
                     const TuneOptions& options, const std::string& settings);

}  // namespace abstand::tune
