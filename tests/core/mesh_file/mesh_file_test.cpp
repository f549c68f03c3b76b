// Mesh files: formats, units, cleaning, bad input, saving.
#include "core/mesh_file/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "core/geometry/mass_properties.hpp"
#include "core/geometry/shape.hpp"
#include "tests/support/paths.hpp"

namespace abstand::mesh_file {
namespace mesh_file_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ScratchFolder;

/// Coordinates of a tetrahedron in any unit; its volume is a sixth of the unit's cube.
constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

void expectTetrahedron(const LoadedMesh& loaded, double unit) {
  EXPECT_EQ(loaded.mesh.triangles.size(), 4u);
  EXPECT_EQ(loaded.mesh.vertices.size(), 4u);
  EXPECT_TRUE(loaded.report.watertight);
  EXPECT_NEAR(loaded.report.volume, unit * unit * unit / 6.0, 1e-12 * unit * unit * unit);
}

/// `count` as the header says it, whatever the number of triangles.
std::string binaryStl(std::uint32_t count, const std::vector<float>& corners,
                      const std::string& header = "x") {
  std::string s = header;
  s.resize(80, ' ');
  s.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t t = 0; t + 8 < corners.size(); t += 9) {
    s.append(12, '\0');
    s.append(reinterpret_cast<const char*>(&corners[t]), 36);
    s.append(2, '\0');
  }
  return s;
}

const std::vector<float> kCorners{0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                  1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1};

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment c\nelement vertex 4\nproperty uchar red\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class T>
void put(std::string& s, T value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  s.append(bytes, sizeof value);
}

std::string binaryPly(bool big) {
  std::string s = plyHeader(big ? "binary_big_endian" : "binary_little_endian");
  const float v[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::int32_t f[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& p : v) {
    s += '\x7f';
    for (const float c : p) put(s, c, big);
  }
  for (const auto& t : f) {
    s += '\x03';
    for (const auto i : t) put(s, i, big);
  }
  return s;
}

TEST(MeshFile, ReadsTetrahedronInEveryFormat) {
  std::string stl = "solid vertex 1 2\n";
  for (std::size_t i = 0; i < kCorners.size(); i += 3) {
    if (i % 9 == 0) stl += " facet normal 0 0 1\n  outer loop\n";
    stl += "   VERTEX " + std::to_string(kCorners[i]) + " " + std::to_string(kCorners[i + 1]) + " " +
           std::to_string(kCorners[i + 2]) + "\r\n";
    if (i % 9 == 6) stl += "  endloop\n endfacet\n";
  }
  stl += "endsolid vertex\n";
  const std::string off =
      "4 4 6\n0 0 0\n1 0 0 # c\n\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 2 0 3\n";
  const std::string ply =
      plyHeader("ascii") + "9 0 0 0\n9 1 0 0\n9 0 1 0\n9 0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const struct {
    const char* format;
    std::string content;
  } cases[] = {
      {"stl", stl},
      {"STL", binaryStl(4, kCorners)},
      {"stl", binaryStl(4, kCorners, "solid lies")},
      {"stl", binaryStl(4, kCorners) + "bytes behind the end"},
      {"obj", kObj},
      {"OBJ",
       "v 0 0 0 1\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nv 0 0 1\nf -4// -2/1 \\\n-3/1/1\nf 1 2 4\nf 2 3 4\nf 3 1 4"},
      {"off", "OFF " + off},
      {"off", "OFF\n" + off},
      {"off",
       "STCN"
       "OFF\n" +
           off},
      {"off", off},
      {"ply", ply},
      {"ply", binaryPly(false)},
      {"ply", binaryPly(true)}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.content.substr(0, 40));
    expectTetrahedron(parseMesh(c.content, c.format, "f"), 1.0);
    expectTetrahedron(parseMesh(c.content, c.format, "f", 0.001), 0.001);
  }
}

TEST(MeshFile, ReadsPlyTriangleStrips) {
  // A strip 0 2 1 3 0 2 winds around a tetrahedron; written whole, and as two strips of one list.
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (const char* list : {"6 0 2 1 3 0 2\n", "10 0 2 1 3 -1 1 3 0 2 -1\n", "10 0 2 1 3 3 1 1 3 0 2\n"})
    expectTetrahedron(parseMesh(head + list, "ply", "f"), 1.0);
  EXPECT_THROW(parseMesh(head + "3 0 1 9\n", "ply", "f"), ParseError);
  EXPECT_THROW(parseMesh(head + "3 0 1 -2\n", "ply", "f"), ParseError);
}

