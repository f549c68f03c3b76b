#include "core/control/reaction_reader.hpp"

#include <cmath>

#include "core/base/number.hpp"

namespace abstand::control {
namespace {

const std::vector<std::string> kCuts{"each", "together"};  // of torques, and of joints that brake

template <class Options>
concept HasLists = requires(Options& o) {
  Options::eachList(o, [](const char*, config::JointNumbers&, const config::NumberRule&) {});
};

template <class Options>
void addKeys(std::vector<std::string>& keys) {
  Options o;
  Options::eachNumber(o, [&](const char* name, double, const config::NumberRule&) { keys.push_back(name); });
  if constexpr (HasLists<Options>)
    Options::eachList(
        o, [&](const char* name, config::JointNumbers&, const config::NumberRule&) { keys.push_back(name); });
}

template <class Options>
std::vector<std::string> keysOf(std::vector<std::string> more = {}) {
  addKeys<Options>(more);
  return more;
}

config::YamlRange rangeOf(const config::NumberRule& rule) {
  return {rule.min, rule.max, rule.unit, rule.above};
}

template <class Options>
void readNumbers(const config::YamlFields& fields, Options& options) {
  Options::eachNumber(options, [&](const char* name, double& value, const config::NumberRule& rule) {
    value = fields.number(name, rangeOf(rule)).value_or(value);
  });
  if constexpr (HasLists<Options>)
    Options::eachList(
        options, [&](const char* name, config::JointNumbers& numbers, const config::NumberRule& rule) {
          const config::YamlNode* const node = fields.find(name);
          if (!node) return;
          if (node->kind != config::YamlNode::Kind::kList) {
            numbers = {*fields.number(name, rangeOf(rule))};
            return;
          }
          numbers.clear();
          for (const config::YamlNode& item : node->items)
            numbers.push_back(
                config::yamlNumber(item, fields.file(), "`" + std::string(name) + "`", rangeOf(rule)));
          if (numbers.empty())
            throw ParseError(fields.pos(*node), "found an empty list for `" + std::string(name) +
                                                    "`, expected a number, or one for each joint");
        });
}

template <class Options>
std::optional<Options> law(const config::YamlFields& parent) {
  const config::YamlNode* const node = parent.find(Options::kName);
  if (!node) return std::nullopt;
  Options options;
  readNumbers(
      config::YamlFields(*node, parent.file(), "`" + std::string(Options::kName) + "`", keysOf<Options>()),
      options);
  return options;
}

std::optional<TorqueLimitOptions> torque(const config::YamlFields& parent) {
  const config::YamlNode* const node = parent.find("torque");
  if (!node) return std::nullopt;
  TorqueLimitOptions options;
  const config::YamlFields fields(*node, parent.file(), "`torque`", keysOf<TorqueLimitOptions>({"cut"}));
  readNumbers(fields, options);
  if (fields.choice("cut", kCuts).value_or("together") == "each") options.cut = TorqueCut::kEach;
  return options;
}

std::optional<BrakingLawOptions> braking(const config::YamlFields& parent) {
  const config::YamlNode* const node = parent.find("braking");
  if (!node) return std::nullopt;
  BrakingLawOptions options;
  const config::YamlFields fields(*node, parent.file(), "`braking`", keysOf<BrakingLawOptions>({"joints"}));
  readNumbers(fields, options);
  if (fields.choice("joints", kCuts).value_or("each") == "together")
    options.path.kind = safety::BrakingKind::kTogether;
  return options;
}

void policy(const config::YamlFields& fields, safety::StopPolicy& policy) {
  const config::YamlNode* const node = fields.find("on");
  if (!node) return;
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < safety::kStopReasons; ++i)
    reasons.emplace_back(safety::reasonKey(static_cast<safety::StopReason>(i)));
  const config::YamlFields on(*node, fields.file(), "`on`", reasons);
  for (std::size_t i = 0; i < safety::kStopReasons; ++i)
    if (const auto text = on.choice(reasons[i], safety::responseNames()))
      policy.response[i] = *safety::parseResponse(*text);
}

class Lines {
 public:
  explicit Lines(const std::string& indent) : indent_(indent) {}
  void open(const char* name) {
    text_ += indent_ + name + ": {";
    first_ = true;
  }
  void close() { text_ += "}\n"; }
  void item(std::string_view name, const std::string& value) {
    text_ += (first_ ? "" : ", ") + std::string(name) + ": " + value;
    first_ = false;
  }
  template <class Options>
  void numbers(const Options& options) {
    Options::eachNumber(options, [&](const char* name, double value, const config::NumberRule&) {
      if (std::isfinite(value)) item(name, formatDouble(value));
    });
    if constexpr (HasLists<Options>)
      Options::eachList(options,
                        [&](const char* name, const config::JointNumbers& list, const config::NumberRule&) {
                          std::string s;
                          for (const double x : list) s += (s.empty() ? "" : ", ") + formatDouble(x);
                          if (!list.empty() && std::isfinite(list.front()))
                            item(name, list.size() == 1 ? s : "[" + s + "]");
                        });
  }
  template <class Options>
  void law(const std::optional<Options>& options) {
    if (!options) return;
    open(Options::kName);
    numbers(*options);
    close();
  }
  std::string take() { return std::move(text_); }

