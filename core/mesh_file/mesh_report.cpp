// Edges, components and remarks of a mesh.
#include "core/mesh_file/mesh_report.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "core/geometry/mass_properties.hpp"

namespace abstand::mesh_file {
namespace {

/// m. A robot link, a table or a person is smaller; a file in millimetres is larger.
constexpr double kDoubtfullyLarge = 20.0;

/// m. The smallest object worth a distance.
constexpr double kDoubtfullySmall = 1e-3;

/// One side of a triangle; `low` and `high` are its vertices in the order of their numbers.
struct Side {
  std::uint32_t low, high;
  std::uint32_t triangle;
  bool rising;  ///< the triangle runs from low to high
};

/// Connected components of triangles (union-find with path halving).
class Pieces {
 public:
  explicit Pieces(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }
  std::size_t count() const {
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) n += parent_[i] == i ? 1 : 0;
    return n;
  }

 private:
  std::uint32_t root(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<std::uint32_t> parent_;
};

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g m", value);
  return text;
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void addRemarks(MeshReport& r) {
  if (r.open_edges > 0)
    r.remarks.push_back("The surface is open: " + counted(r.open_edges, "edge has only one triangle.",
                                                          "edges have only one triangle."));
  if (r.non_manifold_edges > 0)
    r.remarks.push_back(counted(r.non_manifold_edges, "edge joins", "edges join") +
                        " more than two triangles.");
  if (r.flipped_edges > 0)
    r.remarks.push_back("Neighbouring triangles face opposite ways at " +
                        counted(r.flipped_edges, "edge.", "edges."));
  const bool closed = r.open_edges == 0 && r.non_manifold_edges == 0 && r.flipped_edges == 0;
  if (closed && r.volume < 0.0) r.remarks.push_back("The mesh is inside out: its triangles face inwards.");
  if (closed && r.volume == 0.0) r.remarks.push_back("The mesh encloses no volume.");
  if (r.components > 1)
    r.remarks.push_back("The mesh has " + std::to_string(r.components) + " separate pieces.");
  const double size = r.extent.maxCoeff();
  if (size >= kDoubtfullyLarge)
    r.remarks.push_back("The mesh is " + metres(size) + " large: probably millimetres, scale: 0.001");
  if (size < kDoubtfullySmall)
    r.remarks.push_back("The mesh is " + metres(size) + " small: probably scaled twice, or in another unit");
}

}  // namespace

MeshReport inspect(const geometry::TriangleMesh& mesh) {
  MeshReport r;
  r.triangles = mesh.triangles.size();
  r.vertices = mesh.vertices.size();
  if (mesh.triangles.empty()) {
    r.remarks.push_back("The mesh has no triangle.");
    return r;
  }

  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  const auto edge = [](const Side& s) { return std::pair{s.low, s.high}; };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return edge(a) < edge(b); });

  Pieces pieces(mesh.triangles.size());
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& s) { return edge(s) != edge(*first); });
    for (auto s = first + 1; s < last; ++s) pieces.join(first->triangle, s->triangle);
    const auto shared_by = last - first;
    if (shared_by == 1) ++r.open_edges;
    if (shared_by > 2) ++r.non_manifold_edges;
    if (shared_by == 2 && first->rising == (first + 1)->rising) ++r.flipped_edges;
    first = last;
  }
  r.components = pieces.count();
  r.volume = geometry::signedVolume(mesh);
  r.extent = geometry::bounds(mesh).extent();
  r.watertight = r.open_edges == 0 && r.non_manifold_edges == 0 && r.flipped_edges == 0 && r.volume > 0.0;
  addRemarks(r);
  return r;
}

}  // namespace abstand::mesh_file
