// COLLADA 1.4 and 1.5: the meshes of the visual scene with their transforms, in metres.
#include <map>

#include "core/mesh_file/mesh_file_readers.hpp"
#include "core/text/text_lines.hpp"
#include "core/text/xml_element.hpp"

namespace abstand::mesh_file {
namespace {

/// Nested instances grow exponentially; these constants limit what a small file can expand to. Work counts
/// characters read, again for every instance, and elements visited, and may be a multiple of the file size.
constexpr int kDeepestNode = 256;
constexpr std::size_t kMinWork = std::size_t{64} << 20;
constexpr std::size_t kMaxInstances = 32;
constexpr std::size_t kWorkOfElement = 64;
constexpr std::size_t kMaxDaeVertices = 20'000'000;
constexpr std::size_t kMaxTriangles = 20'000'000;

/// Columns of an index list; real files have at most a handful.
constexpr std::size_t kMaxColumns = 64;

using Affine = Eigen::Affine3d;

/// Half-open range of vertices, `first` to `end` - 1.
struct Range {
  std::uint32_t first{0}, end{0};
};

class Reader {
 public:
  Reader(const text::XmlElement& root, std::size_t file_size, const std::string& name)
      : root_(root), name_(name), max_work_(kMinWork + kMaxInstances * file_size) {}

  geometry::TriangleMesh run() {
    if (root_.name != "COLLADA")
      fail(root_, "found <" + std::string(root_.name.substr(0, 40)) + ">, expected <COLLADA>");
    collectIds(root_);
    Affine X = Affine::Identity();
    if (const auto* asset = root_.child("asset")) {
      if (const auto* unit = asset->child("unit"); unit && !unit->attribute("meter").empty()) {
        const double metre = text::number(unit->attribute("meter"), at(*unit));
        if (metre <= 0.0)
          fail(*unit, "found a unit of " + formatDouble(metre) + " m, expected a positive one");
        X.linear() *= metre;
      }
    }
    if (const auto* scene = visualScene()) {
      visit(*scene, X, 0);
    } else {
      // A library without a scene: every geometry once, untransformed.
      for (const auto& library : root_.children) {
        if (library.name != "library_geometries") continue;
        for (const auto& geometry : library.children) addGeometry(geometry, X);
      }
    }
    return std::move(mesh_);
  }

 private:
  SourcePos at(const text::XmlElement& e) const { return {name_, e.line, 0}; }
  [[noreturn]] void fail(const text::XmlElement& e, const std::string& message) const {
    throw ParseError(at(e), message);
  }

  void collectIds(const text::XmlElement& e) {
    if (const auto id = e.attribute("id"); !id.empty()) ids_.emplace(id, &e);
    for (const auto& c : e.children) collectIds(c);
  }

  /// The element with the id that the attribute `key` of `e` refers to (`#id`).
  const text::XmlElement& target(const text::XmlElement& e, std::string_view key,
                                 std::string_view expected) const {
    const auto url = e.attribute(key);
    const auto found = url.starts_with('#') ? ids_.find(url.substr(1)) : ids_.end();
    if (found == ids_.end() || (!expected.empty() && found->second->name != expected))
      fail(e, "found " + text::inDoubleQuotes(url) + ", expected # and the id of an element <" +
                  std::string(expected) + "> of this file");
    return *found->second;
  }

  const text::XmlElement* visualScene() const {
    if (const auto* scene = root_.child("scene"))
      if (const auto* instance = scene->child("instance_visual_scene"))
        return &target(*instance, "url", "visual_scene");
    const auto* library = root_.child("library_visual_scenes");
    return library ? library->child("visual_scene") : nullptr;
  }

  void spend(const text::XmlElement& e) {
    work_ += e.text.size() + kWorkOfElement * (1 + e.children.size());
    if (work_ > max_work_) fail(e, "found nodes that contain themselves, or too many instances");
  }

  std::vector<double> numbers(const text::XmlElement& e) {
    spend(e);
    std::vector<double> values;
    std::string_view rest = e.text;
    for (auto word = text::nextWord(rest); !word.empty(); word = text::nextWord(rest))
      values.push_back(text::number(word, at(e)));
    return values;
  }

