#include "core/geometry/convex_hull.hpp"

// The only file that includes Qhull.
#include <libqhull_r/qhull_ra.h>

#include <cstdio>
#include <memory>

namespace abstand::geometry {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Owns Qhull's state and memory; the destructor frees both, also after an error.
class Qhull {
 public:
  Qhull() { qh_zero(&state_, nullptr); }
  ~Qhull() {
    qh_freeqhull(&state_, qh_ALL);
    int long_memory = 0, long_total = 0;
    qh_memfreeshort(&state_, &long_memory, &long_total);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool run(std::vector<double>& coordinates) {
    // Qhull's messages are discarded.
    const std::unique_ptr<std::FILE, CloseFile> quiet(std::fopen("/dev/null", "w"));
    if (!quiet) return false;
    char command[] = "qhull FA";
    const int failed = qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                                    False, command, quiet.get(), quiet.get());
    return failed == 0;
  }

  qhT& state() { return state_; }

 private:
  qhT state_;
};

}  // namespace

std::optional<ConvexHull> convexHull(const std::vector<Vector3d>& points) {
  if (points.size() < 4) return std::nullopt;
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vector3d& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  Qhull qhull;
  if (!qhull.run(coordinates)) return std::nullopt;

  qhT* qh = &qhull.state();
  std::vector<Eigen::RowVector4d> planes;
  facetT* facet = nullptr;
  FORALLfacets { planes.emplace_back(facet->normal[0], facet->normal[1], facet->normal[2], facet->offset); }
  ConvexHull hull;
  hull.planes.resize(static_cast<Eigen::Index>(planes.size()), 4);
  for (std::size_t i = 0; i < planes.size(); ++i) hull.planes.row(static_cast<Eigen::Index>(i)) = planes[i];
  hull.volume = qh->totvol;
  vertexT* vertex = nullptr;
  FORALLvertices { hull.corners.push_back(static_cast<std::uint32_t>(qh_pointid(qh, vertex->point))); }
  hull.farthest_outside = qh->max_outside;
  return hull;
}

}  // namespace abstand::geometry
