// Where a shell's points go, and which part of the surface each one stands for.
#pragma once

#include <span>
#include <utility>

#include "core/shell/pointshell_samples.hpp"
#include "core/shell/sub_triangles.hpp"

namespace abstand::shell {

/// The pieces of a surface, covered by centres: one stretch of them after the other, so that what a cover of
/// samples needs is small, whatever the size of the surface. A stretch knows the centres of those before it
/// near its border.
class ShellSampler {
 public:
  /// Points per area at each piece, as a multiple of the usual one, at least 1. `normal_length` (m): a
  /// difference of 1 between two unit normals counts as this distance. `cell`: as for FarthestPointSampler.
  /// Pool and density must outlive this object.
  ShellSampler(const SubTriangles& pool, const std::vector<float>& density, double normal_length,
               double cell);

  /// Takes centres from the middles of the pieces until each is within `reach` (m) of one, by
  /// FarthestPointSampler::spread().
  void spread(double reach);
  /// Moves the centres, drops those that were nearest to no piece, and adds more as above.
  void fill(std::vector<Vector3f> points, std::vector<Vector3f> normals, double reach);

  std::uint32_t count() const { return static_cast<std::uint32_t>(points_.size()); }
  /// The centres' numbers, such that the first m, for any m, cover the surface about evenly: as they were
  /// found in one stretch, else those first that were far from others; what fills holes at the end.
  std::vector<std::uint32_t> order() const;
  /// Of each piece the number of its nearest centre.
  const std::vector<std::uint32_t>& nearest() const { return nearest_; }
  /// The same, at the end.
  std::vector<std::uint32_t> takeNearest() { return std::move(nearest_); }

 private:
  struct Box {
    Vector3f lower, upper;
    void enclose(const Vector3f& p) { lower = lower.cwiseMin(p), upper = upper.cwiseMax(p); }
    bool isWithin(float reach, const Box& other) const {
      return ((lower.array() - reach) <= other.upper.array()).all() &&
             ((upper.array() + reach) >= other.lower.array()).all();
    }
  };
  struct Stretch {
    std::uint32_t first, end;
    std::uint32_t known;  ///< batches that its pieces know
    Box box;              ///< of the pieces' middles
  };
  /// Centres that were found together, by number.
  struct Batch {
    std::uint32_t first, end;
    Box box;
  };
  static Box emptyBox();
  template <class Fn>
  void inTurn(Fn fn);
  /// The cover gets the samples of this stretch.
  void take(Stretch& stretch);
  bool isNear(std::uint32_t centre, const Stretch& stretch, double reach) const;
  /// To the one that is taken: the centres of a batch.
  void offer(const Stretch& stretch, const Batch& batch, double reach);
  /// What the cover has found for the stretch.
  void keep(Stretch& stretch, bool filling);
  /// Lets all pieces know the centres that were found after their stretch was left.
  void catchUp(double reach);
  std::span<std::uint32_t> nearestOf(const Stretch& s) { return {&nearest_[s.first], s.end - s.first}; }

  const SubTriangles& pool_;
  const std::vector<float>& density_;
  double normal_length_, cell_;
  std::vector<Stretch> stretches_;
  std::vector<Batch> batches_;
  std::vector<Vector3f> points_, normals_;  ///< of the centres
  std::vector<float> found_at2_;  ///< squared distance to the others at that time; or filling a hole
  std::vector<bool> used_;        ///< by centre
  std::vector<std::uint32_t> nearest_;
  const Stretch* taken_{nullptr};
  std::vector<Sample> samples_;
  FarthestPointSampler cover_;
};

}  // namespace abstand::shell
