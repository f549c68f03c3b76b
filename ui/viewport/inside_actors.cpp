// Shell points, tree spheres and a slice of the distance field of single bodies.
#include "ui/viewport/inside_actors.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <algorithm>
#include <cmath>

#include "ui/style/heat.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kCirclePoints = 20;
constexpr double kFarthestShade = 0.05;  // m: what is farther away has the colour of the farthest
const QColor kInsideBody(0xffb05090);    // negative distances

vtkSmartPointer<vtkPolyData> pointsOf(const BodyInside& inside) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Vector3f& p : inside.points) {
    const vtkIdType id = points->InsertNextPoint(p.x(), p.y(), p.z());
    cells->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

/// Three circles for each sphere.
vtkSmartPointer<vtkPolyData> spheresOf(const std::vector<BodyInside::Sphere>& spheres) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const BodyInside::Sphere& sphere : spheres)
    for (int normal = 0; normal < 3; ++normal) {
      cells->InsertNextCell(kCirclePoints + 1);
      vtkIdType first = -1;
      for (int k = 0; k < kCirclePoints; ++k) {
        const double angle = 2.0 * kPi * k / kCirclePoints;
        Vector3d p = sphere.centre.cast<double>();
        p[(normal + 1) % 3] += sphere.radius * std::cos(angle);
        p[(normal + 2) % 3] += sphere.radius * std::sin(angle);
        const vtkIdType id = points->InsertNextPoint(p.data());
        if (k == 0) first = id;
        cells->InsertCellPoint(id);
      }
      cells->InsertCellPoint(first);
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> sliceOf(const BodyInside::Slice& slice) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int row = 0; row < slice.rows; ++row)
    for (int column = 0; column < slice.columns; ++column) {
      const float distance = slice.distance[static_cast<std::size_t>(row * slice.columns + column)];
      if (std::isnan(distance)) continue;
      const Vector3f p =
          slice.corner + slice.cell * Vector3f(static_cast<float>(column), static_cast<float>(row), 0.0F);
      vtkIdType corners[4];
      for (int k = 0; k < 4; ++k)
        corners[k] = points->InsertNextPoint(p.x() + (k == 1 || k == 2 ? slice.cell : 0.0F),
                                             p.y() + (k >= 2 ? slice.cell : 0.0F), p.z());
      cells->InsertNextCell(4, corners);
      const double shade = std::min(1.0, std::abs(distance) / kFarthestShade);
      const QColor colour =
          distance < 0.0F ? kInsideBody.darker(100 + static_cast<int>(100.0 * shade)) : QColor(heat(shade));
      const unsigned char rgb[3]{static_cast<unsigned char>(colour.red()),
                                 static_cast<unsigned char>(colour.green()),
                                 static_cast<unsigned char>(colour.blue())};
      colours->InsertNextTypedTuple(rgb);
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colours);
  return data;
}

}  // namespace

void InsideActors::setSource(InsideOf source) {
  source_ = std::move(source);
  fresh_ = false;
}

void InsideActors::setView(InsideView view, int level) {
  view_ = view;
  level_ = level;
  fresh_ = false;
}

void InsideActors::clear() {
  for (const Item& item : items_) renderer_->RemoveActor(item.actor);
  items_.clear();
}

vtkSmartPointer<vtkActor> InsideActors::actorOf(const BodyInside& inside) const {
  vtkSmartPointer<vtkPolyData> data;
  if (view_ == InsideView::kPoints) data = pointsOf(inside);
  if (view_ == InsideView::kTree && !inside.levels.empty())
    data = spheresOf(
        inside.levels[std::min(static_cast<std::size_t>(std::max(0, level_)), inside.levels.size() - 1)]);
  if (view_ == InsideView::kSlice) data = sliceOf(inside.slice);
  if (!data) return nullptr;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(view_ == InsideView::kSlice);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  vtkProperty* look = actor->GetProperty();
  look->LightingOff();
  const QColor colour(view_ == InsideView::kPoints ? kAccent : kBlue);
  look->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  look->SetPointSize(3.0F);
  if (view_ == InsideView::kSlice) look->SetOpacity(0.8);
  return actor;
}

void InsideActors::add(int object) {
  const std::optional<BodyInside> inside = source_ ? source_(object) : std::nullopt;
  if (!inside) return;
  Item item{object, actorOf(*inside), vtkSmartPointer<vtkMatrix4x4>::New(), {}};
  if (!item.actor) return;
  item.actor->SetUserMatrix(item.pose);
  renderer_->AddActor(item.actor);
  items_.push_back(std::move(item));
}

bool InsideActors::refresh(const view::SceneSnapshot& snapshot, const std::vector<int>& chosen) {
  bool changed = false;
  if (!fresh_ || chosen != chosen_) {
    changed = !items_.empty();
    clear();
    chosen_ = chosen;
    fresh_ = true;
    if (view_ != InsideView::kNothing && chosen.size() <= kMaxBodies)
      for (const int object : chosen) add(object);
    changed |= !items_.empty();
  }
  for (Item& item : items_) {
    const Transform& X = snapshot.objects[static_cast<std::size_t>(item.object)].X_WB;
    if (!changed && X.matrix() == item.X_WB.matrix()) continue;
    item.X_WB = X;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) item.pose->SetElement(row, column, X.matrix()(row, column));
    changed = true;
  }
  return changed;
}

}  // namespace abstand::ui
