// Decompression of OpenNI depth images.
#include "tracking/depth/formats/oni_packing.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

class Unpacker {
 public:
  Unpacker(std::string_view bytes, std::size_t count, const std::string& file)
      : bytes_{bytes}, count_{count}, file_{file} {
    // A byte encodes at most 30 pixels, which limits the memory for untrusted sizes.
    numbers_.reserve(std::min(count, 30 * bytes.size()));
  }

  std::vector<std::uint16_t> plain() {
    if (bytes_.size() != 2 * count_)
      fail("found " + std::to_string(bytes_.size()) + " bytes of pixels, expected " +
           std::to_string(2 * count_));
    while (numbers_.size() < count_) numbers_.push_back(lowFirst());
    return std::move(numbers_);
  }

  std::vector<std::uint16_t> differences() {
    put(lowFirst());
    while (at_ < bytes_.size()) {
      const int code = byte();
      if (code == 0xff) {
        full();
      } else if (code < 0xe0) {
        step(code >> 4);
        const int low = code & 0xf;
        if (low == 0xf)
          full();
        else if (low == 0xe)
          fail("found an unknown difference");
        else if (low != 0xd)
          step(low);
      } else if (code <= 0xef) {
        for (int i = 2 * (code - 0xe0); i > 0; --i) put(last_);
      } else {
        fail("found an unknown code");
      }
    }
    if (numbers_.size() != count_)
      fail("found " + std::to_string(numbers_.size()) + " pixels, expected " + std::to_string(count_));
    return std::move(numbers_);
  }

  std::vector<std::uint16_t> table() {
    std::vector<std::uint16_t> values(lowFirst());
    for (std::uint16_t& v : values) v = lowFirst();
    std::vector<std::uint16_t> places = differences();
    for (std::uint16_t& place : places) {
      if (place >= values.size())
        fail("found place " + std::to_string(place) + " in a table of " + std::to_string(values.size()));
      place = values[place];
    }
    return places;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError({file_}, "at byte " + std::to_string(at_) + " of an image: " + message);
  }
  int byte() {
    if (at_ == bytes_.size()) fail("found its end, expected more");
    return static_cast<unsigned char>(bytes_[at_++]);
  }
  std::uint16_t lowFirst() {
    const int low = byte();
    return static_cast<std::uint16_t>(low | byte() << 8);
  }
  void put(std::uint16_t number) {
    if (numbers_.size() == count_) fail("found more than " + std::to_string(count_) + " pixels");
    last_ = number;
    numbers_.push_back(number);
  }
  void step(int code) { put(static_cast<std::uint16_t>(last_ - (code - 6))); }
  void full() {
    const int high = byte();
    if (high >= 0x80)
      put(static_cast<std::uint16_t>(last_ - (high - 192)));
    else
      put(static_cast<std::uint16_t>(high << 8 | byte()));
  }

  std::string_view bytes_;
  std::size_t count_;
  const std::string& file_;
  std::size_t at_{0};
  std::uint16_t last_{0};
  std::vector<std::uint16_t> numbers_;
};

}  // namespace

std::vector<std::uint16_t> unpackOni(std::string_view bytes, OniPacking packing, std::size_t count,
                                     const std::string& file) {
  Unpacker unpacker(bytes, count, file);
  if (packing == OniPacking::kNone) return unpacker.plain();
  return packing == OniPacking::k16z ? unpacker.differences() : unpacker.table();
}

}  // namespace abstand::tracking
