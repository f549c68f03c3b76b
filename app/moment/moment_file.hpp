// File of recorded moments (`.moments`): the frames one after the other, and their fingerprint.
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "app/moment/moment_packet.hpp"

namespace abstand::moment {

/// Gives the next frame of a moment; empty: there are no more.
using NextFrame = std::function<std::span<const std::byte>()>;

/// Appears whole or not at all. Throws UsageError and WriteError.
void writeMomentFile(const std::filesystem::path& file, const SceneCard& card, const NextFrame& next);

/// True if the file begins as one of moments; false also if it cannot be read.
bool isMomentFile(const std::filesystem::path& file);

/// Called with the frame of each moment and what it holds, in order of time.
using TakeMoment = std::function<void(std::span<const std::byte> frame, const Moment& moment)>;
/// Checks everything, the fingerprint first. Throws ParseError for a damaged file, and for one without a
/// moment. `begin`: called once, before the first moment.
void readMomentFile(const std::filesystem::path& file, const std::function<void(const SceneCard&)>& begin,
                    const TakeMoment& take);

}  // namespace abstand::moment
