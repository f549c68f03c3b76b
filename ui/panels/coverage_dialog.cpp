#include "ui/panels/coverage_dialog.hpp"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/coverage_text.hpp"
#include "ui/panels/coverage_strip.hpp"
#include "ui/panels/sensor_editor.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr int kPartColumn = 0, kSeenColumn = 1, kStrip = 2, kLongest = 3, kFirstCause = 4,
              kCoverageColumns = kFirstCause + kHiddenByCount - 1;
constexpr int kSwatch = 10;                             // px
constexpr int kStripWidth = 170;                        // px, at least
constexpr int kRowHeight = 21;                          // px
constexpr int kDialogWidth = 760, kDialogHeight = 560;  // px
constexpr int kLowHeight = 440, kHighWindow = 1000;     // px: in a lower window the 3D view stays visible

QIcon swatch(const QColor& colour) {
  QPixmap square(kSwatch, kSwatch);
  square.fill(colour);
  return QIcon(square);
}

QString coverageOutcome(const CoverageReport& report) {
  const CoveragePart *worst = nullptr, *longest = nullptr;
  const auto longestOf = [](const CoveragePart& part) {
    if (part.longest < 0) return 0.0;
    const CoverageSpan& span = part.spans[static_cast<std::size_t>(part.longest)];
    return span.to - span.from;
  };
  for (const CoveragePart& part : report.parts) {
    if (!worst || part.times[0] < worst->times[0]) worst = &part;
    if (part.longest >= 0 && (!longest || longestOf(part) > longestOf(*longest))) longest = &part;
  }
  if (!worst) return {};
  QString text = worst->times[0] >= 1.0 ? CoverageDialog::tr("Every part is seen at all times.")
                                        : CoverageDialog::tr("Least seen: %1, %2 % of the time.")
                                              .arg(worst->name, fixed(100.0 * worst->times[0], 1));
  if (longest)
    text += QLatin1Char(' ') +
            CoverageDialog::tr("Longest: %1.")
                .arg(spanText(*longest, longest->spans[static_cast<std::size_t>(longest->longest)]));
  return text + QLatin1Char('\n') +
         CoverageDialog::tr("Ten times per second, %1 x %2 pixels; robots follow their recorded motion.")
             .arg(report.columns)
             .arg(report.rows);
}

}  // namespace

int CoverageDialog::columnOf(HiddenBy cause) {
  return cause == HiddenBy::kSeen ? kSeenColumn : kFirstCause + static_cast<int>(cause) - 1;
}
int CoverageDialog::stripColumn() { return kStrip; }

