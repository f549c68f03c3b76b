// Joint positions: closed forms, and assimp as the oracle on real captures.
#include "tracking/bvh/bvh_pose.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <map>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/bvh/bvh_reader.hpp"

namespace abstand::tracking {
namespace bvh_pose_test {

constexpr double kRounding = 1e-12;        // a few roundings of lengths about 1
constexpr double kOraclePerExtent = 1e-4;  // assimp computes in floats

/// Positions of a two-joint tree, the child 1 along y, in the only frame.
std::vector<Vector3d> positions(const std::string& root_channels, const std::string& child_channels,
                                const std::string& data) {
  const BvhHierarchy h = [&] {
    BvhReader reader("HIERARCHY\nROOT a\n{\nOFFSET 10 20 30\nCHANNELS " + root_channels +
                         "\nJOINT b\n{\nOFFSET 0 1 0\nCHANNELS " + child_channels +
                         "\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n" + data,
                     "t");
    return reader.hierarchy();
  }();
  std::vector<double> values;
  std::istringstream in(data);
  for (double v = 0; in >> v;) values.push_back(v);
  BvhPose pose(h);
  pose.set(values);
  return pose.positions();
}

TEST(BvhPose, FirstChannelRotatesOutermost) {
  struct Case {
    const char* what;
    const char *root, *child, *data;
    Vector3d p_root, p_child, p_end;
  };
  const Case cases[] = {
      {"no turn", "3 Zrotation Xrotation Yrotation", "0", "0 0 0", {10, 20, 30}, {10, 21, 30}, {10, 21, 31}},
      // Rz(90) Rx(90) takes y to z and z to x; the other order would take y to -x.
      {"Z then X", "2 Zrotation Xrotation", "0", "90 90", {10, 20, 30}, {10, 20, 31}, {11, 20, 31}},
      {"X then Z", "2 Xrotation Zrotation", "0", "90 90", {10, 20, 30}, {9, 20, 30}, {9, 19, 30}},
      {"rotations before positions",
       "6 Zrotation Xrotation Yrotation Xposition Yposition Zposition",
       "0",
       "90 0 0 1 2 3",
       {1, 2, 3},
       {0, 2, 3},
       {0, 2, 4}},
      {"one position replaces one component", "1 Yposition", "0", "5", {10, 5, 30}, {10, 6, 30}, {10, 6, 31}},
      {"a child's positions replace its OFFSET",
       "1 Zrotation",
       "6 Xposition Yposition Zposition Xrotation Yrotation Zrotation",
       "90 2 0 0 0 90 0",
       {10, 20, 30},
       {10, 22, 30},
       {10, 23, 30}}};
  for (const Case& c : cases) {
    const auto p = positions(c.root, c.child, c.data);
    EXPECT_LT((p[0] - c.p_root).norm(), kRounding) << c.what;
    EXPECT_LT((p[1] - c.p_child).norm(), kRounding) << c.what << " " << p[1].transpose();
    EXPECT_LT((p[2] - c.p_end).norm(), kRounding) << c.what << " " << p[2].transpose();
  }
}

/// World positions of all nodes with a channel at a key, by assimp.
void oraclePositions(const aiNode& node, const std::map<std::string, const aiNodeAnim*>& channels,
                     unsigned key, const aiMatrix4x4& X_WParent, std::map<std::string, Vector3d>& out) {
  aiMatrix4x4 X_WNode = X_WParent * node.mTransformation;
  const auto it = channels.find(node.mName.C_Str());
  if (it != channels.end()) {
    const aiNodeAnim& a = *it->second;
    const auto& position = a.mPositionKeys[std::min(key, a.mNumPositionKeys - 1)].mValue;
    const auto& rotation = a.mRotationKeys[std::min(key, a.mNumRotationKeys - 1)].mValue;
    X_WNode = X_WParent * aiMatrix4x4(aiVector3D(1, 1, 1), rotation, position);
    out[node.mName.C_Str()] = Vector3d(X_WNode.a4, X_WNode.b4, X_WNode.c4);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    oraclePositions(*node.mChildren[i], channels, key, X_WNode, out);
}

class BvhAgainstAssimp : public ::testing::TestWithParam<const char*> {};

TEST_P(BvhAgainstAssimp, PositionsMatch) {
  const auto file = testing::debianBvh(GetParam());
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumAnimations, 1u);
  std::map<std::string, const aiNodeAnim*> channels;
  for (unsigned i = 0; i < scene->mAnimations[0]->mNumChannels; ++i)
    channels[scene->mAnimations[0]->mChannels[i]->mNodeName.C_Str()] = scene->mAnimations[0]->mChannels[i];

  BvhReader reader(readFile(file), file.string());
  BvhPose pose(reader.hierarchy());
  const auto claimed = static_cast<unsigned>(reader.head().frames);
  double worst = 0.0;
  std::size_t compared = 0;
  for (unsigned frame = 0; frame < claimed; ++frame) {
    const auto values = reader.next();
    ASSERT_TRUE(values);
    if (frame % 97 != 0 && frame + 1 != claimed) continue;
    pose.set(*values);
    std::map<std::string, Vector3d> expected;
    oraclePositions(*scene->mRootNode, channels, frame, aiMatrix4x4(), expected);
    Eigen::AlignedBox3d extent;
    for (const auto& p : pose.positions()) extent.extend(p);
    for (std::size_t j = 0; j < reader.hierarchy().joints.size(); ++j) {
      const auto it = expected.find(reader.hierarchy().joints[j].name);
      if (it == expected.end()) continue;
      ++compared;
      worst = std::max(worst, (pose.positions()[j] - it->second).norm() / extent.diagonal().norm());
    }
  }
  EXPECT_LT(worst, kOraclePerExtent);
  EXPECT_GT(compared, 20u * 20u);  // at least 20 joints in 20 frames
}

INSTANTIATE_TEST_SUITE_P(Captures, BvhAgainstAssimp, ::testing::Values("Boxing_Toes.bvh", "01_01.bvh"),
                         [](const auto& i) { return std::string(i.param, 2) == "01" ? "Cmu" : "Boxing"; });

}  // namespace bvh_pose_test
}  // namespace abstand::tracking
