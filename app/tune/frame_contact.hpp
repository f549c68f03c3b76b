// Predicted contact of a body part in one frame.
#pragma once

#include <cstdint>
#include <optional>

namespace abstand::tune {

/// In place of the index of a region: no contact is predicted.
inline constexpr std::uint16_t kNoRegion = 65535;

/// The hardest contact of a part that could occur in a frame: of its pairs nearer than PassOptions::near that
/// close in, the one with the largest share of a limit. Force and energy are those of the region with the
/// largest share of the force; the pressure is its peak under the surface of the link
/// (contact::predictPressure). The numbers are rounded up (roundedUp()).
struct FrameContact {
  std::uint16_t link{0};            ///< index into PassResult::links
  std::uint16_t region{kNoRegion};  ///< index into PassResult::regions
  double force{0.0}, energy{0.0};   ///< N, J
  double pressure{0.0};             ///< Pa, infinite: no contact area is certain; 0: excluded
  /// The larger one of the shares of force and pressure. Infinite where contact is excluded, and for a part
  /// that is not seen, which has no region.
  double share{0.0};
};

/// Step of the numbers of a contact in files: N, J, N/cm^2 and share. A power of two, so that they are exact.
inline constexpr double kContactStep = 1.0 / 16384.0;
/// N, J and N/cm^2: larger ones are stored as this, and such a pressure is read as infinite. Shares from
/// kInfiniteShare on are read as infinite.
inline constexpr double kMaxContact = 1e5, kInfiniteShare = 1e4;
inline constexpr double kPerSquareCentimetre = 1e-4;  ///< N/cm^2 of 1 Pa

/// The contact as a file keeps it: rounded up to whole steps.
FrameContact roundedUp(const FrameContact& contact);

/// A predicted contact and its time.
struct ContactMoment {
  double t{0.0};  ///< s
  FrameContact contact;
};

/// Predicted contacts of a part over a recording.
struct PartContacts {
  /// s, from each frame whose contact would exceed a limit, or is excluded or unknown, to the next one.
  double exceeded{0.0};
  /// With the largest share, of equal ones the one with the largest force; empty if nothing near ever closed
  /// in.
  std::optional<ContactMoment> worst;
};

/// Whether `a` is judged harder than `b`.
inline bool isHarder(const FrameContact& a, const FrameContact& b) {
  return a.share > b.share || (a.share == b.share && a.force > b.force);
}

}  // namespace abstand::tune
