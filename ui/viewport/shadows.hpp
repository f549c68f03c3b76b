// The shadows of all objects on the floor, in one actor. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// The triangles of all objects, put together once; a frame moves the points of those objects that moved.
class Shadows {
 public:
  explicit Shadows(vtkRenderer* renderer);
  ~Shadows();

  /// A shape for each object, in its body frame.
  void open(const std::vector<vtkSmartPointer<vtkPolyData>>& shapes);
  void setColour(const QColor& colour);
  /// m; the shadows lie just above it.
  void setFloorHeight(double z);
  /// No shadow of this object where it is not visible. True when that is new.
  bool set(std::size_t object, const Transform& X_WB, bool visible);
  /// All of them, whatever their objects are.
  void setShown(bool shown);

 private:
  struct Shadow {
    Eigen::Matrix3Xf p_B;
    vtkIdType first{0};
    Transform X_WB{Transform::Identity()};
    bool visible{false};
  };
  void cast(const Shadow& shadow);

  vtkRenderer* renderer_;
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkPoints> points_;
  std::vector<Shadow> shadows_;
  double floor_{0.0};
};

}  // namespace abstand::ui
