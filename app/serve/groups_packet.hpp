// The answer to a control packet: how it went, and what the groups of pairs do now.
#pragma once

#include "app/serve/state_packet.hpp"
#include "app/session/pair_control.hpp"

namespace abstand::serve {

struct GroupsReport {
  const session::PairControl& control;
  bool torques_on;
  session::PairControl::Outcome outcome;
  std::uint64_t time_us;  ///< clock of the server
};

/// 56 + 8 G bytes for G groups: header; u64 time of the server; u32 outcome (PairControl::Outcome), u32
/// torques on, u32 pairs in no group, u32 G; of each group u32 state (PairGroupState), u32 pairs.
constexpr std::size_t groupsBytes(std::size_t groups) { return kHeaderBytes + 24 + 8 * groups; }

/// `into` has groupsBytes() at least. Give the bytes written; of JSON 0 when `into` is too small. No
/// allocation.
std::size_t writeGroups(const GroupsReport& report, const ReplyTo& to, std::span<std::byte> into) noexcept;
std::size_t writeGroupsJson(const GroupsReport& report, const ReplyTo& to, const PacketFormat& quoted_format,
                            std::span<std::byte> into) noexcept;

}  // namespace abstand::serve
