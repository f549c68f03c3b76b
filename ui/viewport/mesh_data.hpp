// Triangle meshes as VTK draws them. VTK: include from .cpp files of this folder only.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "ui/viewport/prepared_meshes.hpp"

namespace abstand::ui {

/// The data of one object, all in its body frame.
struct MeshData {
  vtkSmartPointer<vtkPolyData> surface;  ///< with normals, split at edges
  vtkSmartPointer<vtkPolyData> hull;     ///< blown up a little; drawn inside out it is an outline
  vtkSmartPointer<vtkPolyData> shadow;   ///< coarser
};

struct PreparedMeshes {
  std::vector<MeshData> objects;
};

}  // namespace abstand::ui
