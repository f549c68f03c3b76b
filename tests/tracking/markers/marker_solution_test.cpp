// Bodies found again from their markers.
#include "tracking/markers/marker_solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/markers/synthetic_markers.hpp"

namespace abstand::tracking {
namespace marker_solution_test {

using testing::makeMarkers;
using testing::SyntheticMarkers;

/// Root mean square over all frames, of joints that are there (m); hands and head apart, which end at points
/// that no marker shows.
double jointError(const SyntheticMarkers& m, const std::vector<humanmodel::SkeletonFrame>& frames,
                  humanmodel::Joint j) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].has(j)) continue;
    sum += (frames[i][j] - m.joints[i][j]).squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : kInfinity;
}

constexpr humanmodel::Joint kLimbJoints[]{
    humanmodel::Joint::kHipLeft,    humanmodel::Joint::kHipRight,    humanmodel::Joint::kKneeLeft,
    humanmodel::Joint::kKneeRight,  humanmodel::Joint::kAnkleLeft,   humanmodel::Joint::kAnkleRight,
    humanmodel::Joint::kElbowLeft,  humanmodel::Joint::kElbowRight,  humanmodel::Joint::kWristLeft,
    humanmodel::Joint::kWristRight, humanmodel::Joint::kShoulderLeft};

TEST(BodySizes, JacobianMatchesFiniteDifferences) {
  const BodyRig base = makeRig(humanmodel::makeHuman({}));
  SizeVector sizes = sameSizes();
  sizes[0] = 1.04;
  sizes[static_cast<int>(index(BodySize::kThigh))] = 0.05;
  const RigPose pose = testing::walkingPose(base, 0.4);
  const auto placeOf = [&](const SizeVector& at, RigSegment s, const Vector3d& p) -> Vector3d {
    RigPlacement X_WS;
    place(resized(base, at), pose, X_WS);
    return X_WS[index(s)] * growth(s, at).cwiseProduct(p);
  };
  constexpr double kChange = 1e-4, kTolerance = 1e-9;  // linear in the sizes: roundings only
  const Vector3d p{0.03, -0.02, -0.1};
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    RigPlacement X_WS;
    place(resized(base, sizes), pose, X_WS);
    const auto J = sizeJacobian(base, X_WS, segmentAt(i), p);
    for (int k = 0; k < static_cast<int>(kBodySizes); ++k) {
      const SizeVector moved = sizes + kChange * SizeVector::Unit(k);
      const Vector3d numeric = (placeOf(moved, segmentAt(i), p) - placeOf(sizes, segmentAt(i), p)) / kChange;
      EXPECT_LT((numeric - J.col(k)).norm(), kTolerance)
          << segmentName(segmentAt(i)) << ", " << sizeName(static_cast<BodySize>(k));
    }
  }
}

TEST(MarkerSolution, ExactMarkersRecoverBody) {
  // Markers where the set has them: nothing pulls the body away from the truth but the priors of its sizes.
  const SyntheticMarkers m = makeMarkers(1, 2.0, 30.0, 0.0, 0.0);
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments);
  EXPECT_EQ(s.report.lost, 0u);
  EXPECT_LT(s.report.rms, 0.001);
  for (const humanmodel::Joint j : kLimbJoints)
    EXPECT_LT(jointError(m, s.frames, j), 0.004) << humanmodel::jointName(j);
  EXPECT_NEAR(s.report.stature, m.body.height, 0.02);
}

TEST(MarkerSolution, RecoversJointsUnderNoiseGapsAndSwappedLabels) {
  SyntheticMarkers m = makeMarkers(2, 4.0, 50.0, 0.001, 0.005);
  std::mt19937_64 random(3);
  const auto markerOf = [&](const char* label) {
    return static_cast<std::size_t>(
        std::find_if(m.found.begin(), m.found.end(), [&](const auto& f) { return f.label == label; }) -
        m.found.begin());
  };
  const std::size_t knee = markerOf("LKNE"), ankle = markerOf("LANK"), ghost = markerOf("RTIB");
  for (std::size_t i = 0; i < m.moments.size(); ++i) {
    // Two labels exchanged in a fifth of the frames, one marker on the floor in some.
    if (i >= 60 && i < 100) std::swap(m.moments[i][knee], m.moments[i][ankle]);
    if (i >= 120 && i < 150) m.moments[i][ghost] = Vector3d(1.0, 1.0, 0.0);
    for (auto& p : m.moments[i])
      if (random() % 5 == 0) p.setConstant(kNaN);
  }
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments);
  EXPECT_EQ(s.report.lost, 0u);
  // The priors hold what markers some 9 mm from the set's places say of the joints to within a few mm.
  for (const humanmodel::Joint j : kLimbJoints)
    EXPECT_LT(jointError(m, s.frames, j), 0.010) << humanmodel::jointName(j);
  double mean = 0.0;
  for (const humanmodel::Joint j : kLimbJoints) mean += jointError(m, s.frames, j) / std::size(kLimbJoints);
  EXPECT_LT(mean, 0.006);
  EXPECT_LT(s.report.rms, 0.003);
  // What is exchanged is not believed, and named.
  ASSERT_EQ(s.report.swaps.size(), 1u);
  EXPECT_EQ(s.report.swaps[0].a, "LKNE");
  EXPECT_EQ(s.report.swaps[0].b, "LANK");
  EXPECT_GT(s.report.swaps[0].frames, 15u);  // both seen: 0.64 of 40
  for (const auto& use : s.report.used) {
    const bool is_wrong = use.label == "LKNE" || use.label == "LANK" || use.label == "RTIB";
    if (is_wrong)
      EXPECT_GT(use.misplaced, 15u) << use.label;
    else
      EXPECT_EQ(use.misplaced, 0u) << use.label;
  }
}

