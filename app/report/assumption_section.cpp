#include "app/report/assumption_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "app/tune/part_frames.hpp"
#include "app/tune/stated_options.hpp"
#include "app/tune/stored_terms.hpp"
#include "core/base/number.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

using AssumptionRows = std::vector<std::vector<std::string>>;

std::string tenthMm(double metres) { return text::rounded(1e3 * metres, 1) + " mm"; }
std::string wholeMs(double seconds) { return text::rounded(1e3 * seconds, 0) + " ms"; }
std::string timeWithUnit(double t) { return text::rounded(t, 3) + " s"; }

std::string joinedNames(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all.empty() ? "none" : all;
}

/// "user" also where somebody stated the default on purpose.
std::string saidBy(const tune::TuneOptions& options, const char* name) {
  return tune::isStated(options, name) ? "user" : "default";
}

/// m, the largest uncertainty that a recording states of its tracker; 0: none does.
double largestStated(const std::vector<tune::TunedRecording>& recordings, double calibration) {
  // Files round the sum and its shares apart.
  constexpr double kRounding = 1e-6;
  double largest = 0.0;
  for (const tune::TunedRecording& r : recordings) {
    tune::PartByPart parts(r);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const tune::PartClearance& part = parts.part(p);
      for (std::size_t i = 0; i < part.track.frames(); ++i) {
        const double stated =
            part.uncertainty[i] - part.age_uncertainty[i] - part.latency_uncertainty[i] - calibration;
        if (std::isfinite(stated) && stated > kRounding) largest = std::max(largest, stated);
      }
    }
  }
  return largest;
}

/// Tolerance of distances beyond 0.1 m when pairs start warm.
AssumptionRows::value_type toleranceRow(const tune::TuneAnswer& answer) {
  const auto warm = tune::warmStartOf(answer.recordings);
  return {"tolerance of distances beyond 0.1 m",
          warm ? text::rounded(100.0 * warm->far_tolerance, 3) + " %" : "cold starts: not used",
          !warm || warm->far_tolerance == query::kFarTolerance ? "default" : "user",
          "distances beyond 0.1 m may be larger than the smallest one by it; the bound includes it"};
}

AssumptionRows marginRows(const tune::TuneAnswer& answer) {
  const tune::TuneOptions& o = answer.options;
  const double stated = largestStated(answer.recordings, o.pass.calibration_error);
  const std::vector<std::string> clamped = tune::clampedParts(answer.recordings);
  return {
      {"reaction time", wholeMs(o.pass.braking.reaction_time), saidBy(o, "reaction_time"),
       "each 10 ms more need 10 ms times the closing speed more margin: 16 mm at 1.6 m/s"},
      {"deceleration of each joint", formatDouble(o.pass.braking.deceleration) + " rad/s^2 or m/s^2",
       saidBy(o, "deceleration"), "half of it doubles the braking time and the person's displacement in it"},
      {"limit", tenthMm(o.pass.limit), saidBy(o, "limit"), "margins grow with it one to one"},
      {"error of the tracker", stated > 0.0 ? "up to " + tenthMm(stated) : "not stated, counts as 0",
       "recordings", "every clearance is smaller by it, and margins grow with it one to one"},
      {"calibration error between recording and robot", tenthMm(o.pass.calibration_error),
       saidBy(o, "calibration_error"),
       "every clearance is smaller by it, and margins grow with it one to one; 0 means that it was not "
       "measured"},
      {"latency of a person's pose", wholeMs(o.pass.latency), saidBy(o, "latency"),
       "each 10 ms more take 10 ms times the part's speed (2 m/s, or the fastest recorded) from every "
       "clearance: 20 mm at 2 m/s; 0 says that nobody has measured it"},
      {"parts that may be clamped", joinedNames(clamped), clamped.empty() ? saidBy(o, "clamped") : "user",
       "quasi-static limits apply to their contacts, which are usually half of the transient ones, and no "
       "part of their mass recoils"},
      {"table of contact limits",
       answer.recordings.front().contact_limits.empty() ? "none" : answer.recordings.front().contact_limits,
       saidBy(o, "contact_limits"), "contacts, and speeds that their limits permit, follow from it"},
      {"near", tenthMm(o.pass.near), saidBy(o, "near"),
       "approaches and contacts of pairs farther apart are not judged: larger finds more of them"},
      {"restart time", timeWithUnit(o.restart_time), saidBy(o, "restart_time"),
       "adds to the time stopped, not to margins"},
      toleranceRow(answer)};
}

/// Of the speeds of people, which are one row.
std::string speedSaidBy(const tune::TuneOptions& options) {
  std::string users;
  for (const char* name : {"person_speed", "person_speed_near", "near"})
    if (tune::isStated(options, std::string("separation.") + name))
      users += (users.empty() ? "" : ", ") + std::string(name);
  return users.empty() ? "default" : "user (" + users + ")";
}

/// The sources of the speeds of people and of what is near, as the table in use states them.
std::string speedSources(const tune::TunedRecording& recording) {
  std::string text;
  for (const tune::CitedTerm& term : recording.separation_terms)
    text += term.key + " " + formatDouble(term.value) + ": " + term.source +
            (term.to_be_checked.empty() ? "" : " (to be checked: " + term.to_be_checked + ")") + "; ";
  if (text.empty())
    text =
        std::string(safety::kApproachSpeedEdition) + ": walking 1.6 m/s, a hand 2.0 m/s nearer than 500 mm; ";
  return text + "S_h grows with it";
}

