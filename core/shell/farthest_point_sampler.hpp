// Farthest-point sampling of weighted surface samples.
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
  /// Unit normal times the length (m) that a difference of 1 between unit normals is weighted with.
  Vector3f normal;
  /// At least 1: factor of squared distances to this sample; larger values attract denser centres.
  float weight;
};

/// Covers samples of a surface with centres, one after the other. Distances are measured in six dimensions,
/// position and scaled normal, so that neither faces that meet at an angle nor the two sides of a plate cover
/// each other, and strongly curved places get more centres. Samples are stored in the non-empty cells of a
/// sparse grid; a new centre updates only the cells around it.
class FarthestPointSampler {
 public:
  /// Starts with new samples, at least one, and no centres. `cell`: edge of the grid's cells, about the last
  /// `radius` (m). Centres found are numbered from `first_centre` on.
  void start(const std::vector<Sample>& samples, double cell, std::uint32_t first_centre = 0);
  /// Restarts with the same samples. nearest[i]: index of the nearest existing centre of sample i, in the
  /// order given to start(); the centres have positions `points` and scaled normals `normals`.
  void restart(std::span<const std::uint32_t> nearest, const std::vector<Vector3f>& points,
               const std::vector<Vector3f>& normals, std::uint32_t first_centre);

  /// Adds an existing centre: updates the samples within `radius` of it.
  void offer(std::uint32_t centre, const Vector3f& point, const Vector3f& normal, double radius);
  /// Farthest-point sampling (Gonzalez 1985) until every sample is within `radius` of a centre. `radius` is
  /// at most four cells. Each new centre is farther than `radius` from all earlier and offered ones, and
  /// within a few percent the farthest sample. Distant centres are first selected from one sample for each
  /// cell.
  void selectCentres(double radius);
  /// Adds centres until every sample is within `radius` of one.
  void fillHoles(double radius);
  struct Found {
    Sample sample;
    float distance2;  ///< squared distance to the earlier centres
  };
  /// Samples that became centres since start() or restart(), by index.
  std::vector<Found> found() const;
  /// Nearest centre of each sample, in the order given to start(). Exact for samples within the last
  /// `radius`.
  void nearest(std::span<std::uint32_t> out) const;

 private:
  static constexpr int kLanes = 4;
  struct Centre {
    float id;  ///< sample index as bits
    Four p;    ///< fourth component 0
    Vector3f n;
  };
  /// Samples as a structure of arrays. Padding repeats a sample and counts as covered.
  struct Group {
    Four x, y, z, nx, ny, nz, weight;
    Four distance2;  ///< squared distance to the nearest centre
    Four nearest;    ///< index of the nearest centre as bits, for lane selection
  };
  /// Range of groups with the samples of one cell.
  struct Cell {
    Four lower, upper;  ///< box of the positions; fourth component 0
    float farthest;     ///< largest squared distance to the nearest centre
    float min_weight;
    std::uint32_t begin, end;
  };
  /// 4 x 4 x 4 cells. Bit (z 4 + y) 4 + x of `occupied`: the cell has samples; its index is first + the
  /// number of lower bits set.
  struct SparseBlock {
    Vector3i at;
    std::uint32_t first;
    std::uint64_t occupied;
    std::uint8_t offset[64];
  };

  Vector3i cellOf(const Vector3f& p) const;
  const SparseBlock* blockAt(const Vector3i& at) const;
  std::uint32_t addBlock(const Vector3i& at);
  /// Sorts the samples into cells.
  void sortIntoCells(const std::vector<Sample>& samples);
  void store(std::uint32_t at, const Sample& sample, float distance2);
  Sample sample(std::uint32_t at) const;
  void add(std::uint32_t id, const Vector3f& p, const Vector3f& n, float radius);
  void addSample(std::uint32_t at, float radius, float distance2);
  void updateCell(Cell& cell, const Centre& centre);
  std::uint32_t farthestOf(const Cell& cell) const;
  float farthest2() const;
  /// Selects samples farther than `from` as centres, then lowers the threshold step by step to `radius`.
  void lowerThreshold(float from, float radius);

  float cell_{0.0f}, per_cell_{0.0f};
  Vector3f lower_;
  std::vector<Group> groups_;         ///< sorted by cells
  std::vector<std::uint32_t> order_;  ///< index in the groups -> index of the sample, or none
  std::vector<Cell> cells_;
  std::vector<SparseBlock> blocks_;
  std::vector<std::uint32_t> block_table_;  ///< open addressing; a power of two
  std::vector<std::uint32_t> cell_of_;      ///< cell of each sample during sorting
  struct Selected {
    std::uint32_t at;  ///< index in the groups
    float distance2;   ///< as in Found
  };
  std::vector<Selected> centres_;  ///< centres selected by selectCentres() and fillHoles()
  std::uint32_t first_centre_{0};
};

}  // namespace abstand::shell
