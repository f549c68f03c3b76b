// Proves that a stretch of code allocates nothing on this thread.
#pragma once

namespace abstand::testing {

/// Counts calls of operator new on the constructing thread while it lives.
class NoAlloc {
 public:
  NoAlloc();
  ~NoAlloc();
  NoAlloc(const NoAlloc&) = delete;
  NoAlloc& operator=(const NoAlloc&) = delete;
  long count() const;

 private:
  long start_;
};

}  // namespace abstand::testing
