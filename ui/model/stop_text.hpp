// What a robot's stop machine and the limits of its joints say, in the user's words and units.
#pragma once

#include <QString>

#include "core/view/snapshot.hpp"
#include "ui/model/stop_spans.hpp"

namespace abstand::ui {

QString reasonText(safety::StopReason reason);
/// When a stop has this reason, in a sentence.
QString reasonMeaning(safety::StopReason reason);
/// What the robot does: "slows down".
QString responseText(safety::StopResponse response);
QString stateText(safety::StopState state);
/// Why a reset was refused.
QString refusalText(safety::ResetRefusal refusal);
/// It stands or is being brought to stand: shown in the alarm colour, with a mark.
bool isStop(safety::StopState state);
/// "distance 39.8 mm, limit 40.0 mm, left_arm/link5 – operator/hand_left". `robot`: index into
/// SceneOutline::reacting.
QString causeText(const safety::StopCause& cause, const view::SceneOutline& outline, std::size_t robot);
/// Why a robot does not run as planned: "protective stop: left_arm/link5 – operator/hand_left at 39.8 mm";
/// empty while it runs. `robot`: as above, of the snapshot.
QString stopText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, std::size_t robot);
/// "left_arm stood from 6.574 s to 7.102 s when this was played, protective stop: distance …"
QString spanText(const StopSpan& span, const view::SceneOutline& outline);
/// One line of the log: "6.574 s  left_arm: running → protective stop: distance …"
QString entryText(const safety::StopEntry& entry, const view::SceneOutline& outline, std::size_t robot);
/// "6.574 s  left_arm: joint A2 beyond its velocity limit: 2.10 rad/s, limit 1.92 rad/s"
QString breachText(const mechanism::LimitBreach& breach, const view::SceneOutline& outline,
                   std::size_t robot);
/// "left_arm: protective stop" of the robot that is worst off, the first of equal ones; empty without robots.
QString worstText(const view::SceneSnapshot& snapshot, const view::SceneOutline& outline, bool* alarm);

}  // namespace abstand::ui
