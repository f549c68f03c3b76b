#include "core/safety/stop_log.hpp"

#include <cmath>
#include <cstdio>

namespace abstand::safety {
namespace {

constexpr std::array<std::string_view, kStopStates> kStateNames{"running", "slowing", "protective stop",
                                                                "emergency stop", "waiting for reset"};

const char* unitOf(const StopCause& cause) {
  switch (cause.reason) {
    case StopReason::kDistance:
    case StopReason::kBraking:
      return " m";
    case StopReason::kSeparation:
    case StopReason::kSpeedBound:
      return " m/s";
    case StopReason::kEnergy:
      return " J";
    case StopReason::kStaleInput:
    case StopReason::kLostPerson:
    case StopReason::kLostLink:
      return " s";
    case StopReason::kTorque:
    case StopReason::kJointSpeed:
    case StopReason::kUser:
      break;
  }
  return "";  // the joint's own unit
}

std::string shortNumber(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  // The decimal separator is a point in every locale.
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';
  return text;
}

std::string named(const char* what, int index, const std::function<std::string(int)>& name) {
  return std::string(", ") + what + " " + (name ? name(index) : std::to_string(index));
}

/// The pair or joint that a cause refers to; empty if none.
std::string about(const StopCause& cause, const StopNames& names) {
  std::string s;
  if (cause.pair >= 0) s += named("pair", cause.pair, names.pair);
  if (cause.joint >= 0) s += named("joint", cause.joint, names.joint);
  return s;
}

/// Text of a change to a lower state or to standstill. The cause's values are those of the time when it
/// arose.
std::string relief(const StopEntry& e) {
  if (e.to == StopState::kWaitingForReset) return "the robot is at standstill and waits for a reset";
  if (e.from == StopState::kWaitingForReset) return "reset by a person, the robot resumes";
  if (e.from == StopState::kSlowing) return "the cause is gone, full speed again";
  return "the cause is gone, the robot resumes automatically";
}

}  // namespace

std::string_view stateName(StopState state) { return kStateNames[static_cast<std::size_t>(state)]; }

std::string describe(const StopEntry& e, const StopNames& names) {
  std::string s = shortNumber(e.t) + " s: " + std::string(stateName(e.from)) + " -> " +
                  std::string(stateName(e.to)) + ", ";
  if (e.to == StopState::kRunning || e.to == StopState::kWaitingForReset)
    return s + relief(e) + " after " + shortNumber(e.lasted) + " s; the reason was " +
           std::string(reasonName(e.cause.reason)) + about(e.cause, names);
  s += reasonName(e.cause.reason);
  if (!std::isnan(e.cause.value)) s += " " + shortNumber(e.cause.value) + unitOf(e.cause);
  if (!std::isnan(e.cause.limit)) s += ", limit " + shortNumber(e.cause.limit) + unitOf(e.cause);
  return s + about(e.cause, names) + ", after " + shortNumber(e.lasted) + " s";
}

}  // namespace abstand::safety
