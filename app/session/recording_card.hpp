// The card of a recording from its report.
#pragma once

#include "core/view/recording_card.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::session {

view::RecordingCard recordingCard(const std::string& person, const std::filesystem::path& file,
                                  const tracking::Recording& recording);

}  // namespace abstand::session