  std::vector<std::uint32_t> indices(const text::XmlElement& e) {
    spend(e);
    std::vector<std::uint32_t> values;
    std::string_view rest = e.text;
    for (auto word = text::nextWord(rest); !word.empty(); word = text::nextWord(rest)) {
      const auto value = parseInt(word);
      if (!value || *value < 0) fail(e, "found " + text::inDoubleQuotes(word) + ", expected an index from 0");
      values.push_back(static_cast<std::uint32_t>(*value));
    }
    return values;
  }

  /// X times the transforms of a node, in order.
  Affine transform(const text::XmlElement& node, Affine X) {
    for (const auto& e : node.children) {
      std::size_t expected = 0;
      if (e.name == "matrix") expected = 16;
      if (e.name == "rotate") expected = 4;
      if (e.name == "translate" || e.name == "scale") expected = 3;
      if (e.name == "lookat" || e.name == "skew")
        fail(e, "found <" + std::string(e.name) + ">, expected matrix, rotate, translate or scale");
      if (expected == 0) continue;
      const auto v = numbers(e);
      if (v.size() != expected)
        fail(e, "found " + std::to_string(v.size()) + " numbers, expected " + std::to_string(expected));
      if (e.name == "matrix") {
        Affine M = Affine::Identity();
        for (int i = 0; i < 12; ++i) M(i / 4, i % 4) = v[static_cast<std::size_t>(i)];
        X = X * M;
      } else if (e.name == "rotate") {
        const Vector3d axis(v[0], v[1], v[2]);
        if (axis.norm() > 0.0) X.rotate(Eigen::AngleAxisd(unit::deg(v[3]), axis.normalized()));
      } else if (e.name == "translate") {
        X.translate(Vector3d(v[0], v[1], v[2]));
      } else {
        X.scale(Vector3d(v[0], v[1], v[2]));
      }
    }
    return X;
  }

  void visit(const text::XmlElement& node, const Affine& X_parent, int depth) {
    spend(node);
    if (depth > kDeepestNode) fail(node, "found nodes that contain themselves, or nested too deep");
    const Affine X = transform(node, X_parent);
    for (const auto& e : node.children) {
      if (e.name == "node") visit(e, X, depth + 1);
      if (e.name == "instance_node") visit(target(e, "url", "node"), X, depth + 1);
      if (e.name == "instance_geometry") addGeometry(target(e, "url", "geometry"), X);
    }
  }

  void addGeometry(const text::XmlElement& geometry, const Affine& X) {
    const auto* mesh = geometry.child("mesh");
    if (!mesh) return;
    spend(*mesh);
    std::map<const text::XmlElement*, Range> sources;
    for (const auto& e : mesh->children) {
      if (e.name == "triangles" || e.name == "polylist" || e.name == "polygons" || e.name == "tristrips" ||
          e.name == "trifans")
        addPrimitives(e, X, sources);
    }
  }

  /// Adds the vertices of a <source>, transformed.
  Range addVertices(const text::XmlElement& source, const Affine& X) {
    const auto* technique = source.child("technique_common");
    const auto* accessor = technique ? technique->child("accessor") : nullptr;
    if (!accessor) fail(source, "found a source without an accessor");
    const auto values = numbers(target(*accessor, "source", "float_array"));
    const auto integer = [&](std::string_view key, std::uint64_t otherwise) -> std::uint64_t {
      const auto word = accessor->attribute(key);
      if (word.empty()) return otherwise;
      const auto value = parseInt(word);
      if (!value || *value < 0)
        fail(*accessor, "found " + text::inDoubleQuotes(word) + ", expected a number from 0");
      return static_cast<std::uint64_t>(*value);
    };
    const auto count = integer("count", 0), offset = integer("offset", 0), stride = integer("stride", 1);
    if (count > 0 && (stride < 3 || offset + (count - 1) * stride + 3 > values.size()))
      fail(*accessor, "found " + std::to_string(count) + " points with stride " + std::to_string(stride) +
                          " in an array of " + std::to_string(values.size()) +
                          " numbers, expected them to fit");
    if (mesh_.vertices.size() + count > kMaxDaeVertices)
      fail(source, "found more than " + std::to_string(kMaxDaeVertices) + " vertices");
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto* v = values.data() + offset + i * stride;
      mesh_.vertices.push_back(X * Vector3d(v[0], v[1], v[2]));
      if (!mesh_.vertices.back().allFinite()) fail(source, "found a coordinate that is not finite");
    }
    return {first, static_cast<std::uint32_t>(mesh_.vertices.size())};
  }

