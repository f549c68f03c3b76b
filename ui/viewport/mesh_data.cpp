// Triangle meshes as VTK draws them.
#include "ui/viewport/mesh_data.hpp"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>

namespace abstand::ui {

namespace {

constexpr std::size_t kTriangleBudget = 60000;  // more cost too much where the processor draws
constexpr double kFeatureAngle = 35.0;          // degrees; sharper edges are drawn sharp
constexpr vtkIdType kWholeBelow = 1000;         // triangles
constexpr vtkIdType kCoarseShadowAbove = 500;   // triangles
constexpr int kShadowCells = 24;                // along the longest side
constexpr double kOutline = 0.006;              // m
constexpr double kOutlineShare = 0.06;          // of the object's size, for small ones

vtkSmartPointer<vtkPolyData> toPolyData(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                       static_cast<vtkIdType>(3 * mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const vtkIdType corners[3]{triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* data, bool split) {
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(data);
  filter->SetSplitting(split);
  filter->SetFeatureAngle(kFeatureAngle);
  filter->ConsistencyOff();
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> blownUp(vtkPolyData* clean) {
  vtkSmartPointer<vtkPolyData> hull = withNormals(clean, false);
  vtkDataArray* normals = hull->GetPointData()->GetNormals();
  if (!normals) return hull;
  const double by = std::min(kOutline, kOutlineShare * clean->GetLength());
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(hull->GetPoints());
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i) {
    const Vector3d p = Vector3d(moved->GetPoint(i)) + by * Vector3d(normals->GetTuple3(i));
    moved->SetPoint(i, p.data());
  }
  hull->SetPoints(moved);
  return hull;
}

/// `keep`: share of the triangles to keep, 1 for all; small meshes are kept whole.
MeshData makeMeshData(const geometry::TriangleMesh& mesh, double keep) {
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(toPolyData(mesh));
  clean->ConvertPolysToLinesOff();
  clean->Update();
  vtkSmartPointer<vtkPolyData> shape = clean->GetOutput();
  if (keep < 1.0 && shape->GetNumberOfPolys() > kWholeBelow) {
    vtkNew<vtkQuadricDecimation> fewer;
    fewer->SetInputData(shape);
    fewer->SetTargetReduction(1.0 - keep);
    fewer->Update();
    shape = fewer->GetOutput();
  }
  MeshData data;
  data.surface = withNormals(shape, true);
  data.hull = blownUp(shape);
  data.shadow = data.surface;
  if (shape->GetNumberOfPolys() > kCoarseShadowAbove) {
    vtkNew<vtkQuadricClustering> coarse;
    coarse->SetInputData(shape);
    coarse->SetNumberOfDivisions(kShadowCells, kShadowCells, kShadowCells);
    coarse->Update();
    data.shadow = coarse->GetOutput();
  }
  return data;
}

}  // namespace

std::shared_ptr<const PreparedMeshes> prepareMeshes(const std::vector<geometry::TriangleMesh>& meshes) {
  std::size_t triangles = 0;
  for (const geometry::TriangleMesh& mesh : meshes) triangles += mesh.triangles.size();
  const double keep = triangles > kTriangleBudget
                          ? static_cast<double>(kTriangleBudget) / static_cast<double>(triangles)
                          : 1.0;
  auto prepared = std::make_shared<PreparedMeshes>();
  for (const geometry::TriangleMesh& mesh : meshes) prepared->objects.push_back(makeMeshData(mesh, keep));
  return prepared;
}

}  // namespace abstand::ui
