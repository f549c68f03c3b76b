// Joints by the shape of a tree without readable names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/error.hpp"
#include "tests/tracking/joint_guess/guess_cases.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/neck_choice.hpp"
#include "tracking/joint_guess/shape_guess.hpp"
#include "tracking/recording/required_person.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

using testing::bvhOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kSame = 1e-9;  // m

// m; a file whose units are not known is scaled by its stature, which depends on the top of the head.
constexpr double kOtherScale = 0.03;

TEST(JointGuess, UnreadableNamesAreGuessedByShape) {
  const Recording plain = read(bvhOf({}));
  EXPECT_FALSE(plain.report.map_use.is_guess);
  for (const auto& name :
       {std::function<std::string(int)>([](int i) { return "bone" + std::to_string(i); }),
        std::function<std::string(int)>([](int i) { return "\xe9\xaa\xa8" + std::to_string(i); })}) {
    const Recording r = read(renamed(bvhOf({}), name));
    EXPECT_EQ(r.report.joint_map, "guessed from the shape");
    EXPECT_THAT(r.report.missing_parts, IsEmpty());
    EXPECT_EQ(limbsApart(plain, r), 0.0) << "left and right by the toes";
    EXPECT_NEAR(r.report.stature, testing::kSmallHumanStature, kSame);
    EXPECT_THAT(r.report.warnings, Contains(HasSubstr("the joint assignment is guessed: two branches")));
  }
}

TEST(JointGuess, FindsNoPersonInOtherTrees) {
  for (const int teeth : {1, 3, 300}) {
    const Recording r = read(comb(teeth));
    EXPECT_THAT(r.report.mapped, IsEmpty()) << teeth;
    EXPECT_THAT(r.report.notes, Contains(HasSubstr("cannot be guessed from the shape"))) << teeth;
    try {
      requirePerson(r.report, "t.bvh");
      FAIL();
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr("t.bvh: error: found no body part"));
    }
  }
}

TEST(JointGuess, LegsWithoutArmsAreGuessedByShape) {
  const Recording r = read(figureBvh(legsOnly()));
  EXPECT_EQ(r.report.joint_map, "guessed from the shape");
  EXPECT_THAT(r.report.map_use.reason, HasSubstr("no two are arms, so that arms are missing"));
  EXPECT_THAT(r.report.missing_parts,
              ::testing::UnorderedElementsAre("biceps_left", "biceps_right", "forearm_left", "forearm_right",
                                              "hand_left", "hand_right"));
  EXPECT_EQ(usedFor(r, humanmodel::Joint::kHipLeft), "b2");
  EXPECT_EQ(usedFor(r, humanmodel::Joint::kAnkleRight), "b8");
  EXPECT_EQ(usedFor(r, humanmodel::Joint::kNeck), "b12");
  EXPECT_EQ(usedFor(r, humanmodel::Joint::kHead), "b13");
}

TEST(JointGuess, HandsMayDiffer) {
  const Figure empty{{7, {0, 18, 0}, true}};
  Figure sword{{7, {0, -18, 0}, true}};
  append(sword, {{7, {0, -5, 0}}, {8, {0, -110, 0}}, {9, {0, -5, 0}, true}});
  Figure fingers;
  for (const double x : {-3.0, -1.0, 1.0, 3.0})
    append(fingers, {{7, {x, -8, 0}}, {8, {0, -4, 0}}, {9, {0, -3, 0}}, {10, {0, -2, 0}, true}});
  for (const Figure& right : {sword, fingers}) {
    const Recording r = read(figureBvh(wholeFigure({empty, right})));
    EXPECT_EQ(r.report.joint_map, "guessed from the shape") << ::testing::PrintToString(r.report.notes);
    EXPECT_THAT(r.report.missing_parts, IsEmpty());
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kShoulderLeft), "b15");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kWristLeft), "b17");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kShoulderRight), "b19");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kWristRight), "b21");
  }
}

