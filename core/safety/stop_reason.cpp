#include "core/safety/stop_reason.hpp"

namespace abstand::safety {
namespace {

struct ReasonText {
  std::string_view name, key;
};
constexpr std::array<ReasonText, kStopReasons> kReasonTexts{{{"distance", "distance"},
                                                             {"separation", "separation"},
                                                             {"energy", "energy"},
                                                             {"stale input", "stale_input"},
                                                             {"lost person", "lost_person"},
                                                             {"lost link", "lost_link"},
                                                             {"torque", "torque"},
                                                             {"joint speed", "joint_speed"},
                                                             {"speed bound", "speed_bound"},
                                                             {"user", "user"},
                                                             {"braking path", "braking"}}};
constexpr std::array<std::string_view, kStopResponses> kResponseNames{"none", "slow", "protective",
                                                                      "emergency"};

}  // namespace

std::string_view reasonName(StopReason reason) { return kReasonTexts[static_cast<std::size_t>(reason)].name; }
std::string_view reasonKey(StopReason reason) { return kReasonTexts[static_cast<std::size_t>(reason)].key; }
std::string_view responseName(StopResponse response) {
  return kResponseNames[static_cast<std::size_t>(response)];
}

std::optional<StopResponse> parseResponse(std::string_view text) {
  for (std::size_t i = 0; i < kStopResponses; ++i)
    if (text == kResponseNames[i]) return static_cast<StopResponse>(i);
  return std::nullopt;
}

std::vector<std::string> responseNames() { return {kResponseNames.begin(), kResponseNames.end()}; }

}  // namespace abstand::safety
