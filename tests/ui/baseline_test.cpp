// The window and its plots look as they did: pictures of them against those in tests/ui/baselines.
//
// scripts/baselines writes them anew; look at them, and commit them with the change that made them differ.
#include <gtest/gtest.h>

#include <QAction>
#include <QPainter>

#include "tests/support/paths.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/plots/strip_chart.hpp"
#include "ui/style/actions.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {
namespace baseline_test {

/// How a picture is kept and compared.
struct Look {
  QSize size;    ///< px of the baseline
  QSize cells;   ///< that are compared
  double share;  ///< of the cells that may differ
};
// Letters and edges blur, panels and colours do not.
const Look kWindow{{600, 400}, {60, 40}, 0.02};
// Cells of four pixels, so that a line of one pixel counts; one that is missing takes a cell of each column.
const Look kPlots{{600, 600}, {150, 150}, 0.004};
// Of 255: by how much a channel of a cell may differ, for other letters and other OpenGL libraries.
constexpr int kTolerance = 24;

QImage cellsOf(const QImage& image, const Look& look) {
  return image.convertToFormat(QImage::Format_RGB32)
      .scaled(look.cells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Share of the cells that differ.
double difference(const QImage& a, const QImage& b, const Look& look) {
  const QImage x = cellsOf(a, look), y = cellsOf(b, look);
  int different = 0;
  for (int row = 0; row < x.height(); ++row)
    for (int column = 0; column < x.width(); ++column) {
      const QColor p(x.pixel(column, row)), q(y.pixel(column, row));
      const int largest = std::max(
          {std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
      different += largest > kTolerance;
    }
  return static_cast<double>(different) / (x.width() * x.height());
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
  /// As they are saved as a picture: the same whatever the layout of the docks.
  QImage plots() {
    const std::vector<StripChart*> charts = window.panels().plots->charts();
    QImage image(kPlots.size, QImage::Format_RGB32);
    image.fill(charts.front()->palette().color(QPalette::Window));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double height = static_cast<double>(image.height()) / static_cast<double>(charts.size());
    for (std::size_t i = 0; i < charts.size(); ++i)
      charts[i]->paint(painter, QRectF(0.0, static_cast<double>(i) * height, image.width(), height));
    return image;
  }
  void TearDown() override { window.actions()[ActionId::kDarkTheme]->setChecked(false); }

  void compare(const QString& name, const QImage& picture, const Look& look) {
    const QImage now = picture.scaled(look.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QString file = QString::fromStdString(
        testing::projectFile("tests/ui/baselines/" + name.toStdString() + ".png").string());
    const bool renew = qEnvironmentVariableIsSet("ABSTAND_RENEW_BASELINES");
    ASSERT_TRUE(!renew || now.save(file)) << file.toStdString();
    const QImage before(file);
    ASSERT_FALSE(before.isNull()) << file.toStdString();
    const double share = difference(now, before, look);
    EXPECT_LE(share, look.share) << name.toStdString();
    if (share > look.share) now.save(name + QStringLiteral("_now.png"));
  }
};

TEST_F(BaselineTest, WindowMatchesInLightAndDark) {
  compare(QStringLiteral("light"), grabWindow(window), kWindow);
  window.actions()[ActionId::kDarkTheme]->setChecked(true);
  QTest::qWait(100);
  compare(QStringLiteral("dark"), grabWindow(window), kWindow);
}

/// The charts alone, large enough that each line counts.
TEST_F(BaselineTest, PlotsMatchInLightAndDark) {
  compare(QStringLiteral("plots_light"), plots(), kPlots);
  window.actions()[ActionId::kDarkTheme]->setChecked(true);
  QTest::qWait(100);
  compare(QStringLiteral("plots_dark"), plots(), kPlots);
}

TEST_F(BaselineTest, PlotsShowForcesOfEarlierMargins) {
  session.setMargin(session.indexOf("operator/hand_left"), 0.0);
  session.seek(3.9);
  window.pull();
  QTest::qWait(100);
  compare(QStringLiteral("plots_earlier"), plots(), kPlots);
}

TEST_F(BaselineTest, DetectsMissingLineOfPlots) {
  const QImage now = plots();
  EXPECT_EQ(difference(now, now, kPlots), 0.0);
  for (const std::size_t chart : {0, 1}) {
    StripChart* of = window.panels().plots->charts()[chart];
    const FrameSeries* series = of->series(0);
    of->setSeries(nullptr, 0);
    EXPECT_GT(difference(plots(), now, kPlots), kPlots.share) << "chart " << chart;
    of->setSeries(series, 0);
    EXPECT_EQ(difference(plots(), now, kPlots), 0.0);
  }
}

TEST_F(BaselineTest, DetectsDifferentImage) {
  const QImage now = grabWindow(window);
  EXPECT_EQ(difference(now, now, kWindow), 0.0);
  window.actions()[ActionId::kTop]->trigger();
  QTest::qWait(100);
  EXPECT_GT(difference(grabWindow(window), now, kWindow), kWindow.share) << "another camera";
}

}  // namespace baseline_test
}  // namespace abstand::ui