TEST(JointGuess, EquallyGoodArmsAreNamedAndNotGuessed) {
  const Figure hand{{7, {0, 18, 0}, true}};
  Figure figure = wholeFigure({hand, hand});
  for (const double y : {1.0, -1.0})
    append(figure,
           {{3, {-3, 3 * y, 12}}, {4, {0, 15 * y, 0}}, {5, {0, 30 * y, 0}}, {6, {0, 25 * y, 0}}, hand[0]});
  const Recording r = read(figureBvh(figure));
  EXPECT_THAT(r.report.mapped, IsEmpty());
  EXPECT_THAT(r.report.notes,
              Contains(HasSubstr("two readings of legs and arms are equally good: legs from 'b2' and "
                                 "'b6' with arms from 'b")));
}

/// The whole figure with two tails of hair of three bones; `down`: share of its bones that hang down.
Figure withHair(double first, double second, bool hangs) {
  Figure figure = wholeFigure({Figure{{7, {0, 18, 0}, true}}, Figure{{7, {0, -18, 0}, true}}});
  // The head is the last joint of the trunk, at depth 4.
  auto end = std::ranges::find_if(
      figure, [](const FigureJoint& j) { return j.depth == 5 && j.is_site && j.offset.z() == 18.0; });
  Figure hair;
  for (const double y : {1.0, -1.0}) {
    const auto bone = [&](double length) {
      return hangs ? Vector3d(0, 0, -length) : Vector3d(0, y * length, 0);
    };
    append(hair, {{5, {0, 6 * y, 0}}, {6, bone(first)}, {7, bone(second)}, {8, bone(2), true}});
  }
  figure.insert(end + 1, hair.begin(), hair.end());
  return figure;
}

// Arms leave the trunk at the height of shoulders.
TEST(JointGuess, TailsOfHairAreNoArms) {
  for (const bool hangs : {true, false})
    for (const double first : {15.0, 22.0, 30.0, 36.0})
      for (const double second : {15.0, 25.0, 36.0}) {
        const Recording r = read(figureBvh(withHair(first, second, hangs)));
        EXPECT_EQ(r.report.joint_map, "guessed from the shape") << first << " " << second;
        EXPECT_EQ(usedFor(r, humanmodel::Joint::kNeck), "b12") << first << " " << second;
        EXPECT_EQ(usedFor(r, humanmodel::Joint::kHead), "b13") << first << " " << second;
        EXPECT_EQ(usedFor(r, humanmodel::Joint::kShoulderLeft), "b21") << first << " " << second;
        EXPECT_EQ(usedFor(r, humanmodel::Joint::kWristRight), "b27") << first << " " << second;
      }
}

/// The capture with hair on its head in the axes of its rest pose: two tails to the sides, or hanging.
std::string withHairOnHead(const std::string& bvh, const Vector3d& up, const Vector3d& left, double thigh) {
  std::string text = bvh;
  const auto head = text.find("JOINT Head");
  const auto after = text.find('\n', text.find("CHANNELS", head)) + 1;
  std::string hair;
  for (const double side : {1.0, -1.0}) {
    const auto bone = [](const Vector3d& p) {
      return "\n{\nOFFSET " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
             std::to_string(p.z()) + "\n";
    };
    const Vector3d first = 0.15 * side * thigh * left, next = -0.6 * thigh * up;
    hair += "JOINT hair" + bone(first) + "CHANNELS 0\nJOINT hair" + bone(next) + "CHANNELS 0\nJOINT hair" +
            bone(next) + "CHANNELS 0\nEnd Site" + bone(0.01 * next) + "}\n}\n}\n}\n";
  }
  return text.insert(after, hair);
}