TEST(MarkerSolution, IgnoresMarkerThatNeverFits) {
  SyntheticMarkers m = makeMarkers(4, 2.0, 30.0, 0.001, 0.003);
  for (std::size_t i = 0; i < m.moments.size(); ++i)
    m.moments[i][0] = Vector3d(0.5 + 0.01 * static_cast<double>(i), -1.0, 0.2);
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments);
  ASSERT_EQ(s.report.ignored.size(), 1u);
  EXPECT_EQ(s.report.ignored[0].first, m.found[0].label);
  for (const humanmodel::Joint j : kLimbJoints)
    EXPECT_LT(jointError(m, s.frames, j), 0.012) << humanmodel::jointName(j);
}

TEST(MarkerSolution, FramesWithoutMarkersAreUnseen) {
  SyntheticMarkers m = makeMarkers(5, 3.0, 30.0, 0.001, 0.003);
  for (std::size_t i = 30; i < 60; ++i)
    for (auto& p : m.moments[i]) p.setConstant(kNaN);
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments);
  EXPECT_EQ(s.report.unseen, 30u);
  EXPECT_EQ(s.report.lost, 0u);
  for (std::size_t i = 0; i < m.moments.size(); ++i)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      EXPECT_EQ(s.frames[i].state[j] == humanmodel::JointState::kMissing, i >= 30 && i < 60) << i;
}

TEST(MarkerSolution, KeepsStatedStature) {
  const SyntheticMarkers m = makeMarkers(9, 3.0, 30.0, 0.001, 0.003);
  const double truth = m.sizes[0] * m.base.height;
  EXPECT_NEAR(solveMarkers(m.base, m.found, m.t, m.moments, 0.94 * truth).report.stature, 0.94 * truth,
              0.02 * truth);
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments, truth);
  EXPECT_NEAR(s.report.stature, truth, 0.01 * truth);
  for (const humanmodel::Joint j : kLimbJoints)
    EXPECT_LT(jointError(m, s.frames, j), 0.012) << humanmodel::jointName(j);
}

TEST(MarkerSolution, RandomPointsAreReportedLost) {
  SyntheticMarkers m = makeMarkers(8, 2.0, 30.0, 0.0, 0.0);
  std::mt19937_64 random(10);
  for (auto& moment : m.moments)
    for (auto& p : moment)
      for (int k = 0; k < 3; ++k) p[k] = 10.0 * (static_cast<double>(random() >> 11) * 0x1p-53);
  const MarkerSolution s = solveMarkers(m.base, m.found, m.t, m.moments);
  EXPECT_EQ(s.report.lost, m.moments.size());
  for (auto& moment : m.moments)
    for (auto& p : moment) p.setConstant(kNaN);
  EXPECT_EQ(solveMarkers(m.base, m.found, m.t, m.moments).report.unseen, m.moments.size());
}

TEST(MarkerSolution, JointsWithoutMarkersAreNotTracked) {
  SyntheticMarkers m = makeMarkers(6, 2.0, 30.0, 0.001, 0.003);
  for (auto& moment : m.moments)
    for (std::size_t k = 0; k < m.found.size(); ++k) {
      const auto s = m.found[k].segment;
      const bool is_leg = s == RigSegment::kPelvis || index(s) >= index(RigSegment::kThighLeft);
      if (!is_leg) moment[k].setConstant(kNaN);
    }
  std::vector<FoundMarker> legs;
  std::vector<MarkerPlaces> moments(m.moments.size());
  for (std::size_t k = 0; k < m.found.size(); ++k) {
    if (!std::isfinite(m.moments[0][k].x())) continue;
    legs.push_back(m.found[k]);
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i].push_back(m.moments[i][k]);
  }
  const MarkerSolution s = solveMarkers(m.base, legs, m.t, moments);
  for (const auto& f : s.frames) {
    EXPECT_EQ(f.state[static_cast<std::size_t>(humanmodel::Joint::kNeck)], humanmodel::JointState::kInferred);
    EXPECT_EQ(f.state[static_cast<std::size_t>(humanmodel::Joint::kKneeLeft)],
              humanmodel::JointState::kTracked);
    for (const humanmodel::Joint j : {humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristRight,
                                      humanmodel::Joint::kHeadTop, humanmodel::Joint::kShoulderLeft})
      EXPECT_FALSE(f.has(j)) << humanmodel::jointName(j);
  }
}

TEST(MarkerSolver, AllocatesNothing) {
  const SyntheticMarkers m = makeMarkers(7, 0.2, 30.0, 0.001, 0.0);
  std::vector<RigMarker> markers;
  for (const auto& f : m.found)
    markers.push_back({f.segment, growth(f.segment, m.sizes).cwiseProduct(f.p_S)});
  MarkerSolver solver(m.body);
  PoseHold hold;
  hold.to_rest = restWeights(m.body, markers);
  MarkerPose found = solver.search(markers, m.moments[0], hold);
  EXPECT_LT(found.rms, 0.003);
  testing::NoAlloc guard;
  found = solver.solve(markers, m.moments[1], found.pose, hold, 0.05, 10);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace marker_solution_test
}  // namespace abstand::tracking
