// Slabs of columns over the floor.
#include "tracking/tracker/standing_columns.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace abstand::tracking {
namespace {

constexpr float kColumn = 0.06f;  // m; twice the noise of a Kinect at 3 m
constexpr int kSide = 64;         // columns; a person with straight arms takes up 35
// m: the lowest slab holds more, as soles are cut off with the floor.
constexpr float kLowestSlab = 0.15f, kSlabHeight = 0.10f;

/// Of a height below kStandingBelow.
int slabOf(float z) { return z < kLowestSlab ? 0 : 1 + static_cast<int>((z - kLowestSlab) / kSlabHeight); }

/// Bit k: there are points in slab k.
class Columns {
 public:
  explicit Columns(const SeenPoints& points) {
    for (std::size_t i = 0; i < points.count; ++i) {
      x_ = std::min(x_, points.x[i]);
      y_ = std::min(y_, points.y[i]);
    }
    for (std::size_t i = 0; i < points.count; ++i)
      if (const int c = columnOf(points, i); points.z[i] < kStandingBelow && c >= 0)
        slabs_[static_cast<std::size_t>(c)] |= static_cast<std::uint8_t>(1u << slabOf(points.z[i]));
  }
  /// Slabs from the floor up without a gap in the column of a point. Not in those beside it: they may be
  /// those of a shin behind a hand.
  int standing(const SeenPoints& points, std::size_t i) const {
    const int c = columnOf(points, i);
    return c < 0 ? 0 : std::countr_one(slabs_[static_cast<std::size_t>(c)]);
  }

 private:
  /// -1: outside.
  int columnOf(const SeenPoints& points, std::size_t i) const {
    const int column = static_cast<int>((points.x[i] - x_) / kColumn);
    const int row = static_cast<int>((points.y[i] - y_) / kColumn);
    return column < kSide && row < kSide ? row * kSide + column : -1;
  }

  float x_{std::numeric_limits<float>::max()}, y_{std::numeric_limits<float>::max()};  // m, lowest of all
  std::array<std::uint8_t, static_cast<std::size_t>(kSide) * kSide> slabs_{};
};

}  // namespace

void markStanding(SeenPoints& points) {
  const Columns columns(points);
  for (std::size_t i = 0; i < points.count; ++i)
    points.no_arm[i] =
        points.z[i] < kStandingBelow && columns.standing(points, i) > slabOf(points.z[i]) ? kNoArm : 0.0f;
}

}  // namespace abstand::tracking
