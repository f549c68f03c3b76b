// A fingerprint of bytes: names what is kept on disk, and tells when a file was damaged.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

namespace abstand {

/// 128 bits, enough that different contents never share them by chance. No protection against somebody who
/// wants two contents to share them.
struct ContentKey {
  std::uint64_t low{0}, high{0};

  friend auto operator<=>(const ContentKey&, const ContentKey&) = default;
  /// 32 hexadecimal digits, the high half first.
  std::string hex() const;
};

/// XXH3 with 128 bits over everything that was added, in order. One thread at a time.
class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  void add(const void* bytes, std::size_t count);
  /// The bits of a number, so that -0.0 differs from 0.0.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { add(&value, sizeof value); }
  /// Of what was added until now.
  ContentKey value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abstand
