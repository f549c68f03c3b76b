// Safety margins by group.
#include "ui/panels/margin_panel.hpp"

#include <QFrame>
#include <QLabel>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/model/groups.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/panels/class_margin_row.hpp"
#include "ui/panels/margin_row.hpp"

namespace abstand::ui {

namespace {

/// Below what `content` has so far.
QWidget* lineBelow(QWidget* content) {
  auto* line = new QFrame(content);
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Plain);
  line->setForegroundRole(QPalette::Mid);
  line->setContentsMargins(0, 4, 0, 4);
  content->layout()->addWidget(line);
  return line;
}

}  // namespace

MarginPanel::MarginPanel(QWidget* parent) : QScrollArea(parent), gather_{new QTimer(this)} {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAccessibleName(tr("Safety margins"));
  gather_->setSingleShot(true);
  connect(gather_, &QTimer::timeout, this, &MarginPanel::send);
}

void MarginPanel::open(const view::SceneOutline& outline, const std::vector<double>& margins) {
  gather_->stop();
  waiting_.clear();
  held_ = false;
  group_rows_.clear();
  masters_.clear();
  rows_.assign(outline.objects.size(), nullptr);
  names_.clear();
  for (const auto& object : outline.objects) names_.push_back(QString::fromStdString(object.name));

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  addClasses(outline, content);
  for (const Group& group : groupsOf(outline)) {
    const QString name = QString::fromStdString(group.name);
    auto* master = new MarginRow(groupTitle(group), true, content);
    layout->addWidget(master);
    for (const int object : group.objects) {
      const auto i = static_cast<std::size_t>(object);
      auto* row = new MarginRow(QString::fromStdString(shortName(outline.objects[i])), false, content);
      rows_[i] = row;
      layout->addWidget(row);
      connectRow(row, {object});
    }
    connectRow(master, group.objects);
    group_rows_[name] = master;
    masters_.push_back({master, group.objects, lineBelow(content), groupTitle(group)});
  }
  layout->addStretch();
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
  show(margins);
  setFilter(filter_);
}

/// A row for each class that the scene has pairs of.
void MarginPanel::addClasses(const view::SceneOutline& outline, QWidget* content) {
  classes_ = {};
  for (const auto& pair : outline.pairs)
    if (const PairClass of = pairClassOf(outline, pair); of != PairClass::kOther)
      classes_.pairs[of].push_back(pair);
  if (classes_.pairs.empty()) return;
  auto* title = new QLabel(tr("Classes of pairs"), content);
  title->setObjectName(QStringLiteral("pair_classes"));
  title->setToolTip(
      tr("A ticked class has one margin for all of its pairs, instead of the sums of two bodies' margins"));
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  content->layout()->addWidget(title);
  classes_.title = title;
  for (const auto& entry : classes_.pairs) {
    auto* row = new ClassMarginRow(pairClassName(entry.first), content);
    classes_.rows[entry.first] = row;
    content->layout()->addWidget(row);
    connectClass(entry.first, row);
  }
  int widest = 0;
  for (const auto& entry : classes_.rows) widest = std::max(widest, entry.second->nameWidth());
  for (const auto& entry : classes_.rows) entry.second->setNameWidth(widest);
  classes_.line = lineBelow(content);
}

void MarginPanel::connectClass(PairClass pair_class, ClassMarginRow* row) {
  connect(row, &ClassMarginRow::tickWanted, this,
          [this, pair_class](bool on) { Q_EMIT classTicked(pair_class, on); });
  connect(row, &ClassMarginRow::lockWanted, this,
          [this, pair_class](bool locked) { Q_EMIT classLockWanted(pair_class, locked); });
  connect(row, &ClassMarginRow::edited, this, [this, pair_class, row](double metres) {
    Q_EMIT classMarginChanged(pair_class, metres);
    if (!row->isDragged()) Q_EMIT editFinished();
  });
  connect(row, &ClassMarginRow::released, this, &MarginPanel::editFinished);
}

void MarginPanel::showClass(PairClass pair_class, const std::optional<double>& metres, bool locked) {
  ClassMarginRow* row = classRow(pair_class);
  if (!row) return;
  row->show(metres, locked);
  if (!metres) row->showSum(largestSum(pair_class));
}

ClassMarginRow* MarginPanel::classRow(PairClass pair_class) const {
  const auto found = classes_.rows.find(pair_class);
  return found == classes_.rows.end() ? nullptr : found->second;
}

double MarginPanel::largestSum(PairClass pair_class) const {
  double largest = 0.0;
  const auto found = classes_.pairs.find(pair_class);
  if (found == classes_.pairs.end()) return largest;
  for (const auto& [a, b] : found->second) largest = std::max(largest, row(a)->metres() + row(b)->metres());
  return largest;
}

/// Of classes without a margin of their own.
void MarginPanel::showSums() {
  for (const auto& [pair_class, row] : classes_.rows)
    if (!row->isTicked()) row->showSum(largestSum(pair_class));
}