TEST(JointGuess, RealCapturesWithHairKeepTheirArms) {
  struct Capture {
    const char* file;
    Vector3d up, left;
    double thigh;  ///< units of the file
  };
  for (const Capture& c : {Capture{"bvhtoolbox_walk01.bvh", Vector3d::UnitY(), Vector3d::UnitX(), 44.0},
                           Capture{"mocapbank_test.bvh", Vector3d::UnitY(), Vector3d::UnitX(), 48.0},
                           Capture{"xsens_names_pybvh_test2.bvh", Vector3d::UnitY(), Vector3d::UnitX(), 44.0},
                           Capture{"fair1_wave_hello.bvh", Vector3d::UnitZ(), Vector3d::UnitX(), 11.5}}) {
    const auto file = testing::sharedData(std::string("mocap/bvh/") + c.file);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    std::string bvh = readFile(file);
    std::erase(bvh, '\r');
    const Recording named = read(bvh);
    const Recording r = read(
        renamed(withHairOnHead(bvh, c.up, c.left, c.thigh), [](int i) { return "n" + std::to_string(i); }));
    EXPECT_EQ(r.report.joint_map, "guessed from the shape") << c.file;
    EXPECT_LE(limbsApart(named, r), kSame) << c.file;
  }
}

TEST(JointGuess, AnimalsAndMachinesAreNoPersons) {
  Figure dog{{0, {0, 0, 0}}};
  for (const double side : {1.0, -1.0})
    append(
        dog,
        {{1, {0, 8 * side, 0}}, {2, {3, 0, -25}}, {3, {-6, 0, -22}}, {4, {4, 0, -8}}, {5, {6, 0, 0}, true}});
  append(dog, {{1, {25, 0, 3}}, {2, {25, 0, 0}}});
  for (const double side : {1.0, -1.0})
    append(
        dog,
        {{3, {0, 8 * side, 0}}, {4, {-3, 0, -25}}, {5, {4, 0, -22}}, {6, {0, 0, -8}}, {7, {6, 0, 0}, true}});
  append(dog, {{3, {12, 0, 15}}, {4, {10, 0, 10}}, {5, {15, 0, -2}, true}});
  Figure gripper{{0, {0, 0, 0}}, {1, {0, 0, 30}}, {2, {40, 0, 0}}, {3, {40, 0, 0}}, {4, {10, 0, 0}}};
  for (const double side : {1.0, -1.0})
    append(gripper, {{5, {2, 4 * side, 0}}, {6, {5, 0, 0}}, {7, {5, 0, 0}}, {8, {2, -2 * side, 0}, true}});
  Figure bust{{0, {0, 0, 0}}, {1, {0, 0, 20}}, {2, {0, 0, 25}}};
  for (const double side : {1.0, -1.0})
    append(bust, {{3, {0, 16 * side, 3}}, {4, {0, 0, -29}}, {5, {2, 0, -25}}, {6, {4, 0, -18}, true}});
  append(bust, {{3, {0, 0, 8}}, {4, {0, 0, 10}}, {5, {0, 0, 18}, true}});
  for (const Figure& figure : {dog, gripper, bust}) {
    const Recording r = read(figureBvh(figure));
    EXPECT_THAT(r.report.mapped, IsEmpty()) << r.report.map_use.reason;
  }
}

// Neither names nor trees of any kind may break a guess.
TEST(JointGuess, AnyTreeIsGuessedOrRejected) {
  std::mt19937_64 random(1);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  constexpr const char* kNames[]{"arm", "LeftLeg", "r_hand",          "head/end",
                                 "",    "x|y",     "Spine9999999999", "\xff\xfe"};
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 1 + below(60);
    std::vector<std::string> names;
    std::vector<int> parents;
    std::vector<Vector3d> rest;
    for (std::size_t i = 0; i < n; ++i) {
      names.emplace_back(kNames[below(std::size(kNames))]);
      parents.push_back(below(8) == 0 ? -1 : static_cast<int>(below(i + 1)) - 1);
      const double size = below(3) == 0 ? 0.0 : 1e6 / static_cast<double>(1 + below(1000));
      rest.push_back(size *
                     Vector3d(static_cast<double>(below(3)) - 1.0, static_cast<double>(below(3)) - 1.0, 1.0));
    }
    PointFrame frame;
    frame.p = rest;
    frame.state.assign(n, humanmodel::JointState::kTracked);
    const ShapeGuess shape = guessByShape({names, parents, rest, {&frame, 1}});
    EXPECT_FALSE(shape.reason.empty());
    for (const JointMatch& match : {shape.match, guessByNames(names, true), guessByNames(names, false)})
      for (const int joint : match.joint) EXPECT_LT(joint, static_cast<int>(n));
  }
  EXPECT_EQ(limbJoints(guessByShape({}).match), 0);
}