CoverageDialog::CoverageDialog(const std::vector<SensorKind>& kinds, QWidget* parent)
    : QDialog(parent),
      editor_{new SensorEditor(kinds, this)},
      sentence_{new QLabel(this)},
      table_{new QTableWidget(0, kCoverageColumns, this)},
      strip_{new CoverageStrip(this)},
      busy_{new QProgressBar(this)} {
  setObjectName(QStringLiteral("coverage"));
  setWindowTitle(tr("What a depth camera would not see"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QWidget* window = parent->window();
  resize(kDialogWidth, window->height() < kHighWindow ? kLowHeight : kDialogHeight);
  move(window->mapToGlobal(QPoint(0, window->height() - height())));
  auto* head = new QLabel(
      tr("For how long body parts are hidden from a planned depth camera, and by what. Noise and unknown "
         "objects are not considered: a real camera sees less."),
      this);
  head->setToolTip(
      tr("Over the whole recording. A part counts as seen if at least 30 % of its surface towards the camera "
         "is seen, as in the tracking of people."));
  head->setWordWrap(true);
  QStringList titles{tr("Part"), hiddenTitle(HiddenBy::kSeen), tr("When hidden"), tr("Longest")};
  for (int cause = 1; cause < kHiddenByCount; ++cause) titles << hiddenTitle(static_cast<HiddenBy>(cause));
  table_->setHorizontalHeaderLabels(titles);
  for (int cause = 1; cause < kHiddenByCount; ++cause) {
    QTableWidgetItem* title = table_->horizontalHeaderItem(columnOf(static_cast<HiddenBy>(cause)));
    title->setIcon(swatch(hiddenColour(static_cast<HiddenBy>(cause))));
    title->setToolTip(tr("Share of the time: %1").arg(hiddenText(static_cast<HiddenBy>(cause))));
  }
  table_->setAccessibleName(tr("Time seen and hidden of each part"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kStrip, QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  table_->setItemDelegateForColumn(kStrip, strip_);
  connect(strip_, &CoverageStrip::picked, this, &CoverageDialog::picked);
  connect(table_, &QTableWidget::cellActivated, this, [this](int row, int) {
    const CoveragePart& part = report_.parts[static_cast<std::size_t>(row)];
    if (part.longest >= 0) Q_EMIT picked(part.spans[static_cast<std::size_t>(part.longest)].from);
  });
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  busy_->setAccessibleName(tr("Progress"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* view = buttons->addButton(tr("From the &view"), QDialogButtonBox::ActionRole);
  auto* file = buttons->addButton(tr("From a camera &file…"), QDialogButtonBox::ActionRole);
  auto* remove = buttons->addButton(tr("Re&move the sensor"), QDialogButtonBox::ActionRole);
  stop_ = buttons->addButton(tr("S&top"), QDialogButtonBox::ActionRole);
  view->setToolTip(tr("The sensor stands where the 3D view is seen from, and looks in its direction"));
  file->setToolTip(tr("Lens and pose of a camera file, such as that of a calibration"));
  for (QPushButton* button : {view, file, remove, stop_}) button->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(editor_, &SensorEditor::edited, this, &CoverageDialog::planEdited);
  connect(view, &QPushButton::clicked, this, &CoverageDialog::viewWanted);
  connect(file, &QPushButton::clicked, this, &CoverageDialog::fileWanted);
  connect(remove, &QPushButton::clicked, this, &CoverageDialog::removeWanted);
  connect(stop_, &QPushButton::clicked, this, &CoverageDialog::stop);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::finished, this, &CoverageDialog::stop);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addWidget(editor_);
  layout->addWidget(table_, 1);
  layout->addWidget(sentence_);
  layout->addWidget(busy_);
  layout->addWidget(buttons);
  setWaiting(false);
  // Not in the choice of sensors, which takes letters.
  table_->setFocus();
}

void CoverageDialog::setPlan(const SensorPlan& plan) { editor_->show(plan); }

void CoverageDialog::setTime(double t) {
  strip_->setTime(t);
  table_->viewport()->update();
}

void CoverageDialog::setWaiting(bool waiting) {
  waiting_ = waiting;
  busy_->setVisible(waiting);
  stop_->setEnabled(waiting);
}

void CoverageDialog::wait() {
  table_->setRowCount(0);
  report_ = {};
  setWaiting(true);
  showProgress(0, 0);
}

void CoverageDialog::showProgress(int done, int all) {
  if (!waiting_) return;
  busy_->setRange(0, all);
  busy_->setValue(done);
  sentence_->setText(all == 0 ? tr("Opening the recording…") : tr("Looking from the sensor…"));
}

void CoverageDialog::stop() {
  if (!waiting_) return;
  setWaiting(false);
  sentence_->setText(tr("Stopped."));
  Q_EMIT stopped();
}

void CoverageDialog::fillRow(int row, const CoveragePart& part) {
  const auto set = [&](int column, const QString& text, const QString& tip) {
    auto* item = new QTableWidgetItem(text);
    if (column != kPartColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(tip);
    table_->setItem(row, column, item);
  };
  set(kPartColumn, part.name, {});
  for (int cause = 0; cause < kHiddenByCount; ++cause) {
    const auto at = static_cast<std::size_t>(cause);
    set(columnOf(static_cast<HiddenBy>(cause)),
        cause > 0 && part.times[at] == 0.0 ? QString() : tr("%1 %").arg(fixed(100.0 * part.times[at], 1)),
        tr("%1 % of the surface towards the camera, on average").arg(fixed(100.0 * part.surface[at], 1)));
  }
  const CoverageSpan* longest =
      part.longest >= 0 ? &part.spans[static_cast<std::size_t>(part.longest)] : nullptr;
  set(kLongest, longest ? secondsWithUnit(longest->to - longest->from) : QString(),
      longest ? spanText(part, *longest) : QString());
  set(kStrip, {}, {});
}

void CoverageDialog::show(const CoverageReport& report) {
  setWaiting(false);
  report_ = report;
  strip_->setReport(&report_);
  table_->setRowCount(static_cast<int>(report_.parts.size()));
  for (int cause = 1; cause < kHiddenByCount; ++cause)
    table_->setColumnHidden(
        columnOf(static_cast<HiddenBy>(cause)),
        std::none_of(report_.parts.begin(), report_.parts.end(), [&](const CoveragePart& part) {
          return part.times[static_cast<std::size_t>(cause)] > 0.0;
        }));
  for (int row = 0; row < table_->rowCount(); ++row)
    fillRow(row, report_.parts[static_cast<std::size_t>(row)]);
  sentence_->setText(coverageOutcome(report_));
  fitStrip();
}

/// The room that the other columns leave.
void CoverageDialog::fitStrip() {
  table_->resizeColumnsToContents();
  int others = 0;
  for (int column = 0; column < kCoverageColumns; ++column)
    if (column != kStrip && !table_->isColumnHidden(column)) others += table_->columnWidth(column);
  table_->setColumnWidth(kStrip, std::max(kStripWidth, table_->viewport()->width() - others));
}

void CoverageDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  fitStrip();
}

void CoverageDialog::fail(const QString& problem) {
  setWaiting(false);
  sentence_->setText(problem);
}

}  // namespace abstand::ui
