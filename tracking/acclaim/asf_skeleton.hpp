// Parses the bones of an Acclaim skeleton file (ASF).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Degree of freedom of a channel. Rotations are about the bone's own axes.
enum class AsfChannel : std::uint8_t { kTx, kTy, kTz, kRx, kRy, kRz };

/// A bone, starting at the end of its parent. The root is the first, has no length, and only it may have kTx
/// to kTz.
struct AsfBone {
  std::string name;
  int parent{-1};                     ///< index into the list, smaller than its own; -1 for the root
  Vector3d offset{Vector3d::Zero()};  ///< from its start to its end, axes of the file, rest pose
  Matrix3d C{Matrix3d::Identity()};   ///< its own axes in those of the file, rest pose
  std::string order{"XYZ"};           ///< order of its rotations: the first letter is applied first, about
                                      ///< fixed axes
  std::vector<AsfChannel> channels;   ///< in the order of the AMC
};

struct AsfSkeleton {
  std::vector<AsfBone> bones;           ///< parents first
  Vector3d position{Vector3d::Zero()};  ///< of the root in the rest pose
  double length{1.0};                   ///< from `:units`; 0.45 is CMU's unit of 1 / 0.45 inch
  bool in_degrees{true};                ///< of the ASF; an AMC has its own setting
};

/// Rotation by three angles (rad) about x, y, z, applied in the order of the letters about fixed axes.
Matrix3d fixedAxesRotation(const Vector3d& angles, const std::string& order);

/// True if the text begins like an ASF: a keyword with a colon, and `:bonedata` later.
bool looksLikeAsf(std::string_view text);

/// Throws ParseError with the line. Keywords in any case; `limits`, `bodymass`, `:skin` and `:documentation`
/// are skipped.
AsfSkeleton parseAsf(std::string_view text, const std::string& file);

}  // namespace abstand::tracking
