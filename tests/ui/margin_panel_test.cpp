// Margins: sliders, spin boxes, masters.
#include "ui/panels/margin_panel.hpp"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>

#include "tests/ui/fake_session.hpp"
#include "ui/panels/margin_row.hpp"

namespace abstand::ui {
namespace margin_panel_test {

constexpr int kWaitMs = 2000;    // for a signal that comes after kGatherMs
constexpr double kSame = 1e-12;  // m; mm to m and back is exact but for rounding

struct MarginPanelTest : ::testing::Test {
  void SetUp() override {
    margins.assign(session.outline().objects.size(), 0.01);
    margins[static_cast<std::size_t>(hand)] = 0.04;
    panel.open(session.outline(), margins);
  }
  FakeSession session;
  int hand{session.indexOf("operator/hand_left")};
  std::vector<double> margins;
  MarginPanel panel;
  QMap<int, double> sent() { return changes.takeFirst()[0].value<QMap<int, double>>(); }
  int known_type{qRegisterMetaType<QMap<int, double>>("QMap<int,double>")};  // before the spy asks for it
  QSignalSpy changes{&panel, &MarginPanel::marginsChanged};
  QSignalSpy finished{&panel, &MarginPanel::editFinished};
};

TEST_F(MarginPanelTest, ConsecutiveValuesAreSentOnceInMetres) {
  auto* slider = panel.row(hand)->findChild<QSlider*>();
  for (int mm = 41; mm <= 120; ++mm) slider->setValue(mm);
  EXPECT_EQ(changes.size(), 0);
  ASSERT_TRUE(changes.wait(kWaitMs));
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(finished.size(), 1);
  const QMap<int, double> last = sent();
  ASSERT_EQ(last.size(), 1);
  EXPECT_NEAR(last.value(hand), 0.120, kSame);
  EXPECT_EQ(panel.row(hand)->findChild<QDoubleSpinBox*>()->value(), 120.0);
}

TEST_F(MarginPanelTest, DragEndsWhenSliderIsReleased) {
  auto* slider = panel.row(hand)->findChild<QSlider*>();
  slider->setSliderDown(true);
  slider->setValue(100);
  ASSERT_TRUE(changes.wait(kWaitMs));
  slider->setValue(110);
  ASSERT_TRUE(changes.wait(kWaitMs));
  EXPECT_EQ(finished.size(), 0);
  slider->setValue(120);
  slider->setSliderDown(false);
  ASSERT_EQ(changes.size(), 3) << "the last value is sent at once";
  EXPECT_EQ(finished.size(), 1);
  const auto last = changes[2][0].value<QMap<int, double>>();
  EXPECT_NEAR(last.value(hand), 0.120, kSame);
}

TEST_F(MarginPanelTest, SpinBoxExceedsSliderRange) {
  panel.row(hand)->findChild<QDoubleSpinBox*>()->setValue(750.0);
  ASSERT_TRUE(changes.wait(kWaitMs));
  EXPECT_NEAR(sent().value(hand), 0.75, kSame);
  EXPECT_EQ(panel.row(hand)->findChild<QSlider*>()->value(), 300);
}

TEST_F(MarginPanelTest, GroupRowSetsItsGroupOnly) {
  panel.groupRow("arm")->findChild<QSlider*>()->setValue(77);
  ASSERT_TRUE(changes.wait(kWaitMs));
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(sent().size(), 5);
  EXPECT_NEAR(panel.row(session.indexOf("arm/link2"))->metres(), 0.077, kSame);
  EXPECT_NEAR(panel.row(hand)->metres(), 0.04, kSame);
}

TEST_F(MarginPanelTest, SendsFirstChangeWithoutDelay) {
  panel.row(hand)->findChild<QSlider*>()->setValue(90);
  QCoreApplication::processEvents();
  ASSERT_EQ(changes.size(), 1);
  EXPECT_NEAR(sent().value(hand), 0.09, kSame);
}

TEST_F(MarginPanelTest, ShowsOtherMarginsWithoutSignal) {
  margins[static_cast<std::size_t>(hand)] = 0.2;
  panel.show(margins);
  EXPECT_EQ(panel.row(hand)->metres(), 0.2);
  EXPECT_EQ(panel.groupRow("operator")->metres(), 0.2) << "the largest of its members";
  EXPECT_FALSE(changes.wait(3 * MarginPanel::kGatherMs));
}

}  // namespace margin_panel_test
}  // namespace abstand::ui
