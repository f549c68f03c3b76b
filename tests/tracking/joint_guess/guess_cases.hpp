// Recordings whose joints are guessed: helpers of their tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/joint_guess/joint_choice.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

inline Recording read(const std::string& bvh, const RecordingOptions& options = {}) {
  return readBvhRecording(bvh, "t.bvh", options);
}

/// Every joint gets a new name, by its place in the file.
inline std::string renamed(const std::string& bvh, const std::function<std::string(int)>& name) {
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

/// Names of the joints without end sites, in the order of renamed().
inline std::vector<std::string> namesOf(const std::string& bvh) {
  std::istringstream in(bvh);
  std::vector<std::string> names;
  for (std::string word; in >> word && word != "MOTION";)
    if (word == "ROOT" || word == "JOINT") names.emplace_back() = (in >> word, word);
  return names;
}

/// Largest distance of a limb joint between two readings of one file, in all frames, m.
inline double limbsApart(const Recording& a, const Recording& b) {
  double apart = 0.0;
  for (std::size_t f = 0; f < a.frames.size(); ++f)
    for (std::size_t j = static_cast<std::size_t>(humanmodel::Joint::kShoulderLeft);
         j < humanmodel::kJointCount; ++j) {
      const bool is_tip = (j - 6) % 4 == 3;
      if (!is_tip) apart = std::max(apart, (a.frames[f].p[j] - b.frames[f].p[j]).norm());
    }
  return apart;
}

/// A tree of joints without the lengths of a person.
inline std::string comb(int teeth) {
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

/// A joint of a figure with numbers for names; an end site has depth and offset alone.
struct FigureJoint {
  int depth;
  Vector3d offset;  ///< cm, z up, facing x
  bool is_site{false};
};
using Figure = std::vector<FigureJoint>;

inline std::string figureBvh(const Figure& figure) {
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

inline void append(Figure& figure, const Figure& more) {
  figure.insert(figure.end(), more.begin(), more.end());
}

inline Figure legsOnly() {
  Figure figure{{0, {0, 0, 0}}};
  for (const double side : {1.0, -1.0})
    append(
        figure,
        {{1, {0, 9 * side, 0}}, {2, {0, 0, -43}}, {3, {0, 0, -42}}, {4, {14, 0, -7}}, {5, {6, 0, 0}, true}});
  append(figure, {{1, {0, 0, 10}}, {2, {0, 0, 22}}, {3, {0, 0, 18}}, {4, {0, 0, 9}}, {5, {0, 0, 18}, true}});
  return figure;
}

/// With arms at the second joint of the trunk; `hands`: what the hands hold, from depth 7 on.
inline Figure wholeFigure(const std::array<Figure, 2>& hands) {
  Figure figure = legsOnly();
  for (const std::size_t side : {0u, 1u}) {
    const double y = side == 0 ? 1.0 : -1.0;
    append(figure, {{3, {0, 3 * y, 12}}, {4, {0, 15 * y, 0}}, {5, {0, 30 * y, 0}}, {6, {0, 25 * y, 0}}});
    append(figure, hands[side]);
  }
  return figure;
}

inline std::string usedFor(const Recording& r, humanmodel::Joint j) {
  const auto& names = r.report.map_use.names[static_cast<std::size_t>(j)];
  return names.empty() ? "" : names.front();
}

struct Named {
  const char* file;
  double apart;  ///< m, of limb joints; conventions and proportions may choose a neighbour
};
inline void PrintTo(const Named& n, std::ostream* out) { *out << n.file; }

/// Tests of real captures; the files are listed in shape_guess_test.cpp.
struct RealShape : ::testing::TestWithParam<Named> {
  void SetUp() override {
    const bool is_debian = name.starts_with("01_") || name.starts_with("Boxing");
    const auto file = is_debian ? testing::debianBvh(name) : testing::sharedData("mocap/bvh/" + name);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    text = readFile(file);
  }
  const std::string name = GetParam().file;
  std::string text;
};

inline JointMatch matchByNames(const BvhPoints& points) {
  return chooseJointMap(loadJointMaps(testing::projectFile("data/joint_maps")), points.names());
}

}  // namespace joint_guess_test
}  // namespace abstand::tracking
