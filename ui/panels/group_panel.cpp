// Groups of pairs: run, pause and stop them, and take single pairs out and back in.
#include "ui/panels/group_panel.hpp"
#include "ui/style/tr.hpp"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace abstand::ui {

namespace {

constexpr int kNameColumn = 0, kPairsColumn = 1, kStateColumn = 2;
// What an item stands for: a group (its number, -1: the row of those in none) or a pair.
constexpr int kGroupRole = Qt::UserRole;
constexpr int kPairRole = Qt::UserRole + 1;
constexpr int kNoGroup = -1;

QString stateName(view::PairGroupState state) {
  switch (state) {
    case view::PairGroupState::kRunning:
      return tr("running");
    case view::PairGroupState::kPaused:
      return tr("paused: stale");
    case view::PairGroupState::kStopped:
      return tr("stopped: stale");
  }
  return {};
}

}  // namespace

GroupPanel::GroupPanel(QWidget* parent)
    : QWidget(parent),
      head_{new QLabel(this)},
      tree_{new QTreeWidget(this)},
      run_{new QPushButton(tr("R&un"), this)},
      pause_{new QPushButton(tr("Pau&se"), this)},
      stop_{new QPushButton(tr("S&top"), this)},
      remove_{new QPushButton(tr("Remo&ve pair"), this)},
      add_{new QPushButton(tr("A&dd pair to"), this)} {
  head_->setObjectName(QStringLiteral("groups_head"));
  head_->setWordWrap(true);
  tree_->setColumnCount(3);
  tree_->setHeaderLabels({tr("Group"), tr("Pairs"), tr("State")});
  tree_->setAccessibleName(tr("Groups of pairs"));
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setUniformRowHeights(true);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(kPairsColumn, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(kStateColumn, QHeaderView::ResizeToContents);
  tree_->header()->setStretchLastSection(false);
  run_->setObjectName(QStringLiteral("groups_run"));
  pause_->setObjectName(QStringLiteral("groups_pause"));
  stop_->setObjectName(QStringLiteral("groups_stop"));
  remove_->setObjectName(QStringLiteral("groups_remove"));
  add_->setObjectName(QStringLiteral("groups_add"));
  run_->setToolTip(tr("Check the pairs of the selected groups in every cycle"));
  pause_->setToolTip(tr("Check them no more until they run again; robots with such pairs stop"));
  stop_->setToolTip(tr("The same, said to be for good"));
  remove_->setToolTip(tr("Take the selected pairs out of their groups"));
  add_->setToolTip(tr("Put the selected pairs, which are in no group, into a group"));
  add_->setMenu(new QMenu(add_));

  // Two rows, so that the panel may be narrow.
  auto* buttons = new QGridLayout;
  buttons->setContentsMargins(8, 3, 8, 6);
  int place = 0;
  for (QPushButton* button : {run_, pause_, stop_, remove_, add_}) {
    button->setFocusPolicy(Qt::TabFocus);
    buttons->addWidget(button, place / 3, place % 3);
    ++place;
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(head_);
  layout->addWidget(tree_, 1);
  layout->addLayout(buttons);
  head_->setContentsMargins(8, 2, 8, 2);

  connect(run_, &QPushButton::clicked, this, [this] { order(view::PairGroupState::kRunning); });
  connect(pause_, &QPushButton::clicked, this, [this] { order(view::PairGroupState::kPaused); });
  connect(stop_, &QPushButton::clicked, this, [this] { order(view::PairGroupState::kStopped); });
  connect(remove_, &QPushButton::clicked, this, &GroupPanel::removeSelected);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, &GroupPanel::enableButtons);
  open({});
}

void GroupPanel::open(const view::SceneOutline& outline) {
  groups_.clear();
  pairs_.clear();
  shown_group_.clear();
  tree_->clear();
  add_->menu()->clear();
  for (const std::string& name : outline.pair_groups) {
    const int group = static_cast<int>(groups_.size());
    groups_.push_back(QString::fromStdString(name));
    connect(add_->menu()->addAction(groups_.back()), &QAction::triggered, this, [this, group] {
      for (const QTreeWidgetItem* item : tree_->selectedItems())
        if (item->data(0, kPairRole).isValid()) Q_EMIT addWanted(group, item->data(0, kPairRole).toInt());
    });
  }
  for (const auto& [a, b] : outline.pairs)
    pairs_.push_back(
        tr("%1 – %2").arg(QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
                          QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name)));
  head_->setText(groups_.empty() ? tr("No pairs are checked.") : QString());
  enableButtons();
}

