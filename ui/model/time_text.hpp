// Times that somebody types.
#pragma once

#include <QString>
#include <optional>

namespace abstand::ui {

class Playback;

/// "12.5", "12.5 s", "1:02.5" (minutes and seconds), "frame 120" and "f120" (counted from 1): s of the
/// recording, not clamped to it. Nothing for anything else.
std::optional<double> timeFromText(const QString& text, const Playback& playback);

}  // namespace abstand::ui
