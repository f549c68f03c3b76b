#include "core/math/roll_pitch_yaw.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/number.hpp"

namespace abstand {
namespace {

double rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
  for (char& c : text)
    if (c == ',') c = '.';  // another locale's decimal point
  return parseDouble(text).value_or(value);
}

}  // namespace

Vector3d rollPitchYaw(const Matrix3d& R) {
  const double roll = std::atan2(R(2, 1), R(2, 2));
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2)));
  const double s = std::sin(roll), c = std::cos(roll);
  const double yaw = std::atan2(s * R(0, 2) - c * R(0, 1), c * R(1, 1) - s * R(1, 2));
  return {roll, pitch, yaw};
}

double neatNumber(double value, double tolerance) {
  if (std::abs(value) <= tolerance) return 0.0;
  for (int digits = 1; digits < 17; ++digits)
    if (const double neat = rounded(value, digits); std::abs(neat - value) <= tolerance) return neat;
  return value;
}

Vector3d neatRollPitchYaw(const Matrix3d& R) {
  const Vector3d rpy = rollPitchYaw(R);
  // The other triple of angles of the same rotation, with pitch beyond 90 degrees.
  const auto turned = [](double angle) { return angle > 0.0 ? angle - kPi : angle + kPi; };
  const Vector3d other(turned(rpy.x()), std::copysign(kPi, rpy.y()) - rpy.y(), turned(rpy.z()));
  constexpr std::array kTolerances{1e-9, 1e-12, 2e-15, 0.0};
  for (const Vector3d& angles : {rpy, other}) {
    Eigen::Matrix<double, 3, kTolerances.size()> neat;
    for (int i = 0; i < neat.size(); ++i)
      neat(i % 3, i / 3) = neatNumber(angles[i % 3], kTolerances[static_cast<std::size_t>(i / 3)]);
    for (int x = 0; x < neat.cols(); ++x)
      for (int y = 0; y < neat.cols(); ++y)
        for (int z = 0; z < neat.cols(); ++z)
          if (const Vector3d tried(neat(0, x), neat(1, y), neat(2, z));
              fromXyzRpy(Vector3d::Zero(), tried).linear() == R)
            return tried;
  }
  return rpy;
}

}  // namespace abstand
