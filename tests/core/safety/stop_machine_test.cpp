// Stops: every transition, its reasons, times and log lines.
#include "core/safety/stop_machine.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/base/error.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::safety {
namespace stop_machine_test {

using S = StopState;
using E = StopEvent;

constexpr double kMoving = 1.0;  // rad/s
constexpr std::span<const StopCause> kNone{};

StopState with(StopMachine& m, double t, std::initializer_list<StopReason> reasons, double fastest = kMoving,
               bool reset = false) {
  std::vector<StopCause> causes;
  for (const StopReason r : reasons) causes.push_back({r});
  return m.update(t, causes, fastest, reset);
}

TEST(StopTable, MatchesDocumentedTransitions) {
  // What changes a state; everything else leaves it.
  const std::map<std::pair<S, E>, S> changes{
      {{S::kRunning, E::kSlow}, S::kSlowing},
      {{S::kRunning, E::kProtect}, S::kProtectiveStop},
      {{S::kRunning, E::kEmergency}, S::kEmergencyStop},
      {{S::kSlowing, E::kFree}, S::kRunning},
      {{S::kSlowing, E::kProtect}, S::kProtectiveStop},
      {{S::kSlowing, E::kEmergency}, S::kEmergencyStop},
      {{S::kProtectiveStop, E::kEmergency}, S::kEmergencyStop},
      {{S::kProtectiveStop, E::kStandstill}, S::kWaitingForReset},
      {{S::kProtectiveStop, E::kResume}, S::kRunning},
      {{S::kEmergencyStop, E::kStandstill}, S::kWaitingForReset},
      {{S::kWaitingForReset, E::kEmergency}, S::kEmergencyStop},
      {{S::kWaitingForReset, E::kReset}, S::kRunning},
  };
  for (std::size_t s = 0; s < kStopStates; ++s)
    for (std::size_t e = 0; e < kStopEvents; ++e) {
      const auto state = static_cast<S>(s);
      const auto event = static_cast<E>(e);
      const auto found = changes.find({state, event});
      EXPECT_EQ(nextState(state, event), found == changes.end() ? state : found->second)
          << stateName(state) << ", event " << e;
    }
}

TEST(StopTable, EmergencyEndsOnlyByReset) {
  // All states that can be reached from an emergency without a reset.
  std::set<S> reached{S::kEmergencyStop};
  for (int round = 0; round < 5; ++round)
    for (const S s : std::set<S>(reached))
      for (const E e : {E::kFree, E::kSlow, E::kProtect, E::kEmergency, E::kStandstill, E::kResume})
        reached.insert(nextState(s, e));
  EXPECT_EQ(reached, (std::set<S>{S::kEmergencyStop, S::kWaitingForReset}));
}

TEST(StopMachine, SlowsAndResumes) {
  StopMachine m;
  EXPECT_EQ(m.update(0.0, kNone, kMoving, false), S::kRunning);
  EXPECT_EQ(with(m, 0.1, {StopReason::kSeparation}), S::kSlowing);
  EXPECT_TRUE(m.moving());
  EXPECT_EQ(m.since(), 0.1);
  EXPECT_EQ(m.cause().reason, StopReason::kSeparation);
  EXPECT_EQ(m.update(0.3, kNone, kMoving, false), S::kRunning);
  EXPECT_EQ(m.log().count(), 2u);
}

TEST(StopMachine, ProtectiveStopWaitsForReset) {
  StopMachine m;
  EXPECT_EQ(with(m, 0.0, {StopReason::kDistance}), S::kProtectiveStop);
  EXPECT_FALSE(m.moving());
  EXPECT_EQ(m.update(0.1, kNone, kMoving, true), S::kProtectiveStop) << "it has not stopped yet";
  EXPECT_EQ(m.refusedResets(), 1);
  EXPECT_EQ(m.refusal(), ResetRefusal::kTooEarly);
  EXPECT_EQ(with(m, 0.21, {StopReason::kDistance}, 0.0), S::kWaitingForReset);
  EXPECT_EQ(m.refusal(), ResetRefusal::kNone);
  EXPECT_EQ(with(m, 0.3, {StopReason::kDistance}, 0.0, true), S::kWaitingForReset) << "the cause is there";
  EXPECT_EQ(m.refusal(), ResetRefusal::kCause);
  EXPECT_EQ(m.refusedResets(), 2);
  EXPECT_EQ(m.update(0.4, kNone, 0.0, false), S::kWaitingForReset);
  EXPECT_EQ(m.update(0.5, kNone, 0.0, true), S::kRunning);
  EXPECT_EQ(m.update(0.6, kNone, 0.0, true), S::kRunning);
  EXPECT_EQ(m.refusedResets(), 2) << "who runs has nothing to reset";
}

TEST(StopMachine, BriefRestIsNotStandstill) {
  StopOptions o;
  o.settle = 0.1;
  for (const StopReason reason : {StopReason::kDistance, StopReason::kUser}) {
    StopMachine m(o);
    with(m, 0.0, {reason});
    // Every other cycle at rest, as of a client that sends each posture twice, for a second.
    for (int i = 1; i <= 1000; ++i) {
      const S state = m.update(1e-3 * i, kNone, i % 2 ? 0.0 : kMoving, false);
      ASSERT_EQ(state, reason == StopReason::kUser ? S::kEmergencyStop : S::kProtectiveStop) << i;
    }
    EXPECT_EQ(m.log().count(), 1u) << "one line, not five hundred";
    // It moved last at 1 s.
    EXPECT_FALSE(m.update(1.0995, kNone, 0.0, false) == S::kWaitingForReset);
    EXPECT_EQ(m.update(1.1005, kNone, 0.0, false), S::kWaitingForReset);
    // Who moves while waiting gets no reset before standing again.
    EXPECT_EQ(m.update(1.2, kNone, kMoving, true), S::kWaitingForReset);
    EXPECT_EQ(m.refusal(), ResetRefusal::kTooEarly);
    EXPECT_EQ(m.update(1.25, kNone, 0.0, true), S::kWaitingForReset);
    EXPECT_EQ(m.update(1.31, kNone, 0.0, true), S::kRunning);
  }
}

TEST(StopMachine, IntermittentEmergencyCauseIsOneStop) {
  StopMachine m;
  for (int i = 0; i <= 1000; ++i) {
    const S state =
        i % 50 ? m.update(1e-3 * i, kNone, 0.0, false) : with(m, 1e-3 * i, {StopReason::kUser}, 0.0);
    ASSERT_EQ(state, S::kEmergencyStop) << i;
  }
  EXPECT_EQ(m.log().count(), 1u);
  EXPECT_EQ(m.update(1.101, kNone, 0.0, false), S::kWaitingForReset);
}

TEST(StopMachine, ProtectiveStopMayResumeAutomatically) {
  StopOptions o;
  o.resume_after = 0.5;
  StopMachine m(o);
  EXPECT_EQ(with(m, 0.0, {StopReason::kStaleInput}), S::kProtectiveStop);
  EXPECT_EQ(with(m, 1.0, {StopReason::kStaleInput}, 0.0), S::kProtectiveStop);
  EXPECT_EQ(m.update(1.4, kNone, 0.0, false), S::kProtectiveStop) << "0.4 s are not enough";
  EXPECT_EQ(with(m, 1.45, {StopReason::kStaleInput}, 0.0), S::kProtectiveStop);
  EXPECT_EQ(m.update(1.94, kNone, 0.0, false), S::kProtectiveStop) << "it counts from the last time";
  EXPECT_EQ(m.update(1.96, kNone, 0.0, false), S::kRunning);
}

TEST(StopMachine, EmergencyNeverResumesAutomatically) {
  StopOptions o;
  o.resume_after = 0.1;
  StopMachine m(o);
  EXPECT_EQ(with(m, 0.0, {StopReason::kSeparation, StopReason::kUser, StopReason::kDistance}),
            S::kEmergencyStop);
  EXPECT_EQ(m.cause().reason, StopReason::kUser) << "the highest response is named";
  EXPECT_EQ(with(m, 0.1, {StopReason::kUser}, 0.0), S::kEmergencyStop) << "the button is still down";
  EXPECT_EQ(m.log().count(), 1u) << "and says so once";
  EXPECT_EQ(m.update(0.21, kNone, 0.0, false), S::kWaitingForReset);
  EXPECT_EQ(m.update(99.0, kNone, 0.0, false), S::kWaitingForReset);
  EXPECT_EQ(with(m, 99.1, {StopReason::kUser}, 0.0), S::kEmergencyStop);
  EXPECT_EQ(m.update(99.21, kNone, 0.0, true), S::kRunning) << "stopped, reset, in one cycle";
}

TEST(StopMachine, FollowsPolicy) {
  StopOptions o;
  o.policy.response[static_cast<std::size_t>(StopReason::kLostPerson)] = StopResponse::kSlow;
  o.policy.response[static_cast<std::size_t>(StopReason::kDistance)] = StopResponse::kNone;
  StopMachine m(o);
  EXPECT_EQ(with(m, 0.0, {StopReason::kDistance}), S::kRunning);
  EXPECT_EQ(with(m, 0.1, {StopReason::kDistance, StopReason::kLostPerson}), S::kSlowing);
}

TEST(StopMachine, NonFiniteSpeedIsNotStandstill) {
  StopMachine m;
  with(m, 0.0, {StopReason::kUser});
  EXPECT_EQ(m.update(0.1, kNone, kNaN, false), S::kEmergencyStop);
}

TEST(StopMachine, RejectsBadOptions) {
  StopOptions o;
  o.standstill = kNaN;
  EXPECT_THROW(StopMachine{o}, UsageError);
}

TEST(StopLog, DescribesEntryInOneLine) {
  StopMachine m;
  m.update(10.0, kNone, kMoving, false);
  const StopCause cause{StopReason::kDistance, 0.0434, 0.05, 3, -1};
  m.update(13.25, {&cause, 1}, kMoving, false);
  ASSERT_EQ(m.log().kept(), 1u);
  EXPECT_EQ(describe(m.log().entry(0)),
            "13.25 s: running -> protective stop, distance 0.0434 m, limit 0.05 m, pair 3, after 3.25 s");
  const StopNames names{[](int pair) { return pair == 3 ? "arm/link5 - operator/hand_left" : "?"; }, {}};
  EXPECT_EQ(describe(m.log().entry(0), names),
            "13.25 s: running -> protective stop, distance 0.0434 m, limit 0.05 m, pair arm/link5 - "
            "operator/hand_left, after 3.25 s");
  const StopEntry joint{1.0, S::kRunning, S::kSlowing, {StopReason::kTorque, kNaN, 40.0, -1, 2}, 1.0};
  EXPECT_EQ(describe(joint), "1 s: running -> slowing, torque, limit 40, joint 2, after 1 s");
}

TEST(StopLog, DescribesEndOfStopWithoutItsCause) {
  StopOptions o;
  o.resume_after = 0.5;
  StopMachine m(o);
  const StopCause cause{StopReason::kDistance, 0.0434, 0.05, 3, -1};
  m.update(10.0, {&cause, 1}, 0.0, false);
  m.update(12.0, {&cause, 1}, 0.0, false);
  m.update(12.5, kNone, 0.0, false);
  ASSERT_EQ(m.log().kept(), 2u);
  EXPECT_EQ(
      describe(m.log().entry(1)),
      "12.5 s: protective stop -> running, the cause is gone, the robot resumes automatically after 2.5 s; "
      "the reason was distance, pair 3");

  StopMachine emergency;
  with(emergency, 1.0, {StopReason::kUser}, 0.0);
  for (const double t : {1.2, 1.4}) emergency.update(t, kNone, 0.0, false);
  emergency.update(4.0, kNone, 0.0, true);
  ASSERT_EQ(emergency.log().kept(), 3u);
  EXPECT_NE(
      describe(emergency.log().entry(1)).find("the robot is at standstill and waits for a reset after "),
      std::string::npos);
  EXPECT_NE(describe(emergency.log().entry(2)).find("reset by a person, the robot resumes after "),
            std::string::npos);
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_EQ(describe(emergency.log().entry(i)).find("limit"), std::string::npos);
}

TEST(StopLog, KeepsLastEntriesAndCountsAll) {
  StopMachine m;
  for (int i = 0; i < 1000; ++i) {
    if (i % 2)
      m.update(i, kNone, kMoving, false);
    else
      with(m, i, {StopReason::kSeparation});
  }
  EXPECT_EQ(m.log().count(), 1000u);
  ASSERT_EQ(m.log().kept(), StopLog::kKept);
  EXPECT_EQ(m.log().entry(0).t, 1000.0 - StopLog::kKept);
  EXPECT_EQ(m.log().entry(StopLog::kKept - 1).t, 999.0);
}

TEST(StopMachine, AllocatesNothing) {
  StopMachine m;
  const StopCause slow{StopReason::kSeparation}, user{StopReason::kUser};
  const testing::NoAlloc guard;
  for (int i = 0; i < 1000; ++i) {
    m.update(i, i % 3 ? std::span<const StopCause>(&slow, 1) : kNone, kMoving, false);
    if (i % 100 == 0) m.update(i, {&user, 1}, 0.0, true);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(StopReason, NamesAreDistinct) {
  std::set<std::string_view> names, keys;
  for (std::size_t i = 0; i < kStopReasons; ++i) {
    names.insert(reasonName(static_cast<StopReason>(i)));
    keys.insert(reasonKey(static_cast<StopReason>(i)));
  }
  EXPECT_EQ(names.size(), kStopReasons);
  EXPECT_EQ(keys.size(), kStopReasons);
  for (const StopResponse r :
       {StopResponse::kNone, StopResponse::kSlow, StopResponse::kProtective, StopResponse::kEmergency})
    EXPECT_EQ(parseResponse(responseName(r)), r);
  EXPECT_EQ(parseResponse("halt"), std::nullopt);
}

}  // namespace stop_machine_test
}  // namespace abstand::safety
