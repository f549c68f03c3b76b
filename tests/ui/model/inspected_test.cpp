// What the inspector says of a body, a robot, a person and a pair.
#include <gtest/gtest.h>

#include <QStringList>
#include <cmath>

#include "tests/ui/fake_session.hpp"
#include "ui/model/inspected_joints.hpp"
#include "ui/model/inspected_pairs.hpp"
#include "ui/model/inspected_rows.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {
namespace inspected_test {

struct InspectedSubjectTest : ::testing::Test {
  void at(double t) {
    session.seek(t);
    session.takeSnapshot(snapshot);
  }
  std::vector<int> groupOf(const std::string& name) const {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(outline.objects.size()); ++i)
      if (outline.objects[static_cast<std::size_t>(i)].group == name) all.push_back(i);
    return all;
  }
  /// The value of the first row of this name; of a heading where `heading` is set.
  QString value(const InspectedSubject& subject, const char* name, const char* after = nullptr) const {
    bool reached = !after;
    for (const InspectedRow& row : inspectedRows(outline, snapshot, subject)) {
      if (reached && row.name == QLatin1String(name)) return row.value;
      reached |= after && row.name == QLatin1String(after);
    }
    return QStringLiteral("no row");
  }
  InspectedSubject body(const char* name) const {
    return inspectedSubject(outline, {session.indexOf(name)}, -1);
  }

  FakeSession session;
  const view::SceneOutline& outline{session.outline()};
  view::SceneSnapshot snapshot;
};

TEST_F(InspectedSubjectTest, SelectionHasExpectedKind) {
  EXPECT_EQ(inspectedSubject(outline, {}, -1).kind, SubjectKind::kNone);
  const InspectedSubject link = body("arm/link2");
  EXPECT_EQ(link.kind, SubjectKind::kBody);
  EXPECT_EQ(link.robot, 0);
  EXPECT_EQ(link.person, -1);
  EXPECT_EQ(body("operator/head").person, 0);
  EXPECT_EQ(body("table").robot, -1);
  const InspectedSubject robot = inspectedSubject(outline, groupOf("arm"), -1);
  EXPECT_EQ(robot.kind, SubjectKind::kRobot);
  EXPECT_EQ(subjectTitle(outline, robot), "arm");
  EXPECT_EQ(inspectedSubject(outline, groupOf("operator"), -1).kind, SubjectKind::kPerson);
  EXPECT_EQ(inspectedSubject(outline, {0, 1}, -1).kind, SubjectKind::kSeveral) << "not the whole robot";
  EXPECT_EQ(inspectedSubject(outline, groupOf("objects"), -1).kind, SubjectKind::kSeveral);
  const auto [a, b] = outline.pairs[7];
  const InspectedSubject pair = inspectedSubject(outline, {a, b}, 7);
  EXPECT_EQ(pair.kind, SubjectKind::kPair);
  EXPECT_EQ(inspectedSubject(outline, {-1, 99999}, -1).kind, SubjectKind::kNone);
}

TEST_F(InspectedSubjectTest, NearestPersonHasSmallestDistance) {
  at(1.3);
  const InspectedSubject robot = inspectedSubject(outline, groupOf("arm"), -1);
  int nearest = -1;
  double least = kInfinity;
  for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
    const auto& a = outline.objects[static_cast<std::size_t>(outline.pairs[p].first)];
    const auto& b = outline.objects[static_cast<std::size_t>(outline.pairs[p].second)];
    const bool between = (a.group == "arm" && b.human) || (a.human && b.group == "arm");
    if (!between || snapshot.pairs[p].result.distance >= least) continue;
    least = snapshot.pairs[p].result.distance;
    nearest = static_cast<int>(p);
  }
  ASSERT_GE(nearest, 0);
  EXPECT_EQ(inspectPairs(outline, snapshot, robot.objects).nearest_person, nearest);
  const query::PairResult& result = snapshot.pairs[static_cast<std::size_t>(nearest)].result;
  EXPECT_EQ(value(robot, "Distance", "Nearest person"),
            QStringLiteral("%1, uncertainty %2").arg(lengthText(result.distance), lengthText(result.bound)));
  EXPECT_EQ(value(robot, "At least", "Nearest person"), lengthText(result.distance - result.bound));
  EXPECT_TRUE(value(robot, "Body", "Nearest person").contains(" – operator/"));
}

TEST_F(InspectedSubjectTest, UncheckedPairsAreCountedAndNeverClear) {
  at(0.0);
  const InspectedSubject ball = body("ball");
  ASSERT_EQ(inspectPairs(outline, snapshot, ball.objects).paused, 0u);
  EXPECT_EQ(value(ball, "Not checked"), "1 of 20 pairs");
  EXPECT_EQ(value(ball, "   within the robot or the room"), "1");
  session.setGroup(1, view::PairGroupState::kPaused);
  at(0.0);
  const InspectedPairs pairs = inspectPairs(outline, snapshot, ball.objects);
  EXPECT_EQ(pairs.paused, 5u) << "those with the arm";
  EXPECT_GE(pairs.level, PairLevel::kPaused);
  EXPECT_EQ(value(ball, "Not checked"), "6 of 20 pairs");
  EXPECT_EQ(value(ball, "   paused"), "5");
  EXPECT_EQ(value(ball, "Checked"), "14 pairs");
  session.setGroup(0, view::PairGroupState::kStopped);
  at(0.0);
  EXPECT_EQ(inspectPairs(outline, snapshot, ball.objects).nearest_person, -1);
  EXPECT_EQ(value(ball, "State"), "? not checked");
  // A pair without a result does not pass for clear either.
  snapshot.pairs.assign(snapshot.pairs.size(), {});
  snapshot.pairs.front().result.distance = 1.0;
  snapshot.pairs.front().result.bound = 0.0;
  EXPECT_EQ(inspectPairs(outline, snapshot, {outline.pairs.front().first}).level, PairLevel::kUnknown);
}

