// One actor an object, made when a scene opens; a frame only changes matrices and colours. VTK: .cpp files
// only.
#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <vector>

#include "core/scene/snapshot.hpp"
#include "ui/theme.hpp"
#include "ui/viewport/view_options.hpp"

namespace abstand::ui {

class Selection;

/// Drawn so that the state is seen without colour too: contact has an outline, a lost pose is hollow.
class ObjectActors {
 public:
  /// Bodies and outlines into `renderer`, shadows into `back`.
  ObjectActors(vtkRenderer* renderer, vtkRenderer* back) : renderer_{renderer}, back_{back} {}

  void open(const SceneOutline& outline, Theme theme);
  void setTheme(Theme theme);
  /// True when something looks different now.
  bool refresh(const SceneSnapshot& snapshot, const Selection& selection, const ViewOptions& options);
  void setVisible(int object, bool visible);
  void setFloorHeight(double z) { floor_ = z; }

  /// World box of what is visible, of the chosen objects where there are any.
  Bounds bounds(const std::vector<int>& only = {}) const;
  /// Nearest visible object under a display position (physical pixels from the lower left corner), -1 for
  /// none.
  int pick(double x, double y) const;

 private:
  struct Item {
    vtkSmartPointer<vtkActor> body, outline, shadow;
    vtkSmartPointer<vtkMatrix4x4> pose, shadow_pose;
    QColor colour;
    bool human{false};
    bool visible{true};
  };

  static vtkSmartPointer<vtkActor> addActor(vtkRenderer* renderer, vtkPolyData* data, vtkMatrix4x4* pose);
  bool place(Item& item, const Transform& X_WB);
  bool paint(Item& item, const ObjectSnapshot& now, bool chosen, const ViewOptions& options);

  vtkRenderer* renderer_;
  vtkRenderer* back_;
  std::vector<Item> items_;
  std::vector<SceneOutline::ObjectInfo> infos_;
  Theme theme_{Theme::kLight};
  double floor_{0.0};
};

}  // namespace abstand::ui
