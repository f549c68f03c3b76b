// What a reader remarks on without stopping.
#pragma once

#include <string>

namespace abstand {

/// Something odd in a file that did not stop the reading. line 0: no line is known.
struct FileWarning {
  int line{0};
  std::string text;
};

}  // namespace abstand
