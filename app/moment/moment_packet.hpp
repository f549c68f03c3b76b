// One moment of a served scene as a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/moment/frame.hpp"
#include "app/moment/scene_card.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::moment {

/// What the server's loop counted so far.
struct InputCounts {
  std::uint32_t bad{0}, late{0}, lost{0}, duplicates{0};
};

struct Moment {
  view::SceneSnapshot shown;      ///< t: s, clock of the server; robots: all mechanisms
  std::vector<double> input_age;  ///< s, of the joint values of each mechanism; infinite: never received
  InputCounts counts;
};

/// All sizes as the card says, so that readMoment() and writeMoment() do not allocate.
Moment makeMoment(const SceneCard& card);
/// Frame of a moment without forces, and the largest, with forces in all pairs.
std::size_t minMomentBytes(const SceneCard& card);
std::size_t maxMomentBytes(const SceneCard& card);

/// Writes the whole frame; returns its bytes, 0 if `into` is too small. No allocation.
std::size_t writeMoment(const FrameHeader& header, const Moment& moment, std::span<std::byte> into) noexcept;
/// Reads one untrusted frame of a scene with the sizes of `out`. False if it is damaged: wrong size, a number
/// that is not finite where it has to be, no rotation, an unknown state. `out` is then invalid. Not set: what
/// the frame does not have (SceneSnapshot::step, captured, medians, work, playing, nearest_pair).
bool readMoment(std::span<const std::byte> frame, Moment& out) noexcept;

}  // namespace abstand::moment