// The names of real captures are taken away: the shape must find the joints that the names say.
TEST_P(RealShape, ShapeMatchesNames) {
  const Recording named = read(text);
  const Recording r = read(renamed(text, [](int i) { return "n" + std::to_string(i); }));
  for (const auto& note : r.report.notes) RecordProperty("note", note);
  ASSERT_EQ(r.report.joint_map, "guessed from the shape") << ::testing::PrintToString(r.report.notes);
  EXPECT_LE(limbsApart(named, r), GetParam().apart) << ::testing::PrintToString(r.report.warnings);
  EXPECT_NEAR(r.report.stature, named.report.stature, 0.1);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
}

// Of CMU's two joints of the neck the upper one is its base.
TEST_P(RealShape, NeckMatchesNames) {
  const auto names = namesOf(text);
  const auto nameAt = [&](int i) { return names[static_cast<std::size_t>(i)]; };
  const std::string neck = usedFor(read(text), humanmodel::Joint::kNeck);
  const Recording by_shape = read(renamed(text, [](int i) { return "n" + std::to_string(i); }));
  EXPECT_EQ(nameAt(std::stoi(usedFor(by_shape, humanmodel::Joint::kNeck).substr(1))), neck);
  const Recording by_names = read(renamed(text, [&](int i) { return "q_" + nameAt(i) + "_q"; }));
  EXPECT_EQ(usedFor(by_names, humanmodel::Joint::kNeck), "q_" + neck + "_q");
}

TEST(JointGuess, LowNeckIsRaisedToShoulders) {
  // Pelvis, shoulders at 0.5, neck joints at these heights, head at 0.7.
  const auto neckOf = [](std::vector<double> heights) {
    std::vector<int> parents{-1, 0, 0};
    std::vector<Vector3d> rest{{0, 0, 0}, {0, 0.2, 0.5}, {0, -0.2, 0.5}};
    heights.push_back(0.7);
    for (const double z : heights) {
      parents.push_back(rest.size() == 3 ? 0 : static_cast<int>(rest.size()) - 1);
      rest.push_back({0, 0, z});
    }
    JointMatch match;
    match.joint.fill(-1);
    const auto set = [&](humanmodel::Joint j, int i) { match.joint[static_cast<std::size_t>(j)] = i; };
    set(humanmodel::Joint::kPelvis, 0);
    set(humanmodel::Joint::kShoulderLeft, 1);
    set(humanmodel::Joint::kShoulderRight, 2);
    set(humanmodel::Joint::kNeck, 3);
    set(humanmodel::Joint::kHead, static_cast<int>(rest.size()) - 1);
    raiseNeck(parents, rest, match);
    return rest[static_cast<std::size_t>(match.joint[static_cast<std::size_t>(humanmodel::Joint::kNeck)])]
        .z();
  };
  EXPECT_EQ(neckOf({0.42, 0.54}), 0.54) << "CMU";
  EXPECT_EQ(neckOf({0.30, 0.42, 0.54, 0.6}), 0.54);
  EXPECT_EQ(neckOf({0.52, 0.56}), 0.52) << "the first joint is the base";
  EXPECT_EQ(neckOf({0.47, 0.51}), 0.47) << "shoulders are raised a little";
  EXPECT_EQ(neckOf({0.44, 0.58}), 0.58) << "also CMU";
  EXPECT_EQ(neckOf({0.42, 0.66}), 0.42) << "the next one is farther";
  EXPECT_EQ(neckOf({0.30}), 0.30) << "there is no other";
}

