// A scene file as plain values, before meshes and recordings are loaded.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
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

/// What a body of the scene may set for itself; what is not set follows `defaults`.
struct BodySettings {
  std::optional<double> voxel, point, margin;
  std::optional<double> max_speed;  ///< m/s
  std::optional<int> outer_layers;

  /// Takes what is not set from `other`.
  void fillFrom(const BodySettings& other);
};

struct LinkDescription {
  std::string name;
  std::string frame{"0"};           ///< name of the frame it moves with (in a .mech file its id); 0: the base
  std::filesystem::path mesh;       ///< absolute; empty when a shape or a structure is given
  std::filesystem::path structure;  ///< a file that holds one (docs/structure-files.md); empty: none
  Vector3d scale{Vector3d::Ones()};  ///< of the mesh, metres per unit along its axes; never 0
  std::optional<geometry::Shape> shape;
  /// Link in its frame: `pose`; without one, and with `pose: center`, that of the mechanism file's `link`
  /// environment for a shape, whose origin is its centre, else none.
  Transform X_FL{Transform::Identity()};
  bool posed{false};             ///< the scene says where it is
  std::optional<Vector3d> p_FC;  ///< m, its centre as the mechanism file says it
  bool held{false};              ///< moved by the law `proxy`: it stays on surfaces
  BodySettings settings;
  SourcePos pos;
};

/// A link that a scene cannot show although its robot file gives it geometry.
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
  BodySettings settings;                  ///< of its links, where they have none of their own
  std::filesystem::path srdf;             ///< empty: none
  std::vector<LinkDescription> links;     ///< as the scene lists them, else those of the robot file
  bool no_geometry{false};                ///< `geometry: none`: it has no body, on purpose
  std::vector<std::string> bodiless;      ///< frames that have no body on purpose
  std::vector<BodilessLink> missing;      ///< frames that should have one, and have none or not all of it
  std::size_t frames_with_geometry{0};    ///< in the robot file, without `bodiless`
  std::optional<control::ReactionDescription> reaction;  ///< none: it follows its motion whatever happens
  SourcePos pos;
};

struct RecordingDescription {
  std::filesystem::path file;            ///< empty: stands in the rest pose
  tracking::RecordingOptions options;    ///< how the file is understood
  Vector3d place_xyz{Vector3d::Zero()};  ///< where the recording's origin goes
  double place_yaw{0.0};                 ///< rad, about world z
  /// Depth images that show the scene's robots and objects where the scene has them: they are cut out.
  bool cut_things{false};
  double speed{1.0};     ///< 2: twice as fast as recorded, from its first frame on
  bool mirrored{false};  ///< the person does the same with the other hand (mirrored_person.hpp)
  SourcePos pos;
};

struct HumanDescription {
  std::string name;
  humanmodel::HumanOptions body;
  BodySettings settings;
  bool follow_lengths{false};                          ///< `lengths: recording`
  std::map<humanmodel::BodyPart, BodySettings> parts;  ///< what a part sets for itself
  RecordingDescription recording;
  SourcePos pos;
};

struct ObjectDescription {
  std::string name;
  std::filesystem::path mesh, structure;  ///< as of a link
  Vector3d scale{Vector3d::Ones()};
  std::optional<geometry::Shape> shape;
  Transform X_WB{Transform::Identity()};
  std::optional<double> mass;  ///< kg: in the closed loop it falls and is pushed; none: it stands
  BodySettings settings;
  SourcePos pos;
};

enum class PairDefault { kAll, kBetweenGroups, kNone };

/// A pair that an SRDF or a file of pairs takes out, and why.
struct DroppedPair {
  std::string a, b, reason;
};

struct PairsDescription {
  PairDefault standard{PairDefault::kAll};
  bool exclude_adjacent{true};
  bool within_people{false};         ///< parts of one person against each other, too
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

/// Live mode's groups of pairs, a thread each; empty: chosen by the program (`threads: auto`).
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
  std::vector<std::string> remarks;  ///< what a user should know of the files that were read
};

/// Reads a scene file (cli contract, YAML). Relative paths are resolved against the scene file's folder.
/// Throws ParseError with file, line and column; unknown keys come with the nearest known one, missing files
/// at their line. Robot files are read for their frames and links, SRDFs and files of pairs for their pairs;
/// meshes only have to be there: `packages` says where those of packages are looked for.
SceneDescription loadScene(const std::filesystem::path& file, const robot_file::PackagePaths& packages = {});
SceneDescription parseScene(const std::string& text, const std::filesystem::path& file,
                            const robot_file::PackagePaths& packages = {});

/// The scene as it was understood, as YAML that reads back the same.
std::string describeScene(const SceneDescription& scene);

}  // namespace abstand::scene_file