/// Corners of a polygon in the plane x + y + z = 0, and of a roof over it, so that a solid of it is closed.
std::string objOfPolygon(const std::vector<std::pair<double, double>>& corners) {
  std::string obj, bottom = "f", top = "f";
  const std::size_t n = corners.size();
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : corners)
      obj += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  for (std::size_t i = 0; i < n; ++i) {
    bottom += " " + std::to_string(n - i);
    top += " " + std::to_string(n + i + 1);
    const std::size_t k = (i + 1) % n;
    obj += "f " + std::to_string(i + 1) + " " + std::to_string(k + 1) + " " + std::to_string(n + k + 1) +
           " " + std::to_string(n + i + 1) + "\n";
  }
  return obj + bottom + "\n" + top + "\n";
}

TEST(MeshFile, TriangulatesLargePolygons) {
  // With more corners, triangles of star and comb are flat by the tolerance of cleaning, 1e-6 of the extent.
  constexpr int kFewCorners = 2'000, kPolygonCorners = 20'000;
  std::vector<std::pair<double, double>> star, comb, frame, spiral;
  for (int i = 0; i < kFewCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kFewCorners, r = i % 2 == 0 ? 10.0 : 9.0;
    star.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  // Teeth of a comb, a rectangle with many corners on its sides, an arm that winds inwards and back.
  comb.emplace_back(kFewCorners, -kFewCorners);
  for (int i = kFewCorners; i-- > 0;) comb.emplace_back(i, i % 2 == 0 ? 5.0 : 0.0);
  comb.emplace_back(0.0, -kFewCorners);
  for (int i = 0; i < kPolygonCorners / 4; ++i) frame.emplace_back(i, 0.0);
  for (int i = 0; i < kPolygonCorners / 4; ++i) frame.emplace_back(kPolygonCorners / 4, i);
  for (int i = 0; i < kPolygonCorners / 4; ++i)
    frame.emplace_back(kPolygonCorners / 4 - i, kPolygonCorners / 4);
  for (int i = 0; i < kPolygonCorners / 4; ++i) frame.emplace_back(0.0, kPolygonCorners / 4 - i);
  for (int i = 0; i < kPolygonCorners / 2; ++i) {
    const double a = 0.05 * i;
    spiral.emplace_back((10.0 + a) * std::cos(a), (10.0 + a) * std::sin(a));
  }
  for (int i = kPolygonCorners / 2; i-- > 0;) {
    const double a = 0.05 * i;
    spiral.emplace_back((12.0 + a) * std::cos(a), (12.0 + a) * std::sin(a));
  }
  std::reverse(spiral.begin(), spiral.end());
  for (const auto* polygon : {&star, &comb, &frame, &spiral}) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const auto& [x0, y0] = (*polygon)[i];
      const auto& [x1, y1] = (*polygon)[(i + 1) % polygon->size()];
      area += 0.5 * (x0 * y1 - x1 * y0);
    }
    const auto mesh = parseMesh(objOfPolygon(*polygon), "obj", "f");
    EXPECT_EQ(mesh.report.open_edges, 0u);
    EXPECT_NEAR(mesh.report.volume, std::abs(area), 1e-5 * std::abs(area));
  }
}

std::string dae(const std::string& unit, const std::string& primitives, const std::string& scene) {
  return R"(<?xml version="1.0"?><COLLADA><!-- <x> --><asset>)" + unit + R"(<up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="s"><float_array id="a" count="13">9 0 0 0 1 0 0 0 1 0
0 0 1</float_array><technique_common><accessor source="#a" offset="1" count="4" stride="3"/></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#s"/></vertices>)" +
         primitives + R"(</mesh></geometry></library_geometries><library_nodes><node id="n">
<instance_geometry url="#g"/></node></library_nodes><library_visual_scenes><visual_scene id="w">)" +
         scene + R"(</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>)";
}
const std::string kTriangles =
    R"(<triangles><input semantic="NORMAL" source="#s" offset="1"/><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 0 2 0 1 0 0 0 1 0 3 0 1 0 2 0 3 0 2 0 0 0 3 0</p></triangles>)";
const std::string kInstance = R"(<node><instance_geometry url="#g"/></node>)";

TEST(MeshFileDae, AppliesUnitAndKeepsAxes) {
  expectTetrahedron(parseMesh(dae("", kTriangles, kInstance), "dae", "f"), 1.0);
  const auto inches = parseMesh(dae(R"(<unit meter="0.0254"/>)", kTriangles, kInstance), "dae", "f");
  expectTetrahedron(inches, 0.0254);
  const auto scaled = parseMesh(dae(R"(<unit meter="0.5"/>)", kTriangles, kInstance), "dae", "f", 0.1);
  expectTetrahedron(scaled, 0.05);
  // corner y of the file stays y
  EXPECT_NEAR(geometry::bounds(inches.mesh).upper.y(), 0.0254, 1e-15);
}

