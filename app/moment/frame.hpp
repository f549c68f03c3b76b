// Frames between `abstand serve` and its viewers. See docs/serve.md.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

namespace abstand::moment {

static_assert(std::endian::native == std::endian::little,
              "the wire is little-endian, and so is all we build for");

inline constexpr std::uint32_t kFrameMagic = 0x54534241;  ///< the bytes "ABST"
inline constexpr std::uint16_t kFrameVersion = 1;
inline constexpr std::size_t kFrameHeaderBytes = 32;
/// Longer frames are rejected before anything is allocated for them.
inline constexpr std::size_t kMaxFrameBytes = std::size_t{16} << 20;

/// Numbers of datagrams (docs/serve.md) and frames do not overlap.
enum class FrameType : std::uint16_t {
  kWatch = 6,   ///< viewer: begins or renews, with the rate that it wants
  kScene = 7,   ///< server: SceneCard, once
  kMoment = 8,  ///< server: Moment
  kAlive = 9,   ///< server: its loop lives, and nothing has changed
  kEnd = 10     ///< last frame of a file, with the fingerprint of all before
};

struct FrameHeader {
  FrameType type{FrameType::kMoment};
  std::uint32_t sequence{0};  ///< of moments: rises; gaps are moments that this viewer did not get
  std::uint32_t left_out{0};  ///< of moments: number that this viewer was too slow for, so far
  std::uint64_t time_us{0};   ///< server clock, of the latest round of its loop
  std::uint32_t bytes{0};     ///< of the whole frame
};

/// `into` has at least kFrameHeaderBytes.
void writeHeader(const FrameHeader& header, std::span<std::byte> into) noexcept;
/// Of untrusted bytes; nothing if they are no header: wrong magic, version, type or size. `bytes` has at
/// least kFrameHeaderBytes.
std::optional<FrameHeader> readHeader(std::span<const std::byte> bytes) noexcept;

/// Takes the bytes of a stream as they come, and gives whole frames. Allocates only up to the longest frame.
class FrameSplitter {
 public:
  /// Frames longer than `max_bytes` are damage.
  explicit FrameSplitter(std::size_t max_bytes = kMaxFrameBytes) : max_bytes_(max_bytes) {}

  void setMaxBytes(std::size_t max_bytes) { max_bytes_ = max_bytes; }
  void add(std::span<const std::byte> bytes);
  /// The next whole frame with its header, valid until the next call of any member; nothing: more bytes are
  /// needed, or damaged().
  std::optional<std::span<const std::byte>> next();
  /// What came is no stream of frames. Nothing more will be given.
  bool damaged() const { return damaged_; }
  /// Bytes of a frame that is not whole yet.
  std::size_t waiting() const { return buffer_.size() - begin_; }

 private:
  std::size_t max_bytes_;
  std::vector<std::byte> buffer_;
  std::size_t begin_{0};
  bool damaged_{false};
};

}  // namespace abstand::moment
