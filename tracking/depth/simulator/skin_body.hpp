// Body with smooth skin around the joints of a recording, for the camera simulator.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Appearance of a simulated person.
struct SkinOptions {
  double girth{1.0};      ///< 0.5 to 2: factor of all thicknesses; lengths are those of the recording
  double clothing{0.0};   ///< m, 0 to 0.1: thickness added on trunk, arms and legs
  std::uint64_t seed{0};  ///< 0: usual proportions; otherwise thicknesses vary by up to 8 %, by part
};

/// Stature (m) from the length of the legs (thigh 0.245, calf 0.246 of it; Drillis and Contini 1966, in
/// Winter 2009), the median over the frames with a leg; nullopt if there are none. A recording's own stature
/// is often too small, as its head ends below the vertex.
std::optional<double> statureOfLegs(std::span<const humanmodel::SkeletonFrame> frames);

struct SkinPart {
  std::string_view name;        ///< as in scene files, and "neck"
  geometry::TriangleMesh mesh;  ///< closed, in the axes of the frame that it was made for
};

/// A body built independently of humanmodel, so that a fit of that model is not tested against itself: its
/// lengths are those of the recorded joints in each frame, and its surface is smooth: a trunk lofted along
/// the bent spine, limbs with calf and forearm, a head with a nose, mittens and shoes. Constant after
/// construction.
class SkinBody {
 public:
  /// `stature` (m) determines the thicknesses. Throws UsageError for values out of range.
  SkinBody(double stature, const SkinOptions& options);

  /// Meshes of the parts whose joints exist. Left and right, front and back follow hips, shoulders and toes,
  /// as joints do not determine the twist of a limb or the direction of the head.
  std::vector<SkinPart> wrap(const humanmodel::SkeletonFrame& frame) const;

 private:
  struct Axes {
    Vector3d front, left;  ///< of the trunk, unit
  };
  using Parts = std::vector<SkinPart>;
  static Axes axesOf(const humanmodel::SkeletonFrame& frame, humanmodel::Joint left, humanmodel::Joint right);
  void addTrunk(const humanmodel::SkeletonFrame& frame, Parts& parts) const;
  void addHead(const humanmodel::SkeletonFrame& frame, Parts& parts) const;
  void addArm(const humanmodel::SkeletonFrame& frame, bool is_left, Parts& parts) const;
  void addLeg(const humanmodel::SkeletonFrame& frame, bool is_left, Parts& parts) const;

  double stature_;
  double clothing_;
  /// m, thicknesses as factors of the shares of stature: girth and variation included.
  double trunk_breadth_, trunk_depth_, upper_arm_, forearm_, thigh_, calf_, head_, neck_, foot_;
};

}  // namespace abstand::tracking