TEST(MeshFileDae, AppliesNodeTransforms) {
  const auto m =
      parseMesh(dae("", kTriangles,
                    R"(<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale>
<node><matrix>1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_node url="#n"/></node></node>)"),
                "dae", "f");
  // x of the file, moved by 3 and doubled, points along y; y along -x.
  const geometry::Bounds b = geometry::bounds(m.mesh);
  EXPECT_LE((b.lower - Vector3d(9, 6, 0)).norm(), 1e-14);
  EXPECT_LE((b.upper - Vector3d(10, 8, 1)).norm(), 1e-14);
  EXPECT_NEAR(m.report.volume, 1.0 / 3, 1e-14);
  // A mirror turns the winding, and the reader turns it back.
  const auto mirrored = parseMesh(
      dae("", kTriangles, R"(<node><scale>1 1 -1</scale><instance_node url="#n"/></node>)"), "dae", "f");
  expectTetrahedron(mirrored, 1.0);
  EXPECT_TRUE(mirrored.report.remarks.empty());
}

TEST(MeshFileDae, ReadsAllPrimitives) {
  const std::string input = R"(<input semantic="VERTEX" source="#v" offset="0"/>)";
  for (const std::string& primitives :
       {"<polylist>" + input + "<vcount>3 3 3 3</vcount><p>0 2 1 0 1 3 1 2 3 2 0 3</p></polylist>",
        "<polygons>" + input + "<p>0 2 1</p><p>0 1 3</p><p>1 2 3</p><p>2 0 3</p></polygons>",
        "<trifans>" + input + "<p>0 2 1 3 2</p></trifans><triangles>" + input + "<p>1 2 3</p></triangles>",
        "<tristrips>" + input + "<p>0 2 1 3 0 2</p></tristrips>"})
    expectTetrahedron(parseMesh(dae("", primitives, kInstance), "dae", "f"), 1.0);
}

TEST(MeshFileDae, RejectsUnboundedInstances) {
  std::string nodes = dae("", kTriangles, R"(<node id="m"><instance_node url="#m"/></node>)");
  EXPECT_THROW(parseMesh(nodes, "dae", "f"), ParseError);
  // 2^60 tetrahedra in a few lines
  std::string scene = R"(<node id="k0"><instance_geometry url="#g"/></node>)";
  for (int i = 1; i <= 60; ++i) {
    const std::string below = R"(<instance_node url="#k)" + std::to_string(i - 1) + R"("/>)";
    scene += R"(<node id="k)" + std::to_string(i) + "\">" + below + below + "</node>";
  }
  EXPECT_THROW(parseMesh(dae("", kTriangles, scene), "dae", "f"), ParseError);
  EXPECT_THROW(parseMesh(std::string(1 << 20, '<'), "dae", "f"), ParseError);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THROW(parseMesh(deep, "dae", "f"), ParseError);
}

TEST(MeshFile, TriangulatesConcavePolygonsWithinOutline) {
  // A prism over an L of area 3 and height 1; its L is one polygon of 6 corners, with a seventh on a side.
  const auto m = parseMesh(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 1 0\n"
      "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\nv 0 1 1\n"
      "f 7 6 5 4 3 2 1\nf 8 9 10 11 12 13 14\n"
      "f 1 2 9 8\nf 2 3 10 9\nf 3 4 11 10\nf 4 5 12 11\nf 5 6 13 12\nf 6 7 14 13\nf 7 1 8 14\n",
      "obj", "f");
  EXPECT_TRUE(m.report.watertight);
  EXPECT_NEAR(m.report.volume, 3.0, 1e-14);
  EXPECT_NEAR(geometry::surfaceArea(m.mesh), 2 * 3.0 + 8.0, 1e-13);
  EXPECT_EQ(m.report.degenerate_triangles, 0u);
}

TEST(MeshFile, DroppingFlatTrianglesKeepsMeshClosed) {
  // The tetrahedron with a vertex in the middle of the side from 1 to 2: one face has it, the other is
  // joined to it by a flat triangle.
  const auto m = parseMesh(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.5 0 0\nf 1 3 2\nf 1 5 4\nf 5 2 4\nf 1 2 5\nf 2 3 4\nf 3 1 "
      "4\nf 3 3 1\n",
      "obj", "f");
  EXPECT_EQ(m.report.degenerate_triangles, 2u);
  EXPECT_TRUE(m.report.watertight);
  EXPECT_EQ(m.mesh.triangles.size(), 6u);
  EXPECT_NEAR(m.report.volume, 1.0 / 6, 1e-15);
  EXPECT_THAT(m.report.remarks, Contains("2 degenerate triangles were dropped."));
}

TEST(MeshFile, CorrectsInsideOutMeshes) {
  const auto m =
      parseMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n", "obj", "f");
  expectTetrahedron(m, 1.0);
  EXPECT_THAT(m.report.remarks, Contains(HasSubstr("was inside out")));
}

TEST(MeshFile, RemarksUnlikelySize) {
  EXPECT_THAT(parseMesh(kObj, "obj", "f", 350.0).report.remarks,
              Contains("The mesh is 350 m large: probably millimetres, scale: 0.001"));
  EXPECT_THAT(parseMesh(kObj, "obj", "f", 1e-4).report.remarks, Contains(HasSubstr("0.0001 m small")));
  EXPECT_TRUE(parseMesh(kObj, "obj", "f", 19.9).report.remarks.empty());
}

struct Bad {
  const char* format;
  std::string content;
  const char* says;
};

TEST(MeshFile, RejectsBadContentWithFileName) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto not_finite = kCorners;
  not_finite[10] = nan;
  std::string noise;
  for (std::uint32_t i = 0; i < 5000; ++i) noise += static_cast<char>((i * 2654435761u) >> 13);
  const std::string giant = "2147483647";
  const Bad cases[] = {
      {"stl", "", "neither"},
      {"stl", noise, "claims"},
      {"stl", binaryStl(0xffffffffu, kCorners), "4294967295 triangles, the file has room for 4"},
      {"stl", binaryStl(5, kCorners), "room for 4"},
      {"stl", binaryStl(0, {}), "no triangle"},
      {"stl", binaryStl(4, not_finite), "not finite in triangle 2"},
      {"stl", "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", ":5: error: found a facet of 2"},
      {"stl", "solid a\nvertex 0 0 nan\n", ":2: error: found \"nan\""},
      {"stl", "solid a\nvertex 0 0 1\n", "ends within"},
      {"stl", "solid a\nendsolid", "no triangle"},
      {"obj", noise, "no triangle"},
      {"obj", "v 1 2\n", ":1: error: found nothing, expected a finite number"},
      {"obj", "v 1 2 inf\n", "\"inf\""},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ":4: error: found a face with vertex 3"},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "\"0\""},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "\"-4\""},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n", "vertex number"},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n", "no triangle"},
      {"obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "degenerate triangles only"},
      {"obj", "v 0 0 0\nv 1e9 0 0\nv 0 1 0\nf 1 2 3\n", "at most 1e+06 m"},
      {"off", noise, "expected OFF"},
      {"off", "OFF\n", "the file ends"},
      {"off", "OFF " + giant + " " + giant + " 0\n0 0 0\n", "the file ends, expected a vertex"},
      {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + giant + " 0 1 2\n", "found nothing"},
      {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 NaN\n3 0 1 2\n", ":5: error: found \"NaN\""},
      {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "vertex 3"},
      {"off", "4OFF\n3 1 0\n", "three coordinates"},
      {"ply", noise, "no \"ply\""},
      {"ply", "ply\nformat ascii 1.0\n", "ends within the header"},
      {"ply", "ply\nformat odd 1.0\nend_header\n", "\"odd\""},
      {"ply", "ply\nend_header\n", "without a format"},
      {"ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\n", "2^31"},
      {"ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "no property y"},
      {"ply", plyHeader("ascii"), "the file ends before"},
      {"ply", plyHeader("ascii") + "9 0 0 nan\n", "\"nan\""},
      {"ply", binaryPly(false).substr(0, 250), "the file ends before"},
      {"ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex " + giant +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + giant +
           "\nproperty list uint int vertex_index\nend_header\n0123",
       "the file ends before"},
      {"ply",
       "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int "
       "vertex_index\nend_header\n"
       "\xfe\xff\xff\xff",
       "the file ends before"},
      {"dae", noise, "zero byte"},
      {"dae", "<COLLADA>", "the file ends"},
      {"dae", "<html></html>", "expected <COLLADA>"},
      {"dae", "<COLLADA></x>", "expected </COLLADA>"},
      {"dae", dae("", kTriangles, ""), "no triangle"},
      {"dae", dae("<unit meter=\"-1\"/>", kTriangles, kInstance), "positive"},
      {"dae",
       dae("", "<triangles><input semantic=\"VERTEX\" source=\"#v\"/><p>0 1 4</p></triangles>", kInstance),
       "vertex 4"},
      {"dae", dae("", "<triangles><input semantic=\"VERTEX\" source=\"#w\"/></triangles>", kInstance),
       "<vertices>"},
      {"dae",
       dae("", "<triangles><input semantic=\"VERTEX\" source=\"#v\" offset=\"2000000000\"/></triangles>",
           kInstance),
       "expected 0 to 63"},
      {"", kObj, "expected stl, obj, ply, off, dae"},
      {"3ds", noise, "3ds"},
      {"gltf", noise, "gltf"},
      {"x", noise, "cannot be read as x"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.format) + " " + c.content.substr(0, 60));
    try {
      parseMesh(c.content, c.format, "the_file");
      ADD_FAILURE() << "was accepted";
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), AllOf(HasSubstr("the_file"), HasSubstr(c.says)));
      EXPECT_EQ(e.pos().file, "the_file");
    }
  }
}

