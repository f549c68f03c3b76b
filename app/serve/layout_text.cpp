#include <cstdio>

#include "app/serve/groups_packet.hpp"
#include "app/serve/layout.hpp"
#include "app/serve/state_fields.hpp"

namespace abstand::serve {
namespace {

/// Collects fields in sequence.
class Table {
 public:
  explicit Table(Layout& layout) : layout_(layout) {}

  template <class Number>
  void row(Number, const std::string& what) {
    const char* type = std::is_floating_point_v<Number> ? "f" : std::is_signed_v<Number> ? "i" : "u";
    layout_.packets.back().fields.push_back({at_, type + std::to_string(8 * sizeof(Number)), what});
    at_ += sizeof(Number);
  }
  void title(const std::string& what, std::size_t bytes) {
    layout_.packets.push_back({what, bytes, {}});
    at_ = 0;
  }

 private:
  Layout& layout_;
  std::size_t at_{0};
};

void header(Table& table, PacketType type, const std::string& index, const std::string& flags,
            std::size_t bytes) {
  table.row(std::uint32_t{}, "magic, the bytes 41 42 53 54, \"ABST\"");
  table.row(std::uint16_t{}, "version of the protocol, " + std::to_string(kProtocol));
  table.row(std::uint16_t{}, "type, " + std::to_string(static_cast<int>(type)));
  table.row(std::uint32_t{}, "sequence number");
  table.row(std::uint32_t{}, index);
  table.row(std::uint64_t{}, "time stamp, us, of the sender's clock");
  table.row(std::uint32_t{}, flags);
  table.row(std::uint32_t{}, "bytes of this packet, " + std::to_string(bytes));
}

void joints(Table& table, const PacketFormat& format, std::uint32_t index) {
  const bool all = index == kAllMechanisms;
  const std::size_t bytes = jointsBytes(format.dof(index));
  table.title("joints of " + (all ? "all mechanisms" : format.mechanisms[index].name), bytes);
  header(table, PacketType::kJoints, "mechanism, " + std::to_string(index), "flags; 1: reset", bytes);
  for (std::size_t m = 0; m < format.mechanisms.size(); ++m)
    if (all || m == index)
      for (std::size_t j = 0; j < format.mechanisms[m].dof; ++j)
        table.row(double{}, format.mechanisms[m].name + ".q" + std::to_string(j) + ", rad or m");
}

void skeleton(Table& table, const PacketFormat& format) {
  table.title("skeleton of a person", skeletonBytes());
  std::string people = "person;";
  for (std::size_t p = 0; p < format.people.size(); ++p)
    people += " " + std::to_string(p) + ": " + format.people[p];
  header(table, PacketType::kSkeleton, people, "flags, 0", skeletonBytes());
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    for (const char* axis : {" x, m", " y", " z"})
      table.row(double{}, std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) + axis);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    table.row(std::uint8_t{}, std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) +
                                  (j == 0 ? ": 0 missing, 1 inferred, 2 tracked" : ""));
  for (std::size_t j = kHeaderBytes + 25 * humanmodel::kJointCount; j < skeletonBytes(); ++j)
    table.row(std::uint8_t{}, "0");
}

void control(Table& table) {
  table.title("control of groups of pairs and torques", kControlBytes);
  header(table, PacketType::kControl, "0", "flags, 0", kControlBytes);
  std::string orders = "order;";
  for (std::uint32_t i = 0; i < kControlOrders; ++i)
    orders += " " + std::to_string(i) + ": " + std::string(orderName(static_cast<ControlOrder>(i)));
  table.row(std::uint32_t{}, orders);
  table.row(std::uint32_t{}, "group; 4294967295: all");
  table.row(std::uint32_t{}, "object a of a pair");
  table.row(std::uint32_t{}, "object b of a pair");
}

