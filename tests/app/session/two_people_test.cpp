// Two people and two robots in one scene: who is who, who meets whom, and the same bits for any number of
// threads.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

#include "app/session/session.hpp"
#include "core/base/state_hash.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace two_people_test {

class TwoPeople : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!exists(debianBvh("Boxing_Toes.bvh"))) GTEST_SKIP() << debianBvh("Boxing_Toes.bvh");
  }

  static scene_file::SceneDescription shipped() {
    return scene_file::loadScene(projectFile("data/scenes/two_people.yaml"));
  }
  static std::unique_ptr<session::Session> open(scene_file::SceneDescription description, int threads) {
    session::SessionOptions options;
    options.threads = threads;
    return std::make_unique<session::Session>(std::move(description), options);
  }
  /// Boxes in place of all bodies, which are built at once: for what does not depend on their shape.
  static std::unique_ptr<session::Session> openBoxes() {
    scene_file::SceneDescription scene = shipped();
    scene.defaults.haptic.voxel_size = scene.defaults.haptic.point_spacing = 0.04;
    const auto box = [](auto& body) {
      body.mesh.clear();
      body.shape = geometry::Cuboid{{0.1, 0.1, 0.1}};
    };
    for (auto& mechanism : scene.mechanisms)
      for (auto& link : mechanism.links) box(link);
    for (auto& object : scene.objects) box(object);
    for (auto& human : scene.humans)
      for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
        human.body.overrides[static_cast<humanmodel::BodyPart>(i)].shape = "cuboid";
    return open(std::move(scene), 1);
  }

  static const std::string& groupOf(const session::Session& session, ObjectId id) {
    return session.scene().object(id).spec.group;
  }
};

TEST_F(TwoPeople, BodiesHaveUniqueNamesAndTheirGroup) {
  const auto session = openBoxes();
  std::set<std::string> names;
  std::map<std::string, int> groups;
  for (const scene::Object& o : session->scene().objects()) {
    EXPECT_TRUE(names.insert(o.spec.name).second) << o.spec.name;
    ++groups[o.spec.group];
    if (o.spec.group != "objects") {
      EXPECT_EQ(o.spec.name.substr(0, o.spec.name.find('/')), o.spec.group);
    }
  }
  const std::map<std::string, int> expected{
      {"lwr", 8}, {"scara", 5}, {"operator", 14}, {"colleague", 14}, {"objects", 1}};
  EXPECT_EQ(groups, expected);

  const view::SceneOutline outline = session->outline();
  for (const auto& o : outline.objects)
    EXPECT_EQ(o.human, o.group == "operator" || o.group == "colleague") << o.name;
  std::map<std::string, int> joints;
  for (const auto& j : outline.joints) ++joints[j.mechanism];
  EXPECT_EQ(joints, (std::map<std::string, int>{{"lwr", 7}, {"scara", 4}}));
}

TEST_F(TwoPeople, PairsCoverOtherGroupsOnly) {
  const auto session = openBoxes();
  std::map<std::pair<std::string, std::string>, int> pairs;
  for (const scene::Pair& p : session->scene().pairs()) {
    auto [a, b] = std::minmax(groupOf(*session, p.a), groupOf(*session, p.b));
    ++pairs[{a, b}];
  }
  const std::map<std::pair<std::string, std::string>, int> expected{
      {{"lwr", "scara"}, 40},        {{"lwr", "operator"}, 112},    {{"colleague", "lwr"}, 112},
      {{"operator", "scara"}, 70},   {{"colleague", "scara"}, 70},  {{"colleague", "operator"}, 196},
      {{"lwr", "objects"}, 7},       {{"objects", "scara"}, 4},  // what stands on the table is left out
      {{"objects", "operator"}, 14}, {{"colleague", "objects"}, 14}};
  EXPECT_EQ(pairs, expected);
}

TEST_F(TwoPeople, PeopleAndRobotsFollowTheirOwnMotions) {
  const auto session = openBoxes();
  const auto at = [&](const std::string& name) { return session->scene().find(name)->X_WB.translation(); };
  session->step(0.0);
  const Vector3d operator_hand = at("operator/hand_right"), colleague_hand = at("colleague/hand_right");
  const Vector3d lwr = at("lwr/link7"), scara = at("scara/gripper");
  // The operator stands before the table, the colleague behind it, on their feet.
  EXPECT_GT(at("operator/torso").x(), 0.5);
  EXPECT_LT(at("colleague/torso").x(), -0.3);
  for (const std::string person : {"operator", "colleague"}) {
    EXPECT_GT(at(person + "/head").z(), 1.3) << person;
    EXPECT_LT(at(person + "/head").z(), 1.8) << person;
  }
  session->step(2.0);
  EXPECT_GT((at("operator/hand_right") - operator_hand).norm(), 0.2);
  EXPECT_GT((at("colleague/hand_right") - colleague_hand).norm(), 0.05);
  EXPECT_GT((at("lwr/link7") - lwr).norm(), 0.05);
  EXPECT_GT((at("scara/gripper") - scara).norm(), 0.05);
  // The reach is over after 4.5 s; the boxer goes on.
  session->step(4.5);
  const Vector3d resting = at("operator/hand_right"), boxing = at("colleague/hand_right");
  session->step(6.0);
  EXPECT_EQ(at("operator/hand_right"), resting);
  EXPECT_GT((at("colleague/hand_right") - boxing).norm(), 0.01);
}

/// Efforts of the joints `from` to `to`.
double largestEffort(const session::Session& session, std::size_t from, std::size_t to) {
  double most = 0.0;
  for (std::size_t j = from; j < to; ++j) most = std::max(most, std::abs(session.jointEfforts()[j]));
  return most;
}

void add(StateHash& hash, const Vector3d& v) {
  for (int k = 0; k < 3; ++k) hash.add(v[k]);
}

TEST_F(TwoPeople, IsBitIdenticalForOneAndFourThreads) {
  const ScratchFolder folder;  // so that the second session need not build again
  ::setenv("ABSTAND_CACHE", folder.path().c_str(), 1);
  std::uint64_t expected = 0;
  for (const int threads : {1, 4}) {
    const auto session = open(shipped(), threads);
    ASSERT_EQ(session->jointEfforts().size(), 11u);
    StateHash hash;
    int loaded = 0;
    for (int i = 0; i < 90; ++i) {
      session->step(0.05 * i);
      std::set<std::string> touched;
      for (const scene::Pair& p : session->scene().pairs()) {
        hash.add(p.result.distance);
        hash.add(p.result.bound);
        add(hash, p.result.force_a);
        add(hash, p.result.torque_a);
        add(hash, p.result.witness_b);
        if (p.result.contacts == 0) continue;
        touched.insert(groupOf(*session, p.a));
        touched.insert(groupOf(*session, p.b));
      }
      for (const scene::Object& o : session->scene().objects()) add(hash, o.contact.force);
      for (const double e : session->jointEfforts()) hash.add(e);
      const double lwr = largestEffort(*session, 0, 7), scara = largestEffort(*session, 7, 11);
      EXPECT_TRUE(touched.contains("lwr") || lwr == 0.0) << i;
      EXPECT_TRUE(touched.contains("scara") || scara == 0.0) << i;
      loaded += lwr > 0.1;
    }
    EXPECT_GE(loaded, 3);  // the operator's hand comes into the way of the large arm
    if (threads == 1) expected = hash.value();
    EXPECT_EQ(hash.value(), expected) << threads << " threads";
  }
  ::setenv("ABSTAND_CACHE", "off", 1);
}

}  // namespace two_people_test
}  // namespace abstand::testing
