// What the review of a recording says, in words.
#pragma once

#include <QString>

#include "ui/model/recording_review.hpp"

namespace abstand::ui {

/// "hand_left"; with its person, "operator/hand_left", where there are several.
QString partText(const margin::ClearanceStore& store, std::size_t part);
QString linkText(const margin::ClearanceStore& store, std::size_t link);

/// What an event is about: "hand_left", "hand_left and 3 more", or a robot that stood.
QString subjectText(const RecordingReview& review, const RecordingEvent& event);
/// The event in a sentence.
QString eventText(const RecordingReview& review, const RecordingEvent& event);
/// What a stop at the beginning of an event would have been: "missed", "false"; empty: needed and in time, or
/// no stop.
QString stopText(const RecordingEvent& event);

/// A part at a moment (s): pair, distance, uncertainty and margin, or why there is none.
QString momentText(const RecordingReview& review, std::size_t part, double t);
/// The part that was nearest at a moment, likewise.
QString nearestMomentText(const RecordingReview& review, double t);

/// "12 stops, 20.5 % of the time; 12 false, 0 missed".
QString outcomeText(const margin::MarginOutcome& outcome);
/// The same: what the present margins would have done.
QString whatIfText(const RecordingReview& review);
/// How the numbers of whatIfText() come about.
QString whatIfTip(const RecordingReview& review);
/// How many pairs are not part of the analysis, because the user does not check them; empty: none.
QString leftOutText(const RecordingReview& review);
/// "Analysis 45 %"; empty once it is done or where there is none.
QString analysisText(const RecordingReview& review);

}  // namespace abstand::ui
