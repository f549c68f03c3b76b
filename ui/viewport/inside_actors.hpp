// Shell points, tree spheres and a slice of the distance field of single bodies. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/body_inside.hpp"

namespace abstand::ui {

/// Drawn over the bodies, which would hide them.
class InsideActors {
 public:
  static constexpr std::size_t kMaxBodies = 4;

  explicit InsideActors(vtkRenderer* front) : renderer_{front} {}
  ~InsideActors() { clear(); }

  void setSource(InsideOf source);
  /// `level`: of the tree; one that is not there: the finest.
  void setView(InsideView view, int level);
  InsideView view() const { return view_; }
  int level() const { return level_; }
  /// True when something looks different now. More bodies than kMaxBodies: none.
  bool refresh(const view::SceneSnapshot& snapshot, const std::vector<int>& chosen);
  /// Bodies that are drawn.
  std::size_t shown() const { return items_.size(); }

 private:
  struct Item {
    int object;
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkMatrix4x4> pose;
    Transform X_WB{Transform::Identity()};
  };
  void clear();
  void add(int object);
  vtkSmartPointer<vtkActor> actorOf(const BodyInside& inside) const;

  vtkRenderer* renderer_;
  InsideOf source_;
  InsideView view_{InsideView::kNothing};
  int level_{2};
  std::vector<int> chosen_;
  bool fresh_{true};  // chosen_ and view_ are drawn
  std::vector<Item> items_;
};

}  // namespace abstand::ui
