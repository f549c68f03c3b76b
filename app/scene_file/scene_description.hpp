// Content of a scene file as plain values, before meshes and recordings are loaded.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.hpp"
#include "core/control/reaction_description.hpp"
#include "core/geometry/shape.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "core/scene/query_culling.hpp"
#include "core/structure/haptic_options.hpp"
#include "humanmodel/human_model.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::scene_file {

/// Settings of a body; unset ones follow `defaults`.
struct BodySettings {
  std::optional<double> voxel, point, margin;
  std::optional<double> max_speed;  ///< m/s
  std::optional<int> outer_layers;

  /// Sets unset values from `other`.
  void fillFrom(const BodySettings& other);
};

struct LinkDescription {
  std::string name;
  std::string frame{"0"};           ///< name of the frame it moves with (in a .mech file its id); 0: the base
  std::filesystem::path mesh;       ///< absolute; empty if a shape or a structure is given
  std::filesystem::path structure;  ///< structure file (docs/structure-files.md); empty: none
  Vector3d scale{Vector3d::Ones()};  ///< of the mesh, metres per unit along its axes; never 0
  std::optional<geometry::Shape> shape;
  /// Link in its frame: `pose`; without it, and with `pose: center`, the centre in the mechanism file's
  /// `link` environment for a shape, whose origin is its centre; otherwise the identity.
  Transform X_FL{Transform::Identity()};
  bool posed{false};             ///< the scene sets its pose
  std::optional<Vector3d> p_FC;  ///< m, its centre in the mechanism file
  bool held{false};              ///< moved by the law `proxy`
  BodySettings settings;
  SourcePos pos;
};

/// A link with geometry in its robot file that the scene cannot show.
struct BodilessLink {
  std::string frame;
  std::string reason;  ///< "found no file package://a/b.dae", "not among the scene's links"
};

struct MechanismDescription {
  std::string name;
  std::filesystem::path file;             ///< .mech or URDF
  Transform X_WB{Transform::Identity()};  ///< `base`
  std::vector<double> q;                  ///< empty: all zero
  std::filesystem::path motion;           ///< empty: none
  BodySettings settings;                  ///< of its links, unless they have their own
  std::filesystem::path srdf;             ///< empty: none
  std::vector<LinkDescription> links;     ///< as listed in the scene, otherwise those of the robot file
  bool no_geometry{false};                ///< `geometry: none`: intentionally without bodies
  std::vector<std::string> bodiless;      ///< frames intentionally without a body
  std::vector<BodilessLink> missing;      ///< frames that should have a body, but have none or an incomplete
                                          ///< one
  std::size_t frames_with_geometry{0};    ///< in the robot file, without `bodiless`
  std::optional<control::ReactionDescription> reaction;  ///< nullopt: it only follows its motion
  SourcePos pos;
};

struct RecordingDescription {
  std::filesystem::path file;            ///< empty: stands in the rest pose
  tracking::RecordingOptions options;    ///< interpretation of the file
  Vector3d place_xyz{Vector3d::Zero()};  ///< position of the recording's origin
  double place_yaw{0.0};                 ///< rad, about world z
  /// Whether the scene's robots and objects are removed from the depth images; unset: if the images show
  /// them.
  std::optional<bool> cut_things;
  double speed{1.0};     ///< factor of the recorded speed, from the first frame on
  bool mirrored{false};  ///< mirrored: left and right exchanged (mirrored_person.hpp)
  SourcePos pos;
};

/// Something rigid that a hand holds. It is a body of the person, `PERSON/HAND/NAME`, and counts as that
/// hand.
struct ToolDescription {
  std::string name;
  humanmodel::BodyPart hand{humanmodel::BodyPart::kHandRight};
  std::filesystem::path mesh, structure;  ///< as of a link
  Vector3d scale{Vector3d::Ones()};
  std::optional<geometry::Shape> shape;
  Transform X_HT{Transform::Identity()};  ///< tool in the hand's frame (humanmodel::HumanPart)
  BodySettings settings;                  ///< unset ones follow those of the hand
  SourcePos pos;

  /// "operator/hand_right/driver".
  std::string bodyName(const std::string& person) const;
};

struct HumanDescription {
  std::string name;
  humanmodel::HumanOptions body;
  BodySettings settings;
  bool follow_lengths{false};                          ///< `lengths: recording`
  std::map<humanmodel::BodyPart, BodySettings> parts;  ///< settings of single parts
  /// Parts that a robot may clamp against something fixed; matters for limits of contacts only.
  std::set<humanmodel::BodyPart> clamped;
  std::vector<ToolDescription> tools;
  RecordingDescription recording;
  SourcePos pos;
};

struct ObjectDescription {
  std::string name;
  std::filesystem::path mesh, structure;  ///< as of a link
  Vector3d scale{Vector3d::Ones()};
  std::optional<geometry::Shape> shape;
  Transform X_WB{Transform::Identity()};
  std::optional<double> mass;  ///< kg: in the closed loop it falls and is pushed; without: fixed
  BodySettings settings;
  SourcePos pos;
};

enum class PairDefault { kAll, kBetweenGroups, kNone };

/// A pair dropped by an SRDF or a file of pairs, with the reason.
struct DroppedPair {
  std::string a, b, reason;
};

struct PairsDescription {
  PairDefault standard{PairDefault::kAll};
  bool exclude_adjacent{true};
  bool within_people{false};         ///< also pairs of parts of one person
  std::filesystem::path file;        ///< of `abstand pairs`; empty: none
  std::vector<DroppedPair> dropped;  ///< by that file and by the mechanisms' SRDFs; names of bodies
  std::vector<std::pair<std::string, std::string>> exclude, include;
  std::vector<SourcePos> exclude_pos, include_pos;
};

struct SceneDefaults {
  structure::HapticOptions haptic;
  double margin{0.0};
  double stiffness{1.0e6};  ///< N/m^3, or N/m with `law: thesis`
  bool thesis_law{false};
};

/// Groups of pairs in live mode, one thread each; empty: chosen by the program (`threads: auto`).
using ThreadGroups = std::vector<std::vector<std::pair<std::string, std::string>>>;

struct SceneDescription {
  std::filesystem::path file;
  SceneDefaults defaults;
  std::vector<MechanismDescription> mechanisms;
  std::vector<HumanDescription> humans;
  std::vector<ObjectDescription> objects;
  PairsDescription pairs;
  ThreadGroups threads;
  scene::QueryCulling culling{.remember = true};
  std::vector<std::string> remarks;  ///< remarks for the user about the files
};

/// Reads a scene file (YAML, part of the command line contract). Relative paths are resolved against the
/// scene file's folder. Throws ParseError with file, line and column; unknown keys come with the nearest
/// known one, missing files with their line. Robot files are read for frames and links, SRDFs and files of
/// pairs for their pairs; meshes only need to exist: `packages` states where packages are searched.
SceneDescription loadScene(const std::filesystem::path& file, const robot_file::PackagePaths& packages = {});
SceneDescription parseScene(const std::string& text, const std::filesystem::path& file,
                            const robot_file::PackagePaths& packages = {});

/// The scene as understood, as YAML that reads back the same.
std::string describeScene(const SceneDescription& scene);

}  // namespace abstand::scene_file
