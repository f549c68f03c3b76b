// The shadows of all objects on the floor.
#include "ui/viewport/shadows.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace abstand::ui {

namespace {

constexpr double kShadowLift = 0.002;  // m above the floor
// Where the key light comes from, per metre of height.
constexpr double kLightX = -0.12, kLightY = -0.40;

}  // namespace

Shadows::Shadows(vtkRenderer* renderer) : renderer_{renderer}, actor_{vtkSmartPointer<vtkActor>::New()} {
  actor_->GetProperty()->LightingOff();
  actor_->PickableOff();
  renderer_->AddActor(actor_);
}

Shadows::~Shadows() { renderer_->RemoveActor(actor_); }

void Shadows::open(const std::vector<vtkSmartPointer<vtkPolyData>>& shapes) {
  shadows_.assign(shapes.size(), {});
  points_ = vtkSmartPointer<vtkPoints>::New();
  points_->SetDataTypeToFloat();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> corners;
  vtkIdType first = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    vtkPolyData* shape = shapes[i];
    const vtkIdType n = shape->GetNumberOfPoints();
    shadows_[i].first = first;
    shadows_[i].p_B.resize(3, n);
    for (vtkIdType k = 0; k < n; ++k) shadows_[i].p_B.col(k) = Vector3d(shape->GetPoint(k)).cast<float>();
    vtkCellArray* polys = shape->GetPolys();
    for (vtkIdType cell = 0; cell < polys->GetNumberOfCells(); ++cell) {
      polys->GetCellAtId(cell, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) corners->SetId(k, first + corners->GetId(k));
      cells->InsertNextCell(corners);
    }
    first += n;
  }
  points_->SetNumberOfPoints(first);
  for (const Shadow& shadow : shadows_) cast(shadow);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  actor_->SetMapper(mapper);
}

void Shadows::setColour(const QColor& c) { actor_->GetProperty()->SetColor(c.redF(), c.greenF(), c.blueF()); }

void Shadows::setFloorHeight(double z) {
  floor_ = z;
  for (const Shadow& shadow : shadows_) cast(shadow);
  if (points_) points_->Modified();
}

bool Shadows::set(std::size_t object, const Transform& X_WB, bool visible) {
  Shadow& shadow = shadows_[object];
  const bool moved = visible && shadow.X_WB.matrix() != X_WB.matrix();
  if (!moved && shadow.visible == visible) return false;
  shadow.X_WB = X_WB;
  shadow.visible = visible;
  cast(shadow);
  points_->Modified();
  return true;
}

void Shadows::setShown(bool shown) { actor_->SetVisibility(shown); }

/// Slanting projection onto the floor along the key light; what casts none shrinks to a point.
void Shadows::cast(const Shadow& shadow) {
  if (shadow.p_B.cols() == 0) return;
  auto* out = static_cast<vtkFloatArray*>(points_->GetData())->GetPointer(3 * shadow.first);
  Eigen::Map<Eigen::Matrix3Xf> p_W(out, 3, shadow.p_B.cols());
  if (!shadow.visible) {
    p_W.colwise() = Eigen::Vector3f(0.0F, 0.0F, static_cast<float>(floor_));
    return;
  }
  Matrix3d flat = Matrix3d::Identity();
  flat(0, 2) = -kLightX;
  flat(1, 2) = -kLightY;
  flat(2, 2) = 0.0;
  const Vector3d shift(kLightX * floor_, kLightY * floor_, floor_ + kShadowLift);
  const Eigen::Matrix3f turn = (flat * shadow.X_WB.linear()).cast<float>();
  const Eigen::Vector3f origin = (flat * shadow.X_WB.translation() + shift).cast<float>();
  p_W.noalias() = turn * shadow.p_B;
  p_W.colwise() += origin;
}

}  // namespace abstand::ui
