#include "tests/tracking/depth/calibration/pcl_table.hpp"

#include <pcl/console/print.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/search/organized.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "tests/tracking/depth/calibration/room_cases.hpp"

namespace abstand::testing {
namespace {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Normals = pcl::PointCloud<pcl::Normal>;
using tracking::DepthCamera;
using tracking::DepthImage;

constexpr float kReach = 0.07f;  // m, as RoomView

/// Of the processor, for all threads together.
template <class Work>
double milliseconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Organised; unmeasured points are NaN.
Cloud::Ptr cloudOf(const DepthCamera& camera, const DepthImage& image) {
  auto cloud = pcl::make_shared<Cloud>(static_cast<std::uint32_t>(image.width),
                                       static_cast<std::uint32_t>(image.height));
  cloud->is_dense = false;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const double z = static_cast<double>(image.at(u, v));
      const Eigen::Vector3f p =
          z > 0.0 ? Eigen::Vector3f(camera.at(u, v, z).cast<float>()) : Eigen::Vector3f::Constant(NAN);
      cloud->at(u, v) = Point(p.x(), p.y(), p.z());
    }
  return cloud;
}

/// Unit normals by pixel; zero: none.
using NormalImage = std::vector<Vector3d>;

NormalImage oursOf(const DepthCamera& camera, const DepthImage& image) {
  const tracking::RoomView view(camera, image);
  NormalImage normals(image.z.size(), Vector3d::Zero());
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u)
      if (const double z = static_cast<double>(image.at(u, v)); z > 0.0)
        if (const tracking::RoomPoint* p = view.at(camera.at(u, v, z)))
          normals[static_cast<std::size_t>(v * image.width + u)] = p->n_C;
  return normals;
}

NormalImage imageOf(const Normals& found) {
  NormalImage normals;
  for (const pcl::Normal& n : found) {
    const Vector3d v = n.getNormalVector3fMap().cast<double>();
    normals.push_back(v.allFinite() ? v : Vector3d(Vector3d::Zero()));
  }
  return normals;
}

struct Method {
  std::string name;
  std::function<void(const Cloud::Ptr&, Normals&)> compute;
};

std::vector<Method> methods() {
  const auto integral = [](auto kind) {
    return [kind](const Cloud::Ptr& cloud, Normals& normals) {
      pcl::IntegralImageNormalEstimation<Point, pcl::Normal> estimation;
      estimation.setNormalEstimationMethod(kind);
      estimation.setMaxDepthChangeFactor(0.03f);
      estimation.setNormalSmoothingSize(12.0f);
      estimation.setDepthDependentSmoothing(true);
      estimation.setInputCloud(cloud);
      estimation.compute(normals);
    };
  };
  using Integral = pcl::IntegralImageNormalEstimation<Point, pcl::Normal>;
  return {{"`NormalEstimation`, radius 7 cm, kd-tree",
           [](const Cloud::Ptr& cloud, Normals& normals) {
             pcl::NormalEstimation<Point, pcl::Normal> estimation;
             estimation.setInputCloud(cloud);
             estimation.setRadiusSearch(kReach);
             estimation.compute(normals);
           }},
          {"`NormalEstimation`, radius 7 cm, search in the image",
           [](const Cloud::Ptr& cloud, Normals& normals) {
             pcl::NormalEstimation<Point, pcl::Normal> estimation;
             estimation.setInputCloud(cloud);
             estimation.setSearchMethod(pcl::make_shared<pcl::search::OrganizedNeighbor<Point>>());
             estimation.setRadiusSearch(kReach);
             estimation.compute(normals);
           }},
          {"`NormalEstimationOMP`, the same, two threads",
           [](const Cloud::Ptr& cloud, Normals& normals) {
             pcl::NormalEstimationOMP<Point, pcl::Normal> estimation(2);
             estimation.setInputCloud(cloud);
             estimation.setSearchMethod(pcl::make_shared<pcl::search::OrganizedNeighbor<Point>>());
             estimation.setRadiusSearch(kReach);
             estimation.compute(normals);
           }},
          {"`IntegralImageNormalEstimation`, covariance", integral(Integral::COVARIANCE_MATRIX)},
          {"`IntegralImageNormalEstimation`, mean 3D gradient", integral(Integral::AVERAGE_3D_GRADIENT)},
          {"`IntegralImageNormalEstimation`, mean depth change", integral(Integral::AVERAGE_DEPTH_CHANGE)}};
}

