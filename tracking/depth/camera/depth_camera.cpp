// Pinhole depth camera and its file format.
#include "tracking/depth/camera/depth_camera.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"
#include "core/math/roll_pitch_yaw.hpp"

namespace abstand::tracking {
namespace {

constexpr config::YamlRange kFocalRange{0.0, 1e5, "pixels", true};
constexpr config::YamlRange kCentreRange{-1e5, 1e5, "pixels"};
constexpr config::YamlRange kScaleRange{0.0, 1e7, "units per metre", true};
constexpr config::YamlRange kSpreadRange{0.0, 10.0, "m"};
constexpr config::YamlRange kPositionRange{-1e3, 1e3, "m"};
constexpr config::YamlRange kAngleRange{-10.0, 10.0, "rad"};
constexpr config::YamlRange kDistortionRange{-1e3, 1e3};
constexpr double kSamePlace = 1e-6;  // m

double need(const config::YamlFields& fields, const char* key, const config::YamlRange& range) {
  fields.need(key);
  return *fields.number(key, range);
}

int needPixels(const config::YamlFields& fields, const char* key) {
  fields.need(key);
  return *fields.integer(key, 1, DepthCamera::kMaxPixels);
}

std::string listed(const Vector3d& v) {
  return "[" + formatDouble(v.x()) + ", " + formatDouble(v.y()) + ", " + formatDouble(v.z()) + "]";
}

}  // namespace

Eigen::Vector2d DepthCamera::pixelOf(const Vector3d& p_C) const {
  const auto& k = distortion;
  const double x = p_C.x() / p_C.z(), y = p_C.y() / p_C.z(), rr = x * x + y * y;
  const double radial = 1.0 + rr * (k[0] + rr * (k[1] + rr * k[4]));
  const double xd = x * radial + 2.0 * k[2] * x * y + k[3] * (rr + 2.0 * x * x);
  const double yd = y * radial + k[2] * (rr + 2.0 * y * y) + 2.0 * k[3] * x * y;
  return {fx * xd + cx, fy * yd + cy};
}

DepthCamera parseDepthCamera(const std::string& text, const std::string& file) {
  const config::YamlNode root = config::parseYaml(text, file);
  const config::YamlFields fields(
      root, file, "a camera file",
      {"width", "height", "fx", "fy", "cx", "cy", "depth_scale", "distortion", "T_WC", "spread"});
  DepthCamera camera;
  camera.width = needPixels(fields, "width");
  camera.height = needPixels(fields, "height");
  camera.fx = need(fields, "fx", kFocalRange);
  camera.fy = need(fields, "fy", kFocalRange);
  camera.cx = need(fields, "cx", kCentreRange);
  camera.cy = need(fields, "cy", kCentreRange);
  camera.depth_scale = need(fields, "depth_scale", kScaleRange);
  if (const auto* node = fields.find("distortion")) {
    const auto& list = fields.list("distortion");
    if (list.size() != 5)
      throw ParseError(fields.pos(*node), "found " + std::to_string(list.size()) +
                                              " numbers in `distortion`, expected 5: k1, k2, p1, p2, k3");
    for (std::size_t i = 0; i < 5; ++i)
      camera.distortion[static_cast<Eigen::Index>(i)] =
          config::yamlNumber(list[i], file, "`distortion`", kDistortionRange);
  }
  if (const auto* node = fields.find("T_WC")) {
    const config::YamlFields pose(*node, file, "`T_WC`", {"xyz", "rpy"});
    camera.X_WC = fromXyzRpy(pose.vector("xyz", kPositionRange).value_or(Vector3d::Zero()),
                             pose.vector("rpy", kAngleRange).value_or(Vector3d::Zero()));
  }
  camera.spread = fields.number("spread", kSpreadRange).value_or(0.0);
  return camera;
}

DepthCamera loadDepthCamera(const std::filesystem::path& file) {
  return parseDepthCamera(readFile(file, config::kMaxYamlBytes), file.string());
}

std::string describeDepthCamera(const DepthCamera& c) {
  std::string text = "width: " + std::to_string(c.width) + "\nheight: " + std::to_string(c.height);
  const auto add = [&](const char* key, double v) {
    text += std::string("\n") + key + ": " + formatDouble(v);
  };
  add("fx", c.fx);
  add("fy", c.fy);
  add("cx", c.cx);
  add("cy", c.cy);
  add("depth_scale", c.depth_scale);
  if (!c.distortion.isZero(0.0)) {
    text += "\ndistortion: [";
    for (Eigen::Index i = 0; i < 5; ++i) text += (i ? ", " : "") + formatDouble(c.distortion[i]);
    text += "]";
  }
  return text + "\nT_WC: {xyz: " + listed(c.X_WC.translation()) +
         ", rpy: " + listed(rollPitchYaw(c.X_WC.linear())) + "}\n" +
         (c.spread > 0.0 ? "spread: " + formatDouble(c.spread) + "\n" : "");
}

Transform lookingAt(const Vector3d& eye, const Vector3d& target) {
  const Vector3d direction = target - eye, across = direction.cross(Vector3d::UnitZ());
  if (!(across.norm() > kSamePlace * std::max(1.0, direction.norm())))
    throw UsageError("found a view direction that is vertical or zero, expected another target");
  Transform X = Transform::Identity();
  X.linear().col(2) = direction.normalized();
  X.linear().col(0) = across.normalized();
  X.linear().col(1) = X.linear().col(2).cross(X.linear().col(0));
  X.translation() = eye;
  return X;
}

}  // namespace abstand::tracking
