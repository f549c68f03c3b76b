// The table of pairs with its filter.
#include "ui/panels/pair_panel.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/selection.hpp"
#include "ui/panels/title_width.hpp"

namespace abstand::ui {

namespace {
constexpr int kColumnWidth = 76;  // px, at least
constexpr int kStateSpace = 24;   // px, about the text of a state
constexpr int kAllClasses = -1;
constexpr int kRoomForPoints = 860, kRoomForForce = 760;  // px, of the panel
}  // namespace

PairPanel::PairPanel(Selection& selection, QWidget* parent)
    : QWidget(parent),
      selection_{selection},
      model_{new PairTableModel(this)},
      filter_{new PairFilter(this)},
      filter_box_{new QLineEdit(this)},
      class_box_{new QComboBox(this)},
      all_{new QToolButton(this)},
      count_{new QLabel(this)},
      table_{new QTableView(this)} {
  filter_->setSourceModel(model_);
  filter_box_->setPlaceholderText(tr("Filter by name"));
  filter_box_->setClearButtonEnabled(true);
  filter_box_->setAccessibleName(tr("Filter pairs by name"));
  filter_box_->setMaximumWidth(240);
  class_box_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  class_box_->setAccessibleName(tr("Class of pairs"));
  class_box_->setToolTip(tr("Whom the listed distances are about"));
  all_->setText(tr("Only the selection  ✕"));
  all_->setToolTip(tr("Show all pairs again (Esc)"));
  all_->hide();
  count_->setForegroundRole(QPalette::PlaceholderText);

  table_->setModel(filter_);
  table_->setAccessibleName(tr("Pairs"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  // Beginning and end of a name tell bodies apart.
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setDragEnabled(true);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PairTableModel::kDistance, Qt::AscendingOrder);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(kColumnWidth);
  header->setSectionResizeMode(QHeaderView::Interactive);
  for (const int names : {PairTableModel::kA, PairTableModel::kB})
    header->setSectionResizeMode(names, QHeaderView::Stretch);
  const int state_width = table_->fontMetrics().horizontalAdvance(tr("⚠ inside margin")) + kStateSpace;
  for (const auto& [column, width] : {std::pair{+PairTableModel::kState, state_width},
                                      {+PairTableModel::kDistance, 112},
                                      {+PairTableModel::kUncertainty, 132},
                                      {+PairTableModel::kMargin, 100},
                                      {+PairTableModel::kForce, 92},
                                      {+PairTableModel::kPoints, 92}})
    header->resizeSection(column, width);
  fitTitles(*header);

  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 5, 8, 3);
  head->addWidget(filter_box_, 1);
  head->addWidget(class_box_);
  head->addWidget(all_);
  head->addStretch();
  head->addWidget(count_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(table_, 1);

  connect(filter_box_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setText(text);
    showCount();
  });
  connect(class_box_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    wanted_ = class_box_->itemData(index).toInt();
    showClass();
  });
  connect(all_, &QToolButton::clicked, &selection_, &Selection::clear);
  connect(&selection_, &Selection::changed, this, &PairPanel::followSelection);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PairPanel::chooseCurrent);
}

/// The names need the room: the inspector has what a narrow table leaves out.
void PairPanel::resizeEvent(QResizeEvent* event) {
  table_->setColumnHidden(PairTableModel::kPoints, width() < kRoomForPoints);
  table_->setColumnHidden(PairTableModel::kForce, width() < kRoomForForce);
  QWidget::resizeEvent(event);
}

void PairPanel::open(const view::SceneOutline& outline) {
  model_->open(outline);
  filter_->setObjects({});
  class_box_->clear();
  class_box_->addItem(tr("All pairs"), kAllClasses);
  for (int i = 0; i < kPairClasses; ++i) {
    const auto of = static_cast<PairClass>(i);
    const bool has = std::any_of(outline.pairs.begin(), outline.pairs.end(),
                                 [&](const auto& pair) { return pairClassOf(outline, pair) == of; });
    if (has) class_box_->addItem(pairClassName(of), i);
  }
  class_box_->setCurrentIndex(std::max(0, class_box_->findData(wanted_)));
  showClass();
}

void PairPanel::showClass() {
  const int of = class_box_->currentData().toInt();
  filter_->setClass(of == kAllClasses ? std::nullopt : std::optional(static_cast<PairClass>(of)));
  showCount();
}

void PairPanel::refresh(const view::SceneSnapshot& snapshot) {
  model_->refresh(snapshot);
  if (!isVisible()) return;
  const int height = table_->viewport()->height();
  for (int row = std::max(0, table_->rowAt(0)); row < filter_->rowCount(); ++row) {
    if (table_->rowViewportPosition(row) >= height) break;
    model_->announce(filter_->mapToSource(filter_->index(row, 0)).row());
  }
}

void PairPanel::chooseCurrent() {
  if (choosing_) return;
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return;
  const int pair = filter_->mapToSource(rows.front()).row();
  const auto [a, b] = model_->objectsOf(pair);
  const QScopedValueRollback guard(choosing_, true);
  selection_.setPair(pair, a, b);
}

void PairPanel::followSelection() {
  // A pair chosen in the table itself must not make the other rows go away.
  if (!choosing_) {
    const QScopedValueRollback guard(choosing_, true);
    filter_->setObjects(selection_.pair() < 0 ? selection_.objects() : std::vector<int>{});
    if (selection_.pair() < 0)
      table_->clearSelection();
    else
      table_->selectRow(filter_->mapFromSource(model_->index(selection_.pair(), 0)).row());
  }
  all_->setVisible(selection_.pair() < 0 && !selection_.objects().empty());
  showCount();
}

void PairPanel::showCount() {
  count_->setText(tr("%1 of %2 pairs").arg(filter_->rowCount()).arg(model_->rowCount()));
}

}  // namespace abstand::ui
