// Skeletons whose names no map knows: joints by names, by shape, or not at all; and the map that is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <sstream>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/joint_guess/guess_fill.hpp"
#include "tracking/joint_guess/joint_choice.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/point_tree.hpp"
#include "tracking/joint_guess/shape_guess.hpp"
#include "tracking/recording/joint_map_writer.hpp"
#include "tracking/recording/required_person.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

using testing::bvhOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::SmallHuman;

constexpr double kSame = 1e-9;       // m
constexpr double kSamePlace = 1e-6;  // units of a file

Recording read(const std::string& bvh, const RecordingOptions& options = {}) {
  return readBvhRecording(bvh, "t.bvh", options);
}

/// Every joint gets a new name, by its place in the file.
std::string renamed(const std::string& bvh, const std::function<std::string(int)>& name) {
  std::istringstream in(bvh);
  std::string out;
  int i = 0;
  for (std::string line; std::getline(in, line);) {
    const auto word = line.find_first_not_of(" \t");
    for (const char* key : {"ROOT ", "JOINT "})
      if (word != std::string::npos && line.compare(word, std::string(key).size(), key) == 0)
        line = std::string(key) + name(i++);
    out += line + "\n";
  }
  return out;
}

/// Largest distance of a limb joint between two readings of one file, in all frames, m.
double limbsApart(const Recording& a, const Recording& b) {
  double apart = 0.0;
  for (std::size_t f = 0; f < a.frames.size(); ++f)
    for (std::size_t j = static_cast<std::size_t>(humanmodel::Joint::kShoulderLeft);
         j < humanmodel::kJointCount; ++j) {
      const bool is_tip = (j - 6) % 4 == 3;
      if (!is_tip) apart = std::max(apart, (a.frames[f].p[j] - b.frames[f].p[j]).norm());
    }
  return apart;
}

TEST(JointGuess, ReadsNamesWithUnknownPrefixes) {
  const Recording plain = read(bvhOf({}));
  const Recording r =
      read(bvhOf({.rename = [](const std::string& n) { return "Ch7_rig_" + n + "_jnt.003"; }}));
  EXPECT_EQ(r.report.joint_map, "guessed from the names");
  EXPECT_TRUE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("the joint assignment is guessed: 12 of 12")));
}

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

TEST(JointGuess, UserMapTakesPrecedence) {
  const testing::ScratchFolder folder;
  const auto map = folder.write("own.map", "name: Own\npelvis: bone0\n");
  const Recording r =
      read(renamed(bvhOf({}), [](int i) { return "bone" + std::to_string(i); }), {.joint_map = map});
  EXPECT_EQ(r.report.joint_map, "Own");
  EXPECT_FALSE(r.report.map_use.is_guess);
  EXPECT_THROW(requirePerson(r.report, "t.bvh"), ParseError);
}

TEST(JointGuess, MisspeltNamesOfUserMapAreReported) {
  const testing::ScratchFolder folder;
  const Recording r = read(
      bvhOf({}), {.joint_map = folder.write("own.map", "name: Own\npelvis: Hips\nelbow_left: LeftElbov\n")});
  EXPECT_THAT(r.report.warnings,
              Contains("the joint map names joints that the file does not have: elbow_left "
                       "'LeftElbov' (nearest: 'LeftElbow')"));
}

