// What continues the background.
#include "tracking/depth/people/learned_background.hpp"

namespace abstand::tracking {
namespace {

constexpr int kMinBorder = 20;  // pixels; fewer do not tell whether a surface continues
// Of a surface that was uncovered, nearly all of the border is even. Of somebody who squats and rises, some
// is: where the legs were before the person was found.
constexpr int kMostlyEven = 3;

}  // namespace

LearnedBackground::LearnedBackground(std::size_t pixels, double learn_after)
    : learn_after_{static_cast<float>(learn_after)}, unassigned_(pixels), background_(pixels) {}

void LearnedBackground::set(std::size_t pixel, float z) {
  background_[pixel] = {z, 0.5f * depthNoise(z), 0.0f, z};
  if (isLearned(unassigned_[pixel])) unassigned_[pixel] = {};  // or that would still be the background
}

bool LearnedBackground::continues(std::span<const std::uint8_t> labels, std::uint8_t label,
                                  const DepthImage& image) const {
  const auto width = static_cast<std::size_t>(image.width);
  int even = 0, steps = 0;
  const auto compare = [&](std::size_t inside, std::size_t outside) {
    if (labels[inside] != label || labels[outside] != 0) return;
    const float z = image.z[inside], behind = backgroundOf(outside).z;
    if (behind > 0.0f) ++(std::abs(behind - z) < 2.0f * depthNoise(z) ? even : steps);
  };
  for (std::size_t i = 0; i + width < image.z.size(); ++i) {
    compare(i, i + 1);
    compare(i + 1, i);
    compare(i, i + width);
    compare(i + width, i);
  }
  return even + steps >= kMinBorder && even > kMostlyEven * steps;
}

}  // namespace abstand::tracking
