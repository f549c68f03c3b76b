#include "app/run/pose_watch.hpp"

#include <algorithm>

#include "core/text/message_text.hpp"

namespace abstand::run {
namespace {

/// Tolerance of two recordings' time ranges, in frame periods.
constexpr double kSteps = 1.5;

double stepOf(double start, double end, std::size_t frames) {
  return frames > 1 ? (end - start) / static_cast<double>(frames - 1) : kInfinity;
}

}  // namespace

void PoseWatch::Spell::note(bool holds, double t) noexcept {
  if (holds) {
    if (cycles == 0) t0 = t;
    t1 = t;
    ++cycles;
    if (!open) ++stretches;
  }
  open = holds;
}

PoseWatch::PoseWatch(const session::Session& session) : session_(session) {
  const scene::Scene& scene = session.scene();
  std::vector<std::string> unmapped;
  const auto& humans = session.description().humans;
  for (std::size_t i = 0; i < humans.size(); ++i) {
    const tracking::Recording* recording = session.humans()[i]->recording();
    if (!recording) continue;
    for (const auto& part : recording->report.missing_parts) unmapped.push_back(humans[i].name + "/" + part);
    const double start = recording->frames.front().t, end = recording->frames.back().t;
    const double slack = kSteps * stepOf(start, end, recording->frames.size());
    Source source{humans[i].name, start - slack, end + slack, {}, {}, {}};
    for (const scene::Object& o : scene.objects())
      if (o.spec.group == humans[i].name)
        source.objects.push_back(static_cast<std::uint32_t>(&o - scene.objects().data()));
    sources_.push_back(std::move(source));
  }
  if (const session::PosesTable* poses = session.poses()) {
    const double slack = kSteps * stepOf(poses->t.front(), poses->t.back(), poses->t.size());
    sources_.push_back({"the table of poses", poses->t.front() - slack, poses->t.back() + slack, {}, {}, {}});
  }
  for (std::uint32_t i = 0; i < scene.objectCount(); ++i) {
    const scene::ObjectSpec& spec = scene.object(ObjectId(i)).spec;
    if (scene.pairsOf(ObjectId(i)).empty()) continue;
    const bool none = std::find(unmapped.begin(), unmapped.end(), spec.name) != unmapped.end();
    bodies_.push_back({i, spec.name, spec.group, none, {}, {}, {}});
  }
}

void PoseWatch::cycle(double t) noexcept {
  ++cycles_;
  const auto& objects = session_.scene().objects();
  for (Body& body : bodies_) {
    const scene::PoseState state = objects[body.object].pose_state;
    body.refused.note(state == scene::PoseState::kRejected, t);
    body.stale.note(state == scene::PoseState::kStale, t);
    body.inferred.note(state == scene::PoseState::kInferred, t);
  }
  for (Source& source : sources_) {
    source.outside.note(t < source.start || t > source.end, t);
    bool seen = source.objects.empty();
    for (const std::uint32_t i : source.objects)
      seen = seen || objects[i].pose_state == scene::PoseState::kFresh ||
             objects[i].pose_state == scene::PoseState::kInferred;
    source.absent.note(!seen, t);
  }
}

void PoseWatch::add(std::vector<Reservation>& out, const char* kind, const std::string& what,
                    const Spell& spell, scene::Severity fails) const {
  if (spell.cycles == 0) return;
  const double share = static_cast<double>(spell.cycles) / static_cast<double>(cycles_);
  std::string text = what + ", " + text::rounded(spell.t0, 3) + " s to " + text::rounded(spell.t1, 3) + " s";
  if (spell.stretches > 1) text += " in " + std::to_string(spell.stretches) + " stretches";
  text += ", " + text::rounded(100.0 * share, 1) + " % of the time";
  out.push_back({kind, text, spell.t0, spell.t1, share, fails, {}});
}

bool PoseWatch::wasAbsent(const Body& body, const Spell& spell) const {
  return std::any_of(sources_.begin(), sources_.end(),
                     [&](const Source& s) { return s.name == body.group && s.absent == spell; });
}

void PoseWatch::addBodies(std::vector<Reservation>& out, const char* kind, const char* what,
                          Spell Body::*spell, scene::Severity fails) const {
  std::vector<bool> told(bodies_.size(), false);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& first = bodies_[i];
    const bool unmapped = first.unmapped && spell == &Body::stale;
    if (told[i] || unmapped || (first.*spell).cycles == 0 || wasAbsent(first, first.*spell)) continue;
    std::string names;
    for (std::size_t j = i; j < bodies_.size(); ++j) {
      const Body& other = bodies_[j];
      if (told[j] || other.group != first.group || !(other.*spell == first.*spell)) continue;
      told[j] = true;
      names += (names.empty() ? "" : ", ") + other.name;
    }
    add(out, kind, names + what, first.*spell, fails);
  }
}

std::vector<Reservation> PoseWatch::reservations() const {
  std::vector<Reservation> out;
  addBodies(out, "refused_pose", ": the pose was rejected (not finite, not a rotation, or too far away)",
            &Body::refused, scene::Severity::kAlways);
  for (const Source& s : sources_)
    add(out, "no_person", s.name + " was never tracked", s.absent, scene::Severity::kAlways);
  for (const Source& s : sources_)
    add(out, "outside_recording", s.name + " is outside the time range of its recording and is held still",
        s.outside, scene::Severity::kAlways);
  addBodies(out, "stale_pose", ": the pose was stale", &Body::stale, scene::Severity::kAlways);
  addBodies(out, "inferred_pose", ": the pose was inferred, not measured", &Body::inferred,
            scene::Severity::kStrict);
  return out;
}

}  // namespace abstand::run