/// A tree of joints without the lengths of a person.
std::string comb(int teeth) {
  std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n";
  for (int i = 0; i < teeth; ++i) {
    text += "JOINT b" + std::to_string(i) + "\n{\nOFFSET " + std::to_string(i) +
            " 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n";
    for (int k = 0; k < 3; ++k) text += "JOINT c\n{\nOFFSET 0 1 0\nCHANNELS 0\n";
    text += "End Site\n{\nOFFSET 0 1 0\n}\n}\n}\n}\n}\n";
  }
  text += "}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0 0 0";
  for (int i = 0; i < teeth; ++i) text += " 0 0 0";
  return text + "\n";
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

/// A joint of a figure with numbers for names; an end site has depth and offset alone.
struct FigureJoint {
  int depth;
  Vector3d offset;  ///< cm, z up, facing x
  bool is_site{false};
};
using Figure = std::vector<FigureJoint>;

std::string figureBvh(const Figure& figure) {
  std::string text = "HIERARCHY\n";
  int open = 0, i = 0;
  for (const FigureJoint& joint : figure) {
    for (; open > joint.depth; --open) text += "}\n";
    text += joint.is_site ? "End Site" : (open == 0 ? "ROOT b" : "JOINT b") + std::to_string(++i);
    text += "\n{\nOFFSET";
    for (const double x : joint.offset) text += " " + std::to_string(x);
    text += joint.is_site ? "\n"
            : open == 0   ? "\nCHANNELS 3 Xposition Yposition Zposition\n"
                          : "\nCHANNELS 0\n";
    ++open;
  }
  for (; open > 0; --open) text += "}\n";
  return text + "MOTION\nFrames: 1\nFrame Time: 0.01\n0 0 95\n";
}

void append(Figure& figure, const Figure& more) { figure.insert(figure.end(), more.begin(), more.end()); }

Figure legsOnly() {
  Figure figure{{0, {0, 0, 0}}};
  for (const double side : {1.0, -1.0})
    append(
        figure,
        {{1, {0, 9 * side, 0}}, {2, {0, 0, -43}}, {3, {0, 0, -42}}, {4, {14, 0, -7}}, {5, {6, 0, 0}, true}});
  append(figure, {{1, {0, 0, 10}}, {2, {0, 0, 22}}, {3, {0, 0, 18}}, {4, {0, 0, 9}}, {5, {0, 0, 18}, true}});
  return figure;
}

/// With arms at the second joint of the trunk; `hands`: what the hands hold, from depth 7 on.
Figure wholeFigure(const std::array<Figure, 2>& hands) {
  Figure figure = legsOnly();
  for (const std::size_t side : {0u, 1u}) {
    const double y = side == 0 ? 1.0 : -1.0;
    append(figure, {{3, {0, 3 * y, 12}}, {4, {0, 15 * y, 0}}, {5, {0, 30 * y, 0}}, {6, {0, 25 * y, 0}}});
    append(figure, hands[side]);
  }
  return figure;
}

std::string usedFor(const Recording& r, humanmodel::Joint j) {
  const auto& names = r.report.map_use.names[static_cast<std::size_t>(j)];
  return names.empty() ? "" : names.front();
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

/// A figure whose joints turn at random, as points without a hierarchy in JSON lines. `turn`: degrees;
/// `rounding`: m.
std::string movingPoints(double turn, double rounding) {
  const Figure hand{{7, {0, 18, 0}, true}}, other_hand{{7, {0, -18, 0}, true}};
  std::string bvh = figureBvh(wholeFigure({hand, other_hand}));
  constexpr int kFrames = 100;
  bvh = bvh.substr(0, bvh.find("MOTION"));
  std::size_t joints = 0;
  const std::string none = "CHANNELS 0", three = "CHANNELS 3 Zrotation Xrotation Yrotation";
  for (auto at = bvh.find(none); at != std::string::npos; at = bvh.find(none, at), ++joints)
    bvh.replace(at, none.size(), three);
  bvh += "MOTION\nFrames: " + std::to_string(kFrames) + "\nFrame Time: 0.01\n";
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(-turn, turn);
  for (int i = 0; i < kFrames; ++i) {
    bvh += "0 0 95";
    for (std::size_t k = 0; k < 3 * joints; ++k) bvh += " " + std::to_string(angle(random));
    bvh += "\n";
  }
  BvhPoints points(bvh, "t.bvh");
  std::string text;
  PointFrame frame;
  for (int i = 0; points.next(frame); ++i) {
    text += "{\"t\": " + std::to_string(0.01 * i) + ", \"joints\": {";
    for (std::size_t k = 0; k < frame.p.size(); ++k) {
      text += std::string(k == 0 ? "" : ", ") + "\"\xe9\xaa\xa8" + points.names()[k] + "\": [";
      for (int axis = 0; axis < 3; ++axis) {
        const double x = rounding * std::round(0.01 * frame.p[k][axis] / rounding);
        text += (axis == 0 ? "" : ", ") + std::to_string(x);
      }
      text += "]";
    }
    text += "}}\n";
  }
  return text;
}

TEST(JointGuess, PointsWithoutHierarchyAreGuessedByMotion) {
  const testing::ScratchFolder folder;
  for (const double rounding : {1e-6, 1e-3}) {
    const Recording r = openRecording(folder.write("a.jsonl", movingPoints(15.0, rounding)));
    EXPECT_EQ(r.report.joint_map, "guessed from the shape") << ::testing::PrintToString(r.report.notes);
    EXPECT_THAT(r.report.map_use.reason, HasSubstr("bones are distances that stay the same; two branches"));
    EXPECT_THAT(r.report.missing_parts, IsEmpty());
    const std::string bone = "\xe9\xaa\xa8";
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kHipLeft), bone + "b2");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kKneeLeft), bone + "b3");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kAnkleRight), bone + "b8");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kShoulderLeft), bone + "b15");
    EXPECT_EQ(usedFor(r, humanmodel::Joint::kWristRight), bone + "b21");
  }
  const Recording still = openRecording(folder.write("still.jsonl", movingPoints(0.0, 1e-6)));
  EXPECT_THAT(still.report.mapped, IsEmpty());
  EXPECT_THAT(still.report.notes, Contains(HasSubstr("its points do not move relative to each other")));
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

