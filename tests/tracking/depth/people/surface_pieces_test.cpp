// Pieces of plates, whose outlines and breadths are known.
#include "tracking/depth/people/surface_pieces.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/depth/people/painted_image.hpp"

namespace abstand::tracking {
namespace surface_pieces_test {

using testing::PaintedImage;

struct Divided {
  explicit Divided(PaintedImage& painted) : pieces(painted.camera()), is_thing(painted.labels().size(), 0) {
    pieces.divide(painted.image(), painted.labels(), 1);
  }
  SurfacePieces pieces;
  std::vector<std::uint8_t> is_thing;
};

// A square of 0.5 m at 2 m has 25 x 25 pixels.
TEST(SurfacePieces, MeasuresASquare) {
  PaintedImage painted;
  painted.plate(-0.25, 0.25, 0.75, 1.25, 2.0);
  Divided divided(painted);
  ASSERT_EQ(divided.pieces.pieces().size(), 1u);
  const SurfacePiece& square = divided.pieces.pieces().front();
  EXPECT_EQ(square.size(), 25u * 25u);
  EXPECT_NEAR(square.area, 25.0 * 25.0 * 4.0 / 1e4, 1e-6);
  const SurfacePieces::Outlines outlines = divided.pieces.outlines(square, painted.image(), divided.is_thing);
  EXPECT_EQ(outlines.whole.free, 4 * 25);
  EXPECT_EQ(outlines.whole.all(), 4 * 25);
  EXPECT_EQ(outlines.above.all(), 25);
  EXPECT_EQ(outlines.end.all(), 25 + 2 * 6) << "0.10 m are five rows, and the first";
  EXPECT_EQ(outlines.covers, -1);
  EXPECT_NEAR(divided.pieces.breadth(square, painted.image()), 25 * 2.0 / 100.0, 1e-6);
}

TEST(SurfacePieces, StepsDividePlatesAndGapsDoNot) {
  PaintedImage painted;
  painted.plate(-0.4, 0.0, 0.75, 1.25, 2.0);
  painted.plate(0.0, 0.4, 0.75, 1.25, 2.0 + 1.5 * static_cast<double>(SurfacePieces::stepAt(2.0f)));
  EXPECT_EQ(Divided(painted).pieces.pieces().size(), 2u);
  painted.clear();
  painted.plate(-0.4, 0.4, 0.75, 1.25, 2.0);
  for (int v = 0; v < painted.camera().height; ++v)
    for (const int u : {79, 80}) {
      painted.image().z[painted.pixel(u, v)] = 0.0f;
      painted.labels()[painted.pixel(u, v)] = 0;
    }
  EXPECT_EQ(Divided(painted).pieces.pieces().size(), 1u) << "two columns without a measurement";
}

TEST(SurfacePieces, OutlinesTellWhatIsBesideAPiece) {
  PaintedImage painted;
  painted.plate(-0.4, 0.0, 0.5, 1.0, 2.0);         // 0: far
  painted.plate(-0.1, 0.3, 0.5, 1.0, 1.6);         // hides its right border
  painted.plate(-0.4, 0.0, 0.9, 1.1, 1.2, false);  // and nobody's plate its top
  Divided divided(painted);
  ASSERT_EQ(divided.pieces.pieces().size(), 2u);
  const SurfacePiece far =
      divided.pieces.pieceAt(painted.pixelOf(-0.3, 0.6, 2.0), painted.image(), painted.labels(), 1);
  EXPECT_GT(far.size(), 0u);
  divided.pieces.divide(painted.image(), painted.labels(), 1);
  const auto& pieces = divided.pieces.pieces();
  const std::size_t k = pieces[0].size() == far.size() ? 0 : 1;
  SurfacePieces::Outlines outlines = divided.pieces.outlines(pieces[k], painted.image(), divided.is_thing);
  EXPECT_EQ(outlines.above.hidden, outlines.above.all()) << "the plate above is nearer";
  EXPECT_EQ(outlines.covers, static_cast<int>(1 - k));
  EXPECT_EQ(outlines.whole.beside, 0);
  const int hidden = outlines.whole.hidden;
  outlines = divided.pieces.outlines(pieces[1 - k], painted.image(), divided.is_thing);
  EXPECT_GT(outlines.whole.beside, 0) << "the far one is beside the near one";
  for (const std::uint32_t i : divided.pieces.pixels(pieces[1 - k])) divided.is_thing[i] = 1;
  outlines = divided.pieces.outlines(pieces[k], painted.image(), divided.is_thing);
  EXPECT_GT(outlines.whole.behind, 0);
  EXPECT_EQ(outlines.whole.behind + outlines.whole.hidden, hidden);
}

TEST(SurfacePieces, PieceOfAPixelWithAnotherLabelIsEmpty) {
  PaintedImage painted;
  painted.plate(-0.25, 0.25, 0.75, 1.25, 2.0);
  SurfacePieces pieces(painted.camera());
  EXPECT_EQ(pieces.pieceAt(0, painted.image(), painted.labels(), 1).size(), 0u);
  EXPECT_EQ(pieces.pieceAt(painted.pixelOf(0.0, 1.0, 2.0), painted.image(), painted.labels(), 1).size(),
            25u * 25u);
}

TEST(SurfacePieces, DoesNotAllocate) {
  PaintedImage painted;
  painted.person();
  SurfacePieces pieces(painted.camera());
  const std::vector<std::uint8_t> is_thing(painted.labels().size(), 0);
  const testing::NoAlloc guard;
  pieces.divide(painted.image(), painted.labels(), 1);
  pieces.outlines(pieces.pieces().front(), painted.image(), is_thing);
  pieces.breadth(pieces.pieces().front(), painted.image());
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace surface_pieces_test
}  // namespace abstand::tracking
