// A person moves the same after any form of one recording; a file that moves nobody is refused.
#include <gtest/gtest.h>

#include "app/session/session.hpp"
#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tracking/compact/compact_recording.hpp"
#include "tracking/registry/open_recording.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::testing {
namespace recording_session_test {

constexpr double kSame = 1e-9;  // m at the far end of a part; a table keeps every bit
/// m; the compact form rounds joints to 0.5 um, and a twist, which follows from how far a limb is bent,
/// enlarges that where it is nearly straight.
constexpr double kRounded = 2e-3;

/// One person alone, in structures as coarse as may be: only poses are looked at.
std::unique_ptr<session::Session> openPerson(const ScratchFolder& folder,
                                             const std::filesystem::path& recording, double speed = 1.0) {
  const auto scene = folder.write("scene.yaml",
                                  "abstand: 1\n"
                                  "defaults: {voxel: 0.05, point: 0.05, outer_layers: 1}\n"
                                  "humans:\n"
                                  "  - {name: someone, height: 1.75, recording: {file: " +
                                      recording.string() + "}}\npairs: {default: none}\n");
  session::SessionOptions options;
  options.person_speed = speed;
  options.threads = 1;
  options.cache = false;
  return std::make_unique<session::Session>(scene_file::loadScene(scene), options);
}

TEST(RecordingSession, PersonMotionIsSameForBvhTableAndCompact) {
  const ScratchFolder folder;
  const auto bvh = projectFile("data/scenes/hug_reach.bvh"), csv = folder.path() / "reach.csv",
             compact = folder.path() / "reach.rec";
  const tracking::Recording recording = tracking::openRecording(bvh);
  tracking::writeSkeletonCsv(csv, recording);
  tracking::writeCompact(compact, recording);
  const auto expected = openPerson(folder, bvh);
  ASSERT_EQ(expected->scene().objects().size(), 14u);
  for (const auto& [file, tolerance] : {std::pair{csv, kSame}, {compact, kRounded}}) {
    const auto session = openPerson(folder, file);
    double moved = 0.0;
    for (const double t : {0.0, 0.51, 1.23, 2.0}) {
      expected->applyMotion(t);
      session->applyMotion(t);
      for (std::size_t i = 0; i < 14; ++i) {
        const Transform &a = expected->scene().objects()[i].X_WB, &b = session->scene().objects()[i].X_WB;
        const Vector3d far(0.3, 0.3, 0.3);
        EXPECT_LT((a * far - b * far).norm(), tolerance) << file << " part " << i << " at " << t;
      }
      moved = std::max(moved, session->scene().objects()[0].X_WB.translation().norm());
    }
    EXPECT_GT(moved, 0.1) << "the person stands somewhere";
  }
}

TEST(RecordingSession, RecordingSpeedScalesTime) {
  const ScratchFolder folder;
  const auto bvh = projectFile("data/scenes/hug_reach.bvh");
  const auto slow = openPerson(folder, bvh), fast = openPerson(folder, bvh, 2.0);
  EXPECT_EQ(fast->frameTimes().size(), slow->frameTimes().size());
  EXPECT_NEAR(fast->frameTimes().back(), 0.5 * slow->frameTimes().back(), 1e-12);
  for (std::size_t frame = 0; frame < slow->frameTimes().size(); frame += 10) {
    slow->applyMotion(slow->frameTimes()[frame]);
    fast->applyMotion(fast->frameTimes()[frame]);
    for (std::size_t i = 0; i < 14; ++i)
      EXPECT_EQ(slow->scene().objects()[i].X_WB.matrix(), fast->scene().objects()[i].X_WB.matrix())
          << frame << " part " << i;
  }
}

TEST(RecordingSession, RejectsUnusableMarkers) {
  const ScratchFolder folder;
  const auto trc =
      folder.write("a.trc",
                   "PathFileType\t4\t(X/Y/Z)\ta.trc\nDataRate\tNumFrames\tNumMarkers\tUnits\n50\t1\t1\tmm\n"
                   "Frame#\tTime\tM1\n\t\tX1\tY1\tZ1\n\n1\t0\t1\t2\t3\n");
  EXPECT_THROW(openPerson(folder, trc), ParseError);
}

}  // namespace recording_session_test
}  // namespace abstand::testing
