// Recordings for tests of `tune` and of what reads its results.
#pragma once

#include <filesystem>

#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::testing {

/// Seven people who come at a ball on a rail, each at a speed of their own.
class SevenPeople : public Cli {
 protected:
  static constexpr int kPeople = 7;
  SevenPeople() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    for (int i = 0; i < kPeople; ++i) {
      writeSlide(folder_, {.robot = 0.5, .person = 0.1 * i, .seconds = 2.5}, std::to_string(i));
      recordings_ += " " + (folder_.path() / ("person" + std::to_string(i) + ".csv")).string();
    }
    scene_ = (folder_.path() / "slide.yaml").string();
  }
  std::string out(const std::string& name) const { return (folder_.path() / name).string(); }
  std::size_t results(const std::string& folder) const {
    std::error_code ec;
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(out(folder) + "/results", ec))
      count += entry.path().extension() == ".h5";
    return count;
  }
  /// Without what differs from place to place.
  static std::string answerOf(json j) {
    j.erase("results");
    return j.dump(1);
  }

  std::string scene_, recordings_;
};

}  // namespace abstand::testing
