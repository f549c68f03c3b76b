#include "core/control/reaction_change.hpp"

#include <type_traits>

#include "core/base/error.hpp"

namespace abstand::control {
namespace {

template <class Options>
concept WithLists = requires(Options& o) {
  Options::eachList(o, [](const char*, config::JointNumbers&, const config::NumberRule&) {});
};

/// A law that decides how its robot is driven, or what it holds.
template <class Options>
constexpr bool kRestarts =
    std::is_same_v<Options, AdmittanceOptions> || std::is_same_v<Options, GodObjectOptions>;

template <class Visit>
void eachLaw(ReactionDescription& r, Visit visit) {
  visit(r.torque);
  visit(r.repulsion);
  visit(r.proxy);
  visit(r.admittance);
  visit(r.speed);
  visit(r.braking);
}

template <class Options>
std::string keyOf(const char* name) {
  return std::string(Options::kName) + "." + name;
}

/// Applies and checks the numbers of one law, and counts them.
class ChangedNumbers {
 public:
  ChangedNumbers(const ReactionChange& change, int dof) : change_(change), dof_(dof) {}

  template <class Options>
  void apply(Options& options) {
    Options::eachNumber(options, [&](const char* name, double& value, const config::NumberRule& rule) {
      const config::JointNumbers* const wanted = find(keyOf<Options>(name));
      if (!wanted) return;
      value = config::forJoints(Options::kName, name, *wanted, 1, rule).front();
    });
    if constexpr (WithLists<Options>)
      Options::eachList(options,
                        [&](const char* name, config::JointNumbers& numbers, const config::NumberRule& rule) {
                          const config::JointNumbers* const wanted = find(keyOf<Options>(name));
                          if (!wanted) return;
                          config::forJoints(Options::kName, name, *wanted, dof_, rule);
                          numbers = *wanted;
                        });
  }
  void requireAllKnown() const {
    for (const auto& [key, value] : change_.numbers)
      if (!known_.contains(key)) throw UsageError("found '" + key + "', expected a number of a law");
  }

 private:
  const config::JointNumbers* find(const std::string& key) {
    const auto it = change_.numbers.find(key);
    if (it == change_.numbers.end()) return nullptr;
    known_[key] = true;
    return &it->second;
  }

  const ReactionChange& change_;
  int dof_;
  std::map<std::string, bool> known_;
};

/// Adds the numbers of one law, with and without the change.
template <class Options>
void addLawNumbers(const Options& scene, const ReactionChange& change, std::vector<LawNumber>& numbers) {
  const auto add = [&](const char* name, const config::JointNumbers& value, const config::NumberRule& rule,
                       bool each_joint) {
    const auto it = change.numbers.find(keyOf<Options>(name));
    numbers.push_back(
        {keyOf<Options>(name), it == change.numbers.end() ? value : it->second, value, rule, each_joint});
  };
  Options::eachNumber(scene, [&](const char* name, double value, const config::NumberRule& rule) {
    add(name, {value}, rule, false);
  });
  if constexpr (WithLists<Options>)
    Options::eachList(scene, [&](const char* name, const config::JointNumbers& value,
                                 const config::NumberRule& rule) { add(name, value, rule, true); });
}

std::optional<safety::StopReason> reasonOf(const std::string& key) {
  for (std::size_t i = 0; i < safety::kStopReasons; ++i)
    if (safety::reasonKey(static_cast<safety::StopReason>(i)) == key)
      return static_cast<safety::StopReason>(i);
  return std::nullopt;
}

void applyResponses(const ReactionChange& change, safety::StopPolicy& policy) {
  for (const auto& [key, response] : change.responses) {
    const auto reason = reasonOf(key);
    if (!reason) throw UsageError("found '" + key + "', expected a reason of a stop");
    policy.response[static_cast<std::size_t>(*reason)] = response;
  }
}

std::vector<StopChoice> stopChoices(const safety::StopPolicy& scene, const ReactionChange& change) {
  std::vector<StopChoice> choices;
  for (std::size_t i = 0; i < safety::kStopReasons; ++i) {
    const auto reason = static_cast<safety::StopReason>(i);
    const auto wanted = change.responses.find(std::string(safety::reasonKey(reason)));
    choices.push_back(
        {reason, wanted == change.responses.end() ? scene.of(reason) : wanted->second, scene.of(reason)});
  }
  return choices;
}

}  // namespace

ReactionDescription changedReaction(const ReactionDescription& scene, const ReactionChange& change, int dof) {
  ReactionDescription reaction = scene;
  ChangedNumbers numbers(change, dof);
  std::size_t switches = 0;
  eachLaw(reaction, [&](auto& law) {
    using Options = typename std::remove_reference_t<decltype(law)>::value_type;
    Options options = law.value_or(Options{});
    numbers.apply(options);
    const auto wanted = change.laws.find(Options::kName);
    if (wanted != change.laws.end()) ++switches;
    const bool on = wanted == change.laws.end() ? law.has_value() : wanted->second;
    if (on)
      law = options;
    else
      law.reset();
  });
  if (switches != change.laws.size()) throw UsageError("found an unknown law to switch");
  numbers.apply(reaction.hold);
  numbers.apply(reaction.watch);
  numbers.apply(reaction.stop);
  numbers.requireAllKnown();
  applyResponses(change, reaction.stop.policy);
  if (reaction.repulsion) reaction.repulsion->validate();
  return reaction;
}

std::vector<LawState> lawStates(const ReactionDescription& scene, const ReactionChange& change) {
  std::vector<LawState> laws;
  ReactionDescription known = scene;
  eachLaw(known, [&](const auto& law) {
    using Options = typename std::remove_reference_t<decltype(law)>::value_type;
    LawState& state = laws.emplace_back();
    state.name = Options::kName;
    state.scene_on = law.has_value();
    const auto wanted = change.laws.find(state.name);
    state.on = wanted == change.laws.end() ? state.scene_on : wanted->second;
    state.switchable = true;
    state.restarts = kRestarts<Options>;
    addLawNumbers(law.value_or(Options{}), change, state.numbers);
  });
  LawState& hold = laws.emplace_back();
  hold.name = HoldOptions::kName;
  addLawNumbers(scene.hold, change, hold.numbers);
  LawState& stop = laws.emplace_back();
  stop.name = WatchOptions::kName;
  addLawNumbers(scene.watch, change, stop.numbers);
  addLawNumbers(scene.stop, change, stop.numbers);
  stop.responses = stopChoices(scene.stop.policy, change);
  return laws;
}

}  // namespace abstand::control
