// Running, slowing, stopped and waiting: the state of a robot beside a person.
#pragma once

#include <span>

#include "core/config/number_rule.hpp"
#include "core/safety/stop_log.hpp"

namespace abstand::safety {

/// What can happen to the machine in one cycle. kSlow, kProtect and kEmergency: the highest response that a
/// present cause asks for; kFree: none asks for anything; kStandstill: it has stopped and has to be reset;
/// kResume: it has stopped, the causes are gone, and it may go on by itself; kReset: a person lets it go on.
enum class StopEvent : std::uint8_t { kFree, kSlow, kProtect, kEmergency, kStandstill, kResume, kReset };
inline constexpr std::size_t kStopEvents = 7;

/// The table of transitions; every state has an answer to every event.
StopState nextState(StopState state, StopEvent event);

/// Why a reset was not heeded: a cause asks for a stop, or it has not stood for StopOptions::settle yet.
enum class ResetRefusal : std::uint8_t { kNone, kCause, kTooEarly };
std::string_view refusalName(ResetRefusal refusal);

struct StopOptions {
  static constexpr const char* kName = "stop";
  /// s. A protective stop ends by itself when no cause asked for it for so long [ISO/TS 15066 5.5.4 lets
  /// motion go on when the separation is there again]. Infinity: it waits for a reset at standstill. An
  /// emergency stop always does.
  double resume_after{kInfinity};
  /// rad/s or m/s: with no joint faster, the robot stands.
  double standstill{1e-3};
  /// s. For so long without a break it has to stand, and no cause to ask for an emergency stop, before a stop
  /// waits for its reset, and before the reset: a moment of rest at a turning point is no standstill, and who
  /// ignores an emergency stop stays in one.
  double settle{0.1};
  /// Share of the planned speed while a cause asks to slow down that names no speed itself.
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

/// One cycle's update() takes all present causes; the highest response wins, the first of equal ones is
/// logged. No allocation, no throw; one thread.
class StopMachine {
 public:
  explicit StopMachine(const StopOptions& options = {});  ///< throws UsageError

  /// @param t        s, not falling
  /// @param causes   that hold in this cycle
  /// @param fastest  rad/s or m/s, the largest joint velocity, of its size; not finite: it does not stand
  /// @param reset    a person asks to go on. Heeded when waiting, standing, and no cause asks for a stop; in
  ///                 any other stop it is refused. It is an edge: pass true in one cycle.
  StopState update(double t, std::span<const StopCause> causes, double fastest, bool reset) noexcept;

  StopState state() const { return state_; }
  double since() const { return since_; }  ///< s, when this state began
  /// What led to the present state; in kRunning: to the last one before.
  const StopCause& cause() const { return cause_; }
  /// Motion is allowed, perhaps slowly.
  bool moving() const { return state_ == StopState::kRunning || state_ == StopState::kSlowing; }
  const StopLog& log() const { return log_; }
  long refusedResets() const { return refused_resets_; }      ///< ever
  ResetRefusal refusal() const { return refusal_; }           ///< of the last update()
  ResetRefusal lastRefusal() const { return last_refusal_; }  ///< of the last reset that was refused

 private:
  void go(StopState to, double t) noexcept;
  void takeReset(double t, bool asks_stop, bool settled) noexcept;

  StopOptions options_;
  StopState state_{StopState::kRunning};
  StopCause cause_;
  double since_{0.0};  ///< s
  double asked_{0.0};  ///< s, when a protective stop was last asked for; likewise:
  double emergency_asked_{-kInfinity}, moved_{0.0};
  bool started_{false};
  long refused_resets_{0};
  ResetRefusal refusal_{ResetRefusal::kNone}, last_refusal_{ResetRefusal::kNone};
  StopLog log_;
};

}  // namespace abstand::safety
