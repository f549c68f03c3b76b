#include "core/safety/stop_machine.hpp"

namespace abstand::safety {
namespace {

using S = StopState;
constexpr std::array<std::array<StopState, kStopEvents>, kStopStates> kTable{{
    // free, slow, protect, emergency, standstill, resume, reset
    {S::kRunning, S::kSlowing, S::kProtectiveStop, S::kEmergencyStop, S::kRunning, S::kRunning, S::kRunning},
    {S::kRunning, S::kSlowing, S::kProtectiveStop, S::kEmergencyStop, S::kSlowing, S::kSlowing, S::kSlowing},
    {S::kProtectiveStop, S::kProtectiveStop, S::kProtectiveStop, S::kEmergencyStop, S::kWaitingForReset,
     S::kRunning, S::kProtectiveStop},
    {S::kEmergencyStop, S::kEmergencyStop, S::kEmergencyStop, S::kEmergencyStop, S::kWaitingForReset,
     S::kEmergencyStop, S::kEmergencyStop},
    {S::kWaitingForReset, S::kWaitingForReset, S::kWaitingForReset, S::kEmergencyStop, S::kWaitingForReset,
     S::kWaitingForReset, S::kRunning},
}};

constexpr std::array<StopEvent, kStopResponses> kEventOf{StopEvent::kFree, StopEvent::kSlow,
                                                         StopEvent::kProtect, StopEvent::kEmergency};

}  // namespace

std::string_view refusalName(ResetRefusal refusal) {
  constexpr std::array<std::string_view, 3> kNames{"", "a cause asks for a stop",
                                                   "the robot is not at standstill yet"};
  return kNames[static_cast<std::size_t>(refusal)];
}

StopState nextState(StopState state, StopEvent event) {
  return kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
}

StopMachine::StopMachine(const StopOptions& options) : options_(options) { options.validate(); }

void StopMachine::setOptions(const StopOptions& options) {
  options.validate();
  options_ = options;
  needs_reset_ = !moving();
}

void StopMachine::go(StopState to, double t) noexcept {
  if (to == state_) return;
  log_.add({t, state_, to, cause_, t - since_});
  state_ = to;
  since_ = t;
  if (moving()) needs_reset_ = false;
}

StopState StopMachine::update(double t, std::span<const StopCause> causes, double fastest,
                              bool reset) noexcept {
  if (!started_) since_ = asked_ = moved_ = t;
  started_ = true;

  StopResponse response = StopResponse::kNone;
  const StopCause* first = nullptr;
  for (const StopCause& cause : causes) {
    const StopResponse r = options_.policy.of(cause.reason);
    if (r > response) response = r, first = &cause;
  }
  const bool asks_stop = response >= StopResponse::kProtective;
  if (asks_stop) asked_ = t;
  if (response >= StopResponse::kEmergency) emergency_asked_ = t;

  const StopState next = nextState(state_, kEventOf[static_cast<std::size_t>(response)]);
  // The cause of a transition, or of a state as long as it lasts.
  if (next != state_ && first) cause_ = *first;
  go(next, t);

  const bool stands = fastest <= options_.standstill;
  if (!stands) moved_ = t;
  const bool settled = stands && t - moved_ >= options_.settle;
  const bool resumes = options_.resume_after < kInfinity && !needs_reset_;
  if (state_ == S::kProtectiveStop && stands && resumes) {
    if (!asks_stop && t - asked_ >= options_.resume_after) go(nextState(state_, StopEvent::kResume), t);
  } else if (settled && (state_ == S::kProtectiveStop ||
                         (state_ == S::kEmergencyStop && t - emergency_asked_ >= options_.settle))) {
    // An emergency stop lasts as long as its cause, even at standstill.
    go(nextState(state_, StopEvent::kStandstill), t);
  }
  refusal_ = ResetRefusal::kNone;
  if (reset && !moving()) takeReset(t, asks_stop, settled);
  return state_;
}

void StopMachine::takeReset(double t, bool asks_stop, bool settled) noexcept {
  if (asks_stop)
    refusal_ = ResetRefusal::kCause;
  else if (!settled || state_ != S::kWaitingForReset)
    refusal_ = ResetRefusal::kTooEarly;
  else
    return go(nextState(state_, StopEvent::kReset), t);
  ++refused_resets_;
  last_refusal_ = refusal_;
}

}  // namespace abstand::safety