TEST_F(InspectedSubjectTest, PosedLinkShowsPose) {
  at(0.7);
  const auto i = static_cast<std::size_t>(session.indexOf("arm/link3"));
  snapshot.objects[i].X_WB = Transform::Identity();
  snapshot.objects[i].X_WB.translation() = Vector3d(0.1, -0.25, 1.5);
  snapshot.objects[i].X_WB.linear() =
      Eigen::AngleAxisd(kPi / 6.0, Vector3d::UnitZ()).toRotationMatrix();  // 30 degrees
  snapshot.objects[i].velocity.linear = Vector3d(0.3, 0.0, 0.4);
  const InspectedSubject link = body("arm/link3");
  EXPECT_EQ(value(link, "Kind"), "link of the robot arm");
  EXPECT_EQ(value(link, "Position"), "x 0.100, y -0.250, z 1.500 m");
  EXPECT_EQ(value(link, "Roll, pitch, yaw"), "0.0°, 0.0°, 30.0°");
  EXPECT_TRUE(value(link, "Speed").startsWith("0.500 m/s"));
  EXPECT_EQ(value(link, "Voxels"), "4.0 mm");
  EXPECT_EQ(value(link, "Error bound"), "3.1 mm");
  EXPECT_EQ(value(link, "Shell points"), "1234, 5.0 mm apart");
  snapshot.objects[i].pose_state = scene::PoseState::kStale;
  EXPECT_TRUE(value(link, "Pose").startsWith("? lost"));
}

TEST_F(InspectedSubjectTest, RobotShowsJointsLimitsAndTorques) {
  at(2.0);
  const InspectedSubject robot = inspectedSubject(outline, groupOf("arm"), -1);
  EXPECT_EQ(value(robot, "Motion"), "follows arm.csv");
  const double q = snapshot.joint_positions[2] * 180.0 / kPi;
  EXPECT_EQ(value(robot, "Joint joint3"), QStringLiteral("%1° (-180.0° to 180.0°)").arg(fixed(q, 1)));
  const view::TorqueParts& torque = snapshot.joint_torques[2];
  EXPECT_EQ(value(robot, "Torque of joint3"),
            QStringLiteral("contact %1, reaction %2, gravity %3, motion %4 N·m of at most 60 N·m")
                .arg(fixed(torque.contact, 1), fixed(torque.reaction, 1), fixed(torque.gravity, 1),
                     fixed(torque.motion, 1)));
  view::SceneOutline::JointInfo slide{"rail", "slide", true, 0.0, kInfinity, kInfinity};
  EXPECT_EQ(jointValueText(slide, 0.25), "250.0 mm");
  snapshot.movers.by_hand = {true};
  EXPECT_EQ(value(robot, "Motion"), "posed by hand");
}

TEST_F(InspectedSubjectTest, StopShowsPairAndDistance) {
  at(0.0);
  const auto [a, b] = outline.pairs[3];
  snapshot.robots[0].state = safety::StopState::kProtectiveStop;
  snapshot.robots[0].cause = {safety::StopReason::kDistance, 0.0398, 0.04, 3, -1};
  const QString expected =
      QStringLiteral("protective stop: %1 – %2 at 39.8 mm")
          .arg(QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
               QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name));
  EXPECT_EQ(stopText(outline, snapshot, 0), expected);
  EXPECT_EQ(value(inspectedSubject(outline, groupOf("arm"), -1), "Motion"), expected);
  snapshot.robots[0].cause = {safety::StopReason::kJointSpeed, 2.5, 2.0, -1, 1};
  EXPECT_EQ(stopText(outline, snapshot, 0),
            "protective stop: joint speed 2.50 rad/s, limit 2.00 rad/s, joint joint2");
  snapshot.robots[0].state = safety::StopState::kRunning;
  EXPECT_TRUE(stopText(outline, snapshot, 0).isEmpty());
}

TEST_F(InspectedSubjectTest, PersonShowsMeasuresAndAge) {
  at(0.0);
  snapshot.movers.person_age = {0.24};
  const InspectedSubject person = inspectedSubject(outline, groupOf("operator"), -1);
  EXPECT_EQ(value(person, "Stature"), "1.780 m");
  EXPECT_EQ(value(person, "Mass"), "80.0 kg");
  EXPECT_EQ(value(person, "Sex"), "male");
  EXPECT_EQ(value(person, "Sizes"), "mean");
  EXPECT_EQ(value(person, "Recording"), "walk.bvh");
  EXPECT_EQ(value(person, "Oldest part seen"), "0.240 s ago");
}

}  // namespace inspected_test
}  // namespace abstand::ui
