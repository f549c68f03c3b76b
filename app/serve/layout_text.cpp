#include <cstdio>

#include "app/serve/state_fields.hpp"

namespace abstand::serve {
namespace {

class Table {
 public:
  template <class Number>
  void row(Number, const std::string& what) {
    const char* type = std::is_floating_point_v<Number> ? "f" : std::is_signed_v<Number> ? "i" : "u";
    char line[32];
    std::snprintf(line, sizeof line, "%7zu  %s%-3zu ", at_, type, 8 * sizeof(Number));
    text_ += line + what + "\n";
    at_ += sizeof(Number);
  }
  void title(const std::string& what, std::size_t bytes) {
    text_ +=
        (text_.empty() ? "" : "\n") + what + ": " + std::to_string(bytes) + " bytes\n offset  type meaning\n";
    at_ = 0;
  }
  void line(const std::string& what) { text_ += what + "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
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
  for (std::size_t j = 0; j < kJointCount; ++j)
    for (const char* axis : {" x, m", " y", " z"})
      table.row(double{}, std::string(jointName(static_cast<Joint>(j))) + axis);
  for (std::size_t j = 0; j < kJointCount; ++j)
    table.row(std::uint8_t{}, std::string(jointName(static_cast<Joint>(j))) +
                                  (j == 0 ? ": 0 missing, 1 inferred, 2 tracked" : ""));
  for (std::size_t j = kHeaderBytes + 25 * kJointCount; j < skeletonBytes(); ++j)
    table.row(std::uint8_t{}, "0");
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

std::string describeLayout(const PacketFormat& format, const StateNames& names, const StateReport& report) {
  Table table;
  for (std::uint32_t m = 0; m < format.mechanisms.size(); ++m) joints(table, format, m);
  if (format.mechanisms.size() > 1) joints(table, format, kAllMechanisms);
  if (!format.people.empty()) skeleton(table, format);
  const std::size_t bytes = stateBytes(report);
  table.title("state, the answer", bytes);
  eachField(report, {}, 0, [&](const FieldLabel& label, auto value) {
    table.row(value, owner(label, format, names) + label.what);
  });
  table.line("\nstates");
  for (std::size_t i = 0; i < kStopStates; ++i)
    table.line(std::to_string(i) + " " + std::string(stateName(static_cast<StopState>(i))));
  table.line("\nreasons; 4294967295: none");
  for (std::size_t i = 0; i < kStopReasons; ++i)
    table.line(std::to_string(i) + " " + std::string(reasonName(static_cast<StopReason>(i))));
  table.line("\nobjects");
  for (std::size_t i = 0; i < names.objects.size(); ++i)
    table.line(std::to_string(i) + " " + names.objects[i]);
  return table.text();
}

}  // namespace abstand::serve
