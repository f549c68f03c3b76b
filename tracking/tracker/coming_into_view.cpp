#include "tracking/tracker/coming_into_view.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

// Somebody who walks in at 0.3 m/s grows by a tenth in kWhile; arms that are raised, and noise, by less.
constexpr double kWhile = 0.2;    // s
constexpr double kGrowth = 1.06;  // in kWhile
// Share of the largest area. A body without one arm has 0.9 of its surface.
constexpr double kNearlyAll = 0.85;
// Share of the width at either side that counts as the border: a Kinect has no depths in up to 0.02.
constexpr double kSideBorder = 0.03;

bool isCutAtSide(const PersonImage& image) {
  const int width = image.image->width, border = static_cast<int>(kSideBorder * width);
  for (std::size_t row = 0; row < image.is_person.size(); row += static_cast<std::size_t>(width))
    for (int u = 0; u <= border; ++u)
      if (image.is_person[row + static_cast<std::size_t>(u)] != 0 ||
          image.is_person[row + static_cast<std::size_t>(width - 1 - u)] != 0)
        return true;
  return false;
}

}  // namespace

double visibleArea(std::span<const PersonImage> images) {
  double area = 0.0;
  for (const PersonImage& image : images) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.is_person.size(); ++i) {
      const auto z = static_cast<double>(image.image->z[i]);
      if (image.is_person[i] != 0) sum += z * z;
    }
    area += sum / (image.camera->fx * image.camera->fy);
  }
  return area;
}

void ComingIntoView::see(double t, std::span<const PersonImage> images) {
  has_ended_ = !seen_.empty() && t - seen_.front().t > kLongest;
  if (!has_ended_)
    seen_.push_back({t, visibleArea(images), std::all_of(images.begin(), images.end(), isCutAtSide)});
}

bool ComingIntoView::isGrowing() const {
  if (seen_.empty()) return true;
  const Seen& last = seen_.back();
  if (has_ended_ || !last.is_cut) return false;
  const auto before =
      std::find_if(seen_.rbegin(), seen_.rend(), [&](const Seen& seen) { return last.t - seen.t >= kWhile; });
  return before == seen_.rend() || last.area > kGrowth * before->area;
}

double ComingIntoView::start(double end) const {
  double largest = 0.0;
  for (const Seen& seen : seen_)
    if (seen.t < end) largest = std::max(largest, seen.area);
  for (const Seen& seen : seen_)
    if (!seen.is_cut || seen.area >= kNearlyAll * largest) return seen.t;
  return kNaN;
}

}  // namespace abstand::tracking
