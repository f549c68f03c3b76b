#include "tests/support/structures.hpp"

#include <map>
#include <sstream>

namespace abstand::testing {
namespace {

std::string identity(const Shape& shape) {
  std::ostringstream s;
  const Bounds box = bounds(shape);
  s << shapeName(shape) << box.extent().transpose() << surfaceArea(shape);
  return s.str();
}

}  // namespace

const HapticStructure& structureOf(const Shape& shape, FieldKind field, double spacing) {
  static std::map<std::string, std::shared_ptr<const HapticStructure>> cache;
  auto& s = cache[identity(shape) + std::string(fieldName(field)) + std::to_string(spacing)];
  if (!s)
    s = buildHapticStructure(
        identity(shape), makeSurface(shape),
        {.voxel_size = spacing, .point_spacing = spacing, .outer_layers = 20, .field = field});
  return *s;
}

}  // namespace abstand::testing
