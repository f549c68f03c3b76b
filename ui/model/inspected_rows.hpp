// What the inspector says of its subject, as rows of text.
#pragma once

#include <QString>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/inspected_subject.hpp"

namespace abstand::ui {

struct InspectedRow {
  /// kAlarm: touching, or a pose that is lost; kInside: inside a margin.
  enum class Mark { kPlain, kHeading, kInside, kAlarm };
  QString name, value;
  Mark mark{Mark::kPlain};
  bool operator==(const InspectedRow&) const = default;
};

/// All values are those of the one moment `snapshot`, and constants of the outline.
std::vector<InspectedRow> inspectedRows(const view::SceneOutline& outline,
                                        const view::SceneSnapshot& snapshot, const InspectedSubject& subject);

}  // namespace abstand::ui
