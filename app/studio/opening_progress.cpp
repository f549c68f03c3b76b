#include "app/studio/opening_progress.hpp"

namespace abstand::studio {
namespace {

constexpr std::chrono::milliseconds kPause{50};

}  // namespace

void OpeningProgress::read(std::size_t done, std::size_t images) {
  opening_.images_done = static_cast<int>(done);
  opening_.images = static_cast<int>(images);
  showNow();
}

void OpeningProgress::plan(std::size_t structures) { opening_.all = static_cast<int>(structures); }

void OpeningProgress::hear(double fraction, std::string_view name) {
  const bool fresh = !names_.contains(name);
  if (fresh) names_.emplace(name);
  opening_.begun = static_cast<int>(names_.size());
  opening_.name = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
  opening_.building = !fresh;
  opening_.fraction = fraction;
  showNow();
}

void OpeningProgress::showNow() {
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < kPause) return;
  shown_ = now;
  show_(opening_);
}

}  // namespace abstand::studio
