// Basic types of the MCAP serialization (https://mcap.dev/spec, "Serialization"). Internal to this module.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

namespace abstand::results {

using TextMap = std::map<std::string, std::string>;

/// Growing byte buffer; numbers are little-endian.
class McapBytes {
 public:
  template <class T>
  requires(std::is_unsigned_v<T>) McapBytes& number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bytes_ += static_cast<char>(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i)));
    return *this;
  }
  /// 32-bit length, then the bytes. `text` is shorter than 4 GiB.
  McapBytes& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  McapBytes& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  /// 32-bit size of all entries in bytes, then key and value of each.
  McapBytes& map(const TextMap& entries) {
    McapBytes all;
    for (const auto& [key, value] : entries) all.text(key).text(value);
    return text(all.bytes());
  }
  /// A map from 16-bit to 64-bit integers.
  McapBytes& map(const std::map<std::uint16_t, std::uint64_t>& entries) {
    McapBytes all;
    for (const auto& [key, value] : entries) all.number(key).number(value);
    return text(all.bytes());
  }
  /// A record: kind, 64-bit length, content.
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
