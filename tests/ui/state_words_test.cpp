// Contact and what is only inside a margin have different words and colours in all parts of the window.
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QStatusBar>
#include <algorithm>

#include "tests/ui/shown_window.hpp"
#include "ui/model/body_state.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/pair_table_model.hpp"
#include "ui/model/scene_tree_model.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/scene_tree_panel.hpp"
#include "ui/plots/plot_panel.hpp"
#include "ui/plots/strip_chart.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/overlay.hpp"

namespace abstand::ui {
namespace state_words_test {

struct StateWords : ShownWindow {
  void SetUp() override {
    ShownWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    hand = session.indexOf("operator/hand_left");
  }
  void at(double t) {
    session.seek(t);
    window.pull();
    findBodyStates(session.outline(), window.moment(), states);
  }
  /// A moment at which some body is in this state.
  double momentWith(PairLevel level) {
    for (double t = 0.0; t <= session.outline().end; t += 0.02) {
      at(t);
      if (body(level) >= 0) return t;
    }
    ADD_FAILURE() << "there is no such moment";
    return 0.0;
  }
  /// With a force that is drawn; -1: there is none.
  int body(PairLevel level) const {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Vector3d& force =
          level == PairLevel::kTouching ? states[i].contact_force : states[i].virtual_force;
      if (states[i].level == level && force.norm() > window.viewport().options().min_force)
        return static_cast<int>(i);
    }
    return -1;
  }
  const std::vector<OverlayLabel>& labels() const { return window.viewport().overlay().content().labels; }
  QString name(int object) const {
    return QString::fromStdString(clearName(session.outline(), static_cast<std::size_t>(object)));
  }
  QModelIndex inTree(int object) {
    const auto* model = static_cast<const SceneTreeModel*>(window.panels().tree->model());
    return model->indexOf(object);
  }

  int hand{-1};
  std::vector<BodyState> states;
};

TEST_F(StateWords, BodiesHaveTheSameWordsEverywhere) {
  for (const PairLevel level : {PairLevel::kTouching, PairLevel::kInside}) {
    momentWith(level);
    const int object = body(level);
    ASSERT_GE(object, 0);
    window.selection().setObjects({object});
    window.pull();
    const bool touches = level == PairLevel::kTouching;
    const QString word = touches ? QStringLiteral("touching") : QStringLiteral("inside margin");
    // 3D label.
    const auto label = std::find_if(labels().begin(), labels().end(), [&](const OverlayLabel& each) {
      return each.text.startsWith(QStringLiteral("⚠ ") + name(object) + QStringLiteral(": "));
    });
    ASSERT_NE(label, labels().end());
    EXPECT_TRUE(label->text.contains(word)) << label->text.toStdString();
    EXPECT_EQ(label->text.contains(QStringLiteral("virtual")), !touches) << label->text.toStdString();
    EXPECT_EQ(label->style, touches ? OverlayLabel::Style::kContact : OverlayLabel::Style::kInside);
    // Tree.
    const QModelIndex row = inTree(object).siblingAtColumn(1);
    EXPECT_EQ(row.data().toString(), QStringLiteral("⚠ ") + word);
    EXPECT_EQ(row.data(Qt::ForegroundRole).value<QBrush>().color(), levelColour(level));
    // Pair table.
    const auto* pairs = window.panels().pairs->model();
    const int pair = states[static_cast<std::size_t>(object)].pair;
    EXPECT_EQ(pairs->index(pair, PairTableModel::kState).data().toString(), QStringLiteral("⚠ ") + word);
    EXPECT_EQ(
        pairs->index(pair, PairTableModel::kForce).data().toString().contains(QStringLiteral("virtual")),
        !touches);
    QColor tint = pairs->index(pair, 0).data(Qt::BackgroundRole).value<QBrush>().color();
    tint.setAlpha(255);
    EXPECT_EQ(tint, levelColour(level));
    // Tips of the tree, the table and the body in 3D, in a sentence.
    const QString sentence = pairs->index(pair, 0).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(sentence.contains(touches ? QStringLiteral(" touch since")
                                          : QStringLiteral(" are inside the margin since")))
        << sentence.toStdString();
    EXPECT_TRUE(sentence.contains(touches ? QStringLiteral("contact force")
                                          : QStringLiteral("virtual (margin) force")));
    for (const char* part : {"distance ", " ± ", "margin ", " m/s"})
      EXPECT_TRUE(sentence.contains(QString::fromUtf8(part)) ||
                  sentence.contains(QStringLiteral("neither closing")))
          << part << ": " << sentence.toStdString();
    EXPECT_TRUE(row.data(Qt::ToolTipRole).toString().endsWith(sentence));
  }
}

TEST_F(StateWords, TipOfBodyIn3dIsSentence) {
  momentWith(PairLevel::kTouching);
  window.viewport().picture();
  int found = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const QPointF at = window.viewport().project(window.moment().objects[i].p_WCom);
    const QString tip = window.viewport().tipAt(at.toPoint());
    if (tip.isEmpty()) continue;
    EXPECT_TRUE(tip.endsWith(QLatin1Char('.'))) << tip.toStdString();
    EXPECT_TRUE(tip.contains(QStringLiteral("distance"))) << tip.toStdString();
    ++found;
  }
  EXPECT_GT(found, 3);
  EXPECT_TRUE(window.viewport().tipAt(QPoint(1, 1)).isEmpty()) << "the background";
}

