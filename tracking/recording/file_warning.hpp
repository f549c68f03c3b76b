// What a reader remarks on without stopping.
#pragma once

#include <cstddef>
#include <string>

namespace abstand::tracking {

/// Something odd in a file that did not stop the reading. line 0: no line is known.
struct FileWarning {
  int line{0};
  std::string text;
  std::size_t frames_missing{0};  ///< frames that the file claims, or begins, and does not hold
};

}  // namespace abstand::tracking
