// Looks at the CPU and the environment once.
#include "core/base/simd.hpp"

#include <cstdlib>
#include <cstring>

namespace abstand {

bool usesAvx2() {
#if defined(__x86_64__)
  static const bool uses = [] {
    const char* simd = std::getenv("ABSTAND_SIMD");
    const bool off = simd != nullptr && std::strcmp(simd, "off") == 0;
    return !off && __builtin_cpu_supports("avx2") != 0;
  }();
  return uses;
#else
  return false;
#endif
}

}  // namespace abstand
