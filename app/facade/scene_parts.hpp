// Parts collected by a SceneBuilder.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "abstand/scene.hpp"
#include "app/scene_file/scene_description.hpp"

namespace abstand {

struct SceneBuilder::Impl {
  scene_file::SceneDescription description;
  std::map<std::string, std::shared_ptr<const structure::HapticStructure>> made;

  /// Including pairs of objects with each other.
  scene_file::SceneDescription described() const;
};

}  // namespace abstand
