#include "app/cli/tune_texts.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/margin_texts.hpp"
#include "app/cli/reservation_texts.hpp"
#include "app/cli/speed_texts.hpp"
#include "app/cli/standard_texts.hpp"
#include "app/cli/warm_start.hpp"
#include "app/tune/stated_options.hpp"
#include "app/tune/stored_limits.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Approaches in the text; the JSON has all.
constexpr std::size_t kTextApproaches = 10;

Json rowJson(const tune::MarginRow& row) {
  Json j{{"part", row.part}, {"margin", row.margin}};
  j.update(outcomeJson(row.outcome));
  return j;
}

/// Shares of people as tall as the model, and of all people.
Json enclosedJson(const tune::TuneAnswer& answer, const std::string& part) {
  const auto range = tune::enclosedRange(answer.recordings, part);
  if (!range) return nullptr;
  return {{"at_stature", {{"min", range->min.at_stature}, {"max", range->max.at_stature}}},
          {"all_statures", {{"min", range->min.all_statures}, {"max", range->max.all_statures}}}};
}

/// "29 %" or "3 to 97 %" of all people.
std::string enclosedText(const tune::TuneAnswer& answer, const std::string& part) {
  const auto range = tune::enclosedRange(answer.recordings, part);
  if (!range) return "not known";
  const std::string least = format("%.0f", 100.0 * range->min.all_statures),
                    largest = format("%.0f", 100.0 * range->max.all_statures);
  return least == largest ? largest + " %" : least + " to " + largest + " %";
}

/// By recorded time; null where no margin suffices, or nothing was judged.
Json unseenMinutesJson(const tune::ProposedMargin& p) {
  const double minutes = p.judged_time / 60.0;
  if (std::isinf(p.margin) || !(minutes > 0.0)) return nullptr;
  return {{"level", 0.95},
          {"seconds", p.judged_time},
          {"violations_per_minute", margin::unseenRate(minutes)},
          {"share", margin::unseenTimeShare(minutes)}};
}

Json proposedJson(const tune::TuneAnswer& answer, const tune::ProposedMargin& p) {
  Json j{{"part", p.part}, {"margin", p.margin}};
  if (const auto& d = p.decided_by) {
    j["decided_by"] = {{"recording", answer.recordings[d->recording].recording},
                       {"t", d->t},
                       {"link", d->link},
                       {"tool", toolJson(d->tool)}};
    j["uncertainty"] = {{"bound", d->bound}, {"pose", d->pose}, {"sampling", d->sampling}};
  } else {
    j["decided_by"] = nullptr;
    j["uncertainty"] = nullptr;
  }
  j["enclosed_share"] = enclosedJson(answer, p.part);
  j["confidence"] = {{"level", 0.95}, {"recordings", p.needed.size()}, {"unseen_share", p.unseen_share}};
  j["confidence"]["unseen_minutes"] = unseenMinutesJson(p);
  Json& fit = j["confidence"]["gumbel"];
  if (p.fit)
    fit = {{"location", p.fit->location},
           {"scale", p.fit->scale},
           {"misfit", p.fit->misfit},
           {"critical_misfit", margin::criticalMisfit(p.fit->count)},
           {"margin_95", p.fit->quantile(0.95)},
           {"margin_99", p.fit->quantile(0.99)}};
  else
    fit = nullptr;
  return j;
}

/// The limits of a contact, and what they follow from; null: excluded.
void addLimits(const tune::RankedApproach& r, Json& j) {
  const auto judged = tune::judgedContact(*r.recording, *r.approach);
  const bool limited = judged && !judged->contact.excluded;
  const auto orNothing = [](bool known, double v) { return known ? numberOrNull(v) : Json(nullptr); };
  j["robot_mass"] = numberOrNull(r.approach->contact.robot_mass);
  j["body_mass"] = orNothing(judged.has_value(), judged ? judged->region.body_mass.value : kNaN);
  j["reduced_mass"] = orNothing(judged.has_value(), judged ? judged->contact.reduced_mass : kNaN);
  j["spring"] = orNothing(judged.has_value(), judged ? judged->region.spring.value : kNaN);
  j["force_limit"] = orNothing(limited, limited ? judged->contact.allowed_force : kNaN);
  j["energy_limit"] = orNothing(limited, limited ? judged->contact.allowed_energy : kNaN);
  j["pressure_limit"] = orNothing(limited, limited ? judged->allowed_pressure : kNaN);
}

