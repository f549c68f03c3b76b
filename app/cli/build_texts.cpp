#include "app/cli/build_texts.hpp"
#include "app/cli/json_values.hpp"

#include <algorithm>

namespace abstand::cli {
namespace {

constexpr double kTable[] = {0.010, 0.005, 0.004, 0.002, 0.001};  // m, voxel size and point spacing

nlohmann::ordered_json placeOrNull(const Vector3d& p) {
  return p.allFinite() ? toJson(p) : nlohmann::ordered_json(nullptr);
}

std::string place(const Vector3d& p) { return format("(%.3f, %.3f, %.3f)", p.x(), p.y(), p.z()); }

std::vector<structure::HapticOptions> rowsFor(const structure::HapticOptions& asked) {
  std::vector<structure::HapticOptions> rows{asked};
  for (const double pitch : kTable) {
    if (asked.voxel_size == pitch && asked.point_spacing == pitch) continue;
    structure::HapticOptions o = asked;
    o.voxel_size = o.point_spacing = pitch;
    rows.push_back(o);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const structure::HapticOptions& l, const structure::HapticOptions& r) {
                     return std::max(l.voxel_size, l.point_spacing) > std::max(r.voxel_size, r.point_spacing);
                   });
  return rows;
}

bool same(const structure::HapticOptions& l, const structure::HapticOptions& r) {
  return l.voxel_size == r.voxel_size && l.point_spacing == r.point_spacing;
}

nlohmann::ordered_json rowJson(const store::ResolutionEstimate& e, bool asked) {
  nlohmann::ordered_json j{
      {"voxel", e.options.voxel_size}, {"point", e.options.point_spacing}, {"asked", asked}};
  j["refused"] = e.refused.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(e.refused);
  if (!e.refused.empty()) return j;
  j["error_bound"] = e.error_bound;
  j["memory_bytes"] = std::llround(e.memory_bytes);
  j["points"] = std::llround(e.points);
  j["build_ms"] = e.build_ms;
  j["distance_us"] = e.distance_us;
  j["contact_us"] = e.contact_us;
  return j;
}

std::string rowText(const store::ResolutionEstimate& e, bool asked) {
  const std::string pitch =
      format("%c %6.2f %6.2f", asked ? '*' : ' ', 1e3 * e.options.voxel_size, 1e3 * e.options.point_spacing);
  if (!e.refused.empty()) return pitch + "  cannot be built: " + e.refused + "\n";
  return pitch + format("  %8.2f mm %8.1f MB %9.0f %9.0f ms %8.1f us %8.1f us\n", 1e3 * e.error_bound,
                        1e-6 * e.memory_bytes, e.points, e.build_ms, e.distance_us, e.contact_us);
}

}  // namespace

Said sayReport(const store::BuildReport& r) {
  Said said;
  said.json["leaks"] = {{"open_edges", r.open_edges},
                        {"non_manifold_edges", r.non_manifold_edges},
                        {"flipped_edges", r.flipped_edges}};
  said.json["inside_doubtful"] = r.inside_doubtful;
  said.json["thin_walls"] = {{"below", r.thin_walls.below},
                             {"share", r.thin_walls.share},
                             {"thinnest", numberOrNull(r.thin_walls.thinnest)},
                             {"where", placeOrNull(r.thin_walls.where)}};
  said.json["convex_hull"] = nullptr;
  if (r.hull)
    said.json["convex_hull"] = {{"volume_ratio", numberOrNull(r.hull->volume_ratio)},
                                {"worst", r.hull->worst},
                                {"where", placeOrNull(r.hull->where)}};

  if (r.inside_doubtful)
    said.text +=
        r.open_edges + r.non_manifold_edges + r.flipped_edges > 0
            ? format(
                  "  leaks: %zu open edges, %zu with more than two triangles, %zu flipped; inside "
                  "is a guess\n",
                  r.open_edges, r.non_manifold_edges, r.flipped_edges)
            : std::string("  the surface intersects itself: inside and outside are uncertain there\n");
  if (r.thin_walls.share > 0.0)
    said.text +=
        format("  thin walls: %.2g %% of the area is thinner than two voxels; thinnest %.2f mm at %s\n",
               1e2 * r.thin_walls.share, 1e3 * r.thin_walls.thinnest, place(r.thin_walls.where).c_str());
  if (r.hull && r.hull->worst > 0.0)
    said.text += format("  convex hull: error up to %.1f mm, at %s, %.2f times the volume\n",
                        1e3 * r.hull->worst, place(r.hull->where).c_str(), r.hull->volume_ratio);
  return said;
}

Said explain(const std::string& name, std::shared_ptr<const geometry::Surface> surface,
             const structure::HapticOptions& asked, const structure::BuildMonitor& monitor) {
  const Vector3d extent = surface->bounds().extent();
  const double area = surface->area(), volume = surface->massProperties().volume;
  Said said;
  said.json = {{"name", name}, {"extent", toJson(extent)}, {"area", area}, {"volume", volume}};
  said.text =
      format("%s: %.3f x %.3f x %.3f m, %.4f m^2, %.6f m^3, field %s\n", name.c_str(), extent.x(), extent.y(),
             extent.z(), area, volume, std::string(structure::fieldName(asked.field)).c_str());
  said.text += "   voxel  point  error bound      memory    points    building    distance     contact\n";
  store::ResolutionProbe probe(std::move(surface));
  auto rows = nlohmann::ordered_json::array();
  for (const structure::HapticOptions& o : rowsFor(asked)) {
    const store::ResolutionEstimate e = probe.estimate(o, monitor);
    rows.push_back(rowJson(e, same(o, asked)));
    said.text += rowText(e, same(o, asked));
  }
  said.json["rows"] = rows;
  return said;
}

nlohmann::ordered_json explainRules() {
  return {
      {"error_bound",
       "predicted upper bound: the field's share grows with the voxel size, the pointshell's is 1.1 "
       "spacings"},
      {"memory_bytes",
       "predicted within 25 %: field blocks counted at their centres, bytes a block and a point "
       "measured on a coarse build"},
      {"points", "predicted within 25 %: area / (1.155 point^2), and edges and tips from two coarse shells"},
      {"build_ms", "phases of the coarse build on this machine, each scaled by voxels, blocks or points"},
      {"distance_us",
       "timed on the coarse build, two copies of the body a tenth of its size apart; grows with "
       "the root of the points"},
      {"contact_us",
       "timed on the coarse build, two copies of the body overlapping by 2 % of its size; the time beyond "
       "a distance query grows with points^0.75"}};
}

}  // namespace abstand::cli
