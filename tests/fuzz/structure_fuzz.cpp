// Any bytes with a checksum that fits as a structure file: a body or a ParseError, nothing else.
#include <cstddef>
#include <cstdint>

#include "core/base/content_hash.hpp"
#include "core/base/error.hpp"
#include "core/store/structure_file.hpp"

namespace {

/// So many triangles that intersect at will take the fuzzer's time and show nothing.
constexpr std::size_t kMaxInputBytes = 4096;

void checkBody(const abstand::store::StoredBody& body) {
  const abstand::geometry::Bounds box = body.surface->bounds();
  ABSTAND_CHECK(box.lower.allFinite() && box.upper.allFinite());
  ABSTAND_CHECK(body.surface->area() > 0.0);
  ABSTAND_CHECK(body.surface->closest(box.centre()).point.allFinite());
  body.options.validate();
}

}  // namespace

/// The file without its last 16 bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMaxInputBytes) return 0;
  std::string file(reinterpret_cast<const char*>(data), size);
  abstand::ContentHash hash;
  hash.add(file.data(), file.size());
  const abstand::ContentKey key = hash.value();
  file.append(reinterpret_cast<const char*>(&key.low), sizeof key.low);
  file.append(reinterpret_cast<const char*>(&key.high), sizeof key.high);
  try {
    checkBody(abstand::store::parseStoredBody(file, "fuzz"));
  } catch (const abstand::ParseError&) {
  }
  return 0;
}
