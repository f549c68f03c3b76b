// One body's distance field as the pair query reads it, whatever its kind. Internal to core/haptic.
#pragma once

#include <cmath>

#include "core/haptic/haptic_structure.hpp"

namespace abstand {

/// Reads a structure's fields at points of its own frame (m). Two numbers matter: a certified lower bound f
/// of the true signed distance (for pruning and for the stated bound), and the best estimate s (for contacts
/// and forces).
class FieldSampler {
 public:
  explicit FieldSampler(const HapticStructure& body)
      : far_(&body.far_field),
        near_(body.near_field ? &*body.near_field : nullptr),
        map_(body.voxelmap ? &*body.voxelmap : nullptr) {
    if (near_) {
      near_error_ = static_cast<float>(near_->errorBound());
      const auto h = static_cast<float>(near_->grid().voxel_size);
      interpolation_ = 0.75f * h * h;
    } else {
      voxel_ = static_cast<float>(map_->grid.voxel_size);
    }
  }

  /// f: the true signed distance at p is never below it.
  float lowerBound(const Vector3f& p) const {
    float s;
    if (near_) return near_->sample(p.x(), p.y(), p.z(), s) ? lowerFromSample(s) : far(p);
    Vector3i voxel;
    if (!voxelOf(p, voxel)) return far(p);
    const int layer = map_->at(voxel);
    // Layers are Chebyshev steps between voxels: layer -k leaves at least k - 1 whole voxels between, and
    // inside no point of a voxel k steps from the surface voxels is deeper than k + 1 voxel diagonals.
    if (layer < 0) return std::max(static_cast<float>(-layer - 1) * voxel_, far(p));
    return -static_cast<float>(layer + 1) * kDiagonal * voxel_;
  }

  /// Layered fields need the normal of a shell point, the others do not look at it.
  bool layered() const { return near_ == nullptr; }

  /// f and s at a shell point with the inward normal n (axes of the field's frame).
  void point(const Vector3f& p, const Vector3f& n, float& f, float& s) const {
    if (near_) {
      if (near_->sample(p.x(), p.y(), p.z(), s)) {
        f = lowerFromSample(s);
      } else {
        f = s = far(p);
      }
      return;
    }
    f = lowerBound(p);
    Vector3i voxel;
    if (!voxelOf(p, voxel)) {
      s = f;
      return;
    }
    // V(P) = n . e + v s with e from the point to the voxel's centre [thesis eq. 2.4]; distance = -V.
    const Vector3f e = map_->grid.centre(voxel.x(), voxel.y(), voxel.z()).cast<float>() - p;
    s = -(n.dot(e) + static_cast<float>(map_->at(voxel)) * voxel_);
  }

  /// By how much s can be smaller than the true distance.
  float slack() const { return near_ ? near_error_ : 2.0f * kDiagonal * voxel_; }

 private:
  static constexpr float kDiagonal = 1.7320508f;

  float far(const Vector3f& p) const { return far_->lowerBound(p.x(), p.y(), p.z()); }

  /// Squared distances interpolate from above by at most 3/4 h^2 (far_field.hpp), so s >= sqrt(3)/2 h means
  /// outside and at least sqrt(s^2 - 3/4 h^2) away; nearer, and inside, the field's own bound holds.
  float lowerFromSample(float s) const {
    const float plain = s - near_error_;
    const float rest = s * s - interpolation_;
    return s > 0.0f && rest > 0.0f ? std::max(plain, std::sqrt(rest)) : plain;
  }

  bool voxelOf(const Vector3f& p, Vector3i& voxel) const {
    const Vector3f local = (p - map_->grid.first_centre.cast<float>()) / voxel_;
    for (int i = 0; i < 3; ++i) {
      // Written so that NaN fails.
      if (!(local[i] > -0.5f && local[i] < static_cast<float>(map_->grid.size[i]) - 0.5f)) return false;
      voxel[i] = static_cast<int>(local[i] + 0.5f);
    }
    return map_->grid.contains(voxel);
  }

  const FarField* far_;
  const NearField* near_;
  const Voxelmap* map_;
  float near_error_{0.0f};
  float interpolation_{0.0f};
  float voxel_{0.0f};
};

}  // namespace abstand
