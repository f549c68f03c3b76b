// Plane fitting by RANSAC. Wraps PCL.
#include "tracking/depth/people/floor_consensus.hpp"

#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <algorithm>

#include "core/math/random.hpp"

namespace abstand::tracking {
namespace {

constexpr int kNeighbourhood = 5;  // a triple extends over this share of the grid's columns, to each side

using Point = pcl::PointXYZ;
using LevelPlane = pcl::SampleConsensusModelPerpendicularPlane<Point>;

FloorPlane planeOf(const Eigen::VectorXf& coefficients) {
  const Eigen::Vector4d c = coefficients.cast<double>();
  const double side = c.y() > 0.0 ? -1.0 : 1.0;  // the image's up direction is -y
  const double scale = side / c.head<3>().norm();
  return {scale * c.head<3>(), scale * c.w()};
}

/// PCL's plane perpendicular to an axis, with samples from a neighbourhood, its own seed (PCL's generator has
/// one global seed) and the caller's count.
class FloorModel : public LevelPlane {
 public:
  FloorModel(const pcl::PointCloud<Point>::ConstPtr& cloud, const PointGrid& grid,
             const ConsensusOptions& options, const std::function<std::size_t(const FloorPlane&)>& count)
      : LevelPlane(cloud), grid_(grid), count_(count), random_(options.seed, 0), tries_(options.tries) {
    setAxis(-Eigen::Vector3f::UnitY());
    setEpsAngle(options.tilt);
  }

  /// Three points near each other in the image are on one plane more often than three arbitrary points.
  void getSamples(int&, pcl::Indices& samples) override {
    const int reach = std::max(2, grid_.columns / kNeighbourhood);
    for (; tries_ > 0; --tries_) {
      const int column = below(grid_.columns), row = below(grid_.rows);
      const pcl::index_t a = grid_.indexOf(column, row);
      const pcl::index_t b = near(column, row, reach), c = near(column, row, reach);
      if (!measured(a) || !measured(b) || !measured(c)) continue;
      samples = {a, b, c};
      --tries_;
      return;
    }
    samples.clear();  // ends the search
  }
  std::size_t countWithinDistance(const Eigen::VectorXf& coefficients, double) const override {
    return isModelValid(coefficients) ? count_(planeOf(coefficients)) : 0;
  }

 private:
  int below(int limit) { return static_cast<int>(random_.below(static_cast<std::size_t>(limit))); }
  pcl::index_t near(int column, int row, int reach) {
    const int dc = below(2 * reach + 1) - reach, dr = below(2 * reach + 1) - reach;
    return grid_.indexOf(std::clamp(column + dc, 0, grid_.columns - 1),
                         std::clamp(row + dr, 0, grid_.rows - 1));
  }
  bool measured(pcl::index_t i) const { return !grid_.points[static_cast<std::size_t>(i)].isZero(0.0); }

  const PointGrid& grid_;
  const std::function<std::size_t(const FloorPlane&)>& count_;
  Random random_;
  int tries_;
};

/// Disables PCL's messages once: finding no plane is a valid result.
void silencePcl() {
  [[maybe_unused]] static const bool silent = [] {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    return true;
  }();
}

}  // namespace

std::optional<FloorPlane> consensusPlane(const PointGrid& grid, const ConsensusOptions& options,
                                         const std::function<std::size_t(const FloorPlane&)>& count) {
  if (grid.points.size() < 3) return std::nullopt;
  silencePcl();
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  for (const Vector3d& p : grid.points) {
    const Eigen::Vector3f f = p.cast<float>();
    cloud->push_back({f.x(), f.y(), f.z()});
  }
  const auto model = pcl::make_shared<FloorModel>(cloud, grid, options, count);
  // The count has its own threshold; PCL requires one to be set.
  pcl::RandomSampleConsensus<Point> search(model, 1.0);
  search.setProbability(options.certainty);
  search.setMaxIterations(options.tries);
  if (!search.computeModel()) return std::nullopt;
  Eigen::VectorXf coefficients;
  search.getModelCoefficients(coefficients);
  return planeOf(coefficients);
}

}  // namespace abstand::tracking
