// Noise model of a Kinect of 2010.
#include "tracking/depth/simulator/kinect_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/math/random.hpp"

namespace abstand::tracking {
namespace {

// Share of the depth: neighbours that differ by less are one surface.
constexpr float kOneSurface = 0.03f;
// Share of the depth: points this little behind the nearest one are lit too.
constexpr float kLit = 0.02f;
constexpr double kNoiseFrom = 0.4;  // m, of the formula of Nguyen and others

/// Box, Muller 1958: a normal deviate of two uniform ones, `u` above 0.
double gaussOf(double u, double v) { return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * kPi * v); }

/// Normal deviates of a standard deviation, rounded: as std::lround(deviation * gaussOf(u, v)), and faster.
/// The angle is known to a share of a turn, in which the cosine has bounds; most radii are then below half a
/// pixel, or surely between that and one and a half.
class RoundedGauss {
 public:
  explicit RoundedGauss(double deviation) : deviation_{deviation} {
    for (std::size_t k = 0; k < kShares; ++k) {
      const double first = std::abs(std::cos(2.0 * kPi * static_cast<double>(k) / kShares)),
                   last = std::abs(std::cos(2.0 * kPi * static_cast<double>(k + 1) / kShares));
      const double low = std::min(first, last), high = std::max(first, last);
      bounds_[k] = {(1.0 + kRounding) * reaching(0.5 / high), (1.0 - kRounding) * reaching(0.5 / low),
                    (1.0 + kRounding) * reaching(1.5 / high)};
    }
  }
  int operator()(Random& random) const {
    const double u = 1.0 - random.unit(), v = random.unit();
    const Bounds& bounds = bounds_[static_cast<std::size_t>(v * kShares)];
    if (u > bounds.zero) return 0;
    if (u < bounds.one && u > bounds.more) return v > 0.25 && v < 0.75 ? -1 : 1;
    return static_cast<int>(std::lround(deviation_ * gaussOf(u, v)));
  }

 private:
  static constexpr std::size_t kShares = 256;  // of a turn; the cosine is monotonic in each
  static constexpr double kRounding = 1e-9;    // share, of exponential, logarithm and cosine
  /// Of the first uniform deviate: above `zero`, the result is 0; between `more` and `one`, 1 or -1.
  struct Bounds {
    double zero, one, more;
  };
  /// The first uniform deviate with this radius (pixels).
  double reaching(double radius) const { return std::exp(-0.5 * std::pow(radius / deviation_, 2)); }

  double deviation_;
  std::array<Bounds, kShares> bounds_;
};

/// A positive number, rounded; faster than std::round.
double rounded(double x) { return static_cast<double>(static_cast<std::int64_t>(x + 0.5)); }

bool oneSurface(float a, float b) {
  return a > 0.0f && b > 0.0f && std::abs(a - b) < kOneSurface * std::min(a, b);
}

/// One row from the projector's view: the projector column of each pixel, and the nearest depth in each
/// column.
class Projector {
 public:
  Projector(const DepthCamera& camera, const KinectNoise& noise)
      : shift_(camera.fx * noise.baseline),
        before_(static_cast<int>(std::ceil(std::abs(shift_) / noise.nearest)) + 1),
        nearest_(static_cast<std::size_t>(camera.width + 2 * before_)),
        columns_(static_cast<std::size_t>(camera.width)) {}

  void project(const DepthImage& image, int row) {
    std::fill(nearest_.begin(), nearest_.end(), std::numeric_limits<float>::infinity());
    for (int u = 0; u < image.width; ++u) {
      const float z = image.at(u, row);
      if (z > 0.0f) columns_[static_cast<std::size_t>(u)] = columnOf(u, z);
    }
    for (int u = 0; u < image.width; ++u) {
      const float z = image.at(u, row);
      if (!(z > 0.0f)) continue;
      int from = columns_[static_cast<std::size_t>(u)], to = from;
      if (u + 1 < image.width && oneSurface(z, image.at(u + 1, row)))
        to = columns_[static_cast<std::size_t>(u) + 1];
      if (from > to) std::swap(from, to);
      for (int column = from; column <= to; ++column) {
        float& nearest = nearest_[static_cast<std::size_t>(column)];
        nearest = std::min(nearest, z);
      }
    }
  }
  /// Whether pixel `u` of the row is lit, which has depth `z` (m).
  bool lights(int u, float z) const {
    return z <= (1.0f + kLit) * nearest_[static_cast<std::size_t>(columns_[static_cast<std::size_t>(u)])];
  }

