// The two searches of a pair query, compiled for more than one machine. Internal to the engine.
#pragma once

#include "core/kernels/field_view.hpp"
#include "core/kernels/pair_scratch.hpp"
#include "core/kernels/sphere_group.hpp"

namespace abstand::kernels {

inline constexpr std::uint32_t kNoPoint = 0xffffffffu;

/// A search ends where nothing can be nearer than the best; when that is farther than `far_from`, where
/// nothing can be nearer by more than `far_part` of it.
struct NearestLimits {
  float start;     ///< m; what is known to be reached, infinity when nothing is
  float far_from;  ///< m
  float far_part;
};

struct NearestPoint {
  float lower_bound;    ///< no shell point's true distance is below it; m
  float estimate;       ///< m, of the point
  std::uint32_t point;  ///< leaf order; kNoPoint when none was looked at
};

/// A ball in the field body's frame; m.
struct Ball {
  float centre[3];
  float radius;
};

struct ContactLimits {
  float margin;  ///< m
  float watch;   ///< m, at least the margin: while no point is within that, which is the nearest within this
  bool by_area;  ///< weigh points by their areas, else by 1
};

/// Of the shell points within the margin, in the field body's frame: sum of depth * weight * inward normal,
/// its moment about the frame's origin, how many, and the deepest.
struct ContactSum {
  double force[3];
  double moment[3];
  int contacts;
  float depth;
  std::uint32_t nearest;  ///< leaf order, by its estimate, when none is within the margin; or kNoPoint
};

/// Both at once, for bodies that touch or are about to.
struct ContactSearch {
  ContactSum sum;
  NearestPoint nearest;  ///< of the points within `watch`, the one of the least estimate
};

/// Points one array a coordinate; m; `count` a multiple of 8.
struct PointArrays {
  const float *x, *y, *z;
  std::size_t count;
};

struct SearchKernels {
  NearestPoint (*nearest)(const TreeView&, const FieldView&, const NearestLimits&, PairScratch&);
  /// No shell point outside of the ball is nearer than what it returns (m), which is at most `start`.
  float (*nearestOutside)(const TreeView&, const FieldView&, const Ball&, float start, PairScratch&);
  ContactSum (*contacts)(const TreeView&, const FieldView&, const ContactLimits&, PairScratch&);
  ContactSearch (*contactSearch)(const TreeView&, const FieldView&, const ContactLimits&, PairScratch&);
  /// The largest of g . p over some points.
  float (*support)(const PointArrays& points, float gx, float gy, float gz);
  /// Which of them it is.
  std::size_t (*extreme)(const PointArrays& points, float gx, float gy, float gz);
  /// Which parts of two bodies may be nearer than `by` (m), by their spheres: bit 8 j + i for part j of the
  /// first `count` of F and part i of P. X_FP as in TreeView.
  std::uint64_t (*meeting)(const float* X_FP, const SphereGroup& P, const SphereGroup& F, std::size_t count,
                           float by);
  const char* name;
};

extern const SearchKernels kPortableKernels;
extern const SearchKernels kAvx2Kernels;  ///< only where the machine's architecture has them

/// The fastest that this machine can run; ABSTAND_SIMD=off in the environment takes the portable ones.
const SearchKernels& searchKernels();

}  // namespace abstand::kernels
