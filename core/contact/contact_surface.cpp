#include "core/contact/contact_surface.hpp"

#include <algorithm>

namespace abstand::contact {

ContactSurface::ContactSurface(const geometry::Surface& surface, double sagitta)
    : watertight_{surface.watertight() && surface.massProperties().volume > 0.0} {
  const geometry::Shape* shape = surface.shape();
  const double tolerance =
      sagitta > 0.0 ? std::max(sagitta, kContactSagittaShare * surface.bounds().extent().maxCoeff())
                    : sagitta;
  mesh_ = geometry::weld(surface.mesh(tolerance), 0.0);
  if (shape && !std::holds_alternative<geometry::Cuboid>(*shape)) sagitta_ = tolerance;
  tree_ = geometry::TriangleTree(mesh_);

  // Triangles at each vertex, concatenated lists.
  first_.assign(mesh_.vertices.size() + 1, 0);
  for (const auto& triangle : mesh_.triangles)
    for (const std::uint32_t v : triangle) ++first_[v + 1];
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) first_[v + 1] += first_[v];
  around_.resize(3 * mesh_.triangles.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    for (const std::uint32_t v : mesh_.triangles[t]) around_[next[v]++] = t;
  makeClusters();
}

void ContactSurface::makeClusters() {
  // Successive slots of the tree are neighbours.
  for (std::uint32_t slot = 0; slot < tree_.size(); ++slot) clustered_.push_back(tree_.triangle(slot));
  for (std::size_t first = 0; first < clustered_.size(); first += kClusterTriangles) {
    geometry::Bounds box;
    for (std::size_t i = first; i < std::min(first + kClusterTriangles, clustered_.size()); ++i)
      for (const std::uint32_t v : mesh_.triangles[clustered_[i]]) box.add(mesh_.vertices[v]);
    boxes_.emplace_back(box.centre(), 0.5 * box.extent());
  }
}

}  // namespace abstand::contact
