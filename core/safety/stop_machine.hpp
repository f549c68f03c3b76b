// State machine of a robot near a person: running, slowing, stopped, waiting for a reset.
#pragma once

#include <span>

#include "core/config/number_rule.hpp"
#include "core/safety/stop_log.hpp"

namespace abstand::safety {

/// Events of one cycle. kSlow, kProtect and kEmergency: the highest response that a present cause requires;
/// kFree: no cause; kStandstill: stopped, needs a reset; kResume: stopped, causes gone, may resume by itself;
/// kReset: a person releases it.
enum class StopEvent : std::uint8_t { kFree, kSlow, kProtect, kEmergency, kStandstill, kResume, kReset };
inline constexpr std::size_t kStopEvents = 7;

/// Transition table; defined for every state and event.
StopState nextState(StopState state, StopEvent event);

/// Why a reset was refused: a cause requires a stop, or the robot has stood still for less than
/// StopOptions::settle.
enum class ResetRefusal : std::uint8_t { kNone, kCause, kTooEarly };
std::string_view refusalName(ResetRefusal refusal);

struct StopOptions {
  static constexpr const char* kName = "stop";
  /// s. A protective stop ends by itself after this time without a cause [ISO/TS 15066:2016, 5.5.4 allows
  /// motion to resume when the separation is restored]. Infinity: it waits for a reset at standstill. An
  /// emergency stop always does.
  double resume_after{kInfinity};
  /// rad/s or m/s: the robot stands still if no joint is faster.
  double standstill{1e-3};
  /// s. Time of uninterrupted standstill without an emergency cause that a stop needs before it waits for its
  /// reset, and before the reset is accepted: the rest at a turning point is not a standstill, and ignoring
  /// an emergency stop does not end it.
  double settle{0.1};
  /// Share of the planned speed while the cause of slowing states no speed.
  double slow_to{0.25};
  StopPolicy policy;

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("resume_after", o.resume_after, config::NumberRule{0.0, kInfinity, "s"});
    visit("standstill", o.standstill, config::NumberRule{0.0, 1.0, "rad/s or m/s"});
    visit("settle", o.settle, config::NumberRule{0.0, 60.0, "s"});
    visit("slow_to", o.slow_to, config::NumberRule{0.0, 1.0});
  }
  void validate() const { config::requireNumbers(*this); }  ///< throws UsageError
};

/// update() receives all present causes of one cycle; the highest response wins, and the first of equal ones
/// is logged. No allocation, no throw; one thread.
class StopMachine {
 public:
  explicit StopMachine(const StopOptions& options = {});  ///< throws UsageError

  /// @param t        s, never decreasing
  /// @param causes   present in this cycle
  /// @param fastest  rad/s or m/s, largest absolute joint velocity; not finite: not at standstill
  /// @param reset    a person requests to continue. Accepted when waiting, at standstill, and without a
  ///                 cause for a stop; refused in any other stop. Edge-triggered: pass true in one cycle.
  StopState update(double t, std::span<const StopCause> causes, double fastest, bool reset) noexcept;

  /// Replaces the options. State, cause and log stay; a stop that is active now ends only by a reset,
  /// whatever `resume_after` is. Throws UsageError before anything changes; valid options never throw.
  void setOptions(const StopOptions& options);

  StopState state() const { return state_; }
  double since() const { return since_; }  ///< s, start of this state
  /// Cause of the present state; in kRunning: of the state before.
  const StopCause& cause() const { return cause_; }
  /// True if motion is allowed, possibly at reduced speed.
  bool moving() const { return state_ == StopState::kRunning || state_ == StopState::kSlowing; }
  const StopLog& log() const { return log_; }
  long refusedResets() const { return refused_resets_; }      ///< total number
  ResetRefusal refusal() const { return refusal_; }           ///< of the last update()
  ResetRefusal lastRefusal() const { return last_refusal_; }  ///< of the last refused reset

 private:
  void go(StopState to, double t) noexcept;
  void takeReset(double t, bool asks_stop, bool settled) noexcept;

  StopOptions options_;
  StopState state_{StopState::kRunning};
  StopCause cause_;
  double since_{0.0};  ///< s
  double asked_{0.0};  ///< s, when a protective stop was last required; likewise:
  double emergency_asked_{-kInfinity}, moved_{0.0};
  bool started_{false};
  bool needs_reset_{false};  ///< the options were replaced during this stop
  long refused_resets_{0};
  ResetRefusal refusal_{ResetRefusal::kNone}, last_refusal_{ResetRefusal::kNone};
  StopLog log_;
};

}  // namespace abstand::safety
