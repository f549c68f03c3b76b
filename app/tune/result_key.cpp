#include "app/tune/result_key.hpp"

#include <algorithm>

#include "app/tune/result_fingerprint.hpp"
#include "core/base/text_file.hpp"

namespace abstand::tune {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

void addText(ContentHash& hash, const std::string& text) {
  hash.add(text.size());
  hash.add(text.data(), text.size());
}

}  // namespace

void addContent(ContentHash& hash, const std::filesystem::path& file) {
  if (file.empty()) return;
  if (std::error_code ec; std::filesystem::is_directory(file, ec)) {
    // A recording of depth images.
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(file))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& f : files) addText(hash, f.filename().string()), addContent(hash, f);
    return;
  }
  const std::string content = readFile(file, kMaxFileBytes);
  hash.add(content.size());
  hash.add(content.data(), content.size());
}

std::string resultVersion() { return std::to_string(kResultFingerprint); }

ContentKey resultKey(const scene_file::SceneDescription& scene, const std::filesystem::path& recording,
                     const TuneOptions& options, const std::string& settings) {
  ContentHash hash;
  addText(hash, settings);
  hash.add(kResultFormat);
  hash.add(kResultFingerprint);
  addText(hash, scene_file::describeScene(scene));
  for (const auto& m : scene.mechanisms) {
    addContent(hash, m.file);
    addContent(hash, m.motion);
    for (const auto& link : m.links) addContent(hash, link.mesh), addContent(hash, link.structure);
  }
  for (const auto& o : scene.objects) addContent(hash, o.mesh), addContent(hash, o.structure);
  for (const auto& h : scene.humans) {
    if (recording.empty()) addContent(hash, h.recording.file);
    addContent(hash, h.recording.options.joint_map);
    hash.add(h.recording.speed);  // not in scene files
    hash.add(h.recording.mirrored);
  }
  addContent(hash, recording);
  const auto& braking = options.pass.braking;
  for (const double v : {options.pass.limit, options.pass.near, options.pass.calibration_error,
                         braking.reaction_time, braking.deceleration})
    hash.add(v);
  options.pass.separation.eachNumber(
      options.pass.separation, [&](const char*, const double& v, const config::NumberRule&) { hash.add(v); });
  if (options.pass.contact) addText(hash, options.pass.contact->content.hex());
  return hash.value();
}

}  // namespace abstand::tune
