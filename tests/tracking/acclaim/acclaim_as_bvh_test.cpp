// One capture in two formats: Acclaim's files are turned into BVH by code of its own, and both readers must
// find the same person.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "core/math/roll_pitch_yaw.hpp"
#include "tests/support/paths.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace acclaim_as_bvh_test {

// m; the directions of bones are unit vectors of six digits, which a reader makes one and what is written
// here leaves as they are.
constexpr double kWritten = 3e-6;

/// As the MotionBuilder conversion of the CMU data base calls the bones of its Acclaim files.
const std::map<std::string, std::string> kNames{{"lhipjoint", "LHipJoint"},
                                                {"lfemur", "LeftUpLeg"},
                                                {"ltibia", "LeftLeg"},
                                                {"lfoot", "LeftFoot"},
                                                {"ltoes", "LeftToeBase"},
                                                {"rhipjoint", "RHipJoint"},
                                                {"rfemur", "RightUpLeg"},
                                                {"rtibia", "RightLeg"},
                                                {"rfoot", "RightFoot"},
                                                {"rtoes", "RightToeBase"},
                                                {"lowerback", "LowerBack"},
                                                {"upperback", "Spine"},
                                                {"thorax", "Spine1"},
                                                {"lowerneck", "Neck"},
                                                {"upperneck", "Neck1"},
                                                {"head", "Head"},
                                                {"lclavicle", "LeftShoulder"},
                                                {"lhumerus", "LeftArm"},
                                                {"lradius", "LeftForeArm"},
                                                {"lwrist", "LeftHand"},
                                                {"lhand", "LeftFingerBase"},
                                                {"lfingers", "LeftHandIndex1"},
                                                {"lthumb", "LThumb"},
                                                {"rclavicle", "RightShoulder"},
                                                {"rhumerus", "RightArm"},
                                                {"rradius", "RightForeArm"},
                                                {"rwrist", "RightHand"},
                                                {"rhand", "RightFingerBase"},
                                                {"rfingers", "RightHandIndex1"},
                                                {"rthumb", "RThumb"}};

struct Bone {
  Vector3d offset{Vector3d::Zero()};    ///< from its begin to its end, in the file's unit
  Matrix3d axis{Matrix3d::Identity()};  ///< the frame in which it turns
  std::string freedoms;                 ///< "rx ry rz" and the like
  std::vector<std::string> below;
};

Matrix3d turned(const Vector3d& degrees) {
  return fromXyzRpy(Vector3d::Zero(), degrees * (kPi / 180.0)).linear();
}

Vector3d threeNumbers(std::istream& in) {
  Vector3d v = Vector3d::Zero();
  in >> v.x() >> v.y() >> v.z();
  return v;
}

std::map<std::string, Bone> readAsf(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::map<std::string, Bone> bones;
  std::string line, word, name;
  bool hierarchy = false;
  Vector3d direction = Vector3d::Zero();
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (hierarchy && bones.count(word) > 0)
      for (std::string child; words >> child;) bones[word].below.push_back(child);
    if (word == ":hierarchy") hierarchy = true;
    if (word == ":root") bones["root"].freedoms = "rx ry rz";
    if (word == "name") words >> name;
    if (word == "direction") direction = threeNumbers(words);
    if (word == "length") {
      double length = 0.0;
      words >> length;
      bones[name].offset = direction * length;
    }
    if (word == "axis" && !name.empty()) bones[name].axis = turned(threeNumbers(words));
    if (word == "dof") std::getline(words, bones[name].freedoms);
  }
  return bones;
}

