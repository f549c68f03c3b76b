// What the engine computes with, of one body.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// Body frame, m.
struct BodyInside {
  std::vector<Vector3f> points;  ///< of the shell
  struct Sphere {
    Vector3f centre;
    float radius;
  };
  /// Of the point-sphere tree, from the root on; only levels with at most kMaxSpheres.
  std::vector<std::vector<Sphere>> levels;
  static constexpr std::size_t kMaxSpheres = 300;

  /// Signed distances of the near field on the plane z = `height`, row by row from the lower corner; NaN: the
  /// near field has no value there. Empty: the body has no near field.
  struct Slice {
    Vector3f corner{Vector3f::Zero()};
    float cell{0.0F};
    int columns{0}, rows{0};
    std::vector<float> distance;
  } slice;
};

/// What of it is drawn for the selected bodies.
enum class InsideView : std::uint8_t { kNothing, kPoints, kTree, kSlice };
inline constexpr int kInsideViews = 4;

/// Of an object of the outline.
using InsideOf = std::function<std::optional<BodyInside>(int object)>;

}  // namespace abstand::ui