/// null: excluded or not judged.
Json contactJson(const tune::RankedApproach& r) {
  const tune::ContactShare& c = r.approach->contact;
  if (c.region.empty()) return nullptr;
  Json j{{"t", c.t},
         {"closing_speed", c.closing},
         {"region", c.region},
         {"kind", contact::kindText(c.kind)},
         {"excluded", c.excluded},
         {"force", c.force},
         {"energy", c.energy},
         {"share", c.share},
         {"pressure", c.excluded ? Json(nullptr) : Json(c.pressure)},
         {"pressure_share", c.excluded ? Json(nullptr) : Json(c.pressure_share)}};
  addLimits(r, j);
  return j;
}

std::string approachesText(const tune::TuneAnswer& answer) {
  const std::vector<tune::RankedApproach> ranked = tune::rankedApproaches(answer);
  std::string text =
      format("\nnearest approaches (%zu below %.0f mm):\n", ranked.size(), 1e3 * answer.options.pass.near);
  for (std::size_t i = 0; i < std::min(ranked.size(), kTextApproaches); ++i) {
    const tune::Approach& a = *ranked[i].approach;
    const tune::TunedRecording& r = *ranked[i].recording;
    text += format("%8.1f mm  %s to %s at %.3f s", 1e3 * a.clearance,
                   tune::partText(r.pass.parts[a.part].part, r.pass.toolName(a.tool)).c_str(),
                   r.pass.links[a.link].c_str(), a.t);
    if (!a.contact.region.empty()) {
      text += format("; hardest contact before, at %.2f m/s: ", a.contact.closing);
      text += a.contact.excluded
                  ? "contact excluded for this region"
                  : format("%.0f N, %.0f %% of the %s limit (%s)", a.contact.force, 100.0 * a.contact.share,
                           std::string(contact::kindText(a.contact.kind)).c_str(), a.contact.region.c_str());
    }
    text += answer.recordings.size() > 1 ? ", " + r.recording + "\n" : "\n";
  }
  return text;
}

Json filesJson(const tune::TuneAnswer& answer) {
  Json files = Json::array();
  for (const tune::InputFile& file : tune::inputFiles(answer.recordings))
    files.push_back({{"file", file.name}, {"content", file.content}});
  return files;
}

Json worstPhasesJson(const tune::TuneAnswer& answer) {
  Json rows = Json::array();
  for (const auto& r : answer.worst_phases)
    for (const tune::WorstPhase& w : r.parts)
      rows.push_back({{"recording", r.recording},
                      {"part", w.part},
                      {"touches", w.touches},
                      {"clearance", w.touches ? Json(nullptr) : Json(w.lower)},
                      {"distance", w.distance},
                      {"link", w.link},
                      {"t_person", w.t_person},
                      {"t_robot", w.t_robot},
                      {"phase", w.phase},
                      {"not_seen", w.unseen},
                      {"queries", w.queries}});
  return rows;
}

std::string worstPhasesText(const tune::TuneAnswer& answer) {
  std::string text;
  for (const auto& r : answer.worst_phases) {
    text += "\nworst phase of " + r.recording + ", certified:\n";
    for (const tune::WorstPhase& w : r.parts)
      text += format("%-24s %s to %s, person at %.3f s, program at %.3f s (phase %.3f s)\n", w.part.c_str(),
                     w.touches ? "   touches" : format("%7.1f mm", 1e3 * w.lower).c_str(), w.link.c_str(),
                     w.t_person, w.t_robot, w.phase);
  }
  return text;
}

Json bodiesJson(const tune::TunedRecording& r) {
  Json people = Json::array();
  for (const tune::PersonNote& person : r.people)
    people.push_back({{"name", person.name}, {"body", person.text}});
  return people;
}