/// The skeleton of a capture without the joints below `cut`.
struct CutCapture {
  std::vector<std::string> names;
  std::vector<int> parents;
  std::vector<Vector3d> rest;
  std::vector<PointFrame> frames;
  std::vector<int> kept;  ///< for each joint, that of the file

  CutCapture(BvhPoints& points, const std::vector<int>& cut) {
    const auto all = points.parents();
    const auto rest_p = points.rest();
    std::vector<int> now(all.size(), -1);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_below = all[i] >= 0 && now[static_cast<std::size_t>(all[i])] < 0;
      if (is_below || std::ranges::find(cut, static_cast<int>(i)) != cut.end()) continue;
      now[i] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(i));
      names.push_back(points.names()[i].ends_with("/end") ? "n/end" : "n");
      parents.push_back(all[i] < 0 ? -1 : now[static_cast<std::size_t>(all[i])]);
      rest.push_back(rest_p[i]);
    }
    PointFrame frame;
    while (frames.size() < 64 && points.next(frame)) {
      frames.push_back(frame);
      frames.back().p.clear();
      for (const int i : kept) frames.back().p.push_back(frame.p[static_cast<std::size_t>(i)]);
      frames.back().state.resize(kept.size());
    }
  }
};

// Without arms the same legs are found on the same sides; without legs, arms are not taken for them.
TEST_P(RealShape, LegsOfBodyWithoutArms) {
  using J = humanmodel::Joint;
  BvhPoints points(text, name);
  const JointMatch named = matchByNames(points);
  const auto at = [](const JointMatch& m, J j) { return m.joint[static_cast<std::size_t>(j)]; };
  for (const bool has_legs : {true, false}) {
    BvhPoints again(text, name);
    const CutCapture cut(again, has_legs
                                    ? std::vector{at(named, J::kShoulderLeft), at(named, J::kShoulderRight)}
                                    : std::vector{at(named, J::kHipLeft), at(named, J::kHipRight)});
    const ShapeGuess guess = guessByShape({cut.names, cut.parents, cut.rest, cut.frames});
    EXPECT_EQ(limbJoints(guess.match), has_legs ? 6 : 0) << guess.reason;
    if (limbJoints(guess.match) != 6) continue;
    for (const J j : {J::kKneeLeft, J::kKneeRight, J::kAnkleLeft, J::kAnkleRight})
      EXPECT_EQ(cut.kept[static_cast<std::size_t>(at(guess.match, j))], at(named, j)) << guess.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealShape,
    ::testing::Values(Named{"blender_reactidle_003_genuine.bvh", kOtherScale},
                      Named{"bvhio_example.bvh", 0.0}, Named{"bvhtoolbox_walk01.bvh", 0.0},
                      Named{"cmu_12_01_walk_motionbuilder.bvh", 0.0},
                      Named{"cmu_jumping_jacks_3dsmax_names.bvh", 0.0}, Named{"fair1_wave_hello.bvh", 0.0},
                      Named{"mocapbank_test.bvh", 0.0}, Named{"rokoko_jesse_dance.bvh", 0.0},
                      Named{"xsens_names_pybvh_test2.bvh", 0.0}, Named{"xzy_spine3_pybvh_test1.bvh", 0.0},
                      Named{"01_01.bvh", 0.0}, Named{"01_03.bvh", 0.0}, Named{"Boxing_Toes.bvh", 0.0}),
    [](const auto& i) {
      std::string name = i.param.file;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
      return name;
    });

}  // namespace joint_guess_test
}  // namespace abstand::tracking
