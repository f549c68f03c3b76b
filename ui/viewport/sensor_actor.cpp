#include "ui/viewport/sensor_actor.hpp"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <QColor>

#include "ui/style/theme.hpp"

namespace abstand::ui {

SensorActor::SensorActor(vtkRenderer* renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  actor_->VisibilityOff();
  const QColor colour(kAccent);
  actor_->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetLineWidth(1.6F);
  renderer->AddActor(actor_);
}

void SensorActor::show(const Transform& X_W, const SensorKind& kind) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto add = [&](const Vector3d& p) { points->InsertNextPoint(p.x(), p.y(), p.z()); };
  const auto line = [&](vtkIdType a, vtkIdType b) {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(a);
    lines->InsertCellPoint(b);
  };
  std::size_t k = 0;
  for (const double z : {kind.nearest, kind.farthest})
    for (const auto& [x, y] : {std::pair(kind.left, kind.top), std::pair(kind.right, kind.top),
                               std::pair(kind.right, kind.bottom), std::pair(kind.left, kind.bottom)})
      corners_[k++] = X_W * Vector3d(x * z, y * z, z);
  for (const Vector3d& corner : corners_) add(corner);
  add(X_W.translation());
  for (vtkIdType i = 0; i < 4; ++i) {
    line(i, (i + 1) % 4);
    line(4 + i, 4 + (i + 1) % 4);
    line(i, 4 + i);
    line(8, i);
  }
  data_->SetPoints(points);
  data_->SetLines(lines);
  data_->Modified();
  actor_->VisibilityOn();
}

void SensorActor::hide() { actor_->VisibilityOff(); }

}  // namespace abstand::ui
