// Margins: sliders, spin boxes, masters, reset.
#include "ui/panels/margin_panel.hpp"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>

#include "tests/ui/fake_session.hpp"
#include "ui/panels/margin_row.hpp"

namespace abstand::ui {
namespace {

constexpr int kWaitMs = 2000;    // for a signal that comes after kGatherMs
constexpr double kSame = 1e-12;  // m; mm to m and back is exact but for rounding

struct MarginPanelTest : testing::Test {
  void SetUp() override {
    margins.assign(session.outline().objects.size(), 0.01);
    margins[static_cast<std::size_t>(hand)] = 0.04;
    panel.open(session.outline(), margins);
  }
  FakeSession session;
  int hand{session.indexOf("operator/hand_left")};
  std::vector<double> margins;
  MarginPanel panel;
  QSignalSpy changes{&panel, &MarginPanel::marginChanged};
};

TEST_F(MarginPanelTest, ADraggedSliderSendsItsNewestValueOnceInMetres) {
  auto* slider = panel.row(hand)->findChild<QSlider*>();
  for (int mm = 41; mm <= 120; ++mm) slider->setValue(mm);
  EXPECT_EQ(changes.size(), 0);
  ASSERT_TRUE(changes.wait(kWaitMs));
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(changes[0][0].toInt(), hand);
  EXPECT_NEAR(changes[0][1].toDouble(), 0.120, kSame);
  EXPECT_EQ(panel.row(hand)->findChild<QDoubleSpinBox*>()->value(), 120.0);
}

TEST_F(MarginPanelTest, TheSpinBoxGoesBeyondTheSlider) {
  panel.row(hand)->findChild<QDoubleSpinBox*>()->setValue(750.0);
  ASSERT_TRUE(changes.wait(kWaitMs));
  EXPECT_NEAR(changes[0][1].toDouble(), 0.75, kSame);
  EXPECT_EQ(panel.row(hand)->findChild<QSlider*>()->value(), 300);
}

TEST_F(MarginPanelTest, AMasterSetsItsGroupOnly) {
  panel.groupRow("arm")->findChild<QSlider*>()->setValue(77);
  ASSERT_TRUE(changes.wait(kWaitMs));
  EXPECT_EQ(changes.size(), 5);
  EXPECT_NEAR(panel.row(session.indexOf("arm/link2"))->metres(), 0.077, kSame);
  EXPECT_NEAR(panel.row(hand)->metres(), 0.04, kSame);
}

TEST_F(MarginPanelTest, ResetSendsOnlyWhatDiffers) {
  panel.row(hand)->findChild<QSlider*>()->setValue(200);
  ASSERT_TRUE(changes.wait(kWaitMs));
  changes.clear();
  panel.reset();
  ASSERT_TRUE(changes.wait(kWaitMs));
  ASSERT_EQ(changes.size(), 1);
  EXPECT_NEAR(changes[0][1].toDouble(), 0.04, kSame);
  EXPECT_NEAR(panel.groupRow("operator")->metres(), 0.04, kSame);
}

}  // namespace
}  // namespace abstand::ui