TEST(MeshFile, ReadsOtherFormatsThroughAssimp) {
  // Neutral File Format: a tetrahedron as four polygons.
  const auto m = parseMesh(
      "p 3\n0 0 0\n0 1 0\n1 0 0\np 3\n0 0 0\n1 0 0\n0 0 1\np 3\n1 0 0\n0 1 0\n0 0 1\n"
      "p 3\n0 1 0\n0 0 0\n0 0 1\n",
      "nff", "f");
  EXPECT_EQ(m.mesh.triangles.size(), 4u);
  EXPECT_NEAR(geometry::surfaceArea(m.mesh), 1.5 + std::sqrt(3.0) / 2, 1e-6);
}

TEST(MeshFile, RejectsBadPathsAndScales) {
  const ScratchFolder d;
  EXPECT_THROW(loadMesh(d.path()), ParseError);
  EXPECT_THROW(loadMesh(d.path() / "none.stl"), ParseError);
  EXPECT_THROW(loadMesh(d.write("empty.stl", "")), ParseError);
  for (const double scale : {0.0, -1.0, kNaN, kInfinity})
    EXPECT_THROW(parseMesh(kObj, "obj", "f", scale), UsageError);
}

TEST(MeshFile, RoundTrips) {
  const ScratchFolder d;
  const auto mesh = geometry::tessellate(geometry::Capsule{0.1, 0.3}, 1e-3);
  saveMesh(mesh, d.path() / "a.obj");
  saveMesh(mesh, d.path() / "a.STL");
  const auto obj = loadMesh(d.path() / "a.obj");
  const auto stl = loadMesh(d.path() / "a.STL");
  // Vertices are numbered anew, in the order in which triangles use them.
  const auto expected = geometry::weld(mesh, 0.0);
  EXPECT_EQ(obj.mesh.vertices, expected.vertices);
  EXPECT_EQ(obj.mesh.triangles, expected.triangles);
  EXPECT_EQ(stl.mesh.triangles, expected.triangles);
  for (std::size_t i = 0; i < expected.vertices.size(); ++i)
    EXPECT_LE((stl.mesh.vertices[i] - expected.vertices[i]).norm(), 1e-7);  // single precision
  EXPECT_EQ(std::filesystem::file_size(d.path() / "a.STL"), 84 + 50 * mesh.triangles.size());
  EXPECT_THROW(saveMesh(mesh, d.path() / "a.ply"), UsageError);
  EXPECT_THROW(saveMesh(mesh, d.path() / "no" / "a.stl"), UsageError);
}

TEST(MeshReport, CountsEdgesAndPieces) {
  geometry::TriangleMesh two;  // two triangles that share a side and run the same way along it
  two.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
  two.triangles = {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}};
  const auto r = inspect(two);
  EXPECT_EQ(r.flipped_edges, 1u);
  EXPECT_EQ(r.open_edges, 7u);
  EXPECT_EQ(r.components, 2u);
  EXPECT_FALSE(r.watertight);
  two.triangles.push_back({1, 0, 2});
  EXPECT_EQ(inspect(two).non_manifold_edges, 1u);
  EXPECT_EQ(inspect(geometry::TriangleMesh{}).remarks.size(), 1u);
  const auto ball = inspect(geometry::tessellate(geometry::Sphere{1.0}, 0.01));
  EXPECT_TRUE(ball.watertight);
  EXPECT_EQ(ball.components, 1u);
  EXPECT_TRUE(ball.remarks.empty());
}

}  // namespace mesh_file_test
}  // namespace abstand::mesh_file
