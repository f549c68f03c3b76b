// The colours of distances over time.
#include "ui/style/heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::ui {

namespace {

/// Cividis, which stays ordered for every kind of colour vision [Nunez, Anderton, Renslow 2018]: nine stops
/// from near (bright) to far (dark).
constexpr std::array<QRgb, 9> kCividis{0xfffee838, 0xffe1cc55, 0xffc3b369, 0xffa59c74, 0xff8a8678,
                                       0xff707173, 0xff575d6d, 0xff35456c, 0xff00224e};
constexpr double kFarDistance = 1.0;  // m; everything beyond is equally dark

}  // namespace

QRgb heat(double distance) {
  // The square root gives the first decimetres most of the colours.
  const double position = std::sqrt(std::clamp(distance / kFarDistance, 0.0, 1.0)) * (kCividis.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(position), kCividis.size() - 2);
  const double f = position - static_cast<double>(i);
  const QColor near(kCividis[i]), far(kCividis[i + 1]);
  const auto mix = [f](int a, int b) { return static_cast<int>(std::lround((1.0 - f) * a + f * b)); };
  return qRgb(mix(near.red(), far.red()), mix(near.green(), far.green()), mix(near.blue(), far.blue()));
}

}  // namespace abstand::ui
