// What a viewer has to know of a served scene before the first moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/content_hash.hpp"

namespace abstand::moment {

/// Names in the order of the scene. The sizes of all moments follow from it.
struct SceneCard {
  std::uint64_t server{0};  ///< differs from one start of a server to the next
  ContentKey scene;         ///< fingerprint of the content of the scene file
  std::string file;         ///< the scene file, absolute, on the machine of the server
  std::vector<std::string> objects, people, groups;
  struct Robot {
    std::string name;
    std::uint32_t dof{0};
    friend bool operator==(const Robot&, const Robot&) = default;
  };
  std::vector<Robot> robots;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< objects

  std::size_t dof() const;  ///< total of all robots
  friend bool operator==(const SceneCard&, const SceneCard&) = default;
};

/// Fingerprint for SceneCard::scene. Throws ParseError for a file that cannot be read.
ContentKey sceneKey(const std::string& file);

/// The frame with its header.
std::vector<std::byte> writeSceneCard(const SceneCard& card);
/// Of one untrusted frame; nothing if it is damaged.
std::optional<SceneCard> readSceneCard(std::span<const std::byte> frame);

}  // namespace abstand::moment
