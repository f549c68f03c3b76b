#include "app/cli/pass_arguments.hpp"

#include <set>
#include <utility>

#include "app/cli/tune_arguments.hpp"
#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::cli {
namespace {

/// Parses KEY=VALUE texts.
void takeSeparation(const std::vector<std::string>& texts, safety::SeparationOptions& options) {
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    std::string known;
    bool found = false;
    safety::SeparationOptions::eachNumber(
        options, [&](const char* key, double& value, const config::NumberRule&) {
          known += (known.empty() ? "" : ", ") + std::string(key);
          if (equals == std::string::npos || text.substr(0, equals) != key) return;
          value = number(text.substr(equals + 1), "--separation " + text.substr(0, equals));
          found = true;
        });
    if (!found)
      throw UsageError("--separation: found '" + text + "', expected KEY=VALUE with a key of " + known);
  }
  options.validate();
}

/// Sorted names, each once.
std::vector<std::string> clampedNames(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!humanmodel::parsePart(name)) {
      std::string known;
      for (const std::string_view part : humanmodel::partNames())
        known += (known.empty() ? "" : ", ") + std::string(part);
      throw UsageError("--clamped: found '" + name + "', expected parts of the body: " + known);
    }
  const std::set<std::string> parts(names.begin(), names.end());
  return {parts.begin(), parts.end()};
}

}  // namespace

std::vector<std::string> PassArguments::stated() const {
  std::set<std::string> names;
  const std::pair<const char*, const std::string*> options[] = {{"limit", &limit},
                                                                {"reaction_time", &reaction_time},
                                                                {"deceleration", &deceleration},
                                                                {"restart_time", &restart_time},
                                                                {"near", &near},
                                                                {"calibration_error", &calibration_error},
                                                                {"latency", &latency},
                                                                {"contact_limits", &contact_limits},
                                                                {"separation_table", &separation_table}};
  for (const auto& [name, text] : options)
    if (!text->empty()) names.insert(name);
  // The reaction time is T_r, too, unless that is stated.
  if (!reaction_time.empty()) names.insert("separation.reaction_time");
  for (const std::string& text : separation) names.insert("separation." + text.substr(0, text.find('=')));
  if (!clamped.empty()) names.insert("clamped");
  return {names.begin(), names.end()};
}

tune::TuneOptions PassArguments::options() const {
  tune::TuneOptions o;
  o.stated = stated();
  if (!limit.empty()) o.pass.limit = numberWithin(limit, "--limit", 0.0, 10.0, "m");
  if (!reaction_time.empty())
    o.pass.braking.reaction_time = numberWithin(reaction_time, "--reaction-time", 0.0, 10.0, "s");
  if (!deceleration.empty())
    o.pass.braking.deceleration = numberWithin(deceleration, "--deceleration", 1e-3, 1e6, "rad/s^2 or m/s^2");
  if (!near.empty()) o.pass.near = numberWithin(near, "--near", 0.0, 10.0, "m");
  if (!calibration_error.empty())
    o.pass.calibration_error = numberWithin(calibration_error, "--calibration-error", 0.0, 10.0, "m");
  if (!latency.empty()) o.pass.latency = numberWithin(latency, "--latency", 0.0, 10.0, "s");
  o.pass.separation_standard = std::make_shared<const safety::SeparationStandard>(
      safety::loadSeparationStandard(separation_table.empty() ? safety::defaultSeparationTable()
                                                              : std::filesystem::path(separation_table)));
  o.pass.separation = o.pass.separation_standard->options();
  if (!reaction_time.empty() || !o.pass.separation_standard->term("reaction_time"))
    o.pass.separation.reaction_time = o.pass.braking.reaction_time;
  takeSeparation(separation, o.pass.separation);
  o.restart_time = restartTime(restart_time);
  o.pass.clamped = clampedNames(clamped);
  o.pass.contact = std::make_shared<const contact::ContactLimits>(contact::loadContactLimits(
      contact_limits.empty() ? contact::defaultContactLimits() : std::filesystem::path(contact_limits),
      humanmodel::partNames()));
  return o;
}

void PassArguments::add(CLI::App& command) {
  command.add_option("--limit", limit, "clearance limit in m of a moving robot (default: 0, no contact)");
  command.add_option("--reaction-time", reaction_time,
                     "reaction time in s: from the first frame inside the margin until the robot "
                     "decelerates (default: 0.1)");
  command.add_option("--deceleration", deceleration,
                     "rad/s^2 or m/s^2, of every joint on its path (default: 5)");
  command.add_option("--restart-time", restart_time,
                     "restart time in s: from the end of an intrusion until the robot resumes (default: 0)");
  command.add_option(
      "--separation", separation,
      "KEY=VALUE...: terms of the protective distance: stopping_time, intrusion, person_speed, ...");
  command.add_option("--separation-table", separation_table,
                     "table of terms of the protective distance (default: ISO 13855:2010, docs/margins.md)");
  command.add_option("--near", near, "m: approaches below this clearance are listed (default: 0.2)");
  command.add_option(
      "--calibration-error", calibration_error,
      "calibration error in m between recording and robot, part of every uncertainty (default: 0)");
  command.add_option("--latency", latency,
                     "s: how old a person's pose is when it arrives, part of every uncertainty (default: 0)");
  command.add_option("--contact-limits", contact_limits,
                     "table of contact limits (default: ISO/TS 15066:2016, docs/contact.md)");
  command.add_option("--clamped", clamped,
                     "PART...: parts that may be clamped; quasi-static contact limits apply to them");
}

}  // namespace abstand::cli
