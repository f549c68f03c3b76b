// What is selected: where it is, how near, how fast, how it is made; joints, places and people can be
// changed.
#pragma once

#include <QWidget>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/document/work.hpp"
#include "ui/model/inspected_rows.hpp"

class QLabel;
class QScrollArea;
class QTreeWidget;

namespace abstand::ui {

class JointEditor;
class PersonEditor;
class PlacementEditor;

/// Shows one moment, the one that is drawn. A hidden panel takes no time. GUI thread only.
class InspectorPanel : public QWidget {
  Q_OBJECT

 public:
  explicit InspectorPanel(QWidget* parent = nullptr);

  /// The outline must live until the next open().
  void open(const view::SceneOutline& outline);
  /// What the selection holds now.
  void setSubject(const std::vector<int>& objects, int pair);
  /// What the document says of robots that are posed by hand, of people, and of places.
  void setWork(const Work& work);
  /// Nothing is refreshed while it is not in front.
  void setInFront(bool in_front) { in_front_ = in_front; }
  void refresh(const view::SceneSnapshot& snapshot);

  const InspectedSubject& subject() const { return subject_; }
  /// SceneSnapshot::step that is shown; -1: none.
  long shownStep() const { return shown_step_; }
  QTreeWidget* rows() const { return rows_; }
  JointEditor* joints() const { return joints_; }
  PersonEditor* person() const { return person_; }
  PlacementEditor* placement() const { return placement_; }
  QLabel* title() const { return title_; }

 private:
  void showEditors();
  void openPlacement();
  void showPlacement();

  const view::SceneOutline* outline_;
  Work work_;
  InspectedSubject subject_;
  std::vector<InspectedRow> shown_;
  bool in_front_{false};
  long shown_step_{-1};
  QLabel* title_;
  QTreeWidget* rows_;
  JointEditor* joints_;
  PersonEditor* person_;
  PlacementEditor* placement_;
  Transform X_thing_{Transform::Identity()};  ///< of the selected object of the room, as it is shown
  QScrollArea *joints_area_, *editors_area_;  ///< of joints; of place and person
};

}  // namespace abstand::ui
