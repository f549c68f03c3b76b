#include "tests/support/structures.hpp"

#include <map>
#include <sstream>

namespace abstand::testing {
namespace {

std::string identity(const geometry::Shape& shape) {
  std::ostringstream s;
  const geometry::Bounds box = geometry::bounds(shape);
  s << geometry::shapeName(shape) << box.extent().transpose() << geometry::surfaceArea(shape);
  return s.str();
}

}  // namespace

const structure::HapticStructure& structureOf(const geometry::Shape& shape, structure::FieldKind field,
                                              double spacing) {
  static std::map<std::string, std::shared_ptr<const structure::HapticStructure>> cache;
  auto& s = cache[identity(shape) + std::string(structure::fieldName(field)) + std::to_string(spacing)];
  if (!s)
    s = structure::buildHapticStructure(
        identity(shape), geometry::makeSurface(shape),
        {.voxel_size = spacing, .point_spacing = spacing, .outer_layers = 20, .field = field});
  return *s;
}

}  // namespace abstand::testing
