// A ball on a rail that drives at a person: everything about margins has a closed form.
#pragma once

#include <memory>

#include "app/depth/open_session.hpp"
#include "core/base/number.hpp"
#include "humanmodel/human_model.hpp"
#include "tests/support/paths.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::testing {

struct SlideSpeeds {
  double robot{0.5};           ///< m/s, towards the person, from 2.4 m before it
  double person{0.0};          ///< m/s, towards the robot
  double stops_at{kInfinity};  ///< s, when the person stands still
  double rate{100.0};          ///< Hz
  double seconds{4.0};
};

/// The person stands at the origin and may come along -x; the ball of 50 mm comes along +x at the height of
/// the trunk.
inline std::unique_ptr<session::Session> openSlide(const ScratchFolder& folder, const SlideSpeeds& speeds,
                                                   const std::string& folder_of = "") {
  folder.write("slide.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\n");
  folder.write("go.csv", "t,q0\n0,0\n" + formatDouble(speeds.seconds) + "," +
                             formatDouble(speeds.robot * speeds.seconds) + "\n");
  tracking::Recording recording;
  const humanmodel::SkeletonFrame rest = humanmodel::makeHuman({}).rest;
  for (int i = 0; i <= static_cast<int>(speeds.seconds * speeds.rate + 0.5); ++i) {
    humanmodel::SkeletonFrame f = rest;
    f.t = i / speeds.rate;
    for (auto& p : f.p) p.x() -= speeds.person * std::min(f.t, speeds.stops_at);
    recording.frames.push_back(f);
  }
  tracking::writeSkeletonCsv(folder.path() / ("person" + folder_of + ".csv"), recording);
  const auto scene = folder.write("slide.yaml", R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02, outer_layers: 1}
mechanisms:
  - name: slide
    file: slide.mech
    base: {xyz: [-2.4, 0, 1.2], rpy: [0, 0, 1.5707963267948966]}
    motion: go.csv
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.05}}}]
humans: [{name: person, height: 1.75, recording: {file: person)" +
                                                    folder_of + R"(.csv}}]
)");
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  return depth::openSession(scene_file::loadScene(scene), options);
}

}  // namespace abstand::testing
