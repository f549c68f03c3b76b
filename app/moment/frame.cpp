#include "app/moment/frame.hpp"

#include "app/moment/byte_cursor.hpp"

namespace abstand::moment {

void writeHeader(const FrameHeader& header, std::span<std::byte> into) noexcept {
  ByteWriter out(into);
  out.put(kFrameMagic);
  out.put(kFrameVersion);
  out.put(static_cast<std::uint16_t>(header.type));
  out.put(header.sequence);
  out.put(header.left_out);
  out.put(header.time_us);
  out.put(std::uint32_t{0});
  out.put(header.bytes);
}

std::optional<FrameHeader> readHeader(std::span<const std::byte> bytes) noexcept {
  ByteReader in(bytes);
  const auto magic = in.get<std::uint32_t>();
  const auto version = in.get<std::uint16_t>();
  const auto type = in.get<std::uint16_t>();
  FrameHeader header;
  header.sequence = in.get<std::uint32_t>();
  header.left_out = in.get<std::uint32_t>();
  header.time_us = in.get<std::uint64_t>();
  const auto flags = in.get<std::uint32_t>();
  header.bytes = in.get<std::uint32_t>();
  const bool known = type >= static_cast<std::uint16_t>(FrameType::kWatch) &&
                     type <= static_cast<std::uint16_t>(FrameType::kEnd);
  if (!in.good() || magic != kFrameMagic || version != kFrameVersion || !known || flags != 0) return {};
  if (header.bytes < kFrameHeaderBytes || header.bytes > kMaxFrameBytes) return {};
  header.type = static_cast<FrameType>(type);
  return header;
}

void FrameSplitter::add(std::span<const std::byte> bytes) {
  if (damaged_) return;
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<std::span<const std::byte>> FrameSplitter::next() {
  const auto rest = std::span<const std::byte>(buffer_).subspan(begin_);
  if (damaged_ || rest.size() < kFrameHeaderBytes) return {};
  const auto header = readHeader(rest);
  if (!header || header->bytes > max_bytes_) {
    damaged_ = true;
    return {};
  }
  if (rest.size() < header->bytes) return {};
  begin_ += header->bytes;
  return rest.first(header->bytes);
}

}  // namespace abstand::moment
