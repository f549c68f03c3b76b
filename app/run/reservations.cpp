#include "app/run/reservations.hpp"

#include <algorithm>
#include <cmath>

#include "app/scene_file/robot_links.hpp"
#include "core/mechanism/joint_range.hpp"
#include "core/text/message_text.hpp"

namespace abstand::run {
namespace {

/// m: a foot nearer to the floor than this stands on it.
constexpr double kFloorDistance = 0.3;
/// m: largest accepted deviation of a body's centre from that in its mechanism's file.
constexpr double kCenterDistance = 0.01;
/// Gap threshold: time step as a multiple of the usual one.
constexpr double kLongStep = 3.0;

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

double shareOf(std::size_t part, std::size_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

void addMechanism(const scene_file::MechanismDescription& m, const session::MechanismDriver& driver,
                  std::vector<Reservation>& out) {
  if (m.no_geometry)
    out.push_back({"bodiless",
                   m.name + " has no geometry, as declared in the scene (geometry: none)",
                   {},
                   {},
                   {},
                   scene::Severity::kNote,
                   {}});
  else if (m.links.empty())
    out.push_back({"no_body",
                   m.name +
                       " has no geometry and is not checked; declare `geometry: none` in the scene if this "
                       "is intended",
                   {},
                   {},
                   {},
                   scene::Severity::kAlways,
                   {}});
  if (!m.bodiless.empty())
    out.push_back(
        {"bodiless",
         "links of " + m.name + " without geometry, as declared in the scene: " + joined(m.bodiless),
         {},
         {},
         {},
         scene::Severity::kNote,
         {}});
  if (!m.missing.empty())
    out.push_back({"missing_body",
                   scene_file::missingBodiesText(m),
                   {},
                   {},
                   shareOf(m.missing.size(), m.frames_with_geometry),
                   scene::Severity::kAlways,
                   {}});

  const auto ranges = mechanism::jointRanges(driver.mechanism());
  const auto unlimited =
      std::count_if(ranges.begin(), ranges.end(), [](const auto& r) { return r.unlimited; });
  std::vector<bool> no_speed(ranges.size(), false);
  for (const auto& f : driver.mechanism().frames)
    if (f.dof >= 0 && !f.mimic && !std::isfinite(f.limits.velocity))
      no_speed[static_cast<std::size_t>(f.dof)] = true;
  const auto fast = std::count(no_speed.begin(), no_speed.end(), true);
  if (unlimited + fast > 0)
    out.push_back({"no_limits",
                   "of " + std::to_string(ranges.size()) + " joints of " + m.name + ", " +
                       std::to_string(unlimited) + " have no position limits and " + std::to_string(fast) +
                       " no velocity limit",
                   {},
                   {},
                   {},
                   m.reaction ? scene::Severity::kStrict : scene::Severity::kNote,
                   {}});
}

/// Reports bodies whose centres differ from the `link` environments of the mechanism's file.
void addCenters(const scene_file::MechanismDescription& m, const session::MechanismDriver& driver,
                const scene::Scene& scene, std::vector<Reservation>& out) {
  for (std::size_t i = 0; i < m.links.size(); ++i) {
    const scene_file::LinkDescription& link = m.links[i];
    const auto& object = driver.links()[i].object;
    if (!link.p_FC || !object) continue;
    const double off = (link.X_FL * scene.object(*object).spec.structure->com - *link.p_FC).norm();
    if (off <= kCenterDistance) continue;
    out.push_back({"link_center",
                   link.name + ": its centre is " + text::rounded(off, 3) + " m from the one that " +
                       m.file.filename().string() +
                       " states (`link` environment), which is not applied here" +
                       (link.posed ? "" : "; `pose: center` puts the mesh's origin there"),
                   {},
                   {},
                   {},
                   link.posed ? scene::Severity::kNote : scene::Severity::kStrict,
                   {}});
  }
}

/// Reports gaps between frames.
void addSteps(const std::string& file, const tracking::Recording& recording, std::vector<Reservation>& out) {
  const auto& frames = recording.frames;
  if (frames.size() < 3 || !(recording.report.rate > 0.0)) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + (middle - steps.begin()), sorted.end());
  const double usual = sorted[steps.size() / 2];
  const double duration = frames.back().t - frames.front().t;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i] > kLongStep * usual)
      out.push_back({"gaps",
                     file + ": no frame for " + text::rounded(steps[i], 3) + " s",
                     frames[i].t,
                     frames[i + 1].t,
                     duration > 0.0 ? std::optional(steps[i] / duration) : std::nullopt,
                     scene::Severity::kStrict,
                     {}});
}

/// Bones that the reader put in are a guess, as units are.
void addRepairs(const std::string& file, const tracking::RecordingReport& report,
                std::vector<Reservation>& out) {
  for (const std::string& repair : report.repairs)
    out.push_back({"repair_guess",
                   file + ": " + repair + "; `repair: false` in the scene leaves the file as it is",
                   {},
                   {},
                   {},
                   scene::Severity::kStrict,
                   {}});
}

