// Reads recordings for the import dialog.
#pragma once

#include "ui/model/import_probe.hpp"

namespace abstand::studio {

/// Never throws: what cannot be read is the problem of the answer. Any thread.
ui::ImportFound readForImport(const QString& file, const ui::ImportWish& wish);

}  // namespace abstand::studio