 private:
  std::string indent_, text_;
  bool first_{true};
};

}  // namespace

ReactionDescription readReaction(const config::YamlNode& node, const std::string& file) {
  const config::YamlFields fields(
      node, file, "`reaction`",
      {"torque", "repulsion", "proxy", "admittance", "speed", "braking", "hold", "stop"});
  ReactionDescription r;
  r.torque = torque(fields);
  r.repulsion = law<RepulsionOptions>(fields);
  if (r.repulsion && r.repulsion->stop_distance >= r.repulsion->range)
    throw ParseError(fields.pos(fields.need("repulsion")),
                     "found a `stop_distance` of " + formatDouble(r.repulsion->stop_distance) +
                         ", expected less than the `range`, " + formatDouble(r.repulsion->range) + " m");
  r.proxy = law<GodObjectOptions>(fields);
  r.admittance = law<AdmittanceOptions>(fields);
  r.speed = law<SpeedScaleOptions>(fields);
  r.braking = braking(fields);
  r.hold = law<HoldOptions>(fields).value_or(r.hold);
  if (const config::YamlNode* const stop = fields.find("stop")) {
    std::vector<std::string> keys = keysOf<WatchOptions>({"on"});
    addKeys<safety::StopOptions>(keys);
    const config::YamlFields s(*stop, file, "`stop`", keys);
    readNumbers(s, r.watch);
    readNumbers(s, r.stop);
    policy(s, r.stop.policy);
  }
  return r;
}

std::string describeReaction(const ReactionDescription& r, const std::string& indent) {
  Lines lines(indent);
  if (r.torque) {
    lines.open("torque");
    lines.numbers(*r.torque);
    lines.item("cut", kCuts[r.torque->cut == TorqueCut::kEach ? 0 : 1]);
    lines.close();
  }
  lines.law(r.repulsion);
  lines.law(r.proxy);
  lines.law(r.admittance);
  lines.law(r.speed);
  if (r.braking) {
    lines.open("braking");
    lines.numbers(*r.braking);
    lines.item("joints", kCuts[r.braking->path.kind == safety::BrakingKind::kEachJoint ? 0 : 1]);
    lines.close();
  }
  lines.law(std::optional(r.hold));
  lines.open("stop");
  lines.numbers(r.watch);
  lines.numbers(r.stop);
  std::string on;
  for (std::size_t i = 0; i < safety::kStopReasons; ++i)
    on += (i ? ", " : "{") + std::string(safety::reasonKey(static_cast<safety::StopReason>(i))) + ": " +
          std::string(safety::responseName(r.stop.policy.response[i]));
  lines.item("on", on + "}");
  lines.close();
  return lines.take();
}

}  // namespace abstand::control
