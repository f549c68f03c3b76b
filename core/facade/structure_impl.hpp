// Implementations of the public types of the engine.
#pragma once

#include "abstand/query.hpp"
#include "abstand/structure.hpp"
#include "core/query/pair_query.hpp"

namespace abstand {

struct Structure::Impl {
  std::shared_ptr<const structure::HapticStructure> made;
};

struct PairState::Impl {
  query::PairMemory memory;
};

}  // namespace abstand

namespace abstand::facade {

/// Valid public shape to internal shape.
geometry::Shape shapeOf(const Shape& shape);
/// Internal shape to public shape.
Shape shapeOf(const geometry::Shape& shape);
/// Internal mesh to public mesh.
Mesh meshOf(geometry::TriangleMesh mesh);
/// Internal result to public result.
PairResult resultOf(const query::PairResult& result);
/// For cold starts, and for warm ones. Throw UsageError for a margin or stiffness that is negative or not
/// finite, and for a tolerance out of range.
query::PairOptions coldOptions(const QueryOptions& options);
query::PairOptions warmOptions(const QueryOptions& options);
/// Throws UsageError if it is not a valid pose.
Transform checkedPose(const Pose& pose);

}  // namespace abstand::facade
