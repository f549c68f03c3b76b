// The list of bookmarks.
#include "ui/panels/bookmark_panel.hpp"

#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/bookmark_table.hpp"

namespace abstand::ui {

BookmarkPanel::BookmarkPanel(QWidget* parent)
    : QWidget(parent),
      bookmarks_{new BookmarkTable(this)},
      table_{new QTableView(this)},
      remove_{new QPushButton(tr("Remove"), this)} {
  table_->setModel(bookmarks_);
  table_->setAccessibleName(tr("Bookmarks"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  remove_->setToolTip(tr("Remove the chosen bookmark"));
  remove_->setEnabled(false);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->addWidget(table_, 1);
  layout->addWidget(remove_, 0, Qt::AlignRight);

  connect(table_, &QTableView::clicked, this,
          [this](const QModelIndex& index) { Q_EMIT picked(index.row()); });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { remove_->setEnabled(table_->selectionModel()->hasSelection()); });
  connect(bookmarks_, &BookmarkTable::noteWanted, this, &BookmarkPanel::noteWanted);
  connect(bookmarks_, &QAbstractItemModel::modelReset, this, [this] { remove_->setEnabled(false); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    const QModelIndexList rows = table_->selectionModel()->selectedRows();
    if (!rows.isEmpty()) Q_EMIT removeWanted(rows.front().row());
  });
}

void BookmarkPanel::show(const QVector<Bookmark>& bookmarks) { bookmarks_->show(bookmarks); }

}  // namespace abstand::ui
