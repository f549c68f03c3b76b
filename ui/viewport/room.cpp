// Floor, grid, background and light.
#include "ui/viewport/room.hpp"

#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::ui {

namespace {

constexpr double kCell = 0.5;    // m between lines
constexpr double kPiece = 0.25;  // m, pieces of a line between which it fades
constexpr int kSpokes = 64;
constexpr double kMinRadius = 3.0;   // m
constexpr double kMaxRadius = 30.0;  // m

/// Coloured points and cells under construction.
struct Sheet {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  Sheet() { colours->SetNumberOfComponents(4); }
  vtkIdType add(double x, double y, const QColor& c, double alpha) {
    const double rgba[4]{static_cast<double>(c.red()), static_cast<double>(c.green()),
                         static_cast<double>(c.blue()), 255.0 * alpha};
    colours->InsertNextTuple(rgba);
    return points->InsertNextPoint(x, y, 0.0);
  }
};

/// 1 in the middle, 0 at the edge, level at both.
double fade(double r, double radius) {
  const double f = std::clamp((r / radius - 0.35) / 0.65, 0.0, 1.0);
  return 1.0 - f * f * (3.0 - 2.0 * f);
}

void addLine(Sheet& sheet, double radius, double offset, bool along_x, const QColor& colour,
             double strength) {
  const double half = std::sqrt(std::max(0.0, radius * radius - offset * offset));
  const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * half / kPiece)));
  vtkIdType before = -1;
  for (int k = 0; k <= pieces; ++k) {
    const double s = -half + 2.0 * half * k / pieces;
    const double alpha = strength * fade(std::hypot(s, offset), radius);
    const vtkIdType here =
        along_x ? sheet.add(s, offset, colour, alpha) : sheet.add(offset, s, colour, alpha);
    if (before >= 0) {
      const vtkIdType ends[2]{before, here};
      sheet.cells->InsertNextCell(2, ends);
    }
    before = here;
  }
}

void show(vtkActor* actor, Sheet& sheet, bool lines) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(sheet.points);
  if (lines)
    data->SetLines(sheet.cells);
  else
    data->SetPolys(sheet.cells);
  data->GetPointData()->SetScalars(sheet.colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
}

}  // namespace

Room::Room(vtkRenderer* back, vtkRenderer* bodies)
    : renderer_{back}, floor_{vtkSmartPointer<vtkActor>::New()}, grid_{vtkSmartPointer<vtkActor>::New()} {
  for (const auto& actor : {floor_, grid_}) {
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->ForceTranslucentOn();
    renderer_->AddActor(actor);
  }
  bodies->AutomaticLightCreationOff();
  bodies->RemoveAllLights();

  vtkNew<vtkLight> key;
  key->SetLightTypeToSceneLight();
  key->SetPosition(-1.2, -4.0, 10.0);
  key->SetFocalPoint(0.0, 0.0, 0.0);
  key->SetIntensity(0.55);
  bodies->AddLight(key);
  vtkNew<vtkLight> head;
  head->SetLightTypeToCameraLight();
  head->SetPosition(0.35, 0.35, 1.0);
  head->SetIntensity(0.62);
  bodies->AddLight(head);
  setTheme(Theme::kLight);
}

void Room::setTheme(Theme theme) {
  theme_ = theme;
  apply();
  build();
}

void Room::setVisible(bool visible) {
  visible_ = visible;
  apply();
}

void Room::setLeftOut(bool left_out) {
  left_out_ = left_out;
  apply();
}

void Room::apply() {
  const SceneColours colours = sceneColours(theme_);
  const QColor bottom = left_out_ ? QColor(Qt::black) : colours.sky_bottom;
  renderer_->SetGradientBackground(!left_out_);
  renderer_->SetBackgroundAlpha(left_out_ ? 0.0 : 1.0);
  renderer_->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  renderer_->SetBackground2(colours.sky_top.redF(), colours.sky_top.greenF(), colours.sky_top.blueF());
  floor_->SetVisibility(visible_ && !left_out_);
  grid_->SetVisibility(visible_ && !left_out_);
}

void Room::fitTo(const geometry::Bounds& box) {
  if (!(box.upper.x() >= box.lower.x())) return;
  height_ = std::min(0.0, box.lower.z());
  const Vector3d reach = box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs());
  radius_ = std::clamp(2.2 * std::max(reach.x(), reach.y()), kMinRadius, kMaxRadius);
  build();
}

void Room::build() {
  const SceneColours colours = sceneColours(theme_);
  Sheet floor;
  const std::array<double, 6> rings{0.0, 0.35, 0.5, 0.65, 0.8, 1.0};
  for (const double r : rings)
    for (int k = 0; k < kSpokes; ++k) {
      const double a = 2.0 * kPi * k / kSpokes;
      floor.add(r * radius_ * std::cos(a), r * radius_ * std::sin(a), colours.floor,
                fade(r * radius_, radius_));
    }
  for (int ring = 0; ring + 1 < static_cast<int>(rings.size()); ++ring)
    for (int k = 0; k < kSpokes; ++k) {
      const int next = (k + 1) % kSpokes;
      const vtkIdType quad[4]{ring * kSpokes + k, (ring + 1) * kSpokes + k, (ring + 1) * kSpokes + next,
                              ring * kSpokes + next};
      floor.cells->InsertNextCell(4, quad);
    }
  show(floor_, floor, false);
  floor_->SetPosition(0.0, 0.0, height_);

  Sheet grid;
  const int lines = static_cast<int>(radius_ / kCell);
  for (int k = -lines; k <= lines; ++k) {
    const QColor colour = k == 0 ? colours.grid.darker(125) : colours.grid;
    const double strength = k == 0 ? 1.0 : k % 2 == 0 ? 0.75 : 0.35;
    addLine(grid, radius_, k * kCell, true, colour, strength);
    addLine(grid, radius_, k * kCell, false, colour, strength);
  }
  show(grid_, grid, true);
  // Between floor and shadows.
  grid_->SetPosition(0.0, 0.0, height_ + 0.001);
}

}  // namespace abstand::ui
