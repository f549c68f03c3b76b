// Writes JSON sequentially into a given buffer.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/math/transform.hpp"

namespace abstand::serve {

/// Writes into a buffer of fixed size; output beyond its end is dropped.
class JsonLine {
 public:
  explicit JsonLine(std::span<std::byte> room)
      : begin_(reinterpret_cast<char*>(room.data())), at_(begin_), end_(begin_ + room.size()) {}

  JsonLine& text(std::string_view s) {
    if (s.size() > static_cast<std::size_t>(end_ - at_)) full_ = true;
    if (full_) return *this;
    at_ = std::copy(s.begin(), s.end(), at_);
    return *this;
  }
  template <class Number>
  JsonLine& number(Number v) {
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(v)) return text("null");
    char buffer[32];
    const auto r = std::to_chars(buffer, buffer + sizeof buffer, v);
    return text({buffer, static_cast<std::size_t>(r.ptr - buffer)});
  }
  JsonLine& vector(const Vector3d& v) {
    text("[").number(v.x());
    text(",").number(v.y());
    text(",").number(v.z());
    return text("]");
  }
  /// Writes an array: calls `each(i)` for i < n, with commas in between, in brackets.
  template <class Each>
  JsonLine& list(std::size_t n, Each each) {
    text("[");
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0) text(",");
      each(i);
    }
    return text("]");
  }
  std::size_t size() const { return full_ ? 0 : static_cast<std::size_t>(at_ - begin_); }

 private:
  char* begin_;
  char* at_;
  char* end_;
  bool full_{false};
};

}  // namespace abstand::serve
