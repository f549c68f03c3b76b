// Registration of two point clouds by generalised ICP. Wraps PCL.
#include "tracking/depth/calibration/cloud_registration.hpp"

#include <pcl/console/print.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>

#include <array>

namespace abstand::tracking {
namespace {

using IcpPoint = pcl::PointXYZ;
using IcpCloud = pcl::PointCloud<IcpPoint>;

struct IcpLevel {
  float voxel;      ///< m, side of a voxel
  double distance;  ///< m, to the nearest point of the other cloud
};
constexpr std::array<IcpLevel, 2> kIcpLevels{{{0.12f, 0.6}, {0.06f, 0.2}}};
constexpr std::size_t kFewestIcpPoints = 50;
constexpr int kIcpNeighbours = 20;  // of a point, for its plane
constexpr int kIcpIterations = 60;
constexpr double kSmallIcpStep = 1e-5;  // of the transform, as PCL measures it

IcpCloud::Ptr cloudOf(const std::vector<Vector3d>& points) {
  auto cloud = pcl::make_shared<IcpCloud>();
  for (const Vector3d& p : points) {
    const Eigen::Vector3f f = p.cast<float>();
    cloud->push_back({f.x(), f.y(), f.z()});
  }
  return cloud;
}

IcpCloud::Ptr thinned(const IcpCloud::ConstPtr& cloud, float voxel) {
  auto thin = pcl::make_shared<IcpCloud>();
  pcl::VoxelGrid<IcpPoint> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(voxel, voxel, voxel);
  grid.filter(*thin);
  return thin;
}

}  // namespace

struct CloudRegistration::Clouds {
  std::array<IcpCloud::Ptr, kIcpLevels.size()> source, target;
};

CloudRegistration::CloudRegistration(const std::vector<Vector3d>& source, const std::vector<Vector3d>& target)
    : clouds_(std::make_unique<Clouds>()) {
  // Too few neighbours are a valid result, not a message.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const IcpCloud::Ptr all_source = cloudOf(source), all_target = cloudOf(target);
  for (std::size_t i = 0; i < kIcpLevels.size(); ++i) {
    clouds_->source[i] = thinned(all_source, kIcpLevels[i].voxel);
    clouds_->target[i] = thinned(all_target, kIcpLevels[i].voxel);
  }
}

CloudRegistration::~CloudRegistration() = default;

Transform CloudRegistration::align(const Transform& X_TS) const {
  bool is_aligned = false;
  Eigen::Matrix4f X = X_TS.matrix().cast<float>();
  for (std::size_t i = 0; i < kIcpLevels.size(); ++i) {
    const IcpCloud::Ptr &source = clouds_->source[i], &target = clouds_->target[i];
    if (std::min(source->size(), target->size()) < kFewestIcpPoints) continue;
    pcl::GeneralizedIterativeClosestPoint<IcpPoint, IcpPoint> icp;
    icp.setInputSource(source);
    icp.setInputTarget(target);
    icp.setCorrespondenceRandomness(kIcpNeighbours);
    icp.setMaxCorrespondenceDistance(kIcpLevels[i].distance);
    icp.setMaximumIterations(kIcpIterations);
    icp.setTransformationEpsilon(kSmallIcpStep);
    icp.setRotationEpsilon(kSmallIcpStep);
    IcpCloud moved;
    icp.align(moved, X);
    if (!icp.getFinalTransformation().allFinite()) continue;
    X = icp.getFinalTransformation();
    is_aligned = true;
  }
  if (!is_aligned) return X_TS;
  Transform aligned = X_TS;
  aligned.linear() =
      Quaterniond(Matrix3d(X.topLeftCorner<3, 3>().cast<double>())).normalized().toRotationMatrix();
  aligned.translation() = X.topRightCorner<3, 1>().cast<double>();
  return aligned;
}

}  // namespace abstand::tracking
