// Groups of points whose distances to each other stay the same.
#pragma once

#include <span>
#include <vector>

#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// Distances between points over a recording: mean and standard deviation, in the units of the file.
class PointDistances {
 public:
  /// `points`: indices of those that are compared. Only frames that have both points of a pair count; a pair
  /// without such a frame has infinite values.
  PointDistances(std::span<const PointFrame> frames, std::span<const int> points);

  std::size_t size() const { return n_; }
  double mean(std::size_t a, std::size_t b) const { return mean_[a * n_ + b]; }
  double deviation(std::size_t a, std::size_t b) const { return deviation_[a * n_ + b]; }
  /// The largest finite mean.
  double extent() const;

 private:
  std::size_t n_;
  std::vector<double> mean_, deviation_;
};

/// Groups of at least two points that are all rigid to each other, that is with a standard deviation of at
/// most `tolerance`. Every rigid pair is in one group; a point may be in several. The groups are built from
/// the nearest pairs on.
std::vector<std::vector<int>> rigidBodies(const PointDistances& distances, double tolerance);

}  // namespace abstand::tracking