AssumptionRows separationRows(const tune::TuneAnswer& answer) {
  const tune::TuneOptions& options = answer.options;
  const safety::SeparationOptions& o = options.pass.separation;
  const bool brakes = o.deceleration > 0.0;
  return {{"T_r, reaction time", wholeMs(o.reaction_time), saidBy(options, "separation.reaction_time"),
           "each 10 ms more add 10 ms times the speeds of person and robot: 16 mm at 1.6 m/s"},
          {"T_s, stopping time",
           brakes ? "robot's speed / " + formatDouble(o.deceleration) + " m/s^2" : wholeMs(o.stopping_time),
           saidBy(options, brakes ? "separation.deceleration" : "separation.stopping_time"),
           "each 10 ms more add 10 ms times the person's speed, and half the robot's"},
          {"v_h, speed of the person",
           text::rounded(o.person_speed, 2) + " m/s, nearer than " + tenthMm(o.near) + " " +
               text::rounded(o.person_speed_near, 2) + " m/s",
           speedSaidBy(options), speedSources(answer.recordings.front())},
          {"acceleration of the person",
           o.person_acceleration > 0.0 ? text::rounded(o.person_acceleration, 2) + " m/s^2"
                                       : "measured speeds are not used",
           saidBy(options, "separation.person_acceleration"),
           "with it, S_h follows from the measured speed where that gives less"},
          {"C, intrusion before detection", tenthMm(o.intrusion), saidBy(options, "separation.intrusion"),
           "adds one to one; 0 says that nobody has looked it up for the sensor"},
          {"Z_d, error of the person's place", tenthMm(o.person_error),
           saidBy(options, "separation.person_error"),
           "adds one to one, beside the uncertainty that clearances have already"},
          {"Z_r, error of the robot's place", tenthMm(o.robot_error),
           saidBy(options, "separation.robot_error"), "adds one to one"}};
}

/// Which editions the numbers follow, and what owners of later ones have to check.
std::string editionText(const tune::TuneAnswer& answer) {
  const tune::TunedRecording& first = answer.recordings.front();
  return "Formula of S_p: " + std::string(safety::kSeparationEdition) +
         ". ISO 10218-2:2025 has taken over the requirements of that specification. Speeds of people: " +
         tune::speedsEdition(first) +
         (first.separation_table.empty() ? "" : " (table: " + first.separation_table + ")") +
         "; of ISO 13855:2010 there is an edition of 2024. This program does not know whether the later "
         "editions "
         "changed the formula or a value: compare each with the editions that you own, and set what differs "
         "(--separation, --separation-table, --contact-limits).";
}

std::string inputTables(const tune::TuneAnswer& answer) {
  AssumptionRows rows;
  for (const tune::TunedRecording& r : answer.recordings)
    rows.push_back({r.recording, std::to_string(r.frames), timeWithUnit(r.seconds()),
                    r.unjudged > 0.0 ? timeWithUnit(r.unjudged) : "", r.content});
  std::string html = "<h2>Inputs</h2>\n" +
                     htmlTable({"recording", "frames", "length", "not judged", "content (XXH3)"}, rows);
  rows.clear();
  for (const tune::TunedRecording& r : answer.recordings)
    for (const tune::PersonNote& person : r.people) rows.push_back({r.recording, person.name, person.text});
  html += "<p>The bodies, as the scene and the plan say; the recordings give the motion:</p>\n" +
          htmlTable({"recording", "person", "body"}, rows);
  rows.clear();
  for (const tune::InputFile& file : tune::inputFiles(answer.recordings))
    rows.push_back({file.name, file.content});
  html += "<p>Files that the numbers follow from; with another content a file is another one:</p>\n" +
          htmlTable({"file", "content (XXH3)"}, rows);
  for (const auto& f : answer.failed)
    html += "<p class=\"failed\">Not run: " + text::escapedXml(f.recording + ": " + f.error) + "</p>\n";
  const std::string& stamp = answer.recordings.front().contact_limits;
  if (!stamp.empty()) html += "<p>Limits of contact: " + text::escapedXml(stamp) + ".</p>\n";
  return html;
}

std::string reservationTable(const tune::TuneAnswer& answer) {
  AssumptionRows rows;
  for (const tune::TunedRecording& r : answer.recordings)
    for (const run::Reservation& reservation : r.reservations)
      rows.push_back({r.recording, reservation.kind, reservation.text});
  return "<h2>Reservations</h2>\n" +
         (rows.empty() ? std::string("<p>None.</p>\n") : htmlTable({"recording", "kind", "reason"}, rows));
}

}  // namespace

std::string assumptionSection(const tune::TuneAnswer& answer) {
  const std::vector<std::string> header{"quantity", "value", "said by", "effect of a change"};
  return "<h2>Assumptions</h2>\n<p>\"default\" is the program's own value, or none: nobody has "
         "confirmed it for this cell. \"User\": stated on the command line, or other than the default. Of "
         "stored results, an option counts as stated where it was stated for each of them.</p>\n" +
         htmlTable(header, marginRows(answer)) +
         "<p>Each stop is judged by itself; robot and person are in step with the recording until the margin "
         "is "
         "violated. Distances "
         "and braking are certified between frames too (docs/margins.md).</p>\n"
         "<h3>Of the protective distance and permitted speeds</h3>\n" +
         "<p>" + editionText(answer) + "</p>\n" + htmlTable(header, separationRows(answer)) +
         inputTables(answer) + reservationTable(answer);
}

}  // namespace abstand::report
