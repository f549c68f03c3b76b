// What can be seen: pictures of the window and of the 3D view.
#include "ui/viewport/viewport.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <set>

#include "tests/ui/shown_window.hpp"
#include "ui/model/selection.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/overlay.hpp"
#include "ui/window_grab.hpp"

namespace abstand::ui {
namespace viewport_test {

constexpr std::size_t kColours = 500;  // a picture with shading and text has many more, a blank one a few

std::size_t countColours(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  return colours.size();
}

/// Pixels of about this hue, as strong as a lit surface of that colour is.
long countHue(const QImage& image, const QColor& colour) {
  long n = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor c(image.pixel(x, y));
      if (c.saturation() > 150 && std::abs(c.hue() - colour.hue()) < 8) ++n;
    }
  return n;
}

struct ViewportTest : ShownWindow {
  QImage pictureAt(double t) {
    session.seek(t);
    window.pull();
    return window.viewport().picture();
  }
};

TEST_F(ViewportTest, PictureHasWindowSizeAndIsNotBlank) {
  const QImage picture = grabWindow(window);
  EXPECT_EQ(picture.size(), QSize(1200, 800));
  EXPECT_GT(countColours(picture), kColours);
  EXPECT_GT(countColours(window.viewport().picture()), kColours);
}

TEST_F(ViewportTest, CopiedPictureIsThatOfTheView) {
  window.actions()[ActionId::kCopyPicture]->trigger();
  const QImage copied = QApplication::clipboard()->image();
  EXPECT_EQ(copied.size(), window.viewport().picture().size());
  EXPECT_GT(countColours(copied), kColours);
}

TEST_F(ViewportTest, OnlyContactIsVermillion) {
  window.actions()[ActionId::kLabels]->setChecked(false);
  window.actions()[ActionId::kClosest]->setChecked(false);
  window.actions()[ActionId::kForces]->setChecked(false);
  const long apart = countHue(pictureAt(5.5), QColor(kVermillion));
  const long contact = countHue(pictureAt(0.4), QColor(kVermillion));
  EXPECT_EQ(apart, 0);
  EXPECT_GT(contact, 500);
}

TEST_F(ViewportTest, DrawsOnlyWhenSomethingChanges) {
  pictureAt(5.5);
  ASSERT_TRUE(QTest::qWaitFor(
      [&, last = -1L]() mutable {
        return std::exchange(last, window.viewport().framesDrawn()) == window.viewport().framesDrawn();
      },
      kWaitMs));
  QTest::qWait(300);
  const long before = window.viewport().framesDrawn();
  QTest::qWait(500);
  EXPECT_EQ(window.viewport().framesDrawn(), before);
  session.seek(6.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return window.viewport().framesDrawn() > before; }, kWaitMs));
}

TEST_F(ViewportTest, EveryToggleChangesThePicture) {
  pictureAt(0.4);
  for (const ActionId id : {ActionId::kForces, ActionId::kTorques, ActionId::kJointTorques,
                            ActionId::kVelocities, ActionId::kClosest, ActionId::kLabels, ActionId::kFloor,
                            ActionId::kShadows, ActionId::kTransparent}) {
    QAction* action = window.actions()[id];
    SCOPED_TRACE(action->text().toStdString());
    const bool was = action->isChecked();
    const QImage before = window.viewport().picture();
    action->setChecked(!was);
    EXPECT_NE(window.viewport().picture(), before);
    action->setChecked(was);
    EXPECT_EQ(window.viewport().picture(), before);
  }
}

TEST_F(ViewportTest, StaleIsHollowAndHiddenIsNotDrawn) {
  const QImage whole = pictureAt(5.5);
  session.setPoseState(session.indexOf("operator/torso"), scene::PoseState::kStale);
  window.pull();
  EXPECT_NE(window.viewport().picture(), whole);
  session.setPoseState(session.indexOf("operator/torso"), scene::PoseState::kFresh);
  window.pull();
  EXPECT_EQ(window.viewport().picture(), whole);
  window.viewport().setObjectVisible(session.indexOf("table"), false);
  EXPECT_NE(window.viewport().picture(), whole);
}

TEST_F(ViewportTest, PoseUncertaintyIsDrawnAsHalo) {
  // Labels state the uncertainty in words.
  ViewOptions options = window.viewport().options();
  options.closest = options.labels = false;
  window.viewport().setOptions(options);
  const QImage sharp = pictureAt(5.5);
  const auto differing = [&](double reach) {
    session.setPoseUncertainty(session.indexOf("operator/torso"), reach);
    window.pull();
    const QImage now = window.viewport().picture();
    int count = 0;
    for (int y = 0; y < now.height(); ++y)
      for (int x = 0; x < now.width(); ++x) count += now.pixel(x, y) != sharp.pixel(x, y);
    return count;
  };
  EXPECT_EQ(differing(0.001), 0) << "nobody sees a millimetre";
  const int near = differing(0.05);
  EXPECT_GT(near, 0);
  EXPECT_GT(differing(0.2), near);
  EXPECT_EQ(differing(0.0), 0);
}

