// Pictures and videos.
#include "ui/picture_commands.hpp"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>

#include "ui/main_window.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/plots/plot_export.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/picture_file.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {

PictureCommands::PictureCommands(const Actions& actions, const Sources& sources, MainWindow* window)
    : QObject(window), from_{sources}, window_{window} {
  connect(actions[ActionId::kSavePlots], &QAction::triggered, this, &PictureCommands::savePlotsAs);
  connect(actions[ActionId::kScreenshot], &QAction::triggered, this, &PictureCommands::saveScreenshot);
  connect(actions[ActionId::kCopyPicture], &QAction::triggered, this, &PictureCommands::copyPicture);
  connect(actions[ActionId::kVideo], &QAction::triggered, this, &PictureCommands::saveVideo);
  connect(&from_.videos, &VideoRecorder::failed, this, &PictureCommands::failed);
  connect(&from_.videos, &VideoRecorder::done, this,
          [this](const QString& file) { Q_EMIT said(tr("Saved %1").arg(file)); });
}

void PictureCommands::copyPicture() {
  QApplication::clipboard()->setImage(from_.viewport.picture());
  Q_EMIT said(tr("The picture is on the clipboard"));
}

void PictureCommands::saveVideo() {
  QFileDialog dialog(window_, tr("Save video"), recentFolder(), tr("Videos (*.avi)"));
  dialog.setObjectName(QStringLiteral("save_video"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("avi"));
  dialog.selectFile(QStringLiteral("abstand.avi"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  from_.videos.start(dialog.selectedFiles().constFirst(), from_.axis.range().value_or(from_.axis.whole()));
}

void PictureCommands::savePlotsAs() {
  QFileDialog dialog(window_, tr("Save plots"), recentFolder(),
                     tr("Table (*.csv);;Drawing (*.svg);;Picture (*.png)"));
  dialog.setObjectName(QStringLiteral("save_plots"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("csv"));
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
  });
  dialog.selectFile(QStringLiteral("plots"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().constFirst();
  rememberFolder(path);
  try {
    savePlots(from_.plots.charts(), path);
    Q_EMIT said(tr("Saved %1").arg(path));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Save plots"), QString::fromUtf8(e.what()));
  }
}

void PictureCommands::saveScreenshot() {
  const QImage picture = grabWindow(*window_);
  const QString name = QStringLiteral("abstand-%1.png")
                           .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  const QString path = QFileDialog::getSaveFileName(
      window_, tr("Save screenshot"), QDir(recentFolder()).filePath(name), tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  try {
    savePicture(picture, path);
    Q_EMIT said(tr("Saved %1").arg(path));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Screenshot"), QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::ui
