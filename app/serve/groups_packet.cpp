#include "app/serve/groups_packet.hpp"

#include "app/serve/json_line.hpp"
#include "app/serve/wire.hpp"

namespace abstand::serve {
namespace {

constexpr std::array<std::string_view, 3> kStateWords{"\"running\"", "\"paused\"", "\"stopped\""};

}  // namespace

std::size_t writeGroups(const GroupsReport& report, const ReplyTo& to, std::span<std::byte> into) noexcept {
  const auto groups = static_cast<std::size_t>(report.control.groups());
  const std::size_t bytes = groupsBytes(groups);
  std::size_t at = 0;
  const auto put = [&](auto value) {
    store(into, at, value);
    at += sizeof value;
  };
  put(kPacketMagic);
  put(kProtocol);
  put(static_cast<std::uint16_t>(PacketType::kGroups));
  put(to.sequence);
  put(to.index);
  put(to.time_us);
  put(std::uint32_t{0});
  put(static_cast<std::uint32_t>(bytes));
  put(report.time_us);
  put(static_cast<std::uint32_t>(report.outcome));
  put(std::uint32_t{report.torques_on ? 1u : 0u});
  put(static_cast<std::uint32_t>(report.control.withoutGroup()));
  put(static_cast<std::uint32_t>(groups));
  for (int g = 0; g < report.control.groups(); ++g) {
    put(static_cast<std::uint32_t>(report.control.state(g)));
    put(static_cast<std::uint32_t>(report.control.size(g)));
  }
  return at;
}

std::size_t writeGroupsJson(const GroupsReport& report, const ReplyTo& to, const PacketFormat& quoted_format,
                            std::span<std::byte> into) noexcept {
  const session::PairControl& control = report.control;
  JsonLine out(into);
  out.text("{\"type\":\"groups\",\"seq\":").number(to.sequence);
  out.text(",\"time_us\":").number(to.time_us);
  out.text(",\"server_us\":").number(report.time_us);
  const bool done = report.outcome == session::PairControl::Outcome::kDone;
  out.text(",\"done\":").text(done ? "true" : "false").text(",\"reason\":");
  if (done)
    out.text("null");
  else
    out.text("\"").text(session::outcomeName(report.outcome)).text("\"");
  out.text(",\"torques_on\":").text(report.torques_on ? "true" : "false");
  out.text(",\"no_group\":").number(control.withoutGroup());
  out.text(",\"groups\":").list(static_cast<std::size_t>(control.groups()), [&](std::size_t i) {
    const auto g = static_cast<int>(i);
    out.text("{\"name\":").text(quoted_format.groups[i]);
    out.text(",\"state\":").text(kStateWords[static_cast<std::size_t>(control.state(g))]);
    out.text(",\"pairs\":").number(control.size(g)).text("}");
  });
  return out.text("}\n").size();
}

}  // namespace abstand::serve
