#include "app/tune/frame_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::tune {
namespace {

double upToStep(double value, double max) {
  return std::min(max, std::ceil(value / kContactStep) * kContactStep);
}

}  // namespace

FrameContact roundedUp(const FrameContact& contact) {
  FrameContact rounded = contact;
  rounded.force = upToStep(contact.force, kMaxContact);
  rounded.energy = upToStep(contact.energy, kMaxContact);
  const double pressure = upToStep(contact.pressure * kPerSquareCentimetre, kMaxContact);
  rounded.pressure = pressure < kMaxContact ? pressure / kPerSquareCentimetre : kInfinity;
  const double share = upToStep(contact.share, kInfiniteShare);
  rounded.share = share < kInfiniteShare ? share : kInfinity;
  return rounded;
}

}  // namespace abstand::tune
