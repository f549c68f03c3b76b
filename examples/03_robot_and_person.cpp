// 3. A URDF robot and a person from a BVH recording: time and place of the smallest distance.
//    03_robot_and_person [ROBOT.urdf PERSON.bvh]
#include <abstand/library.hpp>
#include <abstand/scene.hpp>
#include <cstdio>
#include <exception>
#include <limits>

int main(int argc, char** argv) try {
  const auto data = abstand::dataDirectory();
  abstand::RobotOptions robot;
  robot.q = {0.0, 0.6, 0.9, 0.0, 0.4, 0.0};  // rad
  if (argc > 1) robot.q.clear();
  abstand::PersonOptions person;
  person.height = 1.80;  // m
  person.recording =
      argc > 2 ? argv[2] : data / "scenes/hug_reach.bvh";  // units, axes and names are detected
  person.place << 1.3, 0.0, 0.0;                           // m
  person.yaw = -1.5708;  // rad: the recording faces +y, the person faces the arm

  abstand::SceneBuilder builder;
  builder.addRobot("arm", argc > 1 ? argv[1] : data / "robots/arm6/arm6.urdf", robot)
      .addPerson("visitor", person)
      .setResolution(0.01, 0.01);
  abstand::Scene scene(builder);
  for (const auto& remark : scene.remarks()) std::printf("%s\n", remark.c_str());

  abstand::PairResult least;
  least.distance = std::numeric_limits<double>::infinity();
  double when = 0.0;
  std::size_t nearest = 0;
  for (const double t : scene.frameTimes()) {
    scene.step(t);
    const std::size_t pair = *scene.nearest();
    if (scene.result(pair).distance >= least.distance) continue;
    least = scene.result(pair);
    when = t;
    nearest = pair;
  }
  const auto [a, b] = scene.pairObjects(nearest);
  std::printf("nearest at %.2f s: %s and %s, %.3f m and never below %.3f m\n", when,
              scene.objectName(a).c_str(), scene.objectName(b).c_str(), least.distance,
              least.distance - least.bound);
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
