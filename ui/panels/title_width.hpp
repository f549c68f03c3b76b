// Columns of tables that show their titles in every language.
#pragma once

class QHeaderView;

namespace abstand::ui {

/// Widens each column that has a width of its own and is narrower than its title.
void fitTitles(QHeaderView& header);

}  // namespace abstand::ui