TEST(JointGuess, IgnoresNamesOfImpossibleLimbs) {
  // The left calf begins at the ankle: left and right differ.
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) {
    return "q_" + (n == "LeftKnee" ? "LeftAnkle" : n == "LeftAnkle" ? "LeftKnee" : n) + "_q";
  }}));
  EXPECT_THAT(r.report.notes,
              Contains(HasSubstr("the legs that the names suggest are not used: left and right")));
  EXPECT_EQ(r.report.joint_map, "guessed from the shape");
  EXPECT_EQ(limbsApart(plain, r), 0.0);
}

/// Names of sides and segments; in `names` those that differ from them.
std::string sidedName(const std::string& n, const std::map<std::string, std::string>& names) {
  if (const auto it = names.find(n); it != names.end()) return it->second;
  const bool is_left = n.starts_with("Left"), is_right = n.starts_with("Right");
  if (!is_left && !is_right) return n;
  const std::map<std::string, std::string> segments{
      {"Collar", "collar"}, {"Shoulder", "upperarm"}, {"Elbow", "forearm"}, {"Wrist", "hand"},
      {"Hip", "thigh"},     {"Knee", "shin"},         {"Ankle", "foot"}};
  return (is_left ? "l_" : "r_") + segments.at(n.substr(is_left ? 4 : 5));
}

TEST(JointGuess, JointsThatAMapLacksAreGuessedByNames) {
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) { return sidedName(n, {}); }}));
  EXPECT_EQ(r.report.joint_map, "3ds Max Biped");
  EXPECT_TRUE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(
      r.report.warnings,
      Contains(HasSubstr("joints that the map lacks are guessed: knee_left 'l_shin', knee_right 'r_shin', "
                         "pelvis 'Hips' by the names; check")));
  EXPECT_THAT(r.report.map_use.reason, HasSubstr("; guessed: knee_left 'l_shin'"));
  const testing::ScratchFolder folder;
  const Recording again = read(bvhOf({.rename = [](const std::string& n) { return sidedName(n, {}); }}),
                               {.joint_map = folder.write("own.map", jointMapText(r.report))});
  EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
}

TEST(JointGuess, JointsThatAMapLacksAreGuessedByShape) {
  const Recording plain = read(bvhOf({}));
  const Recording r = read(bvhOf({.rename = [](const std::string& n) {
    return sidedName(n, {{"LeftKnee", "n1"}, {"RightKnee", "n2"}, {"Hips", "Pelvis"}});
  }}));
  EXPECT_EQ(r.report.joint_map, "3ds Max Biped");
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
  EXPECT_EQ(limbsApart(plain, r), 0.0);
  EXPECT_THAT(r.report.warnings, Contains(HasSubstr("knee_left 'n1', knee_right 'n2' by the shape")));
}

TEST(JointGuess, MapThatFindsAllLimbsIsNotGuessed) {
  const Recording r = read(bvhOf({}));
  EXPECT_FALSE(r.report.map_use.is_guess);
  EXPECT_THAT(r.report.warnings, Not(Contains(HasSubstr("guessed"))));
}

