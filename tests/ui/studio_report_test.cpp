// Reports from the window, and reloading what has changed.
#include <gtest/gtest.h>

#include <QAction>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTest>

#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/slide_studio.hpp"
#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/report_dialog.hpp"
#include "ui/report_commands.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_report_test {

struct StudioReport : SlideStudio {
  StudioReport() : SlideStudio({.robot = 0.5, .person = 0.3, .stops_at = 1.8, .seconds = 4.0}) {
    page = QString::fromStdString((folder.path() / "page.html").string());
    open();
  }
  ui::ReportRequest request() const {
    ui::ReportRequest request;
    request.file = page;
    request.margin_set = "abstand_margins: 1\ndefault: {margin: 0.123}\n";
    return request;
  }
  /// Runs a job; the error, or nothing.
  QString run(const ui::Work& work, const ui::ReportRequest& request) {
    ReportJob job(QStringLiteral(ABSTAND_PROGRAM), work, request, {});
    QSignalSpy done(&job, &ReportJob::done), failed(&job, &ReportJob::failed);
    job.start();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !done.isEmpty() || !failed.isEmpty(); }, kLimitMs));
    return failed.isEmpty() ? QString() : failed.front().front().toString();
  }
  std::string written() const { return readFile(page.toStdString(), 1 << 28, true); }

  QString page;
};

TEST_F(StudioReport, UsesMarginsOfWindow) {
  qputenv("PATH", QFileInfo(ABSTAND_PROGRAM).absolutePath().toLocal8Bit() + ":" + qgetenv("PATH"));
  window.panels().margins->groupRow(QStringLiteral("person"))->findChild<QSlider*>()->setValue(137);
  ui::ModalAnswer answer(QStringLiteral("report"), [&](QWidget* dialog) {
    dialog->findChild<QLineEdit*>()->setText(page);
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
      if (button->text().contains(QLatin1String("Make"))) return button->click();
  });
  window.actions()[ui::ActionId::kReport]->trigger();
  EXPECT_TRUE(answer.answered());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.reports().waiting(); }, kLimitMs));
  auto* box = window.findChild<QMessageBox*>(QStringLiteral("report_done"));
  ASSERT_TRUE(box) << "no report";
  EXPECT_TRUE(box->text().contains(page));
  EXPECT_NE(written().find("present_margins"), std::string::npos);
  EXPECT_EQ(window.findChildren<QProgressDialog*>().size(), 0);
}

TEST_F(StudioReport, ReadsRecordingLikeWindow) {
  ui::Work work = window.document().work();
  ASSERT_EQ(run(work, request()), QString());
  const std::string as_recorded = written();
  work.reading.speed = 2.0;
  ASSERT_EQ(run(work, request()), QString());
  EXPECT_NE(written().find("speed 2"), std::string::npos);
  EXPECT_EQ(as_recorded.find("speed 2"), std::string::npos);
  work.reading = {};
  work.reading.up = QStringLiteral("z");
  ASSERT_EQ(run(work, request()), QString());
  EXPECT_NE(written().find("_as_read.yaml"), std::string::npos);
}

TEST_F(StudioReport, ReportsReasonForFailure) {
  ui::ReportRequest wrong = request();
  wrong.file = QString::fromStdString((folder.path() / "nowhere" / "page.html").string());
  EXPECT_TRUE(run(window.document().work(), wrong).contains(QLatin1String("nowhere")));
  ui::Work work = window.document().work();
  work.scene = QStringLiteral("/missing.yaml");
  EXPECT_TRUE(run(work, request()).contains(QLatin1String("missing.yaml")));
  EXPECT_FALSE(QFileInfo::exists(page));
  ReportJob none(QString(), window.document().work(), request(), {});
  QSignalSpy failed(&none, &ReportJob::failed);
  none.start();
  EXPECT_EQ(failed.size(), 1);
}

TEST_F(StudioReport, IsNotWrittenWhenCancelled) {
  {
    ReportJob job(QStringLiteral(ABSTAND_PROGRAM), window.document().work(), request(), {});
    job.start();
  }
  QTest::qWait(100);
  EXPECT_FALSE(QFileInfo::exists(page));
}

TEST_F(StudioReport, ReloadKeepsMarginsAndMoment) {
  window.panels().margins->groupRow(QStringLiteral("person"))->findChild<QSlider*>()->setValue(137);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.document().work().margins.isEmpty(); }, kLimitMs));
  window.playback().seek(1.5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 1.5) < 0.02; }, kLimitMs));
  const ui::Work before = window.document().work();
  std::string text = readFile(scene, 1 << 20);
  text += "# edited\n";
  writeFile(scene, text);
  QSignalSpy ready(studio.get(), &Studio::ready);
  window.actions()[ui::ActionId::kReload]->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLimitMs));
  EXPECT_TRUE(window.document().work() == before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - 1.5) < 0.02; }, kLimitMs));
}

TEST_F(StudioReport, DetectsEditedScene) {
  QSignalSpy said(window.statusBar(), &QStatusBar::messageChanged);
  writeFile(scene, readFile(scene, 1 << 20) + "# edited\n");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return std::any_of(said.begin(), said.end(), [](const auto& message) {
          return message.front().toString().contains(QLatin1String("has changed and was read again"));
        });
      },
      kLimitMs));
}

}  // namespace studio_report_test
}  // namespace abstand::studio
