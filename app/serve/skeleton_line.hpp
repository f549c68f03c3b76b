// A skeleton as the line of JSON that `abstand serve` takes.
#pragma once

#include <cstdint>
#include <span>

#include "humanmodel/joints.hpp"

namespace abstand::serve {

/// Bytes that a line has room in: 22 joints of four numbers, and a name of up to kMaxNameBytes.
inline constexpr std::size_t kMaxLineBytes = 4096, kMaxNameBytes = 256;

/// Whether a name can stand in such a line: printable, without quotes and backslashes, not too long.
bool isLineName(std::string_view name);

/// What parsePacket() reads, without an end of line; joints that are missing are left out. `frame.t` is not
/// looked at. The bytes that were written; 0 where `into` is too small. No allocation.
std::size_t writeSkeletonLine(const humanmodel::SkeletonFrame& frame, std::string_view person,
                              std::uint32_t sequence, std::uint64_t time_us,
                              std::span<std::byte> into) noexcept;

}  // namespace abstand::serve
