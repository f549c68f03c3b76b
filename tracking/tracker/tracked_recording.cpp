// Selection of the reader, and conversion of a track to a recording.
#include "tracking/tracker/tracked_recording.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"
#include "tracking/depth/formats/depth_sources.hpp"
#include "tracking/recording/part_joints.hpp"
#include "tracking/registry/open_recording.hpp"
#include "tracking/tracker/doubtful_cameras.hpp"
#include "tracking/tracker/fitted_clip.hpp"

namespace abstand::tracking {
namespace {

// Share of the images that repeat the one before from which on it is reported.
constexpr double kManyRepeated = 0.1;

std::string toMillimetre(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m", m);
  return text;
}

/// Whether known objects are removed from the images, and why.
struct Removal {
  bool remove{false};
  std::string note;       ///< empty: none are known
  double band{0.0};       ///< m, around them
  std::string warning{};  ///< empty: the images do not contradict
};

Removal removalOf(const KnownObjects& objects, DepthStream& stream, const std::filesystem::path& path) {
  if (!objects.known) return {};
  const std::string things = "the scene's robots and objects were ";
  const bool pose_known = stream.facts().pose_known;
  if (objects.remove) {
    if (!*objects.remove) return {false, things + "not removed from the images, as specified"};
    if (!pose_known)
      throw ParseError({path.string()},
                       "found depth images without a camera pose, expected a camera with T_WC, "
                       "to remove the scene's robots and objects from them");
  }
  if (!pose_known) return {false, things + "not removed from the images, because the camera pose is unknown"};
  if (!objects.remove && !stream.camera().distortion.isZero(0.0))
    return {false, things + "not removed from the images, because the lens distortion is not removed"};
  const ObjectsInImages shown = compareWithKnown(stream, objects);
  if (!shown.show() && !objects.remove)
    return {false, things + "not removed from the images, which do not show them"};
  Removal removal{
      true, things + "removed from the images, " + (objects.remove ? "as specified" : "which show them")};
  if (!shown.show()) return removal;
  removal.band = shown.displaced.band();
  if (const std::string reason = bandReason(shown.displaced); !reason.empty())
    removal.warning = "the images show the scene's robots and objects " + reason;
  return removal;
}

std::string assumedFacing(const Facing& facing) {
  if (facing.lies) return facing.away ? "lying on the front" : "lying on the back";
  return facing.away ? "facing away from the camera" : "facing the camera";
}

}  // namespace

std::string othersWarning(const ClipTrack& track, std::size_t person) {
  std::string others;
  for (std::size_t k = 0; k < track.people.size(); ++k)
    if (k != person)
      others += (others.empty() ? "number " : ", number ") + std::to_string(k + 1) + " in " +
                std::to_string(track.people[k].found) + " images";
  if (others.empty()) return {};
  return "the images show " + std::to_string(track.people.size()) + " people: number " +
         std::to_string(person + 1) + " is used, and no distance to the others is known (" + others +
         "; `abstand track --person N --out FILE.csv` writes each of them)";
}

Recording recordingOf(const ClipTrack& track, const DepthFacts& facts, std::size_t person) {
  if (person >= track.people.size())
    throw UsageError("found " + std::to_string(track.people.size()) +
                     " people in the depth recording, expected " + std::to_string(person + 1) + " or more");
  const ClipPerson& tracked = track.people[person];
  Recording recording;
  recording.frames = tracked.frames;
  RecordingReport& r = recording.report;
  r.format = "depth-" + facts.format;
  r.rate = facts.rate;
  r.rate_reason = facts.rate_reason;
  recording.clock_start = facts.clock_start;
  r.duration = recording.frames.empty() ? 0.0 : recording.frames.back().t - recording.frames.front().t;
  r.units.name = "m";
  r.units.reason = "of the depth camera: " + facts.camera_reason;
  r.up.axis = "z";
  r.up.reason = track.world;
  r.sides.found = "agree";
  r.sides.reason = facingReason(tracked.facing);
  r.stature = tracked.stature.known() ? tracked.stature.used : 0.0;
  if (tracked.stature.known()) r.person.stature_reason = statureReason(tracked.stature);
  r.joint_map = "tracked";
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    r.joints.emplace_back(humanmodel::jointName(static_cast<humanmodel::Joint>(j)));
  for (const PartJoints& part : partJoints())
    for (const humanmodel::Joint j : part.joints)
      r.mapped[std::string(part.part)].emplace_back(humanmodel::jointName(j));
  for (const humanmodel::SkeletonFrame& frame : recording.frames)
    r.gaps += !frame.has(humanmodel::Joint::kPelvis);
  r.warnings = trackWarnings(tracked);
  for (std::string& warning : cameraWarnings(track)) r.warnings.push_back(std::move(warning));
  r.notes = facts.notes;
  r.notes.push_back("person " + std::to_string(person + 1) + " of " + std::to_string(track.people.size()) +
                    ", found in " + std::to_string(tracked.found) + " of " + std::to_string(track.images) +
                    " images, " + toMillimetre(tracked.residual) + " mean distance to the body");
  for (std::string& note : heldNotes(tracked)) r.notes.push_back(std::move(note));
  return recording;
}

std::string facingReason(const Facing& facing) {
  const std::string side = "initially " + assumedFacing(facing);
  if (facing.given) return side + ", as given";
  if (std::isnan(facing.ratio)) return side + ", assumed without comparison with the opposite facing";
  char text[200];
  std::snprintf(text, sizeof text,
                "%s: the residual of facing away is %.2f times that of facing the camera; below %.2f facing "
                "away is certain, above %.2f facing the camera",
                facing.decided() ? "" : ", undecided", facing.ratio, 1.0 / facing.sureAway(), facing.sure());
  return side + text;
}

std::string statureReason(const Stature& stature) {
  switch (stature.source) {
    case Stature::Source::kGiven:
      return toMillimetre(stature.used) + ", as given";
    case Stature::Source::kMeasured:
      return toMillimetre(stature.used) + ", measured";
    case Stature::Source::kInterval:
      break;
  }
  return "unknown, between " + toMillimetre(stature.interval[0]) + " and " +
         toMillimetre(stature.interval[1]) + ": " + stature.reason +
         (stature.used > 0.0 ? "; fitted with " + toMillimetre(stature.used) : "");
}

std::vector<std::string> trackWarnings(const ClipPerson& person) {
  std::vector<std::string> warnings;
  if (!person.facing.decided())
    warnings.push_back("the images do not determine the initial facing: " + assumedFacing(person.facing) +
                       " is assumed, if that is wrong, left and right are swapped (--facing)");
  if (!person.stature.known())
    warnings.push_back("the stature is " + statureReason(person.stature) + " (--height)");
  return warnings;
}

std::vector<std::string> heldNotes(const ClipPerson& person) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < person.held.size(); ++k) {
    if (person.held[k] == 0) continue;
    char text[160];
    std::snprintf(
        text, sizeof text,
        "the %s hand holds a thing in %zu images, up to %.2f m beyond the hand; its pose uncertainty "
        "includes the thing",
        k == 0 ? "left" : "right", person.held[k], person.held_extent[k]);
    notes.emplace_back(text);
  }
  return notes;
}

