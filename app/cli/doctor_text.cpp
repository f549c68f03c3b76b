#include "app/cli/doctor_text.hpp"

#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {
namespace {

constexpr double kMm = 1e3;
/// Longer lists are truncated in the text; the JSON has all entries.
constexpr std::size_t kMaxLines = 10;

}  // namespace

nlohmann::ordered_json doctorJson(const tracking::DoctorReport& r) {
  nlohmann::ordered_json bones = nlohmann::ordered_json::array();
  nlohmann::ordered_json joints = bones, jumps = bones, filters = bones;
  for (const auto& b : r.bones)
    bones.push_back({{"part", b.part}, {"length", b.length}, {"spread", b.spread}, {"drift", b.drift}});
  for (const auto& j : r.joints)
    joints.push_back({{"joint", j.joint},
                      {"missing", j.missing},
                      {"inferred", j.inferred},
                      {"longest_gap", j.longest_gap},
                      {"jitter", numberOrNull(j.jitter)},
                      {"speed", j.speed}});
  for (const auto& j : r.jumps) jumps.push_back({{"joint", j.joint}, {"t", j.t}, {"speed", j.speed}});
  for (const auto& f : r.filters)
    filters.push_back({{"name", f.name},
                       {"delay", f.delay},
                       {"delay_at_rest", f.delay_at_rest},
                       {"jitter_before", numberOrNull(f.jitter_before)},
                       {"jitter_after", numberOrNull(f.jitter_after)},
                       {"moved", f.moved}});
  return {{"step", r.step},
          {"longest_step", r.longest_step},
          {"uneven_steps", r.uneven_steps},
          {"bones", bones},
          {"joints", joints},
          {"swaps", r.swaps},
          {"jumps", jumps},
          {"filters", filters},
          {"fillable", r.fill.filled},
          {"unfillable", r.fill.left}};
}

std::string doctorText(const tracking::DoctorReport& r) {
  std::string text = format("steps: median %.1f ms, longest %.1f ms, %zu more than 10 %% off\n", r.step * kMm,
                            r.longest_step * kMm, r.uneven_steps);
  text += "bone                 length   spread    drift (mm)\n";
  for (const auto& b : r.bones)
    text +=
        format("  %-16s %8.1f %8.1f %8.1f\n", b.part.c_str(), b.length * kMm, b.spread * kMm, b.drift * kMm);
  text += "joint              jitter mm  missing inferred  longest gap ms\n";
  for (const auto& j : r.joints)
    text += format("  %-16s %9.2f %8zu %8zu %15.0f\n", j.joint.c_str(), j.jitter * kMm, j.missing, j.inferred,
                   j.longest_gap * kMm);
  text += format("left and right swapped: %zu times", r.swaps.size());
  for (std::size_t i = 0; i < r.swaps.size() && i < kMaxLines; ++i)
    text += format("%s%.3f s", i == 0 ? ": " : ", ", r.swaps[i]);
  text += format("\njumps beyond %.0f m/s: %zu\n", tracking::kFastestJoint, r.jumps.size());
  for (std::size_t i = 0; i < r.jumps.size() && i < kMaxLines; ++i)
    text += format("  %-16s at %.3f s: %.1f m/s\n", r.jumps[i].joint.c_str(), r.jumps[i].t, r.jumps[i].speed);
  text += "filter                    delay ms (at rest)  jitter mm before  after  99 % displacement mm\n";
  for (const auto& f : r.filters)
    text += format("  %-22s %8.1f (%6.1f) %18.2f %7.2f %10.1f\n", f.name.c_str(), f.delay * kMm,
                   f.delay_at_rest * kMm, f.jitter_before * kMm, f.jitter_after * kMm, f.moved * kMm);
  return text + format("gaps up to %.0f ms: %zu positions can be filled, %zu cannot\n",
                       tracking::kShortGap * kMm, r.fill.filled, r.fill.left);
}

nlohmann::ordered_json predictionJson(const std::vector<tracking::PredictionTrial>& trials,
                                      const safety::MotionBounds& bounds) {
  auto list = nlohmann::ordered_json::array();
  for (const tracking::PredictionTrial& t : trials)
    list.push_back({{"ahead", t.ahead},
                    {"places", t.places},
                    {"still_mean", t.still_mean},
                    {"still_p95", t.still_p95},
                    {"guess_mean", t.guess_mean},
                    {"guess_p95", t.guess_p95},
                    {"guess_most", t.guess_max},
                    {"outside", t.outside},
                    {"speed_needed", t.speed_needed}});
  return {{"person_speed", numberOrNull(bounds.speed)},
          {"person_acceleration", numberOrNull(bounds.acceleration)},
          {"trials", list}};
}

std::string predictionText(const std::vector<tracking::PredictionTrial>& trials,
                           const safety::MotionBounds& bounds) {
  std::string text =
      "ahead     error if held      prediction error (mean, 95 %, max) beyond the bounds   bound needed\n";
  for (const tracking::PredictionTrial& t : trials)
    text += format("%4.0f ms %6.0f %6.0f mm %9.0f %6.0f %6.0f mm %12zu of %zu %10.1f m/s\n", t.ahead * kMm,
                   t.still_mean * kMm, t.still_p95 * kMm, t.guess_mean * kMm, t.guess_p95 * kMm,
                   t.guess_max * kMm, t.outside, t.places, t.speed_needed);
  return text + format("bounds: %.3g m/s, %.3g m/s^2\n", bounds.speed, bounds.acceleration);
}

}  // namespace abstand::cli
