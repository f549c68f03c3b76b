// What the inspector says of its subject, as rows of text.
#pragma once

#include <QString>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/inspected_subject.hpp"

namespace abstand::ui {

struct InspectedRow {
  enum class Mark { kPlain, kHeading, kAlarm };
  QString name, value;
  Mark mark{Mark::kPlain};
  bool operator==(const InspectedRow&) const = default;
};

/// All values are those of the one moment `snapshot`, and constants of the outline.
std::vector<InspectedRow> inspectedRows(const view::SceneOutline& outline,
                                        const view::SceneSnapshot& snapshot, const InspectedSubject& subject);

}  // namespace abstand::ui
