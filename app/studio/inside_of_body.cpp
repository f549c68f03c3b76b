// What the engine computes with, for the window.
#include "app/studio/inside_of_body.hpp"

#include <limits>

namespace abstand::studio {

namespace {

constexpr int kSliceCells = 96;        // along each side
constexpr double kSliceBeyond = 1.25;  // of the bounding sphere's radius

void addLevels(const shell::PointSphereTree& tree, ui::BodyInside& inside) {
  std::vector<std::uint32_t> level;
  if (!tree.nodes.empty()) level.push_back(0);
  while (!level.empty() && level.size() <= ui::BodyInside::kMaxSpheres) {
    auto& spheres = inside.levels.emplace_back();
    std::vector<std::uint32_t> next;
    for (const std::uint32_t n : level) {
      const auto& node = tree.nodes[n];
      spheres.push_back({{node.cx, node.cy, node.cz}, node.radius});
      for (std::uint32_t child = 0; child < node.children; ++child) next.push_back(node.first_child + child);
    }
    level = std::move(next);
  }
}

void addSlice(const structure::HapticStructure& structure, ui::BodyInside& inside) {
  const field::NearField* field = structure::nearField(structure);
  if (!field) return;
  const auto& sphere = structure.bounding_sphere;
  const auto side = static_cast<float>(2.0 * kSliceBeyond * sphere.radius);
  ui::BodyInside::Slice& slice = inside.slice;
  slice.columns = slice.rows = kSliceCells;
  slice.cell = side / kSliceCells;
  slice.corner = sphere.centre.cast<float>() - Vector3f(0.5F * side, 0.5F * side, 0.0F);
  for (int row = 0; row < kSliceCells; ++row)
    for (int column = 0; column < kSliceCells; ++column) {
      const Vector3f p = slice.corner + slice.cell * Vector3f(static_cast<float>(column) + 0.5F,
                                                              static_cast<float>(row) + 0.5F, 0.0F);
      float distance = 0.0F;
      const bool known = field->sample(p.x(), p.y(), p.z(), distance);
      slice.distance.push_back(known ? distance : std::numeric_limits<float>::quiet_NaN());
    }
}

}  // namespace

ui::BodyInside insideOf(const structure::HapticStructure& structure) {
  ui::BodyInside inside;
  for (std::size_t i = 0; i < structure.shell.size(); ++i)
    inside.points.push_back(structure.shell.point(i).cast<float>());
  addLevels(structure.tree, inside);
  addSlice(structure, inside);
  return inside;
}

}  // namespace abstand::studio
