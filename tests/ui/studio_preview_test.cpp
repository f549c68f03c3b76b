// The picture of the moment under the pointer: the bodies where they are then, and nothing shown changes.
#include <gtest/gtest.h>

#include <QImage>
#include <QTextDocument>

#include "tests/ui/slide_studio.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/time_preview.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {
namespace studio_preview_test {

struct StudioPreview : SlideStudio {
  // The ball comes nearer by 1.2 m.
  StudioPreview() : SlideStudio({.robot = 0.3, .person = 0.0, .seconds = 4.0}) {}
  void SetUp() override {
    if (!ui::openGlInfo().available) GTEST_SKIP() << "no OpenGL 3.2 here";
    open();
    ASSERT_TRUE(analysed());
  }
  /// Share of pixels that differ clearly.
  static double difference(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
        count += std::abs(p.lightness() - q.lightness()) > 24;
      }
    return static_cast<double>(count) / (a.width() * a.height());
  }
};

TEST_F(StudioPreview, PosesAreThoseOfTheMoment) {
  const double start = window.playback().start(), end = window.playback().end();
  for (const double share : {0.0, 0.31, 0.77, 1.0}) {
    const double t = start + share * (end - start);
    const view::MomentPoses* poses = window.review().posesNear(t);
    ASSERT_TRUE(poses) << share;
    window.playback().seek(poses->t);
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.moment().t - poses->t) < 1e-9; }, kLimitMs));
    ASSERT_EQ(poses->objects.size(), window.moment().objects.size());
    for (std::size_t i = 0; i < poses->objects.size(); ++i) {
      const view::ObjectSnapshot& shown = window.moment().objects[i];
      EXPECT_TRUE(poses->objects[i].X_WB.isApprox(shown.X_WB, 1e-12)) << i;
      EXPECT_EQ(poses->objects[i].state, shown.pose_state) << i;
    }
  }
  EXPECT_FALSE(window.review().posesNear(end + 1.0));
}

TEST_F(StudioPreview, ShowsAnotherMomentAndChangesNothing) {
  const double start = window.playback().start(), end = window.playback().end();
  window.playback().seek(start);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.moment().t == start; }, kLimitMs));
  const QImage before = window.viewport().picture();
  const view::MomentPoses first = *window.review().posesNear(start), last = *window.review().posesNear(end);
  const QImage of_first = window.viewport().preview(first, 300),
               of_last = window.viewport().preview(last, 300);
  EXPECT_EQ(of_first.width(), 300);
  EXPECT_GT(difference(of_first, of_last), 0.001) << "the ball has moved";
  EXPECT_EQ(window.viewport().picture(), before);
  // As the view itself, which also has labels.
  window.playback().seek(last.t);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.moment().t == last.t; }, kLimitMs));
  const QImage large = window.viewport().picture();
  const QImage small = large.scaled(of_last.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  const double same = difference(small, of_last), other = difference(small, of_first);
  EXPECT_LT(same, other);
  view::MomentPoses strange = last;
  strange.objects.pop_back();
  EXPECT_TRUE(window.viewport().preview(strange, 300).isNull());
}

TEST_F(StudioPreview, TipHasPictureTimeAndText) {
  ui::TimePreview preview(window.review(), window.viewport());
  const QString tip = preview.tip(window.playback().start(), QStringLiteral("nearest < 1 m\nsecond line"));
  EXPECT_TRUE(tip.contains("nearest &lt; 1 m<br>second line"));
  EXPECT_TRUE(tip.contains("Picture: "));
  QTextDocument document;
  document.setHtml(tip);
  EXPECT_GE(document.size().width(), ui::TimePreview::kWidth) << "the picture is there";
  EXPECT_EQ(preview.tip(window.playback().end() + 5.0, QStringLiteral("text")), QStringLiteral("text"));
}

}  // namespace studio_preview_test
}  // namespace abstand::studio
