// Warnings of readers.
#pragma once

#include <cstddef>
#include <string>

namespace abstand::tracking {

/// An anomaly in a file that did not stop reading. line 0: unknown.
struct FileWarning {
  int line{0};
  std::string text;
  std::size_t frames_missing{0};  ///< frames stated or begun in the file but not complete
};

}  // namespace abstand::tracking