void addRecording(const scene_file::HumanDescription& d, const session::HumanDriver& driver,
                  const scene::Scene& scene, std::vector<Reservation>& out) {
  const tracking::Recording& recording = *driver.recording();
  const tracking::RecordingReport& r = recording.report;
  const std::string file = d.recording.file.filename().string();
  const std::size_t frames = recording.frames.size();
  if (r.frames_missing > 0)
    out.push_back({"frames_missing",
                   file + ": the recording is truncated: " + std::to_string(r.frames_missing) + " of " +
                       std::to_string(frames + r.frames_missing) + " frames are missing",
                   recording.frames.back().t,
                   {},
                   shareOf(r.frames_missing, frames + r.frames_missing),
                   scene::Severity::kAlways,
                   {}});
  if (r.gaps > 0)
    out.push_back({"gaps",
                   file + ": a joint is missing in " + std::to_string(r.gaps) + " of " +
                       std::to_string(frames) + " frames",
                   {},
                   {},
                   shareOf(r.gaps, frames),
                   scene::Severity::kStrict,
                   {}});
  addSteps(file, recording, out);

  bool paired = false;
  for (const auto& part : r.missing_parts) {
    ObjectId id(0);
    paired |= scene.find(d.name + "/" + part, &id) && !scene.pairsOf(id).empty();
  }
  if (!r.missing_parts.empty())
    out.push_back({"unmapped_part",
                   file + ": no recorded joints move " + joined(r.missing_parts) + " of " + d.name,
                   {},
                   {},
                   {},
                   paired ? scene::Severity::kAlways : scene::Severity::kNote,
                   {}});
  if (r.units.guessed)
    out.push_back({"units_guess",
                   file + ": the units are guessed (" + r.units.name + ": " + r.units.reason +
                       "); set `units` in the scene",
                   {},
                   {},
                   {},
                   scene::Severity::kStrict,
                   {}});
  if (r.up.guessed)
    out.push_back(
        {"up_guess",
         file + ": the up axis is guessed (" + r.up.axis + ": " + r.up.reason + "); set `up` in the scene",
         {},
         {},
         {},
         scene::Severity::kStrict,
         {}});
  addRepairs(file, r, out);
  const double foot = r.lowest_foot + d.recording.place_xyz.z();
  if (std::abs(foot) > kFloorDistance)
    out.push_back({"floor",
                   file + ": the lowest foot of " + d.name + " is at z = " + text::rounded(foot, 2) +
                       " m, not on the floor at 0",
                   {},
                   {},
                   {},
                   scene::Severity::kStrict,
                   {}});
  for (std::size_t i = 0; i < r.warnings.size(); ++i)
    if (std::find(r.in_fields.begin(), r.in_fields.end(), i) == r.in_fields.end())
      out.push_back({"recording", file + ": " + r.warnings[i], {}, {}, {}, scene::Severity::kStrict, {}});
}

}  // namespace

const char* severityName(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::kNote:
      return "never";
    case scene::Severity::kStrict:
      return "strict";
    case scene::Severity::kAlways:
      return "always";
  }
  return "always";
}

std::vector<Reservation> reservationsOf(const session::Session& session) {
  std::vector<Reservation> out;
  const scene_file::SceneDescription& scene = session.description();
  if (session.scene().pairs().empty())
    out.push_back({"no_pairs",
                   "nothing was checked: the scene has no pairs",
                   {},
                   {},
                   {},
                   scene::Severity::kAlways,
                   {}});
  for (std::size_t i = 0; i < scene.mechanisms.size(); ++i) {
    addMechanism(scene.mechanisms[i], *session.mechanisms()[i], out);
    addCenters(scene.mechanisms[i], *session.mechanisms()[i], session.scene(), out);
  }
  for (std::size_t i = 0; i < scene.humans.size(); ++i)
    if (session.humans()[i]->recording())
      addRecording(scene.humans[i], *session.humans()[i], session.scene(), out);
  // Components and dropped triangles do not invalidate a closed mesh: they remain remarks.
  for (const session::MeshRemark& remark : session.meshRemarks())
    if (remark.doubtful) out.push_back({"mesh", remark.text, {}, {}, {}, scene::Severity::kStrict, {}});
  return out;
}

Reservation interruptedReservation(std::size_t done, std::size_t all, std::optional<double> last) {
  Reservation r;
  r.kind = "interrupted";
  r.text = last ? "interrupted at " + text::rounded(*last, 3) + " s: " + std::to_string(done) + " of " +
                      std::to_string(all) + " frames were run"
                : "interrupted before the first frame";
  r.t0 = last;
  if (all > 0) r.share = 1.0 - shareOf(done, all);
  r.fails = scene::Severity::kAlways;
  return r;
}

void addReservations(std::vector<Reservation>& all, const std::vector<Reservation>& more) {
  for (const Reservation& r : more)
    if (std::find(all.begin(), all.end(), r) == all.end()) all.push_back(r);
}

bool failing(const Reservation& r, bool strict) {
  return r.fails == scene::Severity::kAlways || (strict && r.fails == scene::Severity::kStrict);
}

}  // namespace abstand::run
