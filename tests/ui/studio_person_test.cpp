// A person is rebuilt while everything else stays.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTreeWidget>

#include "app/studio/body_previews.hpp"
#include "app/studio/scene_of_work.hpp"
#include "humanmodel/population.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/body_view.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::studio {
namespace studio_person_test {

using ui::ActionId;

struct StudioPerson : StudioWindow {
  void SetUp() override {
    ASSERT_TRUE(opens([&] { window.openFile(in("scene.yaml")); })) << problem;
    window.document().edit("work", [](ui::Work& work) { work.margins["anna/torso"] = 0.25; });
    window.actions()[ActionId::kTop]->trigger();
    camera = window.viewport().cameraView();
    window.selection().setObjects({2});
    window.panels().inspector->setInFront(true);
  }
  void expectTheRest() {
    EXPECT_EQ(work().margins.value("anna/torso"), 0.25);
    EXPECT_EQ(window.viewport().cameraView(), camera);
    EXPECT_EQ(window.selection().objects(), std::vector<int>{2});
  }
  /// As the inspector has it.
  QString stature() {
    std::vector<int> parts(14);
    for (int i = 0; i < 14; ++i) parts[static_cast<std::size_t>(i)] = i;
    window.selection().setObjects(parts);
    const QTreeWidget* rows = window.panels().inspector->rows();
    QString found;
    for (int i = 0; i < rows->topLevelItemCount(); ++i)
      if (rows->topLevelItem(i)->text(0) == "Stature") found = rows->topLevelItem(i)->text(1);
    window.selection().setObjects({2});
    return found;
  }
  void tick(const char* field, double value) {
    auto* editor = window.panels().inspector->person();
    auto* on = editor->findChild<QCheckBox*>(QString::fromLatin1(field) + "_on");
    if (!on->isChecked()) on->click();
    editor->findChild<QDoubleSpinBox*>(field)->setValue(value);
  }
  bool rebuilds() {
    return opens(
        [&] { window.panels().inspector->person()->findChild<QPushButton*>("rebuild_person")->click(); });
  }
  ui::CameraView camera;
};

TEST_F(StudioPerson, DrawsPersonOfTheFieldsBesideSmallAndLargeOnes) {
  auto* view = window.panels().inspector->person()->findChild<ui::BodyView*>("body_view");
  ASSERT_TRUE(view->isVisible());
  EXPECT_TRUE(view->text().startsWith("This person: 1.75 m")) << view->text().toStdString();
  const double small = humanmodel::statureOfPercentile(5.0, humanmodel::Sex::kFemale),
               large = humanmodel::statureOfPercentile(95.0, humanmodel::Sex::kMale);
  EXPECT_TRUE(view->text().contains("Woman, 5th percentile: " + ui::fixed(small, 2) + " m"));
  EXPECT_TRUE(view->text().contains("Man, 95th percentile: " + ui::fixed(large, 2) + " m"));
  const QImage before = view->grab().toImage();
  tick("stature", 1.95);
  EXPECT_TRUE(view->text().startsWith("This person: 1.95 m")) << "before the person is built";
  EXPECT_NE(view->grab().toImage(), before);
  tick("mass", 300.0);
  tick("stature", 1.2);
  EXPECT_TRUE(view->text().contains("mass")) << view->text().toStdString();
  EXPECT_EQ(stature(), "1.750 m");
}

TEST(BodyPreview, PartsReachFromFloorToStature) {
  ui::PersonOptions options;
  options.stature = 1.6;
  const ui::BodyPreview preview = bodyPreview({}, options);
  EXPECT_EQ(preview.person.patches.size(), humanmodel::kBodyPartCount);
  for (const ui::BodyShape* shape : {&preview.person, &preview.smallest, &preview.largest}) {
    double top = 0.0, bottom = 1.0;
    for (const ui::BodyPatch& patch : shape->patches) {
      top = std::max(top, patch.centre.z() + patch.half.z());
      bottom = std::min(bottom, patch.centre.z() - patch.half.z());
    }
    // Ellipsoids of the model extend beyond their joints by up to 2 cm.
    EXPECT_NEAR(top, shape->stature, 0.02);
    EXPECT_NEAR(bottom, 0.0, 0.02);
  }
  EXPECT_EQ(preview.person.stature, 1.6);
}

TEST_F(StudioPerson, ChangingStatureKeepsOtherStateAndIsUndone) {
  EXPECT_EQ(stature(), "1.750 m");
  window.actions()[ActionId::kLoop]->setChecked(true);
  window.playback().setPlaying(true);
  tick("stature", 1.95);
  ASSERT_TRUE(rebuilds()) << problem;
  EXPECT_EQ(stature(), "1.950 m");
  EXPECT_EQ(work().people.value("anna").stature, 1.95);
  EXPECT_FALSE(work().people.value("anna").mass);
  expectTheRest();
  EXPECT_TRUE(QTest::qWaitFor([&] { return window.moment().playing; }, kLoadMs));
  EXPECT_TRUE(window.playback().playing());
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_EQ(stature(), "1.750 m");
  EXPECT_TRUE(work().people.isEmpty());
  expectTheRest();
  EXPECT_TRUE(QTest::qWaitFor([&] { return window.moment().playing; }, kLoadMs));
}

TEST_F(StudioPerson, PausedMomentIsKept) {
  window.playback().seek(0.7);
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.moment().t - 0.7) < 0.06; }, kLoadMs));
  const double t = window.playback().time();
  tick("percentile", 95.0);
  ASSERT_TRUE(rebuilds()) << problem;
  EXPECT_FALSE(window.playback().playing());
  EXPECT_NEAR(window.playback().time(), t, 1e-9);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.moment().t - t) < 1e-9; }, kLoadMs));
  // Taken away again: as in the scene.
  window.panels().inspector->person()->findChild<QCheckBox*>("percentile_on")->click();
  ASSERT_TRUE(rebuilds()) << problem;
  EXPECT_TRUE(work().people.isEmpty());
}

