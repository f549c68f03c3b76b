// Many arrows of one kind in one actor. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// Points and triangles for all arrows are made once; a frame writes the points of those in use. Straight
/// arrows keep the proportions of their heads at any length; curved ones turn right-handed about their axis.
class ArrowBatch {
 public:
  enum class Shape { kStraight, kCurved };

  ArrowBatch(Shape shape, int capacity, vtkRenderer* renderer);
  ~ArrowBatch();
  ArrowBatch(const ArrowBatch&) = delete;
  ArrowBatch& operator=(const ArrowBatch&) = delete;

  void setColour(const QColor& colour);
  void begin();
  /// Straight: from p_W along `direction` (unit), `length` m, shaft of `radius` m. Curved: three quarters of
  /// a turn about `direction`, of radius `length`. Beyond the capacity arrows are left out.
  void add(const Vector3d& p_W, const Vector3d& direction, double length, double radius);
  /// True when the arrows differ from those before.
  bool finish();

 private:
  struct Vertex {
    Vector3d by_radius, by_length, by_head;  // position = sum of each times its length
    Vector3d normal;
  };

  void makeStraight();
  void makeCurved();
  void ring(double shaft_radius, double length, double head, const Vector3d& slope);
  void band(int first, int second);

  int capacity_;
  int used_{0}, shown_{0};
  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkFloatArray> normals_;
  vtkSmartPointer<vtkActor> actor_;
  vtkRenderer* renderer_;
};

}  // namespace abstand::ui
