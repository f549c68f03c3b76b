#include "ui/panels/title_width.hpp"

#include <QHeaderView>
#include <algorithm>

namespace abstand::ui {

namespace {
constexpr int kTitleSpace = 14;  // px, of the theme: padding and line
}

void fitTitles(QHeaderView& header) {
  for (int column = 0; column < header.count(); ++column) {
    if (header.sectionResizeMode(column) != QHeaderView::Interactive) continue;
    const QString title = header.model()->headerData(column, header.orientation()).toString();
    const int width = header.fontMetrics().horizontalAdvance(title) + kTitleSpace;
    header.resizeSection(column, std::max(header.sectionSize(column), width));
  }
}

}  // namespace abstand::ui
