// Little-endian numbers in bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "core/base/error.hpp"

namespace abstand::serve {

static_assert(std::endian::native == std::endian::little,
              "the wire is little-endian, and so is all we build for");

/// The number of type T that begins at byte `offset`.
template <class T>
T load(std::span<const std::byte> bytes, std::size_t offset) noexcept {
  ABSTAND_CHECK(offset + sizeof(T) <= bytes.size());
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

template <class T>
void store(std::span<std::byte> bytes, std::size_t offset, T value) noexcept {
  ABSTAND_CHECK(offset + sizeof(T) <= bytes.size());
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

}  // namespace abstand::serve
