// Converts progress reports of a build for the window.
#pragma once

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "ui/panels/status_panel.hpp"

namespace abstand::studio {

/// Counts structures by name, and forwards changes at most about 20 times a second. A structure from the
/// cache is reported once; repeated reports mean that it is being built. One thread at a time, like the
/// reports of a BuildMonitor.
class OpeningProgress {
 public:
  using Show = std::function<void(const ui::Opening&)>;
  explicit OpeningProgress(Show show) : show_(std::move(show)) {}

  void read(std::size_t done, std::size_t images);
  void plan(std::size_t structures);
  void hear(double fraction, std::string_view name);

 private:
  void showNow();

  Show show_;
  ui::Opening opening_;
  std::set<std::string, std::less<>> names_;
  std::chrono::steady_clock::time_point shown_{};
};

}  // namespace abstand::studio
