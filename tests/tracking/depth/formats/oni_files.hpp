// Recordings of OpenNI that tests write, byte by byte, after the description in oni_packing.hpp and
// oni_recording.hpp.
#pragma once

#include <bit>
#include <cstdlib>
#include <map>

#include "tests/tracking/depth/formats/depth_files.hpp"

namespace abstand::testing {

/// Numbers packed as `16zP` has them: the first, then differences, as few bytes as there may be.
inline std::string packed16z(const std::vector<std::uint16_t>& numbers) {
  std::string bytes = bytesOf(numbers.front(), 2);
  int half = -1, pairs = 0;  // a difference that waits for its partner; pairs of no difference
  const auto flush = [&] {
    if (pairs > 0) bytes += static_cast<char>(0xe0 + pairs);
    pairs = 0;
  };
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const int step = static_cast<std::int16_t>(static_cast<std::uint16_t>(numbers[i - 1] - numbers[i]));
    if (std::abs(step) <= 6) {
      if (half < 0) {
        half = step + 6;
        continue;
      }
      const int code = half << 4 | (step + 6);
      half = -1;
      if (code == 0x66 && ++pairs < 15) continue;
      if (code != 0x66) {
        flush();
        bytes += static_cast<char>(code);
      } else {
        flush();
      }
      continue;
    }
    flush();
    bytes += static_cast<char>(half < 0 ? 0xff : half << 4 | 0xf);
    half = -1;
    if (std::abs(step) <= 63)
      bytes += static_cast<char>(step + 192);
    else
      bytes += bytesOf(numbers[i], 2, false);
  }
  flush();
  if (half >= 0) bytes += static_cast<char>(half << 4 | 0xd);
  return bytes;
}

/// The same as `16zT`: places in the table of all numbers that there are.
inline std::string packed16zTable(const std::vector<std::uint16_t>& numbers) {
  std::map<std::uint16_t, std::uint16_t> place;
  for (const std::uint16_t n : numbers) place[n] = 0;
  std::string bytes = bytesOf(place.size(), 2);
  std::uint16_t next = 0;
  for (auto& [n, i] : place) {
    bytes += bytesOf(n, 2);
    i = next++;
  }
  std::vector<std::uint16_t> places;
  for (const std::uint16_t n : numbers) places.push_back(place.at(n));
  return bytes + packed16z(places);
}

inline std::string plain16(const std::vector<std::uint16_t>& numbers) {
  std::string bytes;
  for (const std::uint16_t n : numbers) bytes += bytesOf(n, 2);
  return bytes;
}

/// A file of records; `old`: of version 1.0.0.5, with the shorter headers.
class OniText {
 public:
  explicit OniText(bool old = false) : old_{old} {
    text_ = "NI10" + bytesOf(1, 1) + bytesOf(0, 1) +
            (old ? bytesOf(0, 2) + bytesOf(5, 4) : bytesOf(1, 2) + bytesOf(0, 4)) + std::string(8, '\xff') +
            bytesOf(2, 4);
  }

  OniText& record(unsigned type, unsigned stream, const std::string& fields, const std::string& data = {}) {
    text_ += std::string("NIR\0", 4) + bytesOf(type, 4) + bytesOf(stream, 4) +
             bytesOf((old_ ? 24 : 28) + fields.size(), 4) + bytesOf(data.size(), 4) +
             bytesOf(0, old_ ? 4 : 8) + fields + data;
    return *this;
  }
  /// `kind`: 2 depth, 3 colour.
  OniText& stream(unsigned number, const std::string& packing, unsigned kind = 2) {
    return record(0x0d, number, named("Depth") + bytesOf(kind, 4) + packing + std::string(28, '\0'));
  }
  OniText& property(unsigned number, const std::string& name, const std::string& value,
                    bool is_whole = false) {
    return record(is_whole ? 0x03 : 0x06, number, named(name) + bytesOf(value.size(), 4) + value);
  }
  OniText& size(unsigned number, unsigned width, unsigned height) {
    return property(number, "xnMapOutputMode", bytesOf(width, 4) + bytesOf(height, 4) + bytesOf(30, 4));
  }
  OniText& image(unsigned number, double t, const std::string& data) {
    return record(0x0a, number, bytesOf(static_cast<std::uint64_t>(1e6 * t + 0.5), 8) + bytesOf(++images_, 4),
                  data);
  }
  std::string end() const { return OniText(*this).record(0x0b, 0, "").text_; }
  std::string cut() const { return text_; }

  static std::string real(double value) { return bytesOf(std::bit_cast<std::uint64_t>(value), 8); }

 private:
  static std::string named(const std::string& name) { return bytesOf(name.size() + 1, 4) + name + '\0'; }

  bool old_;
  unsigned images_{0};
  std::string text_;
};

}  // namespace abstand::testing
