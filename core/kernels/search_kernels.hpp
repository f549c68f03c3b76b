// Search kernels of a pair query, compiled for several instruction sets. Internal to the engine.
#pragma once

#include "core/kernels/field_view.hpp"
#include "core/kernels/pair_scratch.hpp"
#include "core/kernels/sphere_group.hpp"

namespace abstand::kernels {

inline constexpr std::uint32_t kNoPoint = 0xffffffffu;

/// Termination of the search: no point can be nearer than the best; or, if the best exceeds `far_from`, none
/// can be nearer by more than the share `far_part` of it.
struct NearestLimits {
  float start;     ///< m; known upper bound of the distance, infinity if none
  float far_from;  ///< m
  float far_part;
};

struct NearestPoint {
  float lower_bound;    ///< m; lower bound of the true distance of every shell point
  float estimate;       ///< m, of the point
  std::uint32_t point;  ///< leaf order; kNoPoint if none was visited
};

/// A ball in the field body's frame (m).
struct Ball {
  float centre[3];
  float radius;
};

struct ContactLimits {
  float margin;  ///< m
  float watch;   ///< m, at least the margin: as long as no point is within the margin, the nearest one within
                 ///< this is found
  bool by_area;  ///< weight points by their areas, otherwise by 1
};

/// Sum over the shell points within the margin, in the field body's frame: force (depth * weight * inward
/// normal), its moment about the frame's origin, number of points, and largest depth.
struct ContactSum {
  double force[3];
  double moment[3];
  int contacts;
  float depth;
  std::uint32_t nearest;  ///< if none is within the margin: leaf-order index of the point with the smallest
                          ///< estimate, or kNoPoint
};

/// Results of both searches, for bodies that touch or nearly touch.
struct ContactSearch {
  ContactSum sum;
  NearestPoint nearest;  ///< the point with the smallest estimate within `watch`
};

/// Points as a structure of arrays (m); `count` is a multiple of 8.
struct PointArrays {
  const float *x, *y, *z;
  std::size_t count;
};

struct SearchKernels {
  NearestPoint (*nearest)(const TreeView&, const FieldView&, const NearestLimits&, PairScratch&);
  /// Lower bound (m) of the distance of all shell points outside of the ball, at most `start`.
  float (*nearestOutside)(const TreeView&, const FieldView&, const Ball&, float start, PairScratch&);
  ContactSum (*contacts)(const TreeView&, const FieldView&, const ContactLimits&, PairScratch&);
  ContactSearch (*contactSearch)(const TreeView&, const FieldView&, const ContactLimits&, PairScratch&);
  /// Largest g . p over the points.
  float (*support)(const PointArrays& points, float gx, float gy, float gz);
  /// Index of the point with the largest g . p.
  std::size_t (*extreme)(const PointArrays& points, float gx, float gy, float gz);
  /// Pairs of parts whose bounding spheres are nearer than `by` (m): bit 8 j + i for part j of the first
  /// `count` parts of F and part i of P. X_FP as in TreeView.
  std::uint64_t (*meeting)(const float* X_FP, const SphereGroup& P, const SphereGroup& F, std::size_t count,
                           float by);
  const char* name;
};

extern const SearchKernels kPortableKernels;
extern const SearchKernels kAvx2Kernels;  ///< only on x86-64

/// The fastest kernels that this CPU can run; with ABSTAND_SIMD=off in the environment the portable ones.
const SearchKernels& searchKernels();

}  // namespace abstand::kernels
