// Vertices of a surface relative to a contact place.
#pragma once

#include <algorithm>

#include "core/contact/contact_surface.hpp"

namespace abstand::contact {

/// Vertices of a mesh as u, v and height of a contact place (m), computed when they are asked for: a patch
/// needs few of them. Memory is kept from place to place, also of other meshes. One thread.
class PlacedVertices {
 public:
  /// @param R_PB  rows: u, v and the direction of approach
  void begin(const geometry::TriangleMesh& mesh, const Matrix3d& R_PB, const Vector3d& p_B) {
    vertices_ = mesh.vertices;
    R_PB_ = R_PB;
    p_B_ = p_B;
    if (points_.size() < vertices_.size()) {
      points_.resize(vertices_.size());
      place_of_.resize(vertices_.size(), 0);
    }
    if (++place_ == 0) {
      std::fill(place_of_.begin(), place_of_.end(), 0);
      place_ = 1;
    }
  }
  const Vector3d& operator[](std::uint32_t vertex) {
    if (place_of_[vertex] != place_) {
      points_[vertex] = R_PB_ * (vertices_[vertex] - p_B_);
      place_of_[vertex] = place_;
    }
    return points_[vertex];
  }
  std::size_t size() const { return vertices_.size(); }

 private:
  std::span<const Vector3d> vertices_;
  Matrix3d R_PB_{Matrix3d::Identity()};
  Vector3d p_B_{Vector3d::Zero()};
  std::vector<Vector3d> points_;
  std::vector<std::uint32_t> place_of_;  ///< of each vertex: number of the place it was computed for
  std::uint32_t place_{0};
};

}  // namespace abstand::contact