/// Errors (degrees) of one method in all images, on the pixels of surfaces, and its time.
struct NormalErrors {
  std::vector<double> common;  ///< where RoomView has a normal, too
  double found{0.0}, pixels{0.0}, ms{0.0};

  void add(const NormalImage& normals, const NormalImage& ours, const NormalImage& truth) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i].isZero(0.0)) continue;
      ++pixels;
      found += !normals[i].isZero(0.0);
      if (normals[i].isZero(0.0) || ours[i].isZero(0.0)) continue;
      common.push_back(std::acos(std::min(1.0, std::abs(normals[i].dot(truth[i])))) / unit::deg(1.0));
    }
  }
  void print(const std::string& name, int images, double ours_ms) {
    double sum = 0.0;
    for (const double e : common) sum += e * e;
    std::sort(common.begin(), common.end());
    std::printf("| %s | %d | %.1f; %.1f | %.2f | %.1f |\n", name.c_str(), images,
                std::sqrt(sum / static_cast<double>(common.size())), common[common.size() * 95 / 100],
                found / pixels, ms / ours_ms);
    std::fflush(stdout);
  }
};

}  // namespace

void printNormals() {
  std::printf(
      "\n| normals | images | error: RMS; 95 %% (degrees) | share of the surfaces | processor time "
      "|\n|---|---:|---:|---:|---:|\n");
  for (const int images : {1, 20}) {
    const std::vector<Method> all = methods();
    std::vector<NormalErrors> errors(all.size() + 1);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const std::vector<Box> boxes = roomOf({}, seed);
      const DepthCamera camera = camerasOf(seed, 320)[0];
      const DepthImage image = roomSeen(camera, boxes, seed, images);
      const NormalImage truth = trueNormals(camera, rendered(camera, boxes)), ours = oursOf(camera, image);
      errors[0].ms += milliseconds([&] { const tracking::RoomView view(camera, image); });
      errors[0].add(ours, ours, truth);
      const Cloud::Ptr cloud = cloudOf(camera, image);
      for (std::size_t m = 0; m < all.size(); ++m) {
        Normals found;
        errors[m + 1].ms += milliseconds([&] { all[m].compute(cloud, found); });
        errors[m + 1].add(imageOf(found), ours, truth);
      }
    }
    const double ours_ms = errors[0].ms;
    errors[0].print("planes fitted in the image (`RoomView`)", images, ours_ms);
    for (std::size_t m = 0; m < all.size(); ++m) errors[m + 1].print(all[m].name, images, ours_ms);
  }
}

namespace {

struct Cell {
  std::int32_t x, y, z;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    // Teschner and others 2003.
    return static_cast<std::size_t>(c.x) * 73856093u ^ static_cast<std::size_t>(c.y) * 19349663u ^
           static_cast<std::size_t>(c.z) * 83492791u;
  }
};

Cell cellOf(const Point& p, float leaf) {
  const auto index = [leaf](float x) { return static_cast<std::int32_t>(std::floor(x / leaf)); };
  return {index(p.x), index(p.y), index(p.z)};
}

Cloud::Ptr thinnedByLoop(const Cloud::Ptr& cloud, float leaf) {
  std::unordered_map<Cell, std::pair<Eigen::Vector3f, float>, CellHash> cells;
  cells.reserve(cloud->size() / 8);
  for (const Point& p : *cloud) {
    auto [at, is_new] = cells.try_emplace(cellOf(p, leaf), Eigen::Vector3f::Zero(), 0.0f);
    at->second.first += p.getVector3fMap();
    at->second.second += 1.0f;
  }
  auto thin = pcl::make_shared<Cloud>();
  for (const auto& [cell, sum] : cells) {
    const Eigen::Vector3f p = sum.first / sum.second;
    thin->push_back({p.x(), p.y(), p.z()});
  }
  return thin;
}

template <class Grid>
Cloud::Ptr thinnedBy(const Cloud::Ptr& cloud, float leaf) {
  auto thin = pcl::make_shared<Cloud>();
  Grid grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(leaf, leaf, leaf);
  grid.filter(*thin);
  return thin;
}

using Thin = Cloud::Ptr (*)(const Cloud::Ptr&, float);