TEST_F(ViewportTest, ClickSelectsObjectUnderPointer) {
  pictureAt(5.5);
  // The chosen object fills the middle of the view.
  window.selection().setObjects({session.indexOf("table")});
  window.viewport().fitSelection();
  window.selection().clear();
  window.viewport().picture();
  QWidget* gl = window.viewport().childAt(10, 10);
  ASSERT_NE(gl, nullptr);
  QTest::mouseClick(gl, Qt::LeftButton, {}, gl->rect().center());
  EXPECT_EQ(window.selection().objects(), std::vector<int>{session.indexOf("table")});
  QTest::mouseClick(gl, Qt::LeftButton, {}, QPoint(2, 2));
  EXPECT_TRUE(window.selection().objects().empty());
}

TEST_F(ViewportTest, NothingIsClippedFromAnySide) {
  pictureAt(0.4);
  for (const ActionId id : {ActionId::kFront, ActionId::kSide, ActionId::kTop, ActionId::kIso}) {
    SCOPED_TRACE(window.actions()[id]->text().toStdString());
    window.actions()[id]->trigger();
    // The parts in contact are seen from every side, above the floor's layer and through transparent people.
    for (const ActionId hidden : {ActionId::kLabels, ActionId::kClosest, ActionId::kForces})
      window.actions()[hidden]->setChecked(false);
    EXPECT_GT(countHue(window.viewport().picture(), QColor(kVermillion)), 300);
  }
}

TEST_F(ViewportTest, CameraPresetsDifferAndAreRepeatable) {
  pictureAt(5.5);
  std::vector<QImage> seen;
  for (const ActionId id : {ActionId::kFront, ActionId::kSide, ActionId::kTop, ActionId::kIso}) {
    window.actions()[id]->trigger();
    for (const QImage& other : seen) EXPECT_NE(window.viewport().picture(), other);
    seen.push_back(window.viewport().picture());
  }
  window.actions()[ActionId::kFront]->trigger();
  EXPECT_EQ(window.viewport().picture(), seen.front());
}

TEST_F(ViewportTest, DarkAndLightDifferAndBothHaveContent) {
  const QImage light = grabWindow(window);
  window.actions()[ActionId::kDarkTheme]->setChecked(true);
  QTest::qWait(50);
  const QImage dark = grabWindow(window);
  EXPECT_GT(countColours(dark), kColours);
  EXPECT_NE(dark, light);
  window.actions()[ActionId::kDarkTheme]->setChecked(false);
}

TEST_F(ViewportTest, LegendStaysWithinView) {
  const Overlay& shown = window.viewport().overlay();
  ASSERT_FALSE(shown.content().legend.empty());
  Overlay overlay(nullptr);
  overlay.content().legend = shown.content().legend;
  overlay.content().legend.push_back(
      {LegendLine::Mark::kArrow, QColor(kVermillion),
       QStringLiteral("Abstoßung (Sicherheitsabstand, virtuell): 120 mm ≙ 1234,5 N")});
  overlay.resize(900, 400);
  const LegendPlace wide = overlay.placeLegend();
  for (const int width : {620, 340, 240}) {
    overlay.resize(width, 400);
    const LegendPlace place = overlay.placeLegend();
    EXPECT_TRUE(QRectF(overlay.rect()).contains(place.box)) << width;
    constexpr double kAxes = 80.0;  // px
    EXPECT_GE(place.box.left(), width > 300 ? kAxes : 0.0) << "beside the axes";
    ASSERT_EQ(place.rows.size(), overlay.content().legend.size());
    double rows = 0.0;
    for (const double row : place.rows) rows += row;
    EXPECT_LE(rows, place.box.height());
  }
  overlay.resize(240, 400);
  EXPECT_GT(overlay.placeLegend().rows.back(), wide.rows.back()) << "wrapped, not cut";
}

TEST_F(ViewportTest, LabelsStayWithinNarrowView) {
  Overlay overlay(nullptr);
  const QString text = QStringLiteral("⚠ left_arm/link7: unterschritten, virtuell 48,7 N");
  overlay.content().labels.push_back({QPointF(150.0, 200.0), text});
  overlay.resize(900, 400);
  const double row = overlay.placeLabels().at(0).box.height();
  for (const int width : {360, 300, 200}) {
    overlay.resize(width, 400);
    const PlacedLabel placed = overlay.placeLabels().at(0);
    EXPECT_TRUE(QRectF(overlay.rect()).contains(placed.box)) << width;
  }
  EXPECT_GT(overlay.placeLabels().at(0).box.height(), row) << "wrapped, not cut";
}

}  // namespace viewport_test
}  // namespace abstand::ui