double secondsOf(const tune::TuneAnswer& answer) {
  double seconds = 0.0;
  for (const auto& r : answer.recordings) seconds += r.seconds();
  return seconds;
}

std::size_t framesOf(const tune::TuneAnswer& answer) {
  std::size_t frames = 0;
  for (const auto& r : answer.recordings) frames += r.frames;
  return frames;
}

std::string proposedText(const tune::TuneAnswer& answer, const tune::ProposedMargin& p) {
  const std::string enclosed = enclosedText(answer, p.part);
  if (std::isinf(p.margin))
    return format("%-14s no margin suffices; body encloses %s of people\n", p.part.c_str(), enclosed.c_str());
  if (!p.decided_by)
    return format("%-14s      0 mm  no stop needed; body encloses %s of people\n", p.part.c_str(),
                  enclosed.c_str());
  const auto& d = *p.decided_by;
  return format(
      "%-14s %6.0f mm  determined by %s at %.3f s, %s; including bound %.1f, pose %.1f, one frame %.1f mm; "
      "body "
      "encloses %s of people\n",
      tune::partText(p.part, d.tool).c_str(), 1e3 * p.margin,
      answer.recordings[d.recording].recording.c_str(), d.t, d.link.c_str(), 1e3 * d.bound, 1e3 * d.pose,
      1e3 * d.sampling, enclosed.c_str());
}

/// For the part with the least judged time.
std::string unseenMinutesText(const tune::TuneAnswer& answer) {
  const double minutes = tune::shortestJudgedTime(answer.table) / 60.0;
  if (!(minutes > 0.0)) return "95 % confidence by time: nothing was judged of some part\n";
  return format(
      "95 %% confidence by time: at most %.1f %% of unseen minutes of the same work violate one of these "
      "margins "
      "(fewer than %.2g violations per minute; %.2f minutes judged, variants of a recording counted once)\n",
      100.0 * margin::unseenTimeShare(minutes), margin::unseenRate(minutes), minutes);
}

}  // namespace

nlohmann::ordered_json approachJson(const tune::RankedApproach& r) {
  const tune::Approach& a = *r.approach;
  const double closing = a.motion.closing();
  return {
      {"recording", r.recording->recording},
      {"t", a.t},
      {"part", r.recording->pass.parts[a.part].part},
      {"link", r.recording->pass.links[a.link]},
      {"tool", toolJson(r.recording->pass.toolName(a.tool))},
      {"distance", a.distance},
      {"clearance", a.clearance},
      {"closing_speed", closing},
      {"robot_speed", a.motion.robot_speed},
      {"person_speed", a.motion.person_speed},
      {"time_to_contact", closing > 0.0 && a.clearance > 0.0 ? Json(a.clearance / closing) : Json(nullptr)},
      {"robot_mass", a.motion.robot_mass},
      {"contact", contactJson(r)}};
}