TEST(JointGuess, FillsOnlyWhatAgrees) {
  using J = humanmodel::Joint;
  const auto at = [](const JointMatch& m, J j) { return m.joint[static_cast<std::size_t>(j)]; };
  const auto set = [](JointMatch& m, J j, int i) { m.joint[static_cast<std::size_t>(j)] = i; };
  JointMatch guess;
  guess.joint.fill(-1);
  int next = 0;
  for (auto j = static_cast<std::size_t>(J::kShoulderLeft); j < humanmodel::kJointCount; ++j)
    guess.joint[j] = next++;
  JointMatch none;
  none.joint.fill(-1);
  for (const J j : {J::kHipLeft, J::kHipRight, J::kShoulderLeft, J::kShoulderRight})
    set(none, j, at(guess, j));

  JointMatch agrees = none;
  EXPECT_EQ(fillFrom(agrees, guess).size(), 12u);
  EXPECT_EQ(agrees.joint, guess.joint);
  JointMatch other_knee = none;
  set(other_knee, J::kKneeLeft, 99);
  EXPECT_EQ(fillFrom(other_knee, guess).size(), 6u) << "arms only";
  EXPECT_EQ(at(other_knee, J::kAnkleLeft), -1);
  JointMatch crossed = none;
  set(crossed, J::kHipLeft, at(guess, J::kHipRight));
  set(crossed, J::kHipRight, -1);
  EXPECT_THAT(fillFrom(crossed, guess), IsEmpty());
}

// The name of a root on the floor says pelvis, as far as names go.
TEST(JointGuess, RootOnFloorIsNoPelvis) {
  for (const double root : {0.0, 0.9}) {
    const std::vector<std::string> names{"root",   "thigh_l",    "calf_l",     "foot_l",     "thigh_r",
                                         "calf_r", "foot_r",     "neck",       "upperarm_l", "lowerarm_l",
                                         "hand_l", "upperarm_r", "lowerarm_r", "hand_r"};
    PointFrame frame;
    frame.p = {{0, 0, root},   {0, 0.1, 0.9},  {0, 0.1, 0.5},  {0, 0.1, 0.1},  {0, -0.1, 0.9},
               {0, -0.1, 0.5}, {0, -0.1, 0.1}, {0, 0, 1.45},   {0, 0.2, 1.4},  {0, 0.2, 1.1},
               {0, 0.2, 0.85}, {0, -0.2, 1.4}, {0, -0.2, 1.1}, {0, -0.2, 0.85}};
    frame.state.assign(names.size(), humanmodel::JointState::kTracked);
    const JointChoice choice = chooseJoints({names, {}, {}, {&frame, 1}}, {}, true);
    EXPECT_EQ(choice.match.joint[static_cast<std::size_t>(humanmodel::Joint::kPelvis)], root > 0.0 ? 0 : -1);
    EXPECT_EQ(choice.filled, root > 0.0 ? "pelvis 'root' by the names" : "");
  }
}

TEST(JointMapWriter, RoundTrips) {
  const testing::ScratchFolder folder;
  const std::string odd = renamed(bvhOf({}), [](int i) { return "rig|a:b + c " + std::to_string(i) + "#"; });
  for (const std::string& bvh : {bvhOf({}), odd}) {
    const Recording r = read(bvh);
    const std::string text = jointMapText(r.report);
    const Recording again = read(bvh, {.joint_map = folder.write("own.map", text)});
    EXPECT_FALSE(again.report.map_use.is_guess);
    EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
    EXPECT_EQ(again.report.mapped, r.report.mapped);
    EXPECT_EQ(limbsApart(r, again), 0.0);
    EXPECT_EQ(jointMapText(again.report), text);
  }
  // Two joints of one name: only the first can be named in a map.
  const Recording twice =
      read(renamed(bvhOf({}), [](int i) { return i < 3 ? "top" : "x" + std::to_string(i); }));
  EXPECT_THROW(jointMapText(twice.report), UsageError);
}

TEST(JointMapWriter, WritesTemplateToFillIn) {
  const testing::ScratchFolder folder;
  const std::string text = jointMapText(read(comb(2)).report);
  EXPECT_THAT(text, HasSubstr("\n# hip_left:\n"));
  EXPECT_THAT(text, HasSubstr("Names in the file:\n#   a\n#   b0\n"));
  EXPECT_THROW(read(comb(2), {.joint_map = folder.write("own.map", "name: own\nspines: b0\n")}), ParseError);
  EXPECT_NO_THROW(read(comb(2), {.joint_map = folder.write("own.map", text)})) << "all of it is comments";
}

TEST(JointMapWriter, NamesMayHaveQuotes) {
  const testing::ScratchFolder folder;
  for (const char* form : {"\"@\"", "\"@", "@\"", "\"a|\"@", "say \"@\" twice", "\"@\" | \"b\""}) {
    const std::string bvh = bvhOf({.rename = [&](const std::string& n) {
      const std::string name(form);
      const auto at = name.find('@');
      return name.substr(0, at) + n + name.substr(at + 1);
    }});
    const Recording r = read(bvh);
    ASSERT_THAT(r.report.mapped, Not(IsEmpty())) << form;
    if (std::string_view(form).find("\" | \"") != std::string_view::npos) {
      try {
        jointMapText(r.report);
        FAIL();
      } catch (const UsageError& e) {
        EXPECT_THAT(e.what(), HasSubstr("', which a joint map cannot state, expected names that"));
      }
      continue;
    }
    const Recording again = read(bvh, {.joint_map = folder.write("own.map", jointMapText(r.report))});
    EXPECT_EQ(again.report.map_use.names, r.report.map_use.names) << form;
  }
}

