#include "ui/panels/title_width.hpp"

#include <QHeaderView>
#include <algorithm>

namespace abstand::ui {

namespace {
constexpr int kSortMark = 14;    // px
constexpr int kTitleSpace = 14;  // px, of the theme: padding and line
}  // namespace

void fitTitles(QHeaderView& header) {
  for (int column = 0; column < header.count(); ++column) {
    if (header.sectionResizeMode(column) != QHeaderView::Interactive) continue;
    // The mark of the sorted column stands before a title on the right.
    const bool sorts = header.isSortIndicatorShown() && column == header.sortIndicatorSection();
    const QString title = header.model()->headerData(column, header.orientation()).toString();
    const int width = header.fontMetrics().horizontalAdvance(title) + kTitleSpace + (sorts ? kSortMark : 0);
    header.resizeSection(column, std::max(header.sectionSize(column), width));
  }
}

}  // namespace abstand::ui
