#include "ui/panels/recording_panel.hpp"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/style/clock_text.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

/// Adds the rows of one recording.
class CardRows {
 public:
  CardRows(QTreeWidget* tree, const view::RecordingCard& card)
      : parent_{new QTreeWidgetItem(tree, {text(card.person), QFileInfo(text(card.file)).fileName()})} {
    QFont bold = parent_->font(0);
    bold.setBold(true);
    parent_->setFont(0, bold);
    parent_->setFont(1, bold);
    parent_->setToolTip(1, QDir::toNativeSeparators(text(card.file)));
  }

  QTreeWidgetItem* add(const QString& what, const QString& value, const QString& why = {}) {
    auto* row = new QTreeWidgetItem(parent_, {what, value, why});
    for (const int column : {1, 2}) row->setToolTip(column, row->text(column));
    return row;
  }

  void add(const QString& what, const view::ReadValue& read) {
    QTreeWidgetItem* row =
        add(what, read.guessed ? RecordingPanel::tr("%1 (guessed)").arg(text(read.value)) : text(read.value),
            text(read.reason));
    if (read.guessed) row->setForeground(1, QColor(kVermillion));
  }

  void warn(const QString& value) {
    add(RecordingPanel::tr("Warning"), value)->setForeground(1, QColor(kVermillion));
  }

 private:
  QTreeWidgetItem* parent_;
};

void addRows(QTreeWidget* tree, const view::RecordingCard& card) {
  CardRows rows(tree, card);
  rows.add(RecordingPanel::tr("Format"), text(card.format));
  rows.add(RecordingPanel::tr("Length"),
           RecordingPanel::tr("%1 s, %n frames", nullptr, static_cast<int>(card.frames))
               .arg(fixed(card.duration, 2)));
  rows.add(RecordingPanel::tr("Rate"),
           card.rate > 0.0 ? RecordingPanel::tr("%1 Hz").arg(QLocale().toString(card.rate, 'g', 5))
                           : RecordingPanel::tr("not known"),
           text(card.rate_reason));
  if (std::isfinite(card.clock_start)) rows.add(RecordingPanel::tr("Recorded"), dateText(card.clock_start));
  rows.add(RecordingPanel::tr("Units"), card.units);
  rows.add(RecordingPanel::tr("Vertical axis"), card.up);
  rows.add(RecordingPanel::tr("Left and right"), card.sides);
  rows.add(RecordingPanel::tr("Stature"),
           card.stature > 0.0 ? RecordingPanel::tr("%1 m").arg(fixed(card.stature, 3))
                              : RecordingPanel::tr("not known"),
           text(card.stature_reason));
  if (!card.joint_map.value.empty()) rows.add(RecordingPanel::tr("Joint map"), card.joint_map);
  rows.add(RecordingPanel::tr("Moved parts"), QString::number(card.moved_parts));
  if (!card.missing_parts.empty()) {
    QStringList parts;
    for (const std::string& part : card.missing_parts) parts << text(part);
    rows.warn(RecordingPanel::tr("nothing moves %1").arg(parts.join(QStringLiteral(", "))));
  }
  if (card.frames_missing > 0)
    rows.warn(RecordingPanel::tr("cut: %n frames at least are missing or not complete", nullptr,
                                 static_cast<int>(card.frames_missing)));
  if (card.gaps > 0)
    rows.add(RecordingPanel::tr("Gaps"),
             RecordingPanel::tr("%n frames lack a joint", nullptr, static_cast<int>(card.gaps)));
  for (const std::string& note : card.notes) rows.add(RecordingPanel::tr("Note"), text(note));
  for (const std::string& warning : card.warnings) rows.warn(text(warning));
}

}  // namespace

RecordingPanel::RecordingPanel(QAction* options, QWidget* parent)
    : QWidget(parent),
      choice_row_{new QWidget(this)},
      choice_{new QComboBox(choice_row_)},
      tree_{new QTreeWidget(this)} {
  auto* label = new QLabel(tr("Shown recording"), choice_row_);
  label->setBuddy(choice_);
  choice_->setObjectName(QStringLiteral("recording_choice"));
  choice_->setAccessibleName(tr("Shown recording"));
  choice_->setToolTip(tr("Of the recordings that were opened together; margins, view and selection stay"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* row = new QHBoxLayout(choice_row_);
  row->setContentsMargins(8, 5, 8, 3);
  row->addWidget(label);
  row->addWidget(choice_, 1);
  choice_row_->hide();
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int i) { Q_EMIT wanted(choice_->itemData(i).toString()); });
  tree_->setAccessibleName(tr("Recordings"));
  tree_->setHeaderLabels({tr("Property"), tr("Read as"), tr("Reason")});
  tree_->setRootIsDecorated(false);
  tree_->setAllColumnsShowFocus(true);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  auto* change = new QToolButton(this);
  change->setDefaultAction(options);
  change->setToolButtonStyle(Qt::ToolButtonTextOnly);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 6);
  layout->addWidget(choice_row_);
  layout->addWidget(tree_, 1);
  layout->addWidget(change, 0, Qt::AlignRight);
}

void RecordingPanel::showChoice(const QStringList& files, const QString& shown) {
  choice_->clear();
  for (const QString& file : files) {
    choice_->addItem(QFileInfo(file).fileName(), file);
    choice_->setItemData(choice_->count() - 1, QDir::toNativeSeparators(file), Qt::ToolTipRole);
  }
  choice_->setCurrentIndex(files.indexOf(shown));
  choice_row_->setVisible(files.size() > 1);
}

void RecordingPanel::open(const std::vector<view::RecordingCard>& cards) {
  tree_->clear();
  for (const view::RecordingCard& card : cards) addRows(tree_, card);
  if (cards.empty())
    new QTreeWidgetItem(tree_, {tr("No recording"), tr("The people of this scene stand still")});
  tree_->expandAll();
}

}  // namespace abstand::ui
