// Answer to a control packet: outcome, and states of the groups of pairs.
#pragma once

#include "app/serve/state_packet.hpp"
#include "app/session/pair_control.hpp"

namespace abstand::serve {

struct GroupsReport {
  const session::PairControl& control;
  bool torques_on;
  session::PairControl::Outcome outcome;
  std::uint64_t time_us;  ///< server clock
};

/// 56 + 8 G bytes for G groups: header; u64 server time; u32 outcome (PairControl::Outcome), u32 torques on,
/// u32 pairs in no group, u32 G; for each group u32 state (PairGroupState), u32 pairs.
constexpr std::size_t groupsBytes(std::size_t groups) { return kHeaderBytes + 24 + 8 * groups; }

/// `into` has at least groupsBytes(). Both return the bytes written; for JSON 0 if `into` is too small. No
/// allocation.
std::size_t writeGroups(const GroupsReport& report, const ReplyTo& to, std::span<std::byte> into) noexcept;
std::size_t writeGroupsJson(const GroupsReport& report, const ReplyTo& to, const PacketFormat& quoted_format,
                            std::span<std::byte> into) noexcept;

}  // namespace abstand::serve
