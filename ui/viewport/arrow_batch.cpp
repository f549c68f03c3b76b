// Many arrows of one kind in one actor.
#include "ui/viewport/arrow_batch.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/turn_between.hpp"

namespace abstand::ui {

namespace {

constexpr int kSides = 14;  // around the shaft
constexpr int kArcSteps = 28;
constexpr double kArc = 1.5 * kPi;   // three quarters of a turn
constexpr double kTube = 0.075;      // of the arc's radius
constexpr double kHeadWidth = 2.4;   // of the shaft's radius
constexpr double kHeadLength = 6.0;  // of the shaft's radius

double sideAngle(int k) { return 2.0 * kPi * k / kSides; }

}  // namespace

ArrowBatch::ArrowBatch(Shape shape, int capacity, vtkRenderer* renderer)
    : capacity_{capacity}, renderer_{renderer} {
  if (shape == Shape::kStraight)
    makeStraight();
  else
    makeCurved();
  const auto n = static_cast<vtkIdType>(vertices_.size());
  points_ = vtkSmartPointer<vtkPoints>::New();
  points_->SetDataTypeToFloat();
  points_->SetNumberOfPoints(n * capacity);
  normals_ = vtkSmartPointer<vtkFloatArray>::New();
  normals_->SetNumberOfComponents(3);
  normals_->SetNumberOfTuples(n * capacity);
  normals_->Fill(0.0);
  vtkNew<vtkCellArray> cells;
  for (int a = 0; a < capacity; ++a)
    for (const auto& t : triangles_) {
      const vtkIdType corners[3]{a * n + t[0], a * n + t[1], a * n + t[2]};
      cells->InsertNextCell(3, corners);
    }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  actor_ = vtkSmartPointer<vtkActor>::New();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetAmbient(0.35);
  actor_->GetProperty()->SetDiffuse(0.7);
  actor_->PickableOff();
  actor_->VisibilityOff();
  renderer_->AddActor(actor_);
}

ArrowBatch::~ArrowBatch() { renderer_->RemoveActor(actor_); }

void ArrowBatch::setColour(const QColor& c) {
  actor_->GetProperty()->SetColor(c.redF(), c.greenF(), c.blueF());
}

void ArrowBatch::ring(double shaft_radius, double length, double head, const Vector3d& slope) {
  for (int k = 0; k < kSides; ++k) {
    const Vector3d out(std::cos(sideAngle(k)), std::sin(sideAngle(k)), 0.0);
    vertices_.push_back({shaft_radius * out, length * Vector3d::UnitZ(), head * Vector3d::UnitZ(),
                         (slope.x() * out + slope.z() * Vector3d::UnitZ()).normalized()});
  }
}

void ArrowBatch::band(int first, int second) {
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    triangles_.push_back({first + k, first + next, second + next});
    triangles_.push_back({first + k, second + next, second + k});
  }
}

void ArrowBatch::makeStraight() {
  const Vector3d outwards(1, 0, 0), back(0, 0, -1), cone(kHeadLength, 0, kHeadWidth);
  ring(0.0, 0.0, 0.0, back);  // end of the shaft
  ring(1.0, 0.0, 0.0, back);
  ring(1.0, 0.0, 0.0, outwards);  // shaft
  ring(1.0, 1.0, -1.0, outwards);
  ring(1.0, 1.0, -1.0, back);  // back of the head
  ring(kHeadWidth, 1.0, -1.0, back);
  ring(kHeadWidth, 1.0, -1.0, cone);  // head
  ring(0.0, 1.0, 0.0, cone);
  for (const int first : {0, 2, 4, 6}) band(first * kSides, (first + 1) * kSides);
}

void ArrowBatch::makeCurved() {
  // A tube along the arc, then a cone along its tangent; all lengths are shares of the arc's radius.
  const auto ringAt = [&](double angle, double along, double radius, double slope_along) {
    const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    const Vector3d tangent(-std::sin(angle), std::cos(angle), 0.0);
    for (int k = 0; k < kSides; ++k) {
      const Vector3d side = std::cos(sideAngle(k)) * out - std::sin(sideAngle(k)) * Vector3d::UnitZ();
      vertices_.push_back({Vector3d::Zero(), out + along * tangent + radius * side, Vector3d::Zero(),
                           (side + slope_along * tangent).normalized()});
    }
  };
  for (int step = 0; step <= kArcSteps; ++step) ringAt(kArc * step / kArcSteps, 0.0, kTube, 0.0);
  for (int step = 0; step < kArcSteps; ++step) band(step * kSides, (step + 1) * kSides);
  const int head = (kArcSteps + 1) * kSides;
  constexpr double kSteep = -100.0;  // normal of the head's back, all but along the tangent
  ringAt(kArc, 0.0, kTube, kSteep);
  ringAt(kArc, 0.0, kHeadWidth * kTube, kSteep);
  ringAt(kArc, 0.0, kHeadWidth * kTube, kHeadWidth / kHeadLength);
  ringAt(kArc, kHeadLength * kTube, 0.0, kHeadWidth / kHeadLength);
  band(head, head + kSides);
  band(head + 2 * kSides, head + 3 * kSides);
}

void ArrowBatch::begin() { used_ = 0; }

void ArrowBatch::add(const Vector3d& p_W, const Vector3d& direction, double length, double radius) {
  if (used_ == capacity_ || !p_W.allFinite() || !direction.allFinite()) return;
  const Matrix3d R = turnBetween(Vector3d::UnitZ(), direction).toRotationMatrix();
  const double head = std::min(kHeadLength * radius, 0.6 * length);
  const double shaft = head / kHeadLength;  // short arrows are thin too
  auto at = static_cast<vtkIdType>(vertices_.size()) * used_;
  for (const Vertex& v : vertices_) {
    const Vector3d p = p_W + R * (shaft * v.by_radius + length * v.by_length + head * v.by_head);
    const Vector3d n = R * v.normal;
    points_->SetPoint(at, p.data());
    normals_->SetTuple(at, n.data());
    ++at;
  }
  ++used_;
}

bool ArrowBatch::finish() {
  if (used_ == 0 && shown_ == 0) return false;
  // What is not in use collapses into the first arrow's first point.
  const auto n = static_cast<vtkIdType>(vertices_.size());
  if (used_ > 0) {
    double p[3];
    points_->GetPoint(0, p);
    for (vtkIdType i = n * used_; i < n * capacity_; ++i) points_->SetPoint(i, p);
  }
  points_->Modified();
  normals_->Modified();
  actor_->SetVisibility(used_ > 0);
  shown_ = used_;
  return true;
}

}  // namespace abstand::ui
