// Corners of a convex hull, by Qhull.
#include "core/geometry/hull_vertices.hpp"

#include <algorithm>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace abstand {
namespace {

constexpr double kReach = 1e-12;

/// Qhull's state, given back whatever happens.
class Hull {
 public:
  Hull() { qh_zero(&qh_, nullptr); }
  ~Hull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int current = 0, total = 0;
    qh_memfreeshort(&qh_, &current, &total);
  }
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;

  /// Qhull writes nothing: neither results nor what it thinks of flat input.
  bool make(std::vector<double>& coordinates) {
    char command[] = "qhull Pp";
    std::FILE* quiet = std::tmpfile();
    if (quiet == nullptr) return false;
    const int failed = qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                                    False, command, nullptr, quiet);
    std::fclose(quiet);
    return failed == 0;
  }
  template <class Fn>
  void forVertices(Fn&& fn) {
    for (const vertexT* v = qh_.vertex_list; v != nullptr && v->next != nullptr; v = v->next)
      fn(static_cast<std::size_t>(qh_pointid(&qh_, v->point)));
  }
  double farthestOutside() const { return qh_.max_outside; }

 private:
  qhT qh_;
};

}  // namespace

std::vector<Vector3d> hullVertices(const std::vector<Vector3d>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  double largest = 0.0;
  for (const Vector3d& p : points) {
    coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  Hull hull;
  if (points.size() < 5 || !hull.make(coordinates) || hull.farthestOutside() > kReach * largest)
    return points;
  std::vector<Vector3d> vertices;
  hull.forVertices([&](std::size_t i) { vertices.push_back(points[i]); });
  return vertices;
}

}  // namespace abstand
