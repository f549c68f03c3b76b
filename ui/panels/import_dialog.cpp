// Says how an unknown recording is read, and shows the skeleton that comes of it.
#include "ui/panels/import_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMetaObject>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/panels/ghost_view.hpp"
#include "ui/style/calm_inputs.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {
constexpr int kImportWidth = 860, kImportHeight = 560, kJointWidth = 120;  // px
}

ImportDialog::ImportDialog(const QString& file, ImportReader reader, QWidget* parent)
    : QDialog(parent),
      file_{file},
      reader_{std::move(reader)},
      units_{choice("units", {"m", "cm", "mm", "inches", "cmu"})},
      up_{choice("up", {"x", "y", "z", "-x", "-y", "-z"})},
      mirror_{choice("mirror", {"none", "axes", "sides"})},
      joints_{new QTableWidget(this)},
      ghost_{new GhostView(this)},
      time_{new QSlider(Qt::Horizontal, this)},
      summary_{new QLabel(this)},
      buttons_{new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)} {
  setObjectName(QStringLiteral("import_recording"));
  setWindowTitle(tr("Import %1").arg(QFileInfo(file).fileName()));
  mirror_->setToolTip(tr("axes: the file's axes are left-handed; sides: left and right are exchanged"));
  joints_->setColumnCount(2);
  joints_->setHorizontalHeaderLabels({tr("Joint"), tr("in the file")});
  joints_->setAccessibleName(tr("Which joint of the file is which"));
  joints_->verticalHeader()->hide();
  joints_->horizontalHeader()->resizeSection(0, kJointWidth);
  joints_->horizontalHeader()->setStretchLastSection(true);
  time_->setAccessibleName(tr("Time of the skeleton"));
  time_->setRange(0, 0);
  summary_->setObjectName(QStringLiteral("summary"));
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* form = new QFormLayout;
  form->addRow(tr("&Units of the file"), units_);
  form->addRow(tr("Axis that points u&p"), up_);
  form->addRow(tr("&Mirror"), mirror_);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addWidget(joints_, 1);
  auto* right = new QVBoxLayout;
  right->addWidget(ghost_, 1);
  right->addWidget(time_);
  right->addWidget(summary_);
  auto* columns = new QHBoxLayout;
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(time_, &QSlider::valueChanged, ghost_, &GhostView::setFrame);
  resize(kImportWidth, kImportHeight);
  read();
}

ImportDialog::~ImportDialog() = default;

QComboBox* ImportDialog::choice(const char* name, const QStringList& values) {
  auto* box = new QComboBox(this);
  box->setObjectName(QString::fromLatin1(name));
  box->addItem(tr("as found"), QString());
  for (const QString& value : values) box->addItem(value, value);
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this] {
    wish_.units = units_->currentData().toString();
    wish_.up = up_->currentData().toString();
    wish_.mirror = mirror_->currentData().toString();
    read();
  });
  return box;
}

void ImportDialog::read() {
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
  if (std::exchange(busy_, true)) return;  // take() begins anew
  summary_->setText(tr("Reading…"));
  reading_ = wish_;
  thread_ = std::jthread([this, file = file_, wish = wish_, reader = reader_] {
    const ImportFound found = reader(file, wish);
    QMetaObject::invokeMethod(
        this, [this, found] { take(found); }, Qt::QueuedConnection);
  });
}

void ImportDialog::take(const ImportFound& found) {
  busy_ = false;
  if (!(reading_ == wish_)) return read();
  found_ = found;
  const int before = time_->value();
  time_->setRange(0, std::max(0, static_cast<int>(found_.frames.size()) - 1));
  time_->setValue(before);
  ghost_->setFound(found_);
  ghost_->setFrame(time_->value());
  showJoints();
  summary_->setText(summary());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(found_.problem.isEmpty() && ghost_->bones() > 0);
}

void ImportDialog::showJoints() {
  // Names that are in no list box yet; the boxes stay, so that the user's place is kept.
  const bool same = joints_->rowCount() == found_.canonical.size();
  if (!same) joints_->setRowCount(found_.canonical.size());
  for (int row = 0; row < found_.canonical.size(); ++row) {
    auto* box = static_cast<QComboBox*>(joints_->cellWidget(row, 1));
    if (!box) {
      auto* name = new QTableWidgetItem(found_.canonical[row]);
      name->setFlags(Qt::ItemIsEnabled);
      joints_->setItem(row, 0, name);
      box = new CalmComboBox(joints_);
      box->setObjectName(found_.canonical[row]);
      box->setAccessibleName(tr("Joint %1 in the file").arg(found_.canonical[row]));
      box->addItem(tr("none"), QString());
      for (const QString& each : found_.names) box->addItem(each, each);
      joints_->setCellWidget(row, 1, box);
      connect(box, QOverload<int>::of(&QComboBox::activated), this,
              [this, row, box] { takeJoint(row, box->currentData().toString()); });
    }
    const QString used = found_.used.value(row);
    if (box->findData(used) < 0) box->addItem(used, used);  // the middle of several
    box->setCurrentIndex(box->findData(used));
    box->setEnabled(!found_.map_text.isEmpty() || !found_.names.isEmpty());
  }
}

void ImportDialog::takeJoint(int row, const QString& name) {
  QStringList joints = wish_.joints.isEmpty() ? found_.used : wish_.joints;
  while (joints.size() < found_.canonical.size()) joints << QString();
  // One point is one joint.
  if (!name.isEmpty())
    for (QString& other : joints)
      if (other == name) other.clear();
  joints[row] = name;
  wish_.joints = joints;
  read();
}

QString ImportDialog::summary() const {
  if (!found_.problem.isEmpty()) return tr("⚠ %1").arg(found_.problem);
  const auto said = [](const QString& value, bool guessed) {
    return guessed ? tr("%1 (guessed)").arg(value) : value;
  };
  QStringList lines{
      tr("%1, %2 s, %3 frames").arg(found_.format, fixed(found_.duration, 2)).arg(found_.frame_count),
      tr("units %1, up %2, left and right: %3")
          .arg(said(found_.units, found_.units_guessed), said(found_.up, found_.up_guessed), found_.sides),
      tr("stature %1; joints by %2")
          .arg(found_.stature > 0.0 ? tr("%1 m").arg(fixed(found_.stature, 2)) : tr("not known"),
               said(found_.joint_map.isEmpty() ? tr("no map") : found_.joint_map, found_.map_guessed))};
  if (!found_.missing_parts.isEmpty())
    lines << tr("⚠ nothing moves: %1").arg(found_.missing_parts.join(QStringLiteral(", ")));
  for (const QString& warning : found_.warnings.mid(0, 3)) lines << tr("⚠ %1").arg(warning);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace abstand::ui
