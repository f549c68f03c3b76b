#include "core/margin/frame_block.hpp"

#include <algorithm>
#include <bit>

namespace abstand::margin {
namespace {

std::uint64_t lowBits(std::size_t count) {
  return count >= FrameBlock::kFrames ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

}  // namespace

void FrameBlock::add(const MarginFrame& frame) {
  t_[size_] = frame.t;
  braking_[size_] = frame.braking;
  between_[size_] = frame.between;
  least_[0][size_] = std::min(frame.clearance, frame.between);
  ++size_;
}

void FrameBlock::close(double limit) {
  at_limit_ = between_limit_ = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    at_limit_ |= std::uint64_t{least_[0][i] <= limit} << i;
    between_limit_ |= std::uint64_t{between_[i] <= limit} << i;
  }
  for (std::size_t level = 1; level < kLevels; ++level) {
    const std::size_t half = std::size_t{1} << (level - 1);
    for (std::size_t i = 0; i + 2 * half <= size_; ++i)
      least_[level][i] = std::min(least_[level - 1][i], least_[level - 1][i + half]);
  }
}

double FrameBlock::least(std::size_t begin, std::size_t end) const {
  const std::size_t level = static_cast<std::size_t>(std::bit_width(end - begin)) - 1;
  return std::min(least_[level][begin], least_[level][end - (std::size_t{1} << level)]);
}

void FrameBlock::judge(std::uint64_t inside, OutcomeStream& stream) const {
  for (std::size_t begin = 0, end = 0; begin < size_; begin = end) {
    const bool in = (inside >> begin & 1) != 0;
    const std::uint64_t others = (in ? ~inside : inside) >> begin;
    end = std::min(size_, begin + static_cast<std::size_t>(std::countr_zero(others)));
    const std::uint64_t range = lowBits(end) & ~lowBits(begin);
    MarginFrames frames{t_[begin], t_[end - 1], least(begin, end), braking_[begin], {}, 0};
    if (const std::uint64_t at_limit = at_limit_ & range; in && at_limit != 0)
      frames.at_limit = t_[static_cast<std::size_t>(std::countr_zero(at_limit))];
    frames.unseen = std::popcount(between_limit_ & range);
    in ? stream.addInside(frames) : stream.addOutside(frames);
  }
}

}  // namespace abstand::margin
