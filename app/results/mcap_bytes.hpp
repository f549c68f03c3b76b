// The basic types of MCAP, serialized (https://mcap.dev/spec, "Serialization"). Internal to this module.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

namespace abstand::results {

using TextMap = std::map<std::string, std::string>;

/// Bytes that grow; numbers are little-endian.
class McapBytes {
 public:
  template <class T>
  requires(std::is_unsigned_v<T>) McapBytes& number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bytes_ += static_cast<char>(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i)));
    return *this;
  }
  /// Length as 32 bits, then the bytes. `text` is shorter than 4 GiB.
  McapBytes& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  McapBytes& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  /// Length of all entries in bytes as 32 bits, then key and value of each.
  McapBytes& map(const TextMap& entries) {
    McapBytes all;
    for (const auto& [key, value] : entries) all.text(key).text(value);
    return text(all.bytes());
  }
  /// A map of 16 bits to 64 bits.
  McapBytes& map(const std::map<std::uint16_t, std::uint64_t>& entries) {
    McapBytes all;
    for (const auto& [key, value] : entries) all.number(key).number(value);
    return text(all.bytes());
  }
  /// A record: its kind, its length as 64 bits, its content.
  McapBytes& record(std::uint8_t kind, std::string_view content) {
    number(kind).number(static_cast<std::uint64_t>(content.size()));
    return raw(content);
  }

  const std::string& bytes() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

}  // namespace abstand::results
