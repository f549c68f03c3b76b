#include "ui/viewport/cloud_actor.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace abstand::ui {

CloudActor::CloudActor(vtkRenderer* renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  actor_->VisibilityOff();
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetPointSize(2.5F);
  renderer->AddActor(actor_);
}

void CloudActor::show(const std::vector<CloudPoint>& points, CloudColours colours) {
  actor_->SetVisibility(!points.empty());
  colours_ = colours;
  drawn_.clear();
  for (const CloudPoint& point : points) drawn_.insert(colourOf(point, colours));
  const auto count = static_cast<vtkIdType>(points.size());
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(count);
  float* place = places->GetPointer(0);
  unsigned char* colour = rgb->GetPointer(0);
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(1, count);
  cells->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    const CloudPoint& point = points[static_cast<std::size_t>(i)];
    const QRgb of = colourOf(point, colours);
    for (int k = 0; k < 3; ++k) *place++ = point.p_W[k];
    *colour++ = static_cast<unsigned char>(qRed(of));
    *colour++ = static_cast<unsigned char>(qGreen(of));
    *colour++ = static_cast<unsigned char>(qBlue(of));
    cells->InsertCellPoint(i);
  }
  vtkNew<vtkPoints> vertices;
  vertices->SetData(places);
  data_->SetPoints(vertices);
  data_->SetVerts(cells);
  data_->GetPointData()->SetScalars(rgb);
  data_->Modified();
}

bool CloudActor::has(const CloudPoint& point) const { return drawn_.contains(colourOf(point, colours_)); }

std::size_t CloudActor::shown() const {
  return actor_->GetVisibility() ? static_cast<std::size_t>(data_->GetNumberOfPoints()) : 0;
}

}  // namespace abstand::ui