/// Writes the skeleton of a bone and all below it; collects the order in which the frames name them.
void writeJoint(const std::map<std::string, Bone>& bones, const std::string& name, const Vector3d& at,
                std::ostream& out, std::vector<std::string>& order) {
  const Bone& bone = bones.at(name);
  const bool root = order.empty();
  order.push_back(name);
  out << (root ? "ROOT Hips" : "JOINT " + kNames.at(name)) << "\n{\nOFFSET " << at.transpose()
      << "\nCHANNELS " << (root ? "6 Xposition Yposition Zposition " : "3 ")
      << "Zrotation Yrotation Xrotation\n";
  for (const std::string& child : bone.below) writeJoint(bones, child, bone.offset, out, order);
  if (bone.below.empty()) out << "End Site\n{\nOFFSET " << bone.offset.transpose() << "\n}\n";
  out << "}\n";
}

std::string asBvh(const std::filesystem::path& asf, const std::filesystem::path& amc) {
  const auto bones = readAsf(asf);
  std::vector<std::string> order;
  std::ostringstream out, frames;
  out.precision(9);
  frames.precision(9);
  out << std::fixed << "HIERARCHY\n";
  frames << std::fixed;
  writeJoint(bones, "root", Vector3d::Zero(), out, order);

  std::ifstream in(amc);
  std::string line;
  int count = 0;
  std::map<std::string, std::string> values;
  const auto writeFrame = [&] {
    for (const std::string& name : order) {
      const Bone& bone = bones.at(name);
      std::istringstream numbers(values[name]);
      if (name == "root") frames << threeNumbers(numbers).transpose();
      Vector3d degrees = Vector3d::Zero();
      std::istringstream freedoms(bone.freedoms);
      for (std::string f; freedoms >> f;) numbers >> degrees[f[1] - 'x'];
      const Vector3d rpy = rollPitchYaw(bone.axis * turned(degrees) * bone.axis.transpose()) * (180.0 / kPi);
      frames << ' ' << rpy.z() << ' ' << rpy.y() << ' ' << rpy.x();
    }
    frames << '\n';
    ++count;
  };
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name, rest;
    words >> name;
    std::getline(words, rest);
    const bool number = !name.empty() && name.find_first_not_of("0123456789\r") == std::string::npos;
    if (number && !values.empty()) writeFrame();
    if (bones.count(name) > 0) values[name] = rest;
  }
  writeFrame();
  out << "MOTION\nFrames: " << count << "\nFrame Time: 0.0083333333\n" << frames.str();
  return out.str();
}

TEST(AcclaimAsBvh, SameCaptureGivesSamePerson) {
  const auto asf = testing::sharedData("mocap/asfamc/11.asf"),
             amc = testing::sharedData("mocap/asfamc/11_01.amc");
  if (!std::filesystem::exists(amc)) GTEST_SKIP() << amc;
  const testing::ScratchFolder folder;
  const Recording a = openRecording(amc), b = openRecording(folder.write("11_01.bvh", asBvh(asf, amc)));
  EXPECT_EQ(b.report.format, "bvh");
  EXPECT_EQ(a.report.units.name, b.report.units.name);
  EXPECT_EQ(a.report.up.axis, b.report.up.axis);
  EXPECT_NEAR(a.report.rate, b.report.rate, 1e-3);
  EXPECT_NEAR(a.report.stature, b.report.stature, kWritten);
  EXPECT_EQ(a.report.person.twisted, b.report.person.twisted);
  EXPECT_FALSE(a.report.person.twisted.empty());
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < a.frames.size(); ++k)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const auto joint = static_cast<humanmodel::Joint>(j);
      ASSERT_EQ(a.frames[k].has(joint), b.frames[k].has(joint)) << humanmodel::jointName(joint);
      if (a.frames[k].has(joint)) {
        ASSERT_LT((a.frames[k][joint] - b.frames[k][joint]).norm(), kWritten)
            << humanmodel::jointName(joint) << " of frame " << k;
      }
      ASSERT_LT((a.frames[k].lateral[j] - b.frames[k].lateral[j]).norm(), kWritten)
          << humanmodel::jointName(joint) << " of frame " << k;
    }
}

}  // namespace acclaim_as_bvh_test
}  // namespace abstand::tracking
