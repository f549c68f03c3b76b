#include "core/haptic/near_field.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/parallel.hpp"

namespace abstand {
namespace {

// A 1-Lipschitz function differs from its trilinear interpolation by at most sum w_i |p - x_i|, which is
// largest, half a cell's diagonal, in the middle of the cell.
const double kLipschitzError = std::sqrt(3.0) / 2.0;
// Of float values and positions within some metres, in voxels.
constexpr double kFloatError = 1e-4;
constexpr std::uint32_t kMostBlocks = 1u << 20;  // 3 GB

}  // namespace

NearField::NearField(const Surface& surface, const VoxelGrid& grid, double band, int threads)
    : grid_(grid),
      ox_(static_cast<float>(grid.first_centre.x())),
      oy_(static_cast<float>(grid.first_centre.y())),
      oz_(static_cast<float>(grid.first_centre.z())),
      inv_h_(static_cast<float>(1.0 / grid.voxel_size)),
      error_bound_((kLipschitzError + kFloatError) * grid.voxel_size),
      band_(band) {
  const double h = grid.voxel_size;
  for (int i = 0; i < 3; ++i) blocks_[i] = std::max(1, (grid.size[i] + kCells - 2) / kCells);
  const std::size_t block_count = static_cast<std::size_t>(blocks_[0]) * blocks_[1] * blocks_[2];
  block_index_.assign(block_count, kNoBlock);

  // A block is wanted when some point of it may lie in the band, or inside the body.
  const double half_diagonal = 0.5 * kCells * h * std::sqrt(3.0);
  std::vector<char> wanted(block_count, 1);
  if (std::isfinite(band))
    parallelFor(threads, block_count, [&](std::size_t b) {
      const Vector3d corner(static_cast<double>(b % blocks_[0]),
                            static_cast<double>(b / blocks_[0] % blocks_[1]),
                            static_cast<double>(b / blocks_[0] / blocks_[1]));
      const Vector3d centre = grid.first_centre + h * kCells * (corner.array() + 0.5).matrix();
      const SurfacePoint nearest = surface.closest(centre);
      wanted[b] = nearest.distance - half_diagonal <= band || surface.inside(centre, nearest);
    });
  std::uint32_t count = 0;
  for (std::size_t b = 0; b < block_count; ++b)
    if (wanted[b]) block_index_[b] = count++;
  constexpr std::size_t kValues = static_cast<std::size_t>(kVertices) * kVertices * kVertices;
  if (count > kMostBlocks)
    throw UsageError("the field needs " + std::to_string(count) + " blocks, expected at most " +
                     std::to_string(kMostBlocks) +
                     ": take a larger voxel, fewer outer layers or the mixed field");
  values_.resize(count * kValues);

  // Exact distances at the vertices; neighbours share their nearest triangle, so each hints the next.
  parallelFor(threads, block_count, [&](std::size_t b) {
    if (block_index_[b] == kNoBlock) return;
    const Vector3i corner =
        kCells * Vector3i(static_cast<int>(b % blocks_[0]), static_cast<int>(b / blocks_[0] % blocks_[1]),
                          static_cast<int>(b / blocks_[0] / blocks_[1]));
    float* out = &values_[block_index_[b] * kValues];
    std::uint32_t hint = kNoHint;
    for (int k = 0; k < kVertices; ++k)
      for (int j = 0; j < kVertices; ++j)
        for (int i = 0; i < kVertices; ++i) {
          const Vector3d p = grid.first_centre + h * (corner + Vector3i(i, j, k)).cast<double>();
          const SurfacePoint nearest = surface.closest(p, hint);
          hint = nearest.hint;
          *out++ = static_cast<float>(surface.inside(p, nearest) ? -nearest.distance : nearest.distance);
        }
  });
}

bool NearField::sample(float px, float py, float pz, float& distance) const {
  const float x = (px - ox_) * inv_h_, y = (py - oy_) * inv_h_, z = (pz - oz_) * inv_h_;
  // Written so that NaN fails.
  if (!(x >= 0.0f && y >= 0.0f && z >= 0.0f && x < static_cast<float>(blocks_[0] * kCells) &&
        y < static_cast<float>(blocks_[1] * kCells) && z < static_cast<float>(blocks_[2] * kCells)))
    return false;
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
  const std::uint32_t block =
      block_index_[(static_cast<std::size_t>(k / kCells) * blocks_[1] + j / kCells) * blocks_[0] +
                   i / kCells];
  if (block == kNoBlock) return false;
  constexpr std::size_t kRow = kVertices, kSlab = kRow * kVertices;
  const float* c =
      &values_[block * kSlab * kVertices + (k % kCells) * kSlab + (j % kCells) * kRow + i % kCells];
  const float u = x - static_cast<float>(i), v = y - static_cast<float>(j), w = z - static_cast<float>(k);
  const auto along = [u](const float* p) { return p[0] + u * (p[1] - p[0]); };
  const float near = along(c) + v * (along(c + kRow) - along(c));
  const float far = along(c + kSlab) + v * (along(c + kSlab + kRow) - along(c + kSlab));
  distance = near + w * (far - near);
  return true;
}

std::size_t NearField::memoryBytes() const {
  return values_.size() * sizeof(float) + block_index_.size() * sizeof(std::uint32_t);
}

}  // namespace abstand
