// 128-bit content hash: names cached files and detects damaged ones.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

namespace abstand {

/// 128 bits: different contents never collide by chance. Not cryptographic: collisions can be made on
/// purpose.
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
  /// Adds the bits of a number, so that -0.0 differs from 0.0.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { add(&value, sizeof value); }
  /// Hash of everything added so far.
  ContentKey value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abstand
