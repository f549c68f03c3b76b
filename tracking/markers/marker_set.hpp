// Marker sets: which marker sits where on the body, from data/marker_sets or a user's file.
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
  std::vector<std::string> names;  ///< the best first; "A + B" is the middle of two
  RigSegment segment{RigSegment::kPelvis};
  /// Forward, outward (to the left on pelvis, chest and head) and along the segment, in shares of its half
  /// depth, its half breadth and its length from joint to joint. Of a foot: forward in shares of the length
  /// from ankle to toe, downward in shares of the ankle's height above the toe.
  Vector3d place{Vector3d::Zero()};
  double spread{0.02};  ///< m, standard deviation of where it is really put, each axis
};

/// One convention; data/marker_sets/README.md describes the file format.
struct MarkerSet {
  std::string name, origin, licence;
  std::filesystem::path file;
  std::vector<std::string> prefixes, required;
  std::vector<SetMarker> markers;
};

/// Throws ParseError with line and column.
MarkerSet parseMarkerSet(std::string_view text, const std::filesystem::path& file);
MarkerSet loadMarkerSet(const std::filesystem::path& file);
/// All `*.markers` files of a folder, by file name; none where there is none. Throws ParseError.
std::vector<MarkerSet> loadMarkerSets(const std::filesystem::path& folder);

/// A marker of a set that a file has.
struct FoundMarker {
  std::string label;        ///< as in the file; of a middle "A + B"
  std::vector<int> points;  ///< of the file
  RigSegment segment{RigSegment::kPelvis};
  Vector3d p_S{Vector3d::Zero()};  ///< on the segment of the rig that it was asked for, m
  double spread{0.02};             ///< m
};

struct MarkerMatch {
  std::string set;
  std::vector<FoundMarker> markers;
  std::vector<std::string> not_found;  ///< first names of the set's markers that the file has not
};

/// Every marker of the set that `names` has, placed on `rig`. Without its required names a set finds nothing.
MarkerMatch matchMarkers(const MarkerSet& set, const BodyRig& rig, std::span<const std::string> names);

/// Enough to solve for: six markers on three segments.
bool isEnough(const MarkerMatch& match);

/// The set with most markers in the file, then with fewest missing, then the first; nothing where none finds
/// enough.
std::optional<MarkerMatch> chooseMarkerSet(std::span<const MarkerSet> sets, const BodyRig& rig,
                                           std::span<const std::string> names);

/// From the joint of a segment to the one at its other end, in its own axes, m: the hand and the head end at
/// their tips, the foot at the toe, pelvis and chest at the joint above.
Vector3d farJoint(const BodyRig& rig, RigSegment s);

}  // namespace abstand::tracking
