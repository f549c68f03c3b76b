// What a depth camera would see of a scene, as a clip on disk.
#include "app/depth/depth_clip.hpp"

#include <cstdio>

#include "app/session/times_between.hpp"
#include "core/base/output_file.hpp"
#include "tracking/depth/depth_png.hpp"
#include "tracking/depth/depth_render.hpp"

namespace abstand {
namespace {

constexpr double kSagitta = 5e-4;       // m, of the meshes of shapes
constexpr double kUsualDistance = 2.8;  // m

}  // namespace

DepthClipSummary writeDepthClip(Session& session, const DepthClipOptions& options,
                                const std::filesystem::path& folder) {
  DepthRender render(options.camera);
  const std::vector<double> times =
      timesBetween(session.frameTimes(options.rate), options.start, options.end);
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  writeFile(folder / "camera.yaml", describeDepthCamera(options.camera));

  std::vector<TriangleMesh> meshes;
  for (const Object& object : session.scene().objects())
    meshes.push_back(object.spec.structure->surface->mesh(kSagitta));
  const Transform X_CW = options.camera.X_WC.inverse();
  DepthClipSummary summary;
  std::size_t measured = 0;
  std::string list = "# time [s], file\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (options.interrupted && options.interrupted()) {
      summary.interrupted = true;
      break;
    }
    session.applyMotion(times[i]);
    render.clear();
    for (std::size_t k = 0; k < meshes.size(); ++k)
      render.draw(meshes[k], X_CW * session.scene().objects()[k].X_WB);
    const DepthImage image =
        options.noise ? seenByKinect(render.image(), options.camera, *options.noise, options.seed, i)
                      : render.image();
    for (const float z : image.z) measured += z > 0.0f;
    char name[32], line[64];
    std::snprintf(name, sizeof name, "depth_%06zu.png", i);
    std::snprintf(line, sizeof line, "%.6f %s\n", times[i], name);
    saveDepthPng(image, options.camera.depth_scale, folder / name);
    list += line;
    ++summary.frames;
    if (options.progress) options.progress(i + 1, times.size());
  }
  writeFile(folder / "depth.txt", list);
  const double pixels = static_cast<double>(summary.frames) * options.camera.width * options.camera.height;
  summary.measured = pixels > 0.0 ? static_cast<double>(measured) / pixels : 0.0;
  return summary;
}

Transform usualView(Session& session) {
  session.applyMotion(session.frameTimes().front());
  const std::string group = session.humans().empty() ? "" : session.description().humans.front().name;
  Bounds bounds;
  for (const Object& object : session.scene().objects()) {
    if (!group.empty() && object.spec.group != group) continue;
    bounds.add(object.X_WB * object.spec.structure->bounding_sphere.centre);
  }
  const Vector3d middle = bounds.centre();
  return lookingAt(middle + Vector3d(kUsualDistance, 0, 0), middle);
}

}  // namespace abstand
