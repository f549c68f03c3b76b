// The bones of an Acclaim skeleton file (ASF).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// What one number of a bone moves. Turns are about the bone's own axes.
enum class AsfChannel : std::uint8_t { kTx, kTy, kTz, kRx, kRy, kRz };

/// A bone, from where its parent ends. The root is the first, has no length, and alone may have kTx to kTz.
struct AsfBone {
  std::string name;
  int parent{-1};                     ///< index into the list, smaller than the own; -1 for the root
  Vector3d offset{Vector3d::Zero()};  ///< from its begin to its end in the axes of the file, rest pose
  Matrix3d C{Matrix3d::Identity()};   ///< its own axes in those of the file, rest pose
  std::string order{"XYZ"};           ///< of its turns: the first is done first, about axes that stand still
  std::vector<AsfChannel> channels;   ///< in the order of the AMC
};

struct AsfSkeleton {
  std::vector<AsfBone> bones;           ///< parents first
  Vector3d position{Vector3d::Zero()};  ///< of the root in the rest pose
  double length{1.0};                   ///< as `:units` says it; 0.45 is CMU's 1 / 0.45 inch a unit
  bool in_degrees{true};                ///< of the ASF; an AMC says for itself
};

/// Rotation by three angles (rad) about x, y, z, done in the order of the letters about fixed axes.
Matrix3d fixedAxesRotation(const Vector3d& angles, const std::string& order);

/// True where the text begins like an ASF: a keyword with a colon, and `:bonedata` further on.
bool looksLikeAsf(std::string_view text);

/// Throws ParseError with the line. Words in any case; `limits`, `bodymass`, `:skin` and `:documentation` are
/// skipped.
AsfSkeleton parseAsf(std::string_view text, const std::string& file);

}  // namespace abstand::tracking