void MarginPanel::connectRow(MarginRow* row, const std::vector<int>& objects) {
  connect(row, &MarginRow::edited, this, [this, objects](double metres) {
    for (const int object : objects) {
      MarginRow* member = rows_[static_cast<std::size_t>(object)];
      if (member->locked() || member->isHidden()) continue;
      member->show(metres);
      change(object, metres);
    }
  });
  connect(row, &MarginRow::lockWanted, this, [this, objects](bool locked) {
    std::vector<int> shown;
    for (const int object : objects)
      if (!rows_[static_cast<std::size_t>(object)]->isHidden()) shown.push_back(object);
    Q_EMIT lockWanted(shown, locked);
  });
  connect(row, &MarginRow::released, this, [this] {
    gather_->stop();
    send();
  });
}

void MarginPanel::show(const std::vector<double>& margins) {
  // A row that shows its margin already may be in the middle of an edit.
  const auto set = [](MarginRow* row, double metres) {
    if (row->metres() != metres) row->show(metres);
  };
  for (std::size_t i = 0; i < std::min(rows_.size(), margins.size()); ++i) set(rows_[i], margins[i]);
  for (const Master& master : masters_) {
    double largest = 0.0;
    for (const int object : master.objects)
      largest = std::max(largest, rows_[static_cast<std::size_t>(object)]->metres());
    set(master.row, largest);
  }
  showSums();
}

void MarginPanel::showLocked(const std::vector<bool>& locked) {
  for (std::size_t i = 0; i < std::min(rows_.size(), locked.size()); ++i) rows_[i]->setLocked(locked[i]);
  showMasterLocks();
}

/// The row of a group is locked where all of its rows are that are shown.
void MarginPanel::showMasterLocks() {
  for (const Master& master : masters_)
    master.row->setLocked(std::all_of(master.objects.begin(), master.objects.end(), [this](int object) {
      const MarginRow* row = rows_[static_cast<std::size_t>(object)];
      return row->isHidden() || row->locked();
    }));
}

void MarginPanel::setFilter(const QString& text) {
  filter_ = text.trimmed();
  for (const Master& master : masters_) {
    const bool whole = master.name.contains(filter_, Qt::CaseInsensitive);
    bool any = false;
    for (const int object : master.objects) {
      const auto i = static_cast<std::size_t>(object);
      const bool shown = whole || names_[i].contains(filter_, Qt::CaseInsensitive);
      rows_[i]->setVisible(shown);
      any |= shown;
    }
    master.row->setVisible(any);
    master.line->setVisible(any);
  }
  bool any_class = false;
  for (const auto& [pair_class, row] : classes_.rows) {
    const bool shown = pairClassName(pair_class).contains(filter_, Qt::CaseInsensitive);
    row->setVisible(shown);
    any_class |= shown;
  }
  if (classes_.title) {
    classes_.title->setVisible(any_class);
    classes_.line->setVisible(any_class);
  }
  showMasterLocks();
}

void MarginPanel::setSelected(const std::vector<int>& objects) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i]->setMarked(std::binary_search(objects.begin(), objects.end(), static_cast<int>(i)));
  MarginRow* first = objects.empty() ? nullptr : row(objects.front());
  if (first && !first->isHidden()) ensureWidgetVisible(first);
}

MarginRow* MarginPanel::row(int object) const {
  return object >= 0 && static_cast<std::size_t>(object) < rows_.size()
             ? rows_[static_cast<std::size_t>(object)]
             : nullptr;
}

MarginRow* MarginPanel::groupRow(const QString& group) const {
  const auto found = group_rows_.find(group);
  return found == group_rows_.end() ? nullptr : found->second;
}

void MarginPanel::change(int object, double metres) {
  waiting_[object] = metres;
  if (gather_->isActive()) return;
  const qint64 rest = sent_.isValid() ? kGatherMs - sent_.elapsed() : 0;
  gather_->start(static_cast<int>(std::max<qint64>(0, rest)));
}

void MarginPanel::hold(int object, double metres) {
  MarginRow* held = row(object);
  if (!held || held->locked()) return;
  held_ = true;
  if (held->metres() == metres) return;
  held->show(metres);
  change(object, metres);
}

void MarginPanel::release() {
  if (!std::exchange(held_, false)) return;
  gather_->stop();
  send();
}

bool MarginPanel::isDragged() const {
  if (held_) return true;
  if (std::any_of(classes_.rows.begin(), classes_.rows.end(),
                  [](const auto& entry) { return entry.second->isDragged(); }))
    return true;
  const auto dragged = [](const MarginRow* row) { return row->isDragged(); };
  return std::any_of(rows_.begin(), rows_.end(), dragged) ||
         std::any_of(masters_.begin(), masters_.end(),
                     [&](const Master& master) { return dragged(master.row); });
}

void MarginPanel::send() {
  const QMap<int, double> margins = std::exchange(waiting_, {});
  sent_.start();
  if (!margins.isEmpty()) Q_EMIT marginsChanged(margins);
  if (!isDragged()) Q_EMIT editFinished();
}

}  // namespace abstand::ui
