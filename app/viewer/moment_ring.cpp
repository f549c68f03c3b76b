#include "app/viewer/moment_ring.hpp"

#include <algorithm>

namespace abstand::viewer {

double MomentRing::rateFor(const RingLimits& limits, std::size_t frame_bytes, double wanted) {
  const double most = static_cast<double>(limits.bytes) / static_cast<double>(frame_bytes) / limits.seconds;
  return std::min(wanted, most);
}

bool MomentRing::add(double t, std::span<const std::byte> frame) {
  if (!kept_.empty() && !(t > kept_.back().t)) return false;
  bytes_ += frame.size();
  kept_.push_back({t, {frame.begin(), frame.end()}});
  while (kept_.size() > 1 && (bytes_ > limits_.bytes || kept_.front().t < t - limits_.seconds)) {
    bytes_ -= kept_.front().bytes.size();
    kept_.pop_front();
    ++dropped_;
  }
  return true;
}

void MomentRing::clear() {
  dropped_ += kept_.size();
  kept_.clear();
  bytes_ = 0;
}

std::optional<std::size_t> MomentRing::at(double t) const {
  if (kept_.empty()) return {};
  const auto after = std::upper_bound(kept_.begin(), kept_.end(), t,
                                      [](double value, const Kept& k) { return value < k.t; });
  const auto index = after == kept_.begin() ? 0 : static_cast<std::size_t>(after - kept_.begin()) - 1;
  return dropped_ + index;
}

}  // namespace abstand::viewer
