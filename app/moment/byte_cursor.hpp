// Writes and reads numbers one after the other, within bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace abstand::moment {

/// A write beyond the end is left out and good() is false from then on. No allocation.
class ByteWriter {
 public:
  explicit ByteWriter(std::span<std::byte> into) : into_(into) {}

  template <class T>
  requires(std::is_arithmetic_v<T>) void put(T value) noexcept { putBytes(&value, sizeof value); }
  void putBytes(const void* bytes, std::size_t count) noexcept {
    good_ = good_ && count <= into_.size() - at_;
    if (!good_) return;
    if (count > 0) std::memcpy(into_.data() + at_, bytes, count);
    at_ += count;
  }
  bool good() const { return good_; }
  std::size_t written() const { return at_; }

 private:
  std::span<std::byte> into_;
  std::size_t at_{0};
  bool good_{true};
};

/// A read beyond the end gives 0 and good() is false from then on.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> from) : from_(from) {}

  template <class T>
  requires(std::is_arithmetic_v<T>) T get()
  noexcept {
    T value{};
    good_ = good_ && sizeof value <= left();
    if (!good_) return value;
    std::memcpy(&value, from_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string getText(std::size_t count) {
    good_ = good_ && count <= left();
    if (!good_) return {};
    std::string text(reinterpret_cast<const char*>(from_.data() + at_), count);
    at_ += count;
    return text;
  }
  bool good() const { return good_; }
  void fail() { good_ = false; }
  std::size_t left() const { return from_.size() - at_; }

 private:
  std::span<const std::byte> from_;
  std::size_t at_{0};
  bool good_{true};
};

}  // namespace abstand::moment
