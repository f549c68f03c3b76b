// Samples of a surface and their cover by centres, for farthest-point sampling.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math/four.hpp"
#include "core/math/transform.hpp"

namespace abstand::shell {

/// A sample of a surface.
struct Sample {
  Vector3f position;
  /// Unit normal times the length that a difference of 1 between normals counts for (m).
  Vector3f normal;
  /// At least 1: factor of the squared distances to it; where it is larger, centres come closer.
  float weight;
};

/// Samples of a surface that get covered by centres, one after the other. Distances are in the six dimensions
/// of position and scaled normal, so that faces that meet at an angle and the two sides of a plate do not
/// cover each other, and strongly curved places get more centres. Samples lie in the cells of a grid, of
/// which only those that hold some are kept; a new centre looks at the cells about it.
class FarthestPointSampler {
 public:
  /// Starts with other samples, at least one, and no centres. `cell`: edge of the grid's cells, about the
  /// last reach (m). The centres that it finds are numbered from `first_centre` on.
  void start(const std::vector<Sample>& samples, double cell, std::uint32_t first_centre = 0);
  /// Starts again with the same samples: for each, in the order given to start(), the nearest centre so far,
  /// of those that lie at `points` with `normals`.
  void restart(std::span<const std::uint32_t> nearest, const std::vector<Vector3f>& points,
               const std::vector<Vector3f>& normals, std::uint32_t first_centre);

  /// Offers a centre to the samples within `reach` of it.
  void offer(std::uint32_t centre, const Vector3f& point, const Vector3f& normal, double reach);
  /// Farthest-point sampling (Gonzalez 1985) until every sample is within `reach` of a centre, which is at
  /// most four cells; each centre is farther than `reach` from those before it and those offered, and its
  /// distance to them is the largest of all samples but for some percent. Far apart ones are taken from few
  /// samples for all.
  void spread(double reach);
  /// Adds centres as spread() does.
  void fill(double reach);
  struct Found {
    Sample sample;
    float distance2;  ///< squared, to the centres before it
  };
  /// The samples that became centres since start() or restart(), by their numbers.
  std::vector<Found> found() const;
  /// For every sample, in the order given to start(), the nearest centre. Exact for those within the last
  /// reach.
  void nearest(std::span<std::uint32_t> out) const;

 private:
  static constexpr int kLanes = 4;
  struct Centre {
    float id;  ///< its number as bits
    Four p;    ///< the last is 0
    Vector3f n;
  };
  /// Samples side by side. Padding repeats a sample and counts as covered.
  struct Group {
    Four x, y, z, nx, ny, nz, weight;
    Four distance2;  ///< to the nearest centre
    Four nearest;    ///< its number as bits, so that lanes can be chosen
  };
  /// The samples of one cell: some groups.
  struct Cell {
    Four lower, upper;  ///< box of their positions; the last is 0
    float farthest;     ///< largest squared distance to the nearest centre
    float min_weight;
    std::uint32_t begin, end;
  };
  /// 4 x 4 x 4 cells, bit (z 4 + y) 4 + x of `kept`: this one is there, as cell first + place of its bit.
  struct SparseBlock {
    Vector3i at;
    std::uint32_t first;
    std::uint64_t kept;
    std::uint8_t place[64];
  };

  Vector3i cellOf(const Vector3f& p) const;
  const SparseBlock* brickAt(const Vector3i& at) const;
  std::uint32_t addBrick(const Vector3i& at);
  /// Sorts the samples by cells.
  void arrange(const std::vector<Sample>& samples);
  void put(std::uint32_t at, const Sample& sample, float distance2);
  Sample sample(std::uint32_t at) const;
  void add(std::uint32_t id, const Vector3f& p, const Vector3f& n, float radius);
  void addSample(std::uint32_t at, float radius, float distance2);
  void visit(Cell& cell, const Centre& centre);
  std::uint32_t farthestOf(const Cell& cell) const;
  float farthest2() const;
  /// Makes centres of the samples farther than `from`, then of those farther than a little less, and so on.
  void descend(float from, float reach);

  float cell_{0.0f}, per_cell_{0.0f};
  Vector3f lower_;
  std::vector<Group> groups_;         ///< by cells
  std::vector<std::uint32_t> order_;  ///< place in the groups -> index of the sample, or none
  std::vector<Cell> cells_;
  std::vector<SparseBlock> bricks_;
  std::vector<std::uint32_t> brick_table_;  ///< open addressing; a power of two
  std::vector<std::uint32_t> cell_of_;      ///< of the samples, while they are sorted
  struct Taken {
    std::uint32_t at;  ///< place in the groups
    float distance2;   ///< as in Found
  };
  std::vector<Taken> centres_;  ///< those that spread() and fill() took
  std::uint32_t first_centre_{0};
};

}  // namespace abstand::shell