/// Anew, with the groups that were open and the pairs that were selected.
void GroupPanel::fill(const view::SceneSnapshot& snapshot) {
  std::vector<bool> open(groups_.size() + 1), chosen(pairs_.size());
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem* item = tree_->topLevelItem(i);
    open[static_cast<std::size_t>(item->data(0, kGroupRole).toInt() + 1)] = item->isExpanded();
  }
  for (const QTreeWidgetItem* item : tree_->selectedItems())
    if (item->data(0, kPairRole).isValid())
      chosen[static_cast<std::size_t>(item->data(0, kPairRole).toInt())] = true;
  tree_->clear();
  shown_group_ = snapshot.pair_group;
  const auto none = std::count(shown_group_.begin(), shown_group_.end(), kNoGroup);
  std::vector<QTreeWidgetItem*> rows(groups_.size() + 1, nullptr);
  for (int group = kNoGroup; group < static_cast<int>(groups_.size()); ++group) {
    if (group == kNoGroup && none == 0) continue;
    auto* item = new QTreeWidgetItem(tree_);
    item->setText(kNameColumn,
                  group == kNoGroup ? tr("In no group") : groups_[static_cast<std::size_t>(group)]);
    item->setData(0, kGroupRole, group);
    rows[static_cast<std::size_t>(group + 1)] = item;
  }
  for (std::size_t p = 0; p < shown_group_.size(); ++p) {
    auto* item = new QTreeWidgetItem(rows[static_cast<std::size_t>(shown_group_[p] + 1)]);
    item->setText(kNameColumn, pairs_[p]);
    item->setData(0, kPairRole, static_cast<int>(p));
    item->setSelected(chosen[p]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i]) rows[i]->setExpanded(open[i]);
}

void GroupPanel::refresh(const view::SceneSnapshot& snapshot) {
  if (snapshot.groups.size() != groups_.size() || snapshot.pair_group.size() != pairs_.size()) return;
  if (snapshot.pair_group != shown_group_) fill(snapshot);
  std::size_t stale = 0;
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = tree_->topLevelItem(i);
    const int group = item->data(0, kGroupRole).toInt();
    item->setText(kPairsColumn, QString::number(item->childCount()));
    const bool runs = group != kNoGroup && snapshot.groups[static_cast<std::size_t>(group)].state ==
                                               view::PairGroupState::kRunning;
    if (!runs) stale += static_cast<std::size_t>(item->childCount());
    item->setText(kStateColumn, group == kNoGroup
                                    ? tr("removed: stale")
                                    : stateName(snapshot.groups[static_cast<std::size_t>(group)].state));
  }
  head_->setText(
      stale == 0
          ? tr("All %1 pairs are checked.").arg(pairs_.size())
          : tr("⚠ %1 of %2 pairs are not checked: their distances are stale.").arg(stale).arg(pairs_.size()));
  enableButtons();
}

void GroupPanel::order(view::PairGroupState state) {
  for (const QTreeWidgetItem* item : tree_->selectedItems()) {
    const QVariant group = item->data(0, kGroupRole);
    if (group.isValid() && group.toInt() != kNoGroup) Q_EMIT stateWanted(group.toInt(), state);
  }
}

void GroupPanel::removeSelected() {
  for (const QTreeWidgetItem* item : tree_->selectedItems())
    if (item->data(0, kPairRole).isValid()) Q_EMIT removeWanted(item->data(0, kPairRole).toInt());
}

void GroupPanel::enableButtons() {
  bool groups = false, grouped = false, free = false;
  for (const QTreeWidgetItem* item : tree_->selectedItems()) {
    const QVariant pair = item->data(0, kPairRole);
    if (!pair.isValid()) {
      groups |= item->data(0, kGroupRole).toInt() != kNoGroup;
    } else {
      const bool in_group = shown_group_[static_cast<std::size_t>(pair.toInt())] != kNoGroup;
      (in_group ? grouped : free) = true;
    }
  }
  for (QPushButton* button : {run_, pause_, stop_}) button->setEnabled(groups);
  remove_->setEnabled(grouped);
  add_->setEnabled(free);
}

}  // namespace abstand::ui
