// Reads the bodies of a scene file: mechanisms, people and objects. Internal to the scene reader.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/scene_file/mesh_or_shape.hpp"
#include "app/scene_file/scene_description.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::scene_file {

/// Limit of bodies: all pairs of more would not fit into memory.
inline constexpr std::size_t kMaxBodies = 1000;

/// Reads bodies sequentially and checks that their names are unique. Robots are read in
/// scene_robot_reader.cpp, people in scene_person_reader.cpp.
class SceneBodyReader {
 public:
  /// `folder`: base of relative paths. The file's name and `packages` must outlive the reader.
  SceneBodyReader(const std::string& file, std::filesystem::path folder,
                  const robot_file::PackagePaths& packages)
      : file_{file}, folder_{std::move(folder)}, packages_{packages} {}

  MechanismDescription mechanism(const config::YamlNode& node);
  HumanDescription human(const config::YamlNode& node);
  ObjectDescription object(const config::YamlNode& node);

  /// Pairs dropped by SRDFs.
  const std::vector<DroppedPair>& dropped() const { return dropped_; }
  std::filesystem::path existingFile(const config::YamlNode& node, const std::string& label,
                                     const char* expected) const;

  /// All bodies so far, in order: links and objects as written, parts of people as PERSON/PART.
  const std::vector<std::string>& bodies() const { return bodies_; }
  /// Remarks about the robot files and where their packages were found.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  void takeDisabled(const MechanismDescription& mechanism);
  LinkDescription link(const config::YamlNode& node, const mechanism::Mechanism& mechanism);
  control::ReactionDescription reaction(const config::YamlNode& node, int dof) const;
  RecordingDescription recording(const config::YamlNode& node);
  void readPart(const std::string& name, const config::YamlNode& node, HumanDescription& h) const;
  void readWorn(const config::YamlFields& fields, HumanDescription& h);
  FindFile finder() const;
  std::string newName(const config::YamlFields& fields, std::set<std::string>& taken, const char* kind);
  std::string newBody(const config::YamlFields& fields);
  void addBody(std::string name, const SourcePos& pos);
  void takeBody(const std::string& name, const SourcePos& pos);

  const std::string& file_;
  std::filesystem::path folder_;
  const robot_file::PackagePaths& packages_;
  std::set<std::string> groups_{"objects"};
  std::set<std::string> body_names_;
  std::vector<std::string> bodies_;
  std::vector<std::string> remarks_;
  std::vector<DroppedPair> dropped_;
};

}  // namespace abstand::scene_file
