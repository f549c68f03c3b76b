// Positions of shell points, and the patch of surface that each one represents.
#pragma once

#include <span>
#include <utility>

#include "core/shell/farthest_point_sampler.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// Covers the sub-triangles of a surface with centres, in chunks of consecutive sub-triangles, which limits
/// memory for surfaces of any size. A chunk takes the centres of earlier chunks near its border into account.
class ShellSampler {
 public:
  /// `density`: points per area at each sub-triangle as a multiple of the usual one, at least 1.
  /// `normal_length` (m): weight of a difference of 1 between two unit normals. `cell`: see
  /// FarthestPointSampler. Pool and density must outlive this object.
  ShellSampler(const SubTriangles& pool, const std::vector<float>& density, double normal_length,
               double cell);

  /// Selects centres from the centroids of the sub-triangles until each is within `radius` (m) of one, by
  /// FarthestPointSampler::selectCentres().
  void selectCentres(double radius);
  /// Replaces positions and normals of the centres, drops centres that are nearest to no sub-triangle, and
  /// adds centres until each sub-triangle is within `radius` (m) of one.
  void fillHoles(std::vector<Vector3f> points, std::vector<Vector3f> normals, double radius);

  std::uint32_t count() const { return static_cast<std::uint32_t>(points_.size()); }
  /// Order of the centres in which the first m, for any m, cover the surface about evenly: the order of
  /// selection if there is one chunk, otherwise sorted by distance to the earlier centres; those that fill
  /// holes come last.
  std::vector<std::uint32_t> order() const;
  /// Nearest centre of each sub-triangle.
  const std::vector<std::uint32_t>& nearest() const { return nearest_; }
  /// Moves nearest() out; call last.
  std::vector<std::uint32_t> releaseNearest() { return std::move(nearest_); }

 private:
  struct Box {
    Vector3f lower, upper;
    void enclose(const Vector3f& p) { lower = lower.cwiseMin(p), upper = upper.cwiseMax(p); }
    bool isWithin(float radius, const Box& other) const {
      return ((lower.array() - radius) <= other.upper.array()).all() &&
             ((upper.array() + radius) >= other.lower.array()).all();
    }
  };
  struct Chunk {
    std::uint32_t first, end;
    std::uint32_t offered_batches;  ///< number of batches already offered to its samples
    Box box;                        ///< of the centroids
  };
  /// Range of centres found in one pass.
  struct Batch {
    std::uint32_t first, end;
    Box box;
  };
  static Box emptyBox();
  template <class Fn>
  void forEachChunk(Fn fn);
  /// Loads the samples of a chunk into the sampler.
  void loadSamples(Chunk& chunk);
  bool isNear(std::uint32_t centre, const Chunk& chunk, double radius) const;
  /// Offers the centres of a batch to the loaded chunk.
  void offer(const Chunk& chunk, const Batch& batch, double radius);
  /// Stores the results of the sampler for the chunk.
  void storeResults(Chunk& chunk, bool filling);
  /// Offers every chunk the centres found after it was processed.
  void offerLaterCentres(double radius);
  std::span<std::uint32_t> nearestOf(const Chunk& s) { return {&nearest_[s.first], s.end - s.first}; }

  const SubTriangles& pool_;
  const std::vector<float>& density_;
  double normal_length_, cell_;
  std::vector<Chunk> chunks_;
  std::vector<Batch> batches_;
  std::vector<Vector3f> points_, normals_;  ///< of the centres
  std::vector<float> found_at2_;  ///< squared distance to the other centres when found; or the mark of a hole
                                  ///< filler
  std::vector<bool> used_;        ///< for each centre
  std::vector<std::uint32_t> nearest_;
  const Chunk* loaded_{nullptr};
  std::vector<Sample> samples_;
  FarthestPointSampler sampler_;
};

}  // namespace abstand::shell
