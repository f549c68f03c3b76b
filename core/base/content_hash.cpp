#include "core/base/content_hash.hpp"

// Header-only use, so that the program does not load one more shared library.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdio>

namespace abstand {

std::string ContentKey::hex() const {
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(high),
                static_cast<unsigned long long>(low));
  return text;
}

struct ContentHash::State {
  XXH3_state_t xxh3;
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh3); }
ContentHash::~ContentHash() = default;

void ContentHash::add(const void* bytes, std::size_t count) {
  XXH3_128bits_update(&state_->xxh3, bytes, count);
}

ContentKey ContentHash::value() const {
  const XXH128_hash_t digest = XXH3_128bits_digest(&state_->xxh3);
  return {digest.low64, digest.high64};
}

}  // namespace abstand