TEST_F(StateWords, BodiesInsideMarginAreOchreNotVermillion) {
  window.actions()[ActionId::kLabels]->setChecked(false);
  window.actions()[ActionId::kClosest]->setChecked(false);
  window.actions()[ActionId::kForces]->setChecked(false);
  window.actions()[ActionId::kTorques]->setChecked(false);
  const auto hue = [&](const QColor& colour) {
    const QImage picture = window.viewport().picture();
    long n = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor p = picture.pixelColor(x, y);
        n += p.hsvSaturation() > 120 && std::abs(p.hsvHue() - colour.hsvHue()) < 4;
      }
    return n;
  };
  // Nothing touches, but something is inside a margin.
  double moment = -1.0;
  for (double t = 0.0; t <= session.outline().end && moment < 0.0; t += 0.02) {
    at(t);
    if (body(PairLevel::kInside) >= 0 && body(PairLevel::kTouching) < 0) moment = t;
  }
  ASSERT_GE(moment, 0.0);
  EXPECT_EQ(hue(levelColour(PairLevel::kTouching)), 0);
  EXPECT_GT(hue(levelColour(PairLevel::kInside)), 200);
  momentWith(PairLevel::kTouching);
  EXPECT_GT(hue(levelColour(PairLevel::kTouching)), 200);
}

TEST_F(StateWords, StatusLineNamesStateOfNearestPair) {
  momentWith(PairLevel::kTouching);
  const auto line = [&] {
    for (const QLabel* label : window.statusBar()->findChildren<QLabel*>())
      if (label->accessibleName() == QStringLiteral("Nearest pair")) return label->toolTip();
    return QString();
  };
  EXPECT_TRUE(line().contains(QStringLiteral("⚠ touching"))) << line().toStdString();
  EXPECT_FALSE(line().contains(QStringLiteral("contact")));
}

TEST_F(StateWords, PlotsHaveOneLinePerClassAndForce) {
  at(1.0);
  const auto charts = window.panels().plots->charts();
  ASSERT_GE(charts[0]->lines(), 3u);
  EXPECT_EQ(charts[0]->lineName(0).toStdString(), "Smallest distance: person – robot [mm]");
  EXPECT_EQ(charts[0]->lineName(1).toStdString(), "Smallest distance: person – thing [mm]");
  EXPECT_EQ(charts[1]->lineName(0).toStdString(), "Largest force: contact [N]");
  EXPECT_EQ(charts[1]->lineName(1).toStdString(), "Largest force: virtual (margin) [N]");
  double least[2] = {kInfinity, kInfinity};
  for (std::size_t p = 0; p < window.moment().pairs.size(); ++p) {
    const PairClass of = pairClassOf(session.outline(), session.outline().pairs[p]);
    if (of <= PairClass::kPersonThing) {
      double& nearest = least[static_cast<std::size_t>(of)];
      nearest = std::min(nearest, window.moment().pairs[p].result.distance);
    }
  }
  EXPECT_EQ(charts[0]->shownNow(0), least[0]);
  EXPECT_EQ(charts[0]->shownNow(1), least[1]);
  ASSERT_NE(least[0], least[1]);
  double contact = 0.0, apart = 0.0;
  momentWith(PairLevel::kTouching);
  for (const view::PairSnapshot& pair : window.moment().pairs) {
    double& force = pair.result.distance <= pair.result.bound ? contact : apart;
    force = std::max(force, pair.result.force_a.norm());
  }
  EXPECT_GT(contact, 0.0);
  EXPECT_EQ(charts[1]->shownNow(0), contact);
  EXPECT_EQ(charts[1]->shownNow(1), apart);
  for (const QLabel* label : window.panels().plots->findChildren<QLabel*>())
    EXPECT_NE(label->text(), QStringLiteral("&Window"));
}

TEST_F(StateWords, ForcesOfEarlierMarginsAreMarked) {
  const double t = momentWith(PairLevel::kInside);
  at(t);
  const auto charts = window.panels().plots->charts();
  EXPECT_EQ(charts[1]->lines(), 2u);
  const FrameSeries* apart = charts[1]->series(1);
  ASSERT_GT(apart->at(t), 0.0);
  at(t + 0.2);
  for (int i = 0; i < static_cast<int>(session.outline().objects.size()); ++i) session.setMargin(i, 0.0);
  window.pull();
  ASSERT_EQ(charts[1]->lines(), 3u);
  EXPECT_EQ(charts[1]->lineName(2).toStdString(), "Largest force: of earlier margins [N]");
  EXPECT_TRUE(std::isnan(apart->at(t))) << "it is not known for these margins";
  EXPECT_GT(charts[1]->series(2)->at(t), 0.0);
  at(t);
  EXPECT_EQ(apart->at(t), 0.0) << "played again without a margin";
  EXPECT_TRUE(std::isnan(charts[1]->series(2)->at(t)));
}

}  // namespace state_words_test
}  // namespace abstand::ui
