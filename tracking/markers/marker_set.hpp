// Marker sets: positions of markers on the body, from data/marker_sets or a user's file.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// One marker of a set.
struct SetMarker {
  std::vector<std::string> names;  ///< in order of preference; "A + B" is the midpoint of two
  RigSegment segment{RigSegment::kPelvis};
  /// Position forward, outward (to the left on pelvis, chest and head) and along the segment, as shares of
  /// its half depth, its half breadth and its length from joint to joint. For a foot: forward as a share of
  /// the length from ankle to toe, downward as a share of the ankle's height above the toe.
  Vector3d place{Vector3d::Zero()};
  double spread{0.02};  ///< m, standard deviation of the actual position, each axis
};

/// One naming and placing convention; data/marker_sets/README.md describes the file format.
struct MarkerSet {
  std::string name, origin, licence;
  std::filesystem::path file;
  std::vector<std::string> prefixes, required;
  std::vector<SetMarker> markers;
};

/// Throws ParseError with line and column.
MarkerSet parseMarkerSet(std::string_view text, const std::filesystem::path& file);
MarkerSet loadMarkerSet(const std::filesystem::path& file);
/// All `*.markers` files of a folder, sorted by file name; empty if there are none. Throws ParseError.
std::vector<MarkerSet> loadMarkerSets(const std::filesystem::path& folder);

/// A marker of a set that exists in a file.
struct FoundMarker {
  std::string label;        ///< as in the file; "A + B" for a midpoint
  std::vector<int> points;  ///< indices in the file
  RigSegment segment{RigSegment::kPelvis};
  Vector3d p_S{Vector3d::Zero()};  ///< position on the segment of the rig passed to matchMarkers(), m
  double spread{0.02};             ///< m
};

struct MarkerMatch {
  std::string set;
  std::vector<FoundMarker> markers;
  std::vector<std::string> not_found;  ///< first names of the set's markers missing in the file
};

/// All markers of the set found in `names`, placed on `rig`. Without its required names a set finds nothing.
MarkerMatch matchMarkers(const MarkerSet& set, const BodyRig& rig, std::span<const std::string> names);

/// Enough for solving: six markers on three segments.
bool isEnough(const MarkerMatch& match);

/// The set with most markers in the file, then with fewest missing, then the first; nullopt if none finds
/// enough.
std::optional<MarkerMatch> chooseMarkerSet(std::span<const MarkerSet> sets, const BodyRig& rig,
                                           std::span<const std::string> names);

/// Vector from the joint of a segment to that at its other end, in its own axes, m: hand and head end at
/// their tips, the foot at the toe, pelvis and chest at the joint above.
Vector3d farJoint(const BodyRig& rig, RigSegment s);

/// Half the extent of a part's shape along x (0), y or z, m.
double halfExtent(const geometry::Shape& shape, int axis);

}  // namespace abstand::tracking