std::vector<std::string> cameraWarnings(const ClipTrack& track) {
  std::vector<std::string> warnings;
  const bool is_alone = track.cameras.size() == 1;
  for (std::size_t c = 0; c < track.cameras.size(); ++c) {
    const CameraShare& share = track.cameras[c];
    const std::string name = is_alone ? "the camera" : "camera " + std::to_string(c + 1);
    char text[240];
    if (std::isfinite(share.moved_at)) {
      std::snprintf(text, sizeof text, " was moved at %.2f s: its images are not used from then on",
                    share.moved_at);
      warnings.push_back(name + text);
    }
    if (std::isfinite(share.apart_since)) warnings.push_back(name + " " + apartReason(share));
    if (std::isfinite(share.late_since)) warnings.push_back(name + " " + lateReason(share));
    if (static_cast<double>(share.repeated) > kManyRepeated * static_cast<double>(share.images)) {
      std::snprintf(text, sizeof text, " repeats the image before in %zu of %zu images: it hangs",
                    share.repeated, share.images);
      warnings.push_back(name + text);
    } else if (std::isfinite(share.hung_at)) {
      std::snprintf(text, sizeof text, " repeats an image since %.2f s for %.1f s or longer: it hangs%s",
                    share.hung_at, CameraShare::kHung, is_alone ? "" : ", and its images are not used then");
      warnings.push_back(name + text);
    }
  }
  return warnings;
}

bool isDepthRecording(const std::filesystem::path& path) {
  std::error_code ec;
  if (std::filesystem::is_directory(path, ec)) return true;
  const DepthFileKind kind = depthFileKind(path);
  if (kind != DepthFileKind::kMat) return kind != DepthFileKind::kOther;
  try {
    openDepthStream(path);
    return true;
  } catch (const ParseError&) {
    return false;  // contains a skeleton, or its reader reports the error
  }
}

Recording openAnyRecording(const std::filesystem::path& path, const RecordingOptions& options,
                           std::optional<double> height, const KnownObjects& objects,
                           const TrackMonitor& monitor) {
  if (!isDepthRecording(path)) return openRecording(path, options);
  DepthStreamOptions stream_options;
  stream_options.rate = options.rate;
  stream_options.mirror = options.mirror != "none";
  const auto stream = openDepthStream(path, stream_options);
  ClipTrackerOptions tracker;
  tracker.person.height = height;
  const Removal removal = removalOf(objects, *stream, path);
  if (removal.remove) tracker.known = withBand(objects.known, removal.band);
  tracker.progress = monitor.progress;
  tracker.interrupted = [&monitor] {
    return interruptRequested() || (monitor.cancelled && monitor.cancelled());
  };
  FitLog fits;
  if (monitor.fitted) tracker.watch = [&fits](const ClipMoment& moment) { fits.note(moment); };
  const ClipTrack track = trackClip(*stream, tracker);
  // A partial recording would look like a lost person.
  if (track.interrupted) throw Interrupted();
  if (track.people.empty())
    throw ParseError({path.string()}, "found no person in the depth recording, expected one");
  Recording recording = recordingOf(track, stream->facts(), 0);
  if (monitor.fitted) {
    FittedClip clip = fits.clipOf(track, 0, *stream);
    clip.path = path;
    clip.options = stream_options;
    monitor.fitted(std::make_shared<const FittedClip>(std::move(clip)));
  }
  if (!removal.note.empty()) recording.report.notes.push_back(removal.note);
  if (!removal.warning.empty()) recording.report.warnings.push_back(removal.warning);
  if (std::string others = othersWarning(track, 0); !others.empty())
    recording.report.warnings.push_back(std::move(others));
  return recording;
}

}  // namespace abstand::tracking
