#include "app/tune/result_key.hpp"

#include "app/session/input_content.hpp"
#include "app/tune/result_fingerprint.hpp"

namespace abstand::tune {
namespace {

using session::addContent;

void addText(ContentHash& hash, const std::string& text) {
  hash.add(text.size());
  hash.add(text.data(), text.size());
}

}  // namespace

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
    for (const auto& tool : h.tools) addContent(hash, tool.mesh), addContent(hash, tool.structure);
    hash.add(h.recording.speed);  // not in scene files
    hash.add(h.recording.mirrored);
  }
  addContent(hash, recording);
  const auto& braking = options.pass.braking;
  for (const double v : {options.pass.limit, options.pass.near, options.pass.calibration_error,
                         options.pass.latency, braking.reaction_time, braking.deceleration})
    hash.add(v);
  options.pass.separation.eachNumber(
      options.pass.separation, [&](const char*, const double& v, const config::NumberRule&) { hash.add(v); });
  if (options.pass.separation_standard) addText(hash, options.pass.separation_standard->content.hex());
  if (options.pass.contact) addText(hash, options.pass.contact->content.hex());
  for (const std::string& part : options.pass.clamped) addText(hash, part);
  return hash.value();
}

}  // namespace abstand::tune