 private:
  int columnOf(int u, float z) const {
    const double column = u - shift_ / static_cast<double>(z) + before_;
    return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(nearest_.size() - 1)) + 0.5);
  }

  double shift_;  ///< pixels times m
  int before_;    ///< columns left of the image
  std::vector<float> nearest_;
  std::vector<int> columns_;  ///< of the pixels of the row
};

/// Whether the cosine of the angle between the ray and the normal, from the neighbours, is at least that of
/// a surface that is measured; also if there are no neighbours.
bool isSteep(const DepthImage& image, const DepthCamera& camera, int u, int v, double grazing) {
  const float z = image.at(u, v);
  const int u1 = u + 1 < image.width && oneSurface(z, image.at(u + 1, v)) ? u + 1 : u - 1;
  const int v1 = v + 1 < image.height && oneSurface(z, image.at(u, v + 1)) ? v + 1 : v - 1;
  if (u1 < 0 || v1 < 0 || !oneSurface(z, image.at(u1, v)) || !oneSurface(z, image.at(u, v1))) return true;
  const Vector3d p = camera.at(u, v, static_cast<double>(z));
  const Vector3d n = (camera.at(u1, v, static_cast<double>(image.at(u1, v))) - p)
                         .cross(camera.at(u, v1, static_cast<double>(image.at(u, v1))) - p);
  const double along = n.dot(p);
  return along * along >= grazing * grazing * n.squaredNorm() * p.squaredNorm();
}

}  // namespace

KinectNoise kinectNoiseIn(const DepthCamera& camera) {
  constexpr double kMeasuredAt = 580.0;  // pixels, focal length
  KinectNoise noise;
  noise.across *= camera.fx / kMeasuredAt;
  noise.disparity_step *= camera.fx / kMeasuredAt;
  return noise;
}

DepthImage seenByKinect(const DepthImage& ideal, const DepthCamera& camera, const KinectNoise& noise,
                        std::uint64_t seed, std::uint64_t frame) {
  DepthImage lit(ideal.width, ideal.height), seen(ideal.width, ideal.height);
  Projector projector(camera, noise);
  for (int v = 0; v < ideal.height; ++v) {
    projector.project(ideal, v);
    for (int u = 0; u < ideal.width; ++u) {
      const float z = ideal.at(u, v);
      if (z > 0.0f && projector.lights(u, z) && isSteep(ideal, camera, u, v, noise.grazing)) lit.at(u, v) = z;
    }
  }
  const double per_disparity = camera.fx * noise.baseline;
  const RoundedGauss across(noise.across);
  for (int v = 0; v < ideal.height; ++v) {
    Random random(seed, frame * DepthCamera::kMaxPixels + static_cast<std::uint64_t>(v));
    for (int u = 0; u < ideal.width; ++u) {
      const int from_u = u + across(random), from_v = v + across(random);
      const double first = 1.0 - random.unit(), second = random.unit();
      if (from_u < 0 || from_v < 0 || from_u >= ideal.width || from_v >= ideal.height) continue;
      const double z = static_cast<double>(lit.at(from_u, from_v));
      if (!(z >= noise.nearest && z <= noise.farthest)) continue;
      const double spread = noise.along + noise.along_growth * (z - kNoiseFrom) * (z - kNoiseFrom);
      const double disparity = per_disparity / (z + spread * gaussOf(first, second));
      const double step = rounded(disparity / noise.disparity_step) * noise.disparity_step;
      if (step > 0.0) seen.at(u, v) = static_cast<float>(per_disparity / step);
    }
  }
  return seen;
}

}  // namespace abstand::tracking
