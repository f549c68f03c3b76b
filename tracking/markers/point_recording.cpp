#include "tracking/markers/point_recording.hpp"

#include <algorithm>

#include "core/base/block_list.hpp"
#include "core/base/clock_range.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tracking/joint_guess/joint_choice.hpp"
#include "tracking/markers/marker_recording.hpp"
#include "tracking/markers/subject_choice.hpp"
#include "tracking/recording/conversion.hpp"

namespace abstand::tracking {
namespace {

JointMatch canonicalNames(std::span<const std::string> names) {
  JointMatch match;
  match.joint.fill(-1);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto j = humanmodel::parseJoint(names[i]))
      match.joint[static_cast<std::size_t>(*j)] = static_cast<int>(i);
  return match;
}

/// Frames from which joints may be guessed; more of them if the hierarchy must be guessed as well.
std::vector<PointFrame> readFirst(PointReader& reader) {
  const std::size_t most = reader.parents().empty() ? 600 : 64;
  std::vector<PointFrame> first;
  PointFrame frame;
  while (first.size() < most && reader.next(frame)) first.push_back(frame);
  return first;
}

/// The first names of a file, for messages.
std::string someOf(const std::vector<std::string>& names) {
  std::string some;
  for (std::size_t i = 0; i < names.size() && i < 3; ++i)
    some += (i > 0 ? ", " : "") + text::inQuotes(names[i]);
  return some + (names.size() > 3 ? ", ..." : "");
}

humanmodel::SkeletonFrame pickRest(const std::vector<Vector3d>& p, const JointMatch& match) {
  if (p.empty()) return {};
  PointFrame rest;
  rest.p = p;
  rest.state.assign(p.size(), humanmodel::JointState::kTracked);
  return pickJoints(rest, match);
}

/// Marks inferred joints without a spread; their spread is set in metres later.
void markGuesses(std::vector<humanmodel::SkeletonFrame>& frames) {
  for (auto& f : frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (f.state[j] == humanmodel::JointState::kInferred && f.spread[j] == 0.0) f.spread[j] = kInfinity;
}

/// Sets the spread of the marked joints, after conversion to metres.
void spreadGuesses(std::vector<humanmodel::SkeletonFrame>& frames) {
  for (auto& f : frames)
    for (double& spread : f.spread)
      if (spread == kInfinity) spread = humanmodel::kGuessedSpread;
}

/// From the median step of t, which is robust to gaps; 0 Hz for a single frame.
double rateOf(const std::vector<humanmodel::SkeletonFrame>& frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  if (steps.empty()) return 0.0;
  const double median = nearestQuantile(std::move(steps), 0.5);
  return median > 0.0 ? 1.0 / median : 0.0;
}

/// Warns of points that may be markers, and of the consequences for the person.
void warnOfMarkers(bool by_marker_map, RecordingReport& report) {
  if (report.mapped.empty()) {
    report.joint_map.clear();
    report.warnings.push_back("the file holds " + std::to_string(report.joints.size()) +
                              " markers or points, of which no joint map yields a body part, so nothing can "
                              "be moved after it; a joint map says which markers make a joint "
                              "(data/joint_maps/README.md)");
  } else if (by_marker_map) {
    report.warnings.push_back(
        "joints are taken at the midpoints of skin markers, some centimetres from the "
        "joint centres: no body model is fitted");
  }
}

/// Adds remarks about solved markers for the user.
void describeSolved(RecordingReport& report) {
  const MarkerReport& m = report.markers;
  report.joint_map.clear();
  report.map_use.reason = "markers were solved to joint centres";
  report.map_use.names = {};
  if (!(report.stature > 0.0)) {
    report.stature = m.stature;
    report.person.stature_reason = "of the body under the markers";
  }
  if (m.unseen > 0)
    report.notes.push_back("in " + std::to_string(m.unseen) + " frames no marker of the set is visible");
  if (m.lost > 0)
    report.warnings.push_back("the markers show no body in " + std::to_string(m.lost) + " frames");
  for (const auto& swap : m.swaps)
    report.warnings.push_back("the labels '" + swap.a + "' and '" + swap.b + "' seem swapped in " +
                              std::to_string(swap.frames) + " frames: not used there");
  std::string ignored;
  for (const auto& [label, why] : m.ignored)
    ignored += (ignored.empty() ? "" : "; ") + ("'" + label + "' " + why);
  if (!ignored.empty()) report.warnings.push_back("markers that were not used: " + ignored);
}

/// Says which joints were used and whether they are guesses.
void describeChoice(const JointChoice& choice, RecordingReport& report) {
  report.map_use.reason = choice.reason;
  if (!choice.filled.empty()) report.map_use.reason += "; guessed: " + choice.filled;
  report.map_use.is_guess = choice.is_guess || !choice.filled.empty();
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const int i = choice.match.joint[j];
    if (i < 0) continue;
    auto& names = report.map_use.names[j];
    if (static_cast<std::size_t>(i) < report.joints.size())
      names.push_back(report.joints[static_cast<std::size_t>(i)]);
    else
      for (const int point : choice.match.means[static_cast<std::size_t>(i) - report.joints.size()])
        names.push_back(report.joints[static_cast<std::size_t>(point)]);
  }
  report.map_use.of_markers = choice.match.of_markers;
  report.map_use.head_is_middle = choice.match.head == HeadPoint::kMiddle;
  report.notes.insert(report.notes.end(), choice.notes.begin(), choice.notes.end());
  if (!choice.misses.empty()) report.warnings.push_back(choice.misses);
  const std::string advice =
      "; check the parts, and give a joint map if one is wrong (--write-map writes the one that was used)";
  if (choice.is_guess)
    report.warnings.push_back("the joint assignment is guessed: " + report.map_use.reason + advice);
  else if (!choice.filled.empty())
    report.warnings.push_back("joints that the map lacks are guessed: " + choice.filled + advice);
}

/// Rate, and times from the first frame on if the file's have an arbitrary origin.
void setTimes(const PointFacts& facts, RawRecording& raw) {
  raw.rate = facts.rate > 0.0 ? facts.rate : rateOf(raw.frames);
  raw.rate_reason = facts.rate_reason;
  if (!facts.from_first_frame || raw.frames.front().t == 0.0) return;
  const double start = raw.frames.front().t;
  for (auto& f : raw.frames) f.t -= start;
  raw.rate_reason += "; the file starts at " + formatDouble(start) + " s, here at 0";
  if (start >= kEarliestClock) raw.clock_start = start;
}

/// What the file says of the subject whose points are used, and of itself.
void takeStated(const PointReader& reader, const SubjectChoice& who, RawRecording& raw) {
  StatedSubject stated = statedOf(who, reader.facts().subjects);
  raw.subject = std::move(stated.facts);
  raw.warnings = reader.warnings();
  if (!who.warning.empty()) raw.warnings.push_back({0, who.warning});
  for (std::string& warning : stated.warnings) raw.warnings.push_back({0, std::move(warning)});
  raw.notes = std::move(stated.notes);
  const std::vector<std::string>& notes = reader.facts().notes;
  raw.notes.insert(raw.notes.end(), notes.begin(), notes.end());
}

}  // namespace

