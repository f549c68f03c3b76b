// What the session hears of the document.
#include "ui/document/session_follower.hpp"

#include <gtest/gtest.h>

#include "tests/ui/fake_session.hpp"

namespace abstand::ui {
namespace session_follower_test {

struct SessionFollowerTest : ::testing::Test {
  void attach(const Work& work) {
    view::SceneSnapshot first;
    session.takeSnapshot(first);
    follower.attach(&session, first, work);
  }
  std::string command(const char* name, const char* object, const char* value) const {
    return name + (" " + std::to_string(session.indexOf(object))) + " " + value;
  }
  FakeSession session;
  SessionFollower follower;
};

using Log = std::vector<std::string>;

TEST_F(SessionFollowerTest, SendsOnlyDifferencesAndRestoresSceneValues) {
  Work work;
  work.margins = {{"arm/link1", 0.2}, {"table", 0.01}, {"nobody", 0.3}};
  attach(work);
  EXPECT_EQ(session.log, Log{command("margin", "arm/link1", "0.2")}) << "the table has this margin already";
  session.log.clear();
  follower.follow(work, {});
  EXPECT_EQ(session.log, Log{command("margin", "arm/link1", "0.01")});
  EXPECT_EQ(follower.margin(work, session.indexOf("arm/link1")), 0.2);
  EXPECT_EQ(follower.unknownNames(work), QStringList{"nobody"});
}

TEST_F(SessionFollowerTest, SendsGroupsAndMovedPairs) {
  attach({});
  const auto [a, b] = session.outline().pairs.front();
  const auto name = [&](int i) {
    return QString::fromStdString(session.outline().objects[static_cast<std::size_t>(i)].name);
  };
  Work work;
  work.groups["things"] = view::PairGroupState::kPaused;
  work.moved[{name(a), name(b)}] = "things";
  follower.follow({}, work);
  EXPECT_EQ(session.log, (Log{"remove 0", "add 1 0", "pause 1"}));
  session.log.clear();
  Work none = work;
  none.moved[{name(a), name(b)}] = "";
  follower.follow(work, none);
  EXPECT_EQ(session.log, Log{"remove 0"});
  session.log.clear();
  follower.follow(none, {});
  EXPECT_EQ(session.log, (Log{"add 0 0", "run 1"}));
}

TEST_F(SessionFollowerTest, SendsReactionsThatFitAndNamesOthers) {
  attach({});
  EXPECT_TRUE(session.reactions.empty());
  Work work;
  work.reactions["arm"].numbers["torque.gain"] = {3.0};
  follower.follow({}, work);
  EXPECT_EQ(session.log, Log{"reaction 0"});
  EXPECT_EQ(session.reactions.back().torque->gain, 3.0);
  EXPECT_TRUE(follower.unknownNames(work).isEmpty());
  follower.follow(work, {});
  EXPECT_EQ(session.reactions.back().torque->gain, 1.0) << "that of the scene";
  // Of another scene: the robot keeps the scene's laws as a whole.
  Work other;
  other.reactions["arm"].numbers = {{"torque.gain", {3.0}}, {"torque.limit", {1.0, 2.0}}};
  other.reactions["crane"].laws["torque"] = false;
  follower.follow({}, other);
  EXPECT_EQ(session.reactions.back().torque->gain, 1.0);
  const QStringList unknown = follower.unknownNames(other);
  ASSERT_EQ(unknown.size(), 2);
  EXPECT_EQ(unknown[0], "crane");
  EXPECT_TRUE(unknown[1].startsWith("torque.limit: found 2 numbers")) << unknown[1].toStdString();
}

TEST_F(SessionFollowerTest, SendsPosedRobotsPerJoint) {
  Work work;
  work.posed["arm"] = {0.1, 0.2, 0.3, 0.4, 0.5};
  work.posed["nobody"] = {1.0};
  work.people["nobody either"].mass = 80.0;
  attach(work);
  EXPECT_EQ(session.log, (Log{"pose 0 0.1", "pose 1 0.2", "pose 2 0.3", "pose 3 0.4", "pose 4 0.5"}));
  EXPECT_EQ(follower.unknownNames(work), (QStringList{"nobody", "nobody either"}));
  session.log.clear();
  Work moved = work;
  moved.posed["arm"][3] = -0.4;
  follower.follow(work, moved);
  EXPECT_EQ(session.log, Log{"pose 3 -0.4"});
  session.log.clear();
  follower.follow(moved, {});
  EXPECT_EQ(session.log, Log{"follow 0"});
  session.log.clear();
  // Of another robot of that name.
  work.posed["arm"] = {0.1, 0.2};
  follower.follow({}, work);
  EXPECT_TRUE(session.log.empty());
}

TEST_F(SessionFollowerTest, SendsNothingWithoutSession) {
  Work work;
  work.margins["arm/link1"] = 0.2;
  follower.attach(nullptr, {}, work);
  follower.follow(work, {});
  EXPECT_TRUE(session.log.empty());
}

}  // namespace session_follower_test
}  // namespace abstand::ui
