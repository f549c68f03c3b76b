// What a viewer sends: that it watches, and at which rate.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "app/moment/byte_cursor.hpp"
#include "app/moment/frame.hpp"

namespace abstand::viewer {

inline constexpr std::size_t kWatchBytes = moment::kFrameHeaderBytes + 8;
inline constexpr double kMinWatchRate = 0.1;  ///< Hz

/// `rate`: Hz, of moments.
inline std::array<std::byte, kWatchBytes> watchFrame(double rate) {
  std::array<std::byte, kWatchBytes> frame{};
  moment::writeHeader({moment::FrameType::kWatch, 0, 0, 0, kWatchBytes}, frame);
  moment::ByteWriter(std::span(frame).subspan(moment::kFrameHeaderBytes)).put(rate);
  return frame;
}

/// The rate in one untrusted frame; nothing if it is no watch frame, or not at least kMinWatchRate.
inline std::optional<double> watchedRate(std::span<const std::byte> frame) {
  if (frame.size() != kWatchBytes) return {};
  const auto header = moment::readHeader(frame);
  if (!header || header->type != moment::FrameType::kWatch || header->bytes != kWatchBytes) return {};
  const auto rate = moment::ByteReader(frame.subspan(moment::kFrameHeaderBytes)).get<double>();
  if (!(rate >= kMinWatchRate) || !std::isfinite(rate)) return {};
  return rate;
}

}  // namespace abstand::viewer