void groups(Table& table, const PacketFormat& format) {
  const std::size_t bytes = groupsBytes(format.groups.size());
  table.title("groups of pairs, the answer to control", bytes);
  header(table, PacketType::kGroups, "index of the packet that is answered", "flags, 0", bytes);
  table.row(std::uint64_t{}, "time of the server, us");
  table.row(std::uint32_t{},
            "outcome; 0: done, 1: no such group, 2: no such pair, 3: the pair is in a group "
            "already, 4: the pair is in no group");
  table.row(std::uint32_t{}, "torques; 0: off, 1: on");
  table.row(std::uint32_t{}, "pairs in no group");
  table.row(std::uint32_t{}, "groups, " + std::to_string(format.groups.size()));
  for (const std::string& name : format.groups) {
    table.row(std::uint32_t{}, name + " state; 0: running, 1: paused, 2: stopped");
    table.row(std::uint32_t{}, name + " pairs");
  }
}

std::string owner(const FieldLabel& label, const PacketFormat& format, const StateNames& names) {
  using Of = FieldLabel::Of;
  const std::size_t n = format.mechanisms.size();
  switch (label.of) {
    case Of::kPacket:
      return "";
    case Of::kPerson:
      return format.people[label.index] + " ";
    case Of::kRobot:
      return format.mechanisms[label.index].name + " ";
    case Of::kJoint: {
      std::size_t m = 0, j = label.index;
      while (j >= format.mechanisms[m].dof) j -= format.mechanisms[m++].dof;
      return format.mechanisms[m].name + ".q" + std::to_string(j) + " ";
    }
    case Of::kLink:
      return names.links[label.index] + " ";
    case Of::kSeparation:
      return format.people[label.index / n] + " - " + format.mechanisms[label.index % n].name + " ";
    case Of::kNearest:
      return "nearest " + std::to_string(label.index) + " ";
  }
  return "";
}

}  // namespace

Layout layoutOf(const PacketFormat& format, const StateNames& names, const StateReport& report) {
  Layout layout;
  Table table(layout);
  for (std::uint32_t m = 0; m < format.mechanisms.size(); ++m) joints(table, format, m);
  if (format.mechanisms.size() > 1) joints(table, format, kAllMechanisms);
  if (!format.people.empty()) skeleton(table, format);
  table.title("state, the answer", stateBytes(report));
  eachField(report, {}, 0, [&](const FieldLabel& label, auto value) {
    table.row(value, owner(label, format, names) + label.what);
  });
  control(table);
  groups(table, format);
  for (std::size_t i = 0; i < safety::kStopStates; ++i)
    layout.states.emplace_back(safety::stateName(static_cast<safety::StopState>(i)));
  for (std::size_t i = 0; i < safety::kStopReasons; ++i)
    layout.reasons.emplace_back(safety::reasonName(static_cast<safety::StopReason>(i)));
  layout.groups = format.groups;
  layout.objects = names.objects;
  return layout;
}

std::string describeLayout(const PacketFormat& format, const StateNames& names, const StateReport& report) {
  const Layout layout = layoutOf(format, names, report);
  std::string text;
  for (const auto& packet : layout.packets) {
    text += (text.empty() ? "" : "\n") + packet.title + ": " + std::to_string(packet.bytes) +
            " bytes\n offset  type meaning\n";
    for (const auto& field : packet.fields) {
      char start[32];
      std::snprintf(start, sizeof start, "%7zu  %-4s ", field.offset, field.type.c_str());
      text += start + field.meaning + "\n";
    }
  }
  const auto list = [&text](const char* title, const std::vector<std::string>& words) {
    text += std::string("\n") + title + "\n";
    for (std::size_t i = 0; i < words.size(); ++i) text += std::to_string(i) + " " + words[i] + "\n";
  };
  list("states", layout.states);
  list("reasons; 4294967295: none", layout.reasons);
  list("groups", layout.groups);
  list("objects", layout.objects);
  return text;
}

}  // namespace abstand::serve
