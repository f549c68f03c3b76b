// Read-only views of two structures for a search. Internal to the engine.
#pragma once

#include <cstdint>

#include "core/field/far_field.hpp"
#include "core/field/layer_view.hpp"
#include "core/field/near_field.hpp"
#include "core/shell/point_sphere_tree.hpp"

namespace abstand::kernels {

/// Distance field of one body, of any kind.
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

/// Point-sphere tree of one body P with its pose in the frame F of the other body.
struct TreeView {
  const shell::PointSphereTree::Family* families;
  const float *x, *y, *z, *nx, *ny, *nz, *area;
  float X_FP[12];  ///< row-major 3x4
};

}  // namespace abstand::kernels
