#include "app/session/recording_card.hpp"

namespace abstand::session {

view::RecordingCard recordingCard(const std::string& person, const std::filesystem::path& file,
                                  const tracking::Recording& recording) {
  const tracking::RecordingReport& report = recording.report;
  view::RecordingCard card;
  card.person = person;
  card.file = file.string();
  card.format = report.format;
  card.frames = recording.frames.size();
  card.duration = report.duration;
  card.rate = report.rate;
  card.rate_reason = report.rate_reason;
  card.clock_start = recording.clock_start;
  card.units = {report.units.name, report.units.reason, report.units.guessed};
  card.up = {report.up.axis, report.up.reason, report.up.guessed};
  card.sides = {report.sides.found, report.sides.reason, false};
  card.stature = report.stature;
  card.stature_reason = report.person.stature_reason;
  card.joint_map = {report.joint_map, report.map_use.reason, report.map_use.is_guess};
  card.moved_parts = report.mapped.size();
  card.missing_parts = report.missing_parts;
  card.frames_missing = report.frames_missing;
  card.gaps = report.gaps;
  card.notes = report.notes;
  card.warnings = report.warnings;
  return card;
}

}  // namespace abstand::session