TEST_F(StudioPerson, ImplausiblePersonChangesNothing) {
  tick("stature", 2.4);
  tick("mass", 12.0);
  EXPECT_FALSE(rebuilds());
  EXPECT_FALSE(problem.empty());
  EXPECT_TRUE(work().people.isEmpty());
  EXPECT_EQ(stature(), "1.750 m");
  expectTheRest();
}

TEST_F(StudioPerson, ProjectRestoresPerson) {
  tick("stature", 1.6);
  tick("mass", 70.0);
  ASSERT_TRUE(rebuilds()) << problem;
  ui::writeProject(window.document().project(), in("p.abstand"));
  window.document().setSaved(in("p.abstand"));
  Q_EMIT window.closeRequested();
  ASSERT_TRUE(opens([&] { window.openFile(in("p.abstand")); })) << problem;
  EXPECT_EQ(stature(), "1.600 m");
  EXPECT_EQ(work().people.value("anna").mass, 70.0);
}

TEST_F(StudioPerson, AddedPairIsCheckedAndUndone) {
  const std::size_t before = window.moment().pairs.size();
  ASSERT_TRUE(opens([&] {
    window.document().edit("add", [](ui::Work& work) {
      work.added = {{"anna/head", "anna/foot_left"}, {"anna/head", "nobody"}};
    });
  })) << problem;
  EXPECT_EQ(window.moment().pairs.size(), before + 1);
  expectTheRest();
  ASSERT_TRUE(opens([&] { window.actions()[ActionId::kUndo]->trigger(); })) << problem;
  EXPECT_EQ(window.moment().pairs.size(), before);
  expectTheRest();
}

TEST(SceneOfWork, AppliesPeopleAndReadingOptions) {
  scene_file::SceneDescription scene;
  scene.humans.resize(2);
  scene.humans[0].name = "anna";
  scene.humans[1].name = "ben";
  scene.humans[1].body.percentile = 5.0;
  ui::Work work;
  EXPECT_FALSE(changesScene(work));
  work.people["anna"] = {1.7, std::nullopt, 64.0, "f"};
  work.people["nobody"] = {2.0, std::nullopt, std::nullopt, {}};
  work.reading.units = "cm";
  EXPECT_TRUE(changesScene(work));
  applyWork(work, scene);
  EXPECT_EQ(scene.humans[0].body.height, 1.7);
  EXPECT_EQ(scene.humans[0].body.mass, 64.0);
  EXPECT_EQ(scene.humans[0].body.sex, humanmodel::Sex::kFemale);
  EXPECT_FALSE(scene.humans[0].body.percentile);
  EXPECT_EQ(scene.humans[1].body.percentile, 5.0);
  EXPECT_FALSE(scene.humans[1].body.height);
  EXPECT_EQ(scene.humans[1].recording.options.units, "cm");
}

}  // namespace studio_person_test
}  // namespace abstand::studio
