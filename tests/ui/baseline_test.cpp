// The window looks as it did: pictures of it against those in tests/ui/baselines.
//
// Set ABSTAND_RENEW_BASELINES=1 to write them anew, look at them, and commit them with the change that made
// them differ.
#include <gtest/gtest.h>

#include <QAction>

#include "tests/support/paths.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/style/actions.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {
namespace baseline_test {

// Pixels of a baseline; of its cells so many a side: letters and edges blur, panels and colours do not.
constexpr QSize kBaseline{600, 400}, kCells{60, 40};
// Of 255: by how much a channel of a cell may differ, for other letters and other OpenGL libraries.
constexpr int kTolerance = 24;
// Share of the cells that may differ more.
constexpr double kMaxShare = 0.02;

QImage cellsOf(const QImage& image) {
  return image.convertToFormat(QImage::Format_RGB32)
      .scaled(kCells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Share of the cells that differ.
double difference(const QImage& a, const QImage& b) {
  const QImage x = cellsOf(a), y = cellsOf(b);
  int different = 0;
  for (int row = 0; row < kCells.height(); ++row)
    for (int column = 0; column < kCells.width(); ++column) {
      const QColor p(x.pixel(column, row)), q(y.pixel(column, row));
      const int largest = std::max(
          {std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
      different += largest > kTolerance;
    }
  return static_cast<double>(different) / (kCells.width() * kCells.height());
}

struct BaselineTest : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    // So that the plots have something to show.
    session.play(true);
    while (session.time() < 4.0) {
      session.advance(0.02);
      window.pull();
    }
    session.play(false);
    window.pull();
    QTest::qWait(100);
  }
  void TearDown() override { window.actions()[ActionId::kDarkTheme]->setChecked(false); }

  void compare(const QString& name) {
    const QImage now = grabWindow(window).scaled(kBaseline, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QString file = QString::fromStdString(
        testing::projectFile("tests/ui/baselines/" + name.toStdString() + ".png").string());
    const bool renew = qEnvironmentVariableIsSet("ABSTAND_RENEW_BASELINES");
    ASSERT_TRUE(!renew || now.save(file)) << file.toStdString();
    const QImage before(file);
    ASSERT_FALSE(before.isNull()) << file.toStdString();
    const double share = difference(now, before);
    EXPECT_LE(share, kMaxShare) << name.toStdString();
    if (share > kMaxShare) now.save(name + QStringLiteral("_now.png"));
  }
};

TEST_F(BaselineTest, WindowMatchesInLightAndDark) {
  compare(QStringLiteral("light"));
  window.actions()[ActionId::kDarkTheme]->setChecked(true);
  QTest::qWait(100);
  compare(QStringLiteral("dark"));
}

TEST_F(BaselineTest, DetectsDifferentImage) {
  const QImage now = grabWindow(window);
  EXPECT_EQ(difference(now, now), 0.0);
  window.actions()[ActionId::kTop]->trigger();
  QTest::qWait(100);
  EXPECT_GT(difference(grabWindow(window), now), kMaxShare) << "another camera";
}

}  // namespace baseline_test
}  // namespace abstand::ui