TEST(JointMapWriter, TemplateHasJointsThatWereFound) {
  const testing::ScratchFolder folder;
  const std::string bvh = renamed(bvhOf({}), [](int i) { return "bone" + std::to_string(i); });
  const Recording r = read(bvh, {.joint_map = folder.write("own.map", "name: Own\nhip_left: bone11\n")});
  ASSERT_THAT(r.report.mapped, IsEmpty());
  const std::string text = jointMapText(r.report);
  EXPECT_THAT(text, HasSubstr("\nhip_left: bone11\n# knee_left:\n"));
  const Recording again = read(bvh, {.joint_map = folder.write("filled.map", text)});
  EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
}

// m; a file whose units are not known is scaled by its stature, which depends on the top of the head.
constexpr double kOtherScale = 0.03;

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

struct Named {
  const char* file;
  double apart;  ///< m, of limb joints; conventions and proportions may choose a neighbour
};
void PrintTo(const Named& n, std::ostream* out) { *out << n.file; }

class RealShape : public ::testing::TestWithParam<Named> {};

/// Of a real capture.
std::filesystem::path captureFile(const std::string& name) {
  return name.starts_with("01_") || name.starts_with("Boxing") ? testing::debianBvh(name)
                                                               : testing::sharedData("mocap/bvh/" + name);
}

JointMatch matchByNames(const BvhPoints& points) {
  return chooseJointMap(loadJointMaps(testing::projectFile("data/joint_maps")), points.names());
}

// The names of real captures are taken away: the shape must find the joints that the names say.
TEST_P(RealShape, ShapeMatchesNames) {
  const std::string name = GetParam().file;
  const auto file = captureFile(name);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const std::string text = readFile(file);
  const Recording named = read(text);
  const Recording r = read(renamed(text, [](int i) { return "n" + std::to_string(i); }));
  for (const auto& note : r.report.notes) RecordProperty("note", note);
  ASSERT_EQ(r.report.joint_map, "guessed from the shape") << ::testing::PrintToString(r.report.notes);
  EXPECT_LE(limbsApart(named, r), GetParam().apart) << ::testing::PrintToString(r.report.warnings);
  EXPECT_NEAR(r.report.stature, named.report.stature, 0.1);
  EXPECT_THAT(r.report.missing_parts, IsEmpty());
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
  const std::string name = GetParam().file;
  const auto file = captureFile(name);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  BvhPoints points(readFile(file), name);
  const JointMatch named = matchByNames(points);
  const auto at = [](const JointMatch& m, J j) { return m.joint[static_cast<std::size_t>(j)]; };
  for (const bool has_legs : {true, false}) {
    BvhPoints again(readFile(file), name);
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

// Without the hierarchy, bones are distances that stay the same.
TEST_P(RealShape, PointsWithoutHierarchyMatchNames) {
  using J = humanmodel::Joint;
  const std::string name = GetParam().file;
  const auto file = captureFile(name);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  BvhPoints points(readFile(file), name);
  const JointMatch named = matchByNames(points);
  std::vector<PointFrame> frames;
  for (PointFrame frame; frames.size() < 600 && points.next(frame);) frames.push_back(frame);
  const std::vector<std::string> names(points.names().size(), "n");
  const ShapeGuess guess = guessByMotion(names, frames);
  ASSERT_EQ(limbJoints(guess.match), 12) << guess.reason;
  for (auto j = static_cast<std::size_t>(J::kShoulderLeft); j < humanmodel::kJointCount; ++j) {
    if ((j - 6) % 4 == 3) continue;
    // Of points at the same place any may be used; files round their lengths.
    const auto found = static_cast<std::size_t>(guess.match.joint[j]),
               expected = static_cast<std::size_t>(named.joint[j]);
    EXPECT_NEAR((frames.front().p[found] - frames.front().p[expected]).norm(), 0.0, kSamePlace)
        << humanmodel::jointName(static_cast<J>(j));
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
