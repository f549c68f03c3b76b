// What tests of the gate share: scenes with a person, and what check says of them.
#pragma once

#include <functional>

#include "humanmodel/human_model.hpp"
#include "tests/app/program.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::testing {
namespace cli_gate_test {

inline constexpr int kFrames = 11;
inline constexpr double kStep = 0.1;  // s

inline const char* const kHead = "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05, outer_layers: 1}\n";
inline const char* const kThings =
    "objects:\n  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-4, 0, 0]}}\n"
    "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [4, 0, 1]}}\n";
inline const char* const kPerson = "humans:\n  - {name: p, height: 1.75, recording: {file: p.csv}}\n";
inline const char* const kBetween = "pairs: {default: between_groups}\n";
inline const char* const kJoint =
    "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' velocity='1' effort='1'/></joint>";

/// What a case changes in the person's frames.
using Change = std::function<void(std::vector<humanmodel::SkeletonFrame>&)>;

class CheckCommand : public Cli {
 protected:
  void person(const Change& change) {
    std::vector<humanmodel::SkeletonFrame> frames(kFrames, humanmodel::makeHuman({}).rest);
    for (int i = 0; i < kFrames; ++i) frames[static_cast<std::size_t>(i)].t = i * kStep;
    if (change) change(frames);
    tracking::Recording recording;
    recording.frames = std::move(frames);
    tracking::writeSkeletonCsv(folder_.path() / "p.csv", recording);
  }
  std::string scene(const std::string& text) { return write("s.yaml", kHead + text); }
  /// The first reservation of that kind, or null.
  static json find(const json& document, const std::string& kind) {
    for (const auto& r : document["reservations"])
      if (r["kind"] == kind) return r;
    return nullptr;
  }
};

}  // namespace cli_gate_test
}  // namespace abstand::testing