  void addPrimitives(const text::XmlElement& e, const Affine& X,
                     std::map<const text::XmlElement*, Range>& sources) {
    spend(e);
    const text::XmlElement* vertices = nullptr;
    std::size_t column = 0, columns = 1;
    for (const auto& input : e.children) {
      if (input.name != "input") continue;
      const auto word = input.attribute("offset");
      const auto offset = parseInt(word.empty() ? "0" : word);
      if (!offset || *offset < 0 || static_cast<std::size_t>(*offset) >= kMaxColumns)
        fail(input, "found offset " + text::inDoubleQuotes(word) + ", expected 0 to " +
                        std::to_string(kMaxColumns - 1));
      columns = std::max(columns, static_cast<std::size_t>(*offset) + 1);
      if (input.attribute("semantic") != "VERTEX") continue;
      vertices = &target(input, "source", "vertices");
      column = static_cast<std::size_t>(*offset);
    }
    if (!vertices) fail(e, "found no input with the semantic VERTEX");
    const text::XmlElement* source = nullptr;
    spend(*vertices);
    for (const auto& input : vertices->children)
      if (input.name == "input" && input.attribute("semantic") == "POSITION")
        source = &target(input, "source", "source");
    if (!source) fail(*vertices, "found no input with the semantic POSITION");
    if (!sources.contains(source)) sources[source] = addVertices(*source, X);
    range_ = sources[source];
    mirrored_ = X.linear().determinant() < 0.0;

    const auto* vcount = e.child("vcount");
    const auto sizes = e.name == "polylist" && vcount ? indices(*vcount) : std::vector<std::uint32_t>{};
    for (const auto& p : e.children) {
      if (p.name == "ph") fail(p, "found a polygon with holes, expected one without");
      if (p.name != "p") continue;
      const auto all = indices(p);
      std::vector<std::uint32_t> corners;
      for (std::size_t i = column; i < all.size(); i += columns) corners.push_back(all[i]);
      addPolygons(e, p, corners, sizes);
    }
  }

  /// Adds the polygons of one <p>; `sizes` are those of a polylist.
  void addPolygons(const text::XmlElement& e, const text::XmlElement& p,
                   const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& sizes) {
    const auto n = corners.size();
    if (e.name == "polygons") {
      addPolygon(p, corners);
    } else if (e.name == "triangles") {
      for (std::size_t i = 0; i + 2 < n; i += 3) addPolygon(p, std::span(corners).subspan(i, 3));
    } else if (e.name == "polylist") {
      std::size_t first = 0;
      for (const auto size : sizes) {
        if (size > n - first) fail(p, "found fewer indices than vcount announces");
        addPolygon(p, std::span(corners).subspan(first, size));
        first += size;
      }
    } else {
      const bool strip = e.name == "tristrips";
      for (std::size_t i = 0; i + 2 < n; ++i) {
        std::array<std::uint32_t, 3> t{corners[strip ? i : 0], corners[i + 1], corners[i + 2]};
        if (strip && i % 2 == 1) std::swap(t[0], t[1]);
        addPolygon(p, t);
      }
    }
  }

  /// Adds a polygon whose corners count from the source's first vertex.
  void addPolygon(const text::XmlElement& p, std::span<const std::uint32_t> corners) {
    polygon_.clear();
    for (const auto c : corners) {
      if (c >= range_.end - range_.first)
        fail(p, "found vertex " + std::to_string(c) + ", expected one of " +
                    std::to_string(range_.end - range_.first));
      polygon_.push_back(range_.first + c);
    }
    // A mirroring transform reverses the orientation of triangles.
    if (mirrored_) std::reverse(polygon_.begin(), polygon_.end());
    cutter_.add(polygon_, at(p));
    if (mesh_.triangles.size() > kMaxTriangles)
      fail(p, "found more than " + std::to_string(kMaxTriangles) + " triangles");
  }

  const text::XmlElement& root_;
  const std::string& name_;
  std::size_t max_work_;
  std::map<std::string_view, const text::XmlElement*> ids_;
  std::size_t work_{0};
  geometry::TriangleMesh mesh_;
  PolygonCutter cutter_{mesh_};
  std::vector<std::uint32_t> polygon_;
  Range range_;  ///< vertices of the current primitives
  bool mirrored_{false};
};

}  // namespace

geometry::TriangleMesh readDae(std::string_view content, const std::string& name) {
  const text::XmlElement root = text::parseXml(content, name);
  return Reader(root, content.size(), name).run();
}

}  // namespace abstand::mesh_file
