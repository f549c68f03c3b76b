// Skeletons as JSON lines for `abstand serve`.
#pragma once

#include <cstdint>
#include <span>

#include "humanmodel/joints.hpp"

namespace abstand::serve {

/// Capacity of a line: 22 joints of four numbers, and a name of up to kMaxNameBytes.
inline constexpr std::size_t kMaxLineBytes = 4096, kMaxNameBytes = 256;

/// True if a name is valid in such a line: printable, without quotes and backslashes, not too long.
bool isLineName(std::string_view name);

/// Writes the format that parsePacket() reads, without an end of line; missing joints are omitted. `frame.t`
/// is ignored. Returns the bytes written; 0 if `into` is too small. No allocation.
std::size_t writeSkeletonLine(const humanmodel::SkeletonFrame& frame, std::string_view person,
                              std::uint32_t sequence, std::uint64_t time_us,
                              std::span<std::byte> into) noexcept;

}  // namespace abstand::serve
