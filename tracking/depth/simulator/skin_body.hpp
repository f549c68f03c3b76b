// A body of smooth skin over the bones of a recording, for the camera simulator.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// What a person of the simulator looks like.
struct SkinOptions {
  double girth{1.0};      ///< 0.5 to 2: factor of all thicknesses; lengths are those of the recording
  double clothing{0.0};   ///< m, 0 to 0.1: added to the bare skin of trunk, arms and legs
  std::uint64_t seed{0};  ///< 0: usual proportions; else thicknesses differ by up to 8 %, part by part
};

/// m, from the length of the legs (thigh 0.245, calf 0.246 of it; Drillis and Contini 1966, in Winter 2009),
/// the median over the frames that show one; nothing where none does. A recording's own stature is often
/// short, as its head ends below the vertex.
std::optional<double> statureOfLegs(std::span<const humanmodel::SkeletonFrame> frames);

struct SkinPart {
  std::string_view name;        ///< as in scene files, and "neck"
  geometry::TriangleMesh mesh;  ///< closed, in the axes of the frame that it was made for
};

/// A body that is made unlike the model of humanmodel, so that what fits that model is not tested against
/// itself: its lengths are those of the recorded joints, moment by moment, and its surface is smooth: a trunk
/// lofted along the bent spine, limbs with calf and forearm, a head with a nose, mittens and shoes. Constant
/// after construction.
class SkinBody {
 public:
  /// `stature` (m) sets the thicknesses. Throws UsageError for numbers out of range.
  SkinBody(double stature, const SkinOptions& options);

  /// The parts whose joints are there. Left and right, front and back follow hips, shoulders and toes, as the
  /// joints say nothing of a turn about a limb's own axis or of where the head looks.
  std::vector<SkinPart> wrap(const humanmodel::SkeletonFrame& frame) const;

 private:
  struct Axes {
    Vector3d front, left;  ///< of the trunk, of length 1
  };
  using Parts = std::vector<SkinPart>;
  static Axes axesOf(const humanmodel::SkeletonFrame& frame, humanmodel::Joint left, humanmodel::Joint right);
  void addTrunk(const humanmodel::SkeletonFrame& frame, Parts& parts) const;
  void addHead(const humanmodel::SkeletonFrame& frame, Parts& parts) const;
  void addArm(const humanmodel::SkeletonFrame& frame, bool is_left, Parts& parts) const;
  void addLeg(const humanmodel::SkeletonFrame& frame, bool is_left, Parts& parts) const;

  double stature_;
  double clothing_;
  /// m, what the shares of stature are multiplied with: girth and unevenness included.
  double trunk_breadth_, trunk_depth_, upper_arm_, forearm_, thigh_, calf_, head_, neck_, foot_;
};

}  // namespace abstand::tracking
