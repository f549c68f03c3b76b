// Speed and separation, and predicted contact, of each body part at one moment.
#pragma once

#include <QString>
#include <vector>

#include "core/contact/contact_limits.hpp"
#include "core/contact/predicted_contact.hpp"
#include "core/view/snapshot.hpp"
#include "ui/model/separation_settings.hpp"

namespace abstand::ui {

/// In the order of their weight.
enum class SeparationState : std::uint8_t {
  kKept,        ///< the certified clearance is at least the protective distance
  kNoApproach,  ///< it is not, but the link does not move towards the part
  kNotKept,     ///< it is not
  kUnknown,     ///< the part was not seen, or no pair of it is checked
};

enum class ContactState : std::uint8_t {
  kNoImpact,   ///< they do not move towards each other
  kBelowHalf,  ///< less than half of the limit
  kBelow,      ///< up to the limit
  kAbove,      ///< above the limit, or contact is excluded
  kUnknown,
};

struct SeparationRow {
  int part{-1}, link{-1}, pair{-1};            ///< of the outline; -1: no pair of the part is known
  double clearance{-kInfinity};                ///< m, certified
  double robot_speed{0.0}, person_speed{0.0};  ///< m/s, towards each other
  safety::ProtectiveDistance needed;
  double permitted_speed{0.0};  ///< m/s, of the robot towards the part at this clearance
  SeparationState state{SeparationState::kUnknown};
  contact::RegionContact contact;  ///< its region is null without a table
  ContactState contact_state{ContactState::kUnknown};
};

/// One row for each body part, of the link whose protective distance lacks most; in the order of the outline.
/// `limits`: null for none; the rows point into it.
std::vector<SeparationRow> separationRows(const view::SceneOutline& outline,
                                          const view::SceneSnapshot& snapshot,
                                          const SeparationSettings& settings,
                                          const contact::ContactLimits* limits);

/// All terms with their sources, in lines.
QString separationTip(const view::SceneOutline& outline, const SeparationRow& row,
                      const SeparationSettings& settings);
/// "clear by 212 mm", "lacks 80 mm".
QString separationText(const SeparationRow& row);
/// "120 of 280 N", "excluded".
QString contactText(const SeparationRow& row);

}  // namespace abstand::ui
