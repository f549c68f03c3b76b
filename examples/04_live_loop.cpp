// 4. Live loop: receives joint values and skeletons and computes distances at 1 kHz.
#include <abstand/human.hpp>
#include <abstand/library.hpp>
#include <abstand/scene.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <thread>

int main() try {
  using namespace abstand;
  using Clock = std::chrono::steady_clock;
  PersonOptions visitor;
  visitor.place << 1.2, 0.0, 0.0;  // m
  SceneBuilder builder;
  builder.addRobot("arm", dataDirectory() / "robots/arm6/arm6.urdf").addPerson("visitor", visitor);
  builder.setResolution(0.01, 0.01);
  Scene scene(builder);
  const Skeleton standing = Human({.height = 1.75}).rest();

  const auto start = Clock::now();
  double slowest = 0.0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const auto due = start + std::chrono::milliseconds(cycle);
    std::this_thread::sleep_until(due);
    const double t = 1e-3 * cycle;  // s

    // A real program reads the encoders of the robot and a tracker here.
    const std::vector<double> q{0.3 * std::sin(3 * t), 0.8, 0.6, 0.0, 0.4, 0.0};
    Skeleton skeleton = standing;
    skeleton.t = t;
    for (auto& joint : skeleton.p) joint.x() -= 0.3 * t;  // walks towards the arm, m

    const auto begin = Clock::now();
    scene.moveRobot(0, q, t);
    scene.movePerson(0, skeleton);
    scene.query(t);
    slowest = std::fmax(slowest, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());

    const std::size_t pair = *scene.nearest();
    const PairResult r = scene.result(pair);
    const double safe = r.distance - r.bound - scene.uncertainty(pair);  // certified clearance
    if (cycle % 200 == 0) std::printf("%.1f s: at least %.3f m apart\n", t, safe);
    if (safe < 0.05) {
      std::printf("%.3f s: %.3f m, stop!\n", t, safe);
      break;
    }
  }
  std::printf("slowest cycle: %.0f us\n", slowest);
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
