// Floor, grid, background and light. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "core/geometry/triangle_mesh.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

/// A round floor that fades into the background, lines every half metre, axes through the origin.
class Room {
 public:
  /// Background, floor and grid in `back`, light also in `bodies`.
  Room(vtkRenderer* back, vtkRenderer* bodies);
  void setTheme(Theme theme);
  void setVisible(bool visible);
  /// Nothing at all, for a picture that is laid over another one.
  void setLeftOut(bool left_out);
  /// Floor below everything in `box`, but no higher than z = 0; wide enough for it.
  void fitTo(const geometry::Bounds& box);
  double floorHeight() const { return height_; }

 private:
  void build();
  void apply();

  vtkRenderer* renderer_;
  vtkSmartPointer<vtkActor> floor_, grid_;
  Theme theme_{Theme::kLight};
  bool visible_{true}, left_out_{false};
  double height_{0.0};
  double radius_{4.0};
};

}  // namespace abstand::ui
