// Fuzzes the BVH reader and its kinematics: only ParseError may come out, and only finite positions.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.hpp"
#include "tracking/bvh/bvh_pose.hpp"
#include "tracking/bvh/bvh_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    abstand::tracking::BvhReader reader(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
    abstand::tracking::BvhPose pose(reader.hierarchy());
    while (const auto values = reader.next()) {
      pose.set(*values);
      for (const auto& p : pose.positions()) ABSTAND_CHECK(p.allFinite());
    }
  } catch (const abstand::ParseError&) {
  }
  return 0;
}
