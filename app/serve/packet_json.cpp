#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/serve/json_scanner.hpp"
#include "app/serve/packet.hpp"

namespace abstand::serve {
namespace {

/// Values of the keys, in any order.
struct Fields {
  std::optional<std::string_view> type, mechanism, person, order, group, a, b;
  bool control() const { return order || group || a || b; }
  std::optional<double> sequence, time_us;
  bool q{false}, joints{false}, reset{false};
};

bool whole(const std::optional<double>& v, double most) {
  return v && *v >= 0.0 && *v <= most && *v == std::floor(*v);
}

bool readValues(JsonScanner& in, Packet& out) {
  out.values = 0;
  if (!in.mark('[')) return false;
  if (in.mark(']')) return true;
  do {
    if (out.values == out.q.size() || !in.number(out.q[out.values])) return false;
    ++out.values;
  } while (in.mark(','));
  return in.mark(']');
}

/// [x, y, z], optionally followed by "inferred" or "tracked", and optionally by the spread (m); or null.
bool readJoint(JsonScanner& in, humanmodel::Joint joint, humanmodel::SkeletonFrame& out) {
  if (in.word("null")) return true;
  Vector3d p;
  if (!in.mark('[') || !in.number(p.x()) || !in.mark(',') || !in.number(p.y()) || !in.mark(',') ||
      !in.number(p.z()))
    return false;
  humanmodel::JointState state = humanmodel::JointState::kTracked;
  bool more = in.mark(',');
  if (std::string_view how; more && in.string(how)) {
    if (how == "inferred")
      state = humanmodel::JointState::kInferred;
    else if (how != "tracked")
      return false;
    more = in.mark(',');
  }
  if (more && !in.number(out.spread[static_cast<std::size_t>(joint)])) return false;
  out.set(joint, p, state);
  return in.mark(']');
}

bool readJoints(JsonScanner& in, humanmodel::SkeletonFrame& out) {
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    out.set(static_cast<humanmodel::Joint>(j), Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
  out.spread.fill(0.0);
  if (!in.mark('{')) return false;
  if (in.mark('}')) return true;
  std::array<bool, humanmodel::kJointCount> seen{};
  do {
    std::string_view name;
    if (!in.string(name) || !in.mark(':')) return false;
    const auto joint = humanmodel::parseJoint(name);
    if (!joint || seen[static_cast<std::size_t>(*joint)]) return false;
    seen[static_cast<std::size_t>(*joint)] = true;
    if (!readJoint(in, *joint, out)) return false;
  } while (in.mark(','));
  return in.mark('}');
}

bool once(std::optional<std::string_view>& into, JsonScanner& in) {
  std::string_view text;
  if (into || !in.string(text)) return false;
  into = text;
  return true;
}

bool once(std::optional<double>& into, JsonScanner& in) {
  double v = 0.0;
  if (into || !in.number(v)) return false;
  into = v;
  return true;
}

bool readField(std::string_view key, JsonScanner& in, Fields& fields, Packet& out) {
  if (key == "type") return once(fields.type, in);
  if (key == "seq") return once(fields.sequence, in);
  if (key == "time_us") return once(fields.time_us, in);
  if (key == "mechanism") return once(fields.mechanism, in);
  if (key == "person") return once(fields.person, in);
  if (key == "do") return once(fields.order, in);
  if (key == "group") return once(fields.group, in);
  if (key == "a") return once(fields.a, in);
  if (key == "b") return once(fields.b, in);
  if (key == "q") return !std::exchange(fields.q, true) && readValues(in, out);
  if (key == "joints") return !std::exchange(fields.joints, true) && readJoints(in, out.skeleton);
  if (key == "reset") {
    if (std::exchange(fields.reset, true)) return false;
    out.reset = in.word("true");
    return out.reset || in.word("false");
  }
  return false;
}

PacketFault finishJoints(const Fields& fields, const PacketFormat& format, Packet& out) {
  if (!fields.q || fields.joints || fields.person || fields.control()) return PacketFault::kJson;
  out.type = PacketType::kJoints;
  out.index = kAllMechanisms;
  if (fields.mechanism) {
    out.index = 0;
    while (out.index < format.mechanisms.size() && format.mechanisms[out.index].name != *fields.mechanism)
      ++out.index;
  }
  if (!format.hasMechanism(out.index)) return PacketFault::kIndex;
  if (out.values != format.dof(out.index)) return PacketFault::kSize;
  for (std::size_t i = 0; i < out.values; ++i)
    if (!isUsableCoordinate(out.q[i])) return PacketFault::kNumber;
  return PacketFault::kNone;
}

PacketFault finishSkeleton(const Fields& fields, const PacketFormat& format, Packet& out) {
  if (!fields.joints || !fields.person || fields.q || fields.mechanism || fields.reset || fields.control())
    return PacketFault::kJson;
  out.type = PacketType::kSkeleton;
  out.index = 0;
  while (out.index < format.people.size() && format.people[out.index] != *fields.person) ++out.index;
  if (out.index == format.people.size()) return PacketFault::kIndex;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (out.skeleton.has(static_cast<humanmodel::Joint>(j)))
      for (const double v : out.skeleton.p[j])
        if (!isUsableCoordinate(v)) return PacketFault::kNumber;
  for (const double spread : out.skeleton.spread)
    if (!isUsableCoordinate(spread) || spread < 0.0) return PacketFault::kNumber;
  return PacketFault::kNone;
}

/// Index of a name in a list; its size if not found.
std::uint32_t placeOf(const std::vector<std::string>& names, std::string_view name) {
  const auto place = std::find(names.begin(), names.end(), name) - names.begin();
  return static_cast<std::uint32_t>(place);
}

/// Fields that the command does not use are errors.
PacketFault finishControl(const Fields& fields, const PacketFormat& format, Packet& out) {
  if (!fields.order || fields.q || fields.joints || fields.mechanism || fields.person || fields.reset)
    return PacketFault::kJson;
  out.type = PacketType::kControl;
  out.index = 0;
  std::uint32_t order = 0;
  while (order < kControlOrders && orderName(static_cast<ControlOrder>(order)) != *fields.order) ++order;
  if (order == kControlOrders) return PacketFault::kIndex;
  out.control = {};
  out.control.order = static_cast<ControlOrder>(order);
  const bool one = out.control.order == ControlOrder::kAdd;
  const bool pair = one || out.control.order == ControlOrder::kRemove;
  const bool groups = out.control.order == ControlOrder::kRun || out.control.order == ControlOrder::kPause ||
                      out.control.order == ControlOrder::kStop;
  if (fields.a.has_value() != pair || fields.b.has_value() != pair) return PacketFault::kJson;
  if (one ? !fields.group : fields.group && !groups) return PacketFault::kJson;
  if (fields.group) {
    out.control.group = placeOf(format.groups, *fields.group);
    if (out.control.group == format.groups.size()) return PacketFault::kIndex;
  }
  if (pair) {
    out.control.a = placeOf(format.objects, *fields.a);
    out.control.b = placeOf(format.objects, *fields.b);
  }
  return checkControl(format, out.control);
}

}  // namespace

PacketFault parseJsonPacket(std::string_view text, const PacketFormat& format, Packet& out) noexcept {
  constexpr double kMaxSequence = 4294967295.0;
  constexpr double kMaxTime = 9007199254740992.0;  // 2^53: above, a double cannot represent all integers
  JsonScanner in(text);
  Fields fields;
  out.json = true;
  out.reset = false;
  if (!in.mark('{')) return PacketFault::kJson;
  do {
    std::string_view key;
    if (!in.string(key) || !in.mark(':') || !readField(key, in, fields, out)) return PacketFault::kJson;
  } while (in.mark(','));
  if (!in.mark('}') || !in.atEnd()) return PacketFault::kJson;
  if (!whole(fields.sequence, kMaxSequence) || !whole(fields.time_us, kMaxTime)) return PacketFault::kJson;
  out.sequence = static_cast<std::uint32_t>(*fields.sequence);
  out.time_us = static_cast<std::uint64_t>(*fields.time_us);
  if (fields.type == "joints") return finishJoints(fields, format, out);
  if (fields.type == "skeleton") return finishSkeleton(fields, format, out);
  if (fields.type == "control") return finishControl(fields, format, out);
  return fields.type ? PacketFault::kType : PacketFault::kJson;
}

}  // namespace abstand::serve
