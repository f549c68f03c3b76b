// Simulated depth camera clips of a scene.
#include "app/depth/depth_clip.hpp"

#include <cmath>
#include <cstdio>

#include "app/depth/clip_people.hpp"
#include "app/depth/clip_room.hpp"
#include "app/depth/scene_things.hpp"
#include "app/session/times_between.hpp"
#include "core/base/output_file.hpp"
#include "tracking/depth/formats/depth_png.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::depth {
namespace {

constexpr double kUsualDistance = 2.8;  // m

void writeTruth(const ClipPeople& people, std::span<const double> times, OutputFolder& folder) {
  for (std::size_t i = 0; i < people.size(); ++i) {
    tracking::Recording truth;
    for (const double t : times) truth.frames.push_back(people.at(i, t));
    tracking::writeSkeletonCsv(folder.place(i == 0 ? "truth.csv" : "truth_" + std::to_string(i + 1) + ".csv"),
                               truth);
  }
}

/// Image files and their list, in one of the formats.
class ClipFiles {
 public:
  ClipFiles(ClipFormat form, double depth_scale, OutputFolder& folder)
      : format_{form}, depth_scale_{depth_scale}, folder_{folder} {}

  void add(double t, const tracking::DepthImage& image) {
    char name[64], line[96];
    if (format_ == ClipFormat::kFreenect) {
      const auto stamp = static_cast<std::uint32_t>(std::llround(1e6 * t));
      std::snprintf(name, sizeof name, "d-%.6f-%u.pgm", t, static_cast<unsigned>(stamp));
      std::snprintf(line, sizeof line, "%s\n", name);
      writeFile(folder_.place(name), tracking::freenectDump(image));
    } else {
      std::snprintf(name, sizeof name, "depth_%06zu.png", count_);
      std::snprintf(line, sizeof line, "%.6f %s\n", t, name);
      tracking::saveDepthPng(image, depth_scale_, folder_.place(name));
    }
    list_ += line;
    ++count_;
  }
  void finish() {
    if (format_ == ClipFormat::kFreenect)
      writeFile(folder_.place("INDEX.txt"), list_);
    else
      writeFile(folder_.place("depth.txt"), "# time [s], file\n" + list_);
  }

 private:
  ClipFormat format_;
  double depth_scale_;
  OutputFolder& folder_;
  std::string list_;
  std::size_t count_{0};
};

void checkFreenect(const tracking::DepthCamera& camera, std::span<const double> times) {
  if (camera.width != tracking::kKinectWidth || camera.height != tracking::kKinectHeight)
    throw UsageError("--format freenect: found a camera of " + std::to_string(camera.width) + " x " +
                     std::to_string(camera.height) + " pixels, expected 640 x 480, those of its driver");
  if (!camera.distortion.isZero(0.0))
    throw UsageError("--format freenect: found a camera with distortion, expected one without");
  // Names contain times, which must not be negative.
  if (!times.empty() && times.front() < 0.0)
    throw UsageError("--format freenect: found times below 0, expected --start 0 or later");
}

}  // namespace

DepthClipSummary writeDepthClip(session::Session& session, const DepthClipOptions& options,
                                OutputFolder& folder) {
  tracking::DepthRender render(options.camera);
  const std::vector<double> times =
      session::timesBetween(session.frameTimes(options.rate), options.start, options.end);
  if (options.format == ClipFormat::kFreenect) checkFreenect(options.camera, times);
  writeFile(folder.place("camera.yaml"), tracking::describeDepthCamera(options.camera));

  const SceneThings things(session, !options.skin);
  const ClipPeople people(session);
  std::vector<tracking::SkinBody> skins;
  for (std::size_t i = 0; options.skin && i < people.size(); ++i) {
    tracking::SkinOptions own = *options.skin;
    if (own.seed != 0) own.seed += i;
    skins.emplace_back(people.stature(i), own);
  }
  const std::vector<geometry::TriangleMesh> room = roomOf(options.room, people, times);
  const Transform X_CW = options.camera.X_WC.inverse();
  DepthClipSummary summary;
  std::size_t measured = 0;
  ClipFiles files(options.format, options.camera.depth_scale, folder);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (options.interrupted && options.interrupted()) {
      summary.interrupted = true;
      break;
    }
    session.applyMotion(times[i]);
    render.clear();
    things.draw(X_CW, render);
    for (std::size_t k = 0; k < skins.size(); ++k)
      for (const tracking::SkinPart& part : skins[k].wrap(people.at(k, times[i])))
        render.draw(part.mesh, X_CW);
    for (const geometry::TriangleMesh& wall : room) render.draw(wall, X_CW);
    const tracking::DepthImage image = options.noise ? tracking::seenByKinect(render.image(), options.camera,
                                                                              *options.noise, options.seed, i)
                                                     : render.image();
    for (const float z : image.z) measured += z > 0.0f;
    files.add(times[i], image);
    ++summary.frames;
    if (options.progress) options.progress(i + 1, times.size());
  }
  files.finish();
  if (summary.frames > 0) writeTruth(people, std::span(times).first(summary.frames), folder);
  const double pixels = static_cast<double>(summary.frames) * options.camera.width * options.camera.height;
  summary.measured = pixels > 0.0 ? static_cast<double>(measured) / pixels : 0.0;
  return summary;
}

Transform usualView(session::Session& session) {
  session.applyMotion(session.frameTimes().front());
  const std::string group = session.humans().empty() ? "" : session.description().humans.front().name;
  geometry::Bounds bounds;
  for (const scene::Object& object : session.scene().objects()) {
    if (!group.empty() && object.spec.group != group) continue;
    bounds.add(object.X_WB * object.spec.structure->bounding_sphere.centre);
  }
  const Vector3d middle = bounds.centre();
  return tracking::lookingAt(middle + Vector3d(kUsualDistance, 0, 0), middle);
}

}  // namespace abstand::depth
