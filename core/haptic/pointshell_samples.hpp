// Samples of a surface and their cover by centres, for farthest-point sampling.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand {

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
class SampleCover {
 public:
  /// At least one sample. `cell`: edge of the grid's cells, about the last reach (m).
  SampleCover(const std::vector<Sample>& samples, double cell);

  /// Farthest-point sampling (Gonzalez 1985) until every sample is within `reach` of a centre, which is at
  /// most four cells; each centre is farther than `reach` from those before it, and its distance to them is
  /// the largest of all samples but for some percent. Far apart ones are taken from few samples for all.
  /// Returns the number of centres.
  std::uint32_t spread(double reach);
  /// Moves all centres (by their numbers). Samples within `reach` of one know their nearest then.
  void recentre(const std::vector<Vector3f>& points, const std::vector<Vector3f>& normals, double reach);
  /// Adds centres as spread() does; returns the number of all.
  std::uint32_t fill(double reach);
  /// For every sample, in the order given to the constructor, the nearest centre. Exact for those within the
  /// last reach.
  std::vector<std::uint32_t> nearest() const;

 private:
  static constexpr int kLanes = 4;
  using Lanes = Eigen::Array<float, kLanes, 1>;
  struct Centre {
    float id;  ///< its number as bits
    Lanes p;   ///< the last is 0
    Vector3f n;
  };
  /// Samples side by side. Padding repeats a sample and counts as covered.
  struct Group {
    Lanes x, y, z, nx, ny, nz, weight;
    Lanes distance2;  ///< to the nearest centre
    Lanes nearest;    ///< its number as bits, so that lanes can be chosen
  };
  /// The samples of one cell: some groups.
  struct Cell {
    Lanes lower, upper;  ///< box of their positions; the last is 0
    float farthest;      ///< largest squared distance to the nearest centre
    float least_weight;
    std::uint32_t begin, end;
  };
  /// 4 x 4 x 4 cells, bit (z 4 + y) 4 + x of `kept`: this one is there, as cell first + place of its bit.
  struct Brick {
    Vector3i at;
    std::uint32_t first;
    std::uint64_t kept;
    std::uint8_t place[64];
  };

  Vector3i cellOf(const Vector3f& p) const;
  const Brick* brickAt(const Vector3i& at) const;
  std::uint32_t addBrick(const Vector3i& at);
  /// Sorts the samples by cells.
  void arrange(const std::vector<Sample>& samples);
  void put(std::uint32_t at, const Sample& sample, float distance2);
  Sample sample(std::uint32_t at) const;
  void add(std::uint32_t id, const Vector3f& p, const Vector3f& n, float radius);
  void addSample(std::uint32_t at, float radius);
  void visit(Cell& cell, const Centre& centre);
  std::uint32_t farthestOf(const Cell& cell) const;
  /// Makes centres of the samples farther than `from`, then of those farther than a little less, and so on.
  void descend(float from, float reach);

  std::size_t samples_{0};
  float cell_;
  Vector3f lower_;
  std::vector<Group> groups_;         ///< by cells
  std::vector<std::uint32_t> order_;  ///< place in the groups -> index of the sample, or none
  std::vector<Cell> cells_;
  std::vector<Brick> bricks_;
  std::vector<std::uint32_t> brick_table_;  ///< open addressing; a power of two
  std::vector<std::uint32_t> centres_;      ///< places in the groups of those that spread() and fill() took
  std::uint32_t count_{0};
};

}  // namespace abstand