Json tuneJson(const tune::TuneAnswer& answer) {
  const tune::TuneOptions& o = answer.options;
  Json j{
      {"recordings", answer.recordings.size()}, {"frames", framesOf(answer)}, {"seconds", secondsOf(answer)}};
  j["assumed"] = {{"limit", o.pass.limit},
                  {"reaction_time", o.pass.braking.reaction_time},
                  {"deceleration", o.pass.braking.deceleration},
                  {"restart_time", o.restart_time},
                  {"calibration_error", o.pass.calibration_error},
                  {"latency", o.pass.latency}};
  j["warm_start"] = warmStartJson(tune::warmStartOf(answer.recordings));
  j["assumed_by"] = Json::object();
  for (const std::string& name : tune::assumptionNames())
    j["assumed_by"][name] = tune::isStated(o, name) ? "user" : "default";
  j["inputs"] = Json::array();
  for (const auto& r : answer.recordings)
    j["inputs"].push_back({{"recording", r.recording},
                           {"frames", r.frames},
                           {"seconds", r.seconds()},
                           {"not_judged", r.unjudged},
                           {"clamped", r.clamped},
                           {"people", bodiesJson(r)},
                           {"reservations", reservationsJson(r.reservations)}});
  j["files"] = filesJson(answer);
  j["failed"] = Json::array();
  for (const auto& f : answer.failed) j["failed"].push_back({{"recording", f.recording}, {"error", f.error}});
  if (answer.made || answer.kept)
    j["results"] = {{"made", answer.made.value_or(0)}, {"kept", answer.kept.value_or(0)}};
  j["margins"] = Json::array();
  j["curve"] = Json::array();
  for (const tune::MarginRow& row : answer.table.rows) {
    j["margins"].push_back(rowJson(row));
    j["curve"].push_back({{"part", row.part},
                          {"margin", row.margin},
                          {"stopped_share", row.outcome.stoppedShare()},
                          {"missed_stops", row.outcome.missed_stops}});
  }
  j["approaches"] = Json::array();
  for (const tune::RankedApproach& r : tune::rankedApproaches(answer))
    j["approaches"].push_back(approachJson(r));
  addStandards(answer, j);
  j["clamped"] = tune::clampedParts(answer.recordings);
  if (!answer.worst_phases.empty()) j["worst_phase"] = worstPhasesJson(answer);
  j["separation"] = separationJson(answer);
  j["contacts"] = contactsJson(answer);
  addSpeeds(answer, j);
  j["proposed"] = Json::array();
  for (const auto& p : answer.table.proposed) j["proposed"].push_back(proposedJson(answer, p));
  j["proposed_links"] = groupNeedsJson(answer, answer.links);
  j["proposed_pairs"] = groupNeedsJson(answer, answer.pairs);
  j["margin_sets"] = strategiesJson(answer);
  j["closest"] = closestJson(answer);
  j["bands"] = bandsJson(answer);
  j["interrupted"] = answer.interrupted;
  return j;
}

std::string tuneText(const tune::TuneAnswer& answer) {
  const tune::TuneOptions& o = answer.options;
  std::string text = format(
      "%zu recordings, %zu frames, %.1f s; reaction time %.0f ms, deceleration %.3g rad/s^2 "
      "or m/s^2, limit %.1f mm\n",
      answer.recordings.size(), framesOf(answer), secondsOf(answer), 1e3 * o.pass.braking.reaction_time,
      o.pass.braking.deceleration, 1e3 * o.pass.limit);
  text += warmStartText(tune::warmStartOf(answer.recordings));
  text += "\n";
  for (const auto& r : answer.recordings)
    if (r.unjudged > 0.0)
      text +=
          format("%s: begins with the person too near or not tracked; the first %.2f s were not evaluated\n",
                 r.recording.c_str(), r.unjudged);
  text += format("%-14s %8s %6s %8s %7s %7s %12s\n", tune::kWholeBody, "margin", "stops", "stopped", "false",
                 "missed", "min distance");
  for (const tune::MarginRow& row : answer.table.rows) {
    if (row.part != tune::kWholeBody) continue;
    const margin::MarginOutcome& m = row.outcome;
    text += format("%-14s %5.0f mm %6ld %6.1f %% %7ld %7ld %9.1f mm\n", "", 1e3 * row.margin, m.stops,
                   100.0 * m.stoppedShare(), m.false_stops, m.missed_stops, 1e3 * m.min_clearance);
  }
  text += "\nsmallest margins without a missed stop:\n";
  for (const auto& p : answer.table.proposed) text += proposedText(answer, p);
  const auto& p = answer.table.proposed.front();
  text += format(
      "95 %% confidence: at most %.1f %% of further recordings of the same kind violate one of these "
      "margins\n",
      100.0 * p.unseen_share);
  text += unseenMinutesText(answer);
  text += groupNeedsText(answer) + strategiesText(answer) + bandsText(answer) + closestText(answer);
  text += worstPhasesText(answer) + speedsText(answer) + approachesText(answer);
  for (const auto& r : answer.recordings) text += reservationsText(r.reservations);
  return text;
}

}  // namespace abstand::cli
