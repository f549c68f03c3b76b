// 2. Throughput in poses per millisecond: one pair in independent poses, and along a path.
#include <abstand/query.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>

using namespace abstand;

/// Prints the number of poses per millisecond.
static void time(const char* what, const Structure& a, const Structure& b, const std::vector<Pose>& poses,
                 const BatchOptions& batch) {
  const std::vector<Pose> at_rest{Pose::Identity()};  // one pose of A for all poses of B
  std::vector<PairResult> results(poses.size());
  const auto start = std::chrono::steady_clock::now();
  queryPoses(a, at_rest, b, poses, batch, results);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  double least = results[0].distance;
  for (const PairResult& r : results) least = std::fmin(least, r.distance);
  std::printf("%-22s %7.0f poses a millisecond, nearest %.4f m\n", what, poses.size() / took.count(), least);
}

int main() try {
  const Structure robot = Structure::build(Shape::capsule(0.06, 0.4));
  const Structure person = Structure::build(Shape::ellipsoid({0.12, 0.18, 0.3}));

  std::vector<Pose> path;  // once around, 20,000 frames
  for (int i = 0; i < 20000; ++i) {
    const double angle = 2e-5 * M_PI * 10 * i;
    Pose X = Pose::Identity();
    X.translation() << 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.1 * std::sin(3 * angle);
    X.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
    path.push_back(X);
  }
  time("each for itself", robot, person, path, {});
  time("as a motion", robot, person, path, {.sequence = true});
  time("as a motion, all cores", robot, person, path, {.threads = 0, .sequence = true});
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
