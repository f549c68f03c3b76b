// Check of bit-identical results for any number of threads.
#include "core/verify/same_bits.hpp"

#include <array>

#include "core/base/state_hash.hpp"
#include "core/math/random.hpp"
#include "core/scene/scene.hpp"
#include "core/verify/adversarial_bodies.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::verify {
namespace {

constexpr std::array kThreads{1, 2, 3, 7, 16};
constexpr int kFrames = 20;
constexpr double kMargin = 0.02;    // m
constexpr double kPoseRange = 0.2;  // m

scene::Scene makeScene(const std::vector<AdversarialBody>& bodies) {
  scene::Scene scene;
  std::vector<ObjectId> ids;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    ids.push_back(
        scene.addObject({bodies[i].name, "objects", bodies[i].structures[i % kFields.size()], kMargin}));
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = i + 1; j < ids.size(); ++j) scene.addPair(ids[i], ids[j]);
  return scene;
}

std::uint64_t fingerprint(const scene::Scene& scene) {
  StateHash hash;
  const auto add = [&hash](const Vector3d& v) {
    for (int i = 0; i < 3; ++i) hash.add(v[i]);
  };
  for (const scene::Pair& pair : scene.pairs()) {
    const query::PairResult& r = pair.result;
    for (const double v : {r.distance, r.bound, r.depth, static_cast<double>(r.contacts)}) hash.add(v);
    for (const Vector3d& v : {r.witness_a, r.witness_b, r.force_a, r.torque_a, r.torque_b}) add(v);
  }
  for (const scene::Object& object : scene.objects()) {
    add(object.contact.force);
    add(object.contact.torque);
  }
  return hash.value();
}

}  // namespace

std::vector<CheckResult> checkSameBits(const VerifyOptions& options) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(options.threads);
  scene::Scene scene = makeScene(bodies);
  std::vector<std::uint64_t> expected;
  std::vector<double> differs;
  CheckResult result;
  result.table.header = {"threads", "frames", "frames that differ from one thread's"};
  for (const int threads : kThreads) {
    scene.setThreads(threads);
    int wrong = 0;
    for (int frame = 0; frame < kFrames && !options.stop(); ++frame) {
      Random random(options.seed, static_cast<std::uint64_t>(frame));
      for (std::uint32_t i = 0; i < scene.objectCount(); ++i) {
        Transform X = Transform::Identity();
        X.linear() = random.rotation();
        X.translation() = random.inCube(kPoseRange);
        scene.setPose(ObjectId{i}, X, frame * 0.001);
      }
      scene.step();
      const std::uint64_t bits = fingerprint(scene);
      if (threads == 1) {
        expected.push_back(bits);
        continue;
      }
      const bool same = bits == expected[static_cast<std::size_t>(frame)];
      differs.push_back(same ? 0.0 : 1.0);
      wrong += !same;
    }
    result.table.rows.push_back({std::to_string(threads), std::to_string(kFrames), std::to_string(wrong)});
  }
  result.name = "same_bits";
  result.what = "A scene of " + std::to_string(bodies.size()) + " bodies and " +
                std::to_string(scene.pairs().size()) +
                " pairs in lock step gives the same bits on 1, 2, 3, 7 and 16 threads.";
  result.quantity = "1 where a frame differs";
  result.reason = "Pairs are independent and summed in their order.";
  judge(result, differs, 0.0);
  result.passed = result.passed && differs.size() == (kThreads.size() - 1) * kFrames;
  return {result};
}

}  // namespace abstand::verify
