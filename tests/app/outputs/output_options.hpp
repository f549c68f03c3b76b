// The options that name a file to be written, of all commands.
#pragma once

#include <string>
#include <vector>

#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {

/// An output option: what stands before it, and the file that the command reads.
struct Output {
  std::string name;
  std::string command;
  std::string option;    ///< empty: the output is a positional argument
  std::string input;     ///< a file in the scratch folder that the command reads; empty: it reads none
  std::string ending{};  ///< of the output's name
  bool appends{false};   ///< to what is in the file already
};

inline const std::vector<Output> kFiles{
    {"skeleton out", "skeleton person.csv", "--out", "person.csv"},
    {"skeleton write", "skeleton person.csv", "--write", "person.csv"},
    {"run pairs", "run scene.yaml", "--pairs-out", "scene.yaml"},
    {"run objects", "run scene.yaml", "--objects-out", "scene.yaml"},
    {"run joints", "run scene.yaml", "--joints-out", "scene.yaml"},
    {"run cycles", "run scene.yaml", "--cycles-out", "scene.yaml"},
    {"run session", "run scene.yaml", "--session", "scene.yaml"},
    {"check junit", "check scene.yaml --min-distance 0.01", "--junit", "scene.yaml"},
    {"check report", "check scene.yaml --min-distance 0.01", "--report", "scene.yaml"},
    {"export csv", "export study", "--csv", "study/results/one.h5"},
    {"export pairs", "export study", "--pairs-csv", "study/results/one.h5"},
    {"export mcap", "export study", "--mcap", "study/results/one.h5"},
    {"report html", "report study", "--html", "study/results/one.h5"},
    {"pairs out", "pairs pair.urdf --voxel 0.05 --samples 20 --searches 0", "--out", "pair.urdf"},
    {"pairs srdf", "pairs pair.urdf --voxel 0.05 --samples 20 --searches 0", "--srdf", "pair.urdf"},
    {"convert", "convert pair.urdf --postures 2", "", "pair.urdf", ".urdf"},
    {"dynamics", "dynamics pair.urdf --motion slide.csv", "--out", "slide.csv"},
    {"calibrate", "calibrate points.csv --camera camera.yaml", "--out", "camera.yaml"},
    {"exposure html", "exposure study", "--html", ""},
    {"exposure csv", "exposure study", "--csv", ""},
    {"exposure room", "exposure study", "--room", ""},
    {"exposure body", "exposure study", "--body", ""},
    {"verify", "verify --quick --only continuity --poses 1", "--report", ""},
    {"track", "track clip --height 1.75 --usual-body --facing camera", "--out", "clip/depth_000000.png"},
    {"bench out", "bench --scenario peer --variant h50p50", "--out", "peer/poses.csv", "", true},
    {"bench dump", "bench --scenario peer --variant h50p50", "--dump", "peer/poses.csv"},
};

inline std::string commandOf(const Output& o, const std::string& to) {
  return o.command + " " + o.option + " '" + to + "'";
}

/// Outputs, with the inputs of all of kFiles.
class OutputFiles : public Outputs {
 protected:
  void SetUp() override {
    makePeerScene();
    makeClip();
    makeStudy();
  }
};

}  // namespace abstand::testing
