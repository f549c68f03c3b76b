// 1. The distance of two meshes, with its bound.
//    01_distance [A.stl B.stl]
#include <abstand/library.hpp>
#include <abstand/query.hpp>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) try {
  const auto robots = abstand::dataDirectory() / "robots/lwr";
  const auto a = abstand::Structure::build(abstand::loadMesh(argc > 2 ? argv[1] : robots / "link1.stl"));
  const auto b = abstand::Structure::build(abstand::loadMesh(argc > 2 ? argv[2] : robots / "link4.stl"));

  abstand::Pose X_WB = abstand::Pose::Identity();  // pose of B in the world, m
  X_WB.translation() << 0.5, 0.1, 0.0;
  const abstand::PairResult r = abstand::queryPair(a, abstand::Pose::Identity(), b, X_WB);

  std::printf("distance %.4f m, and never below %.4f m\n", r.distance, r.distance - r.bound);
  std::printf("from (%.3f, %.3f, %.3f) to (%.3f, %.3f, %.3f)\n", r.witness_a.x(), r.witness_a.y(),
              r.witness_a.z(), r.witness_b.x(), r.witness_b.y(), r.witness_b.z());

  X_WB.translation() << 0.05, 0.0, 0.0;  // B is pressed into A
  const abstand::PairResult pressed = abstand::queryPair(a, abstand::Pose::Identity(), b, X_WB);
  std::printf("pressed: distance %.4f m, %d contacts, %.1f N on A\n", pressed.distance, pressed.contacts,
              pressed.force_a.norm());
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