Cloud::Ptr pointsOf(const tracking::RoomView& view) {
  auto cloud = pcl::make_shared<Cloud>();
  for (const tracking::RoomPoint& point : view.points()) {
    const Eigen::Vector3f p = point.p_C.cast<float>();
    cloud->push_back({p.x(), p.y(), p.z()});
  }
  return cloud;
}

/// The stages of CloudRegistration with other thinned clouds.
Eigen::Matrix4f aligned(const Cloud::Ptr& source, const Cloud::Ptr& target, Thin thin, Eigen::Matrix4f X) {
  for (const auto& [leaf, distance] : {std::pair(0.12f, 0.6), std::pair(0.06f, 0.2)}) {
    pcl::GeneralizedIterativeClosestPoint<Point, Point> icp;
    icp.setInputSource(thin(source, leaf));
    icp.setInputTarget(thin(target, leaf));
    icp.setCorrespondenceRandomness(20);
    icp.setMaxCorrespondenceDistance(distance);
    icp.setMaximumIterations(60);
    icp.setTransformationEpsilon(1e-5);
    icp.setRotationEpsilon(1e-5);
    Cloud moved;
    icp.align(moved, X);
    if (icp.getFinalTransformation().allFinite()) X = icp.getFinalTransformation();
  }
  return X;
}

/// Share of the points of `a` that `b` has within 0.1 mm.
double shareIn(const Cloud& a, const Cloud& b, float leaf) {
  std::unordered_map<Cell, std::vector<Point>, CellHash> cells;
  for (const Point& p : b) cells[cellOf(p, leaf)].push_back(p);
  double same = 0.0;
  for (const Point& p : a)
    if (const auto at = cells.find(cellOf(p, leaf)); at != cells.end())
      same += std::any_of(at->second.begin(), at->second.end(), [&](const Point& q) {
        return (p.getVector3fMap() - q.getVector3fMap()).norm() < 1e-4f;
      });
  return same / static_cast<double>(a.size());
}

}  // namespace

void printVoxelGrids() {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  constexpr float kLeaf = 0.06f;
  constexpr std::uint64_t kSeeds = 20;
  const std::array<std::pair<const char*, Thin>, 3> all{
      {{"plain loop with a hash map", thinnedByLoop},
       {"`VoxelGrid`", thinnedBy<pcl::VoxelGrid<Point>>},
       {"`ApproximateVoxelGrid`", thinnedBy<pcl::ApproximateVoxelGrid<Point>>}}};
  std::array<double, 3> ms{}, points{}, same{}, squares{}, worst{}, icp_ms{};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RoomCase c = roomCase({}, seed, 320, 5);
    const Cloud::Ptr source = pointsOf(c.camera), target = pointsOf(c.known);
    const Transform& X_WK = c.known.camera().X_WC;
    const Eigen::Matrix4f start = (X_WK.inverse() * c.camera.camera().X_WC).matrix().cast<float>();
    const Cloud::Ptr plain = thinnedByLoop(source, kLeaf);
    for (std::size_t k = 0; k < all.size(); ++k) {
      Cloud::Ptr thin;
      ms[k] += milliseconds([&] { thin = all[k].second(source, kLeaf); });
      points[k] += static_cast<double>(thin->size()) / kSeeds;
      same[k] += shareIn(*thin, *plain, kLeaf) / kSeeds;
      Eigen::Matrix4f X;
      icp_ms[k] += milliseconds([&] { X = aligned(source, target, all[k].second, start); });
      const Vector3d off = X_WK * Vector3d(X.topRightCorner<3, 1>().cast<double>()) - c.truth.translation();
      squares[k] += off.squaredNorm() / kSeeds;
      worst[k] = std::max(worst[k], off.norm());
    }
  }
  std::printf(
      "\n| voxels of 6 cm | points | the same points | processor time | generalised ICP: position error, "
      "RMS; max | "
      "its time |\n"
      "|---|---:|---:|---:|---:|---:|\n");
  for (std::size_t k = 0; k < all.size(); ++k)
    std::printf("| %s | %.0f | %.3f | %.2f | %.1f; %.1f mm | %.2f |\n", all[k].first, points[k], same[k],
                ms[k] / ms[0], 1e3 * std::sqrt(squares[k]), 1e3 * worst[k], icp_ms[k] / icp_ms[0]);
  std::printf("thinning took %.4f of the time of generalised ICP\n", ms[1] / icp_ms[1]);
}

}  // namespace abstand::testing
