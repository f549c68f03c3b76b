// User options of a haptic structure.
#pragma once

#include <optional>
#include <string_view>

namespace abstand::structure {

/// layered: integer layers, the thesis's voxelmap. flt ("float" in files): float distances over the whole
/// map. mixed: float distances in a sparse band near the surface and a coarse field beyond.
enum class FieldKind { kLayered, kFloat, kMixed };

std::string_view fieldName(FieldKind kind);
std::optional<FieldKind> parseFieldKind(std::string_view text);

struct HapticOptions {
  double voxel_size{0.005};     ///< m; half of the smallest relevant feature
  double point_spacing{0.005};  ///< m; pitch of the pointshell
  int outer_layers{20};         ///< layers of voxels outside the surface
  FieldKind field{FieldKind::kMixed};
  /// Throws UsageError with name, value and rule.
  void validate() const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(voxel_size, point_spacing, outer_layers, field);
  }
};

}  // namespace abstand::structure
