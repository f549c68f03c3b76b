// What a search reads of two structures: plain numbers and pointers. Internal to the engine.
#pragma once

#include <cstdint>

#include "core/field/far_field.hpp"
#include "core/field/layer_view.hpp"
#include "core/field/near_field.hpp"
#include "core/shell/point_sphere_tree.hpp"

namespace abstand::kernels {

/// One body's distance field, whatever its kind.
struct FieldView {
  enum class Kind : std::uint8_t { kNear, kLayered };
  Kind kind;
  field::FarField::View far;
  field::NearField::View near;  ///< kNear
  // kLayered
  float first_centre[3];
  float voxel;
  int size[3];
  field::LayerView layers;
};

/// A point-sphere tree seen from the frame F of the other body.
struct TreeView {
  const shell::PointSphereTree::Family* families;
  const float *x, *y, *z, *nx, *ny, *nz, *area;
  float X_FP[12];  ///< row-major 3x4
};

}  // namespace abstand::kernels