Recording readPoints(PointReader& reader, const std::string& file, const RecordingOptions& options) {
  const PointFacts& facts = reader.facts();
  RawRecording raw;
  raw.format = facts.format;
  raw.joints.assign(reader.names().begin(), reader.names().end());
  raw.is_canonical = facts.is_canonical;
  const std::vector<Vector3d> rest = reader.rest();
  const std::vector<PointFrame> first = readFirst(reader);
  SubjectChoice who{{}, raw.joints, {}};
  if (facts.of_markers) who = chooseSubject(raw.joints, options);
  JointChoice choice;
  if (facts.is_canonical)
    choice.match = canonicalNames(raw.joints);
  else
    choice = chooseJoints({who.names, reader.parents(), rest, first}, options, !facts.of_markers);
  raw.match = choice.match;
  raw.rest = pickRest(rest, raw.match);
  raw.turns.rest = pickRest(reader.turnRest(), raw.match);
  raw.turns.choosePoints(raw.match, reader.parents());
  raw.unit = facts.unit;
  raw.up = facts.up;
  raw.sensor = facts.sensor;

  std::optional<MarkerTrack> markers;
  // A map that the user gives says where the joints are, unless it means another file.
  const bool is_by_map = !options.joint_map.empty() && raw.match.mapped > 0;
  const bool may_be_markers = (facts.of_markers || raw.match.of_markers) && !is_by_map;
  if (options.marker_set != "none" && (may_be_markers || options.marker_set != "auto"))
    markers.emplace(who.names, options, file);
  // C3D and TRC may contain joint centres too: then a joint map fits better than any marker set.
  if (markers && options.marker_set == "auto" && !raw.match.of_markers &&
      raw.match.mapped >= markers->found())
    markers.reset();
  BlockList<humanmodel::SkeletonFrame> frames;
  const auto add = [&](const PointFrame& frame) {
    frames.add(pickJoints(frame, raw.match));
    if (!frame.turn.empty()) raw.turns.add(frame.turn);
    if (markers && markers->hasSet()) markers->add(frame);
  };
  for (const PointFrame& frame : first) add(frame);
  for (PointFrame frame; reader.next(frame);) add(frame);
  raw.frames = frames.take();
  if (raw.frames.empty()) throw ParseError({file}, "found no frame, expected at least one");
  setTimes(facts, raw);
  takeStated(reader, who, raw);
  // In a file of canonical joints inferred ones may have been derived earlier: they are not a tracker's
  // guesses.
  if (!facts.is_canonical && !facts.sensor) markGuesses(raw.frames);
  MarkerReport solved;
  if (markers && markers->hasSet()) solved = markers->solveInto(raw, options);
  if (markers && solved.reason.empty()) solved.reason = markers->reason();
  const bool by_marker_map = raw.match.of_markers;
  Recording recording = convert(std::move(raw), options);
  // Solving markers determines both; the unit may still be a guess.
  recording.report.units.guessed = !facts.unit && text::lowerCase(options.units) == "auto";
  recording.report.up.guessed = !facts.up && text::lowerCase(options.up) == "auto";
  spreadGuesses(recording.frames);
  describeChoice(choice, recording.report);
  recording.report.markers = std::move(solved);
  if (!options.joint_map.empty() && (facts.is_canonical || !recording.report.markers.set.empty()))
    recording.report.warnings.push_back(
        facts.is_canonical ? "the joint map has no effect: the file has Abstand's names of the joints"
        : is_by_map        ? "the joint map has no effect: the markers are solved by the given marker set"
                           : "the joint map has no effect: it matches no point, so that markers are solved");
  if (!recording.report.markers.set.empty())
    describeSolved(recording.report);
  else if (facts.of_markers || by_marker_map)
    warnOfMarkers(by_marker_map, recording.report);
  else if (recording.report.joint_map.empty() && !facts.is_canonical)
    recording.report.warnings.push_back("no joint map matches the joints of this file (" +
                                        someOf(recording.report.joints) + ")");
  return recording;
}

}  // namespace abstand::tracking
