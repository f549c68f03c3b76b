// Triangle meshes as VTK draws them. VTK: include from .cpp files of this folder only.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::ui {

/// The data of one object, all in its body frame.
struct MeshData {
  vtkSmartPointer<vtkPolyData> surface;  ///< with normals, split at edges
  vtkSmartPointer<vtkPolyData> hull;     ///< blown up a little; drawn inside out it is an outline
  vtkSmartPointer<vtkPolyData> shadow;   ///< coarser
};

/// `keep`: share of the triangles to keep, 1 for all; small meshes are kept whole.
MeshData makeMeshData(const geometry::TriangleMesh& mesh, double keep);

}  // namespace abstand::ui
