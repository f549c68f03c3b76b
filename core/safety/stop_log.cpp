#include "core/safety/stop_log.hpp"

#include <cmath>
#include <cstdio>

namespace abstand {
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
  // The decimal point is a point in every locale.
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';
  return text;
}

std::string named(const char* what, int index, const std::function<std::string(int)>& name) {
  return std::string(", ") + what + " " + (name ? name(index) : std::to_string(index));
}

}  // namespace

std::string_view stateName(StopState state) { return kStateNames[static_cast<std::size_t>(state)]; }

std::string describe(const StopEntry& e, const StopNames& names) {
  std::string s = shortNumber(e.t) + " s: " + std::string(stateName(e.from)) + " -> " +
                  std::string(stateName(e.to)) + ", " + std::string(reasonName(e.cause.reason));
  if (!std::isnan(e.cause.value)) s += " " + shortNumber(e.cause.value) + unitOf(e.cause);
  if (!std::isnan(e.cause.limit)) s += ", limit " + shortNumber(e.cause.limit) + unitOf(e.cause);
  if (e.cause.pair >= 0) s += named("pair", e.cause.pair, names.pair);
  if (e.cause.joint >= 0) s += named("joint", e.cause.joint, names.joint);
  return s + ", after " + shortNumber(e.lasted) + " s";
}

}  // namespace abstand
