#include "tests/support/no_alloc.hpp"

#include <cstdlib>
#include <new>

namespace {
thread_local int armed = 0;
thread_local long allocations = 0;
}  // namespace

void* operator new(std::size_t n) {
  if (armed) ++allocations;
  if (void* p = std::malloc(n ? n : 1)) return p;
  throw std::bad_alloc{};
}
void* operator new(std::size_t n, std::align_val_t align) {
  if (armed) ++allocations;
  const auto a = static_cast<std::size_t>(align);
  if (void* p = std::aligned_alloc(a, (n + a - 1) / a * a)) return p;
  throw std::bad_alloc{};
}
void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
  if (armed) ++allocations;
  return std::malloc(n ? n : 1);
}
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace abstand::testing {

NoAlloc::NoAlloc() : start_{allocations} { ++armed; }
NoAlloc::~NoAlloc() { --armed; }
long NoAlloc::count() const { return allocations - start_; }

}  // namespace abstand::testing
