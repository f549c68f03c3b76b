// Eight samples of a distance field at once. Internal to the engine; included by the kernels only.
#pragma once

#include "core/kernels/field_view.hpp"
#include "core/kernels/lanes.hpp"

namespace abstand::kernels {
namespace {

struct Point8 {
  Float8 x, y, z;
};

/// f: certified lower bound of the true signed distance. s: best estimate.
struct Distance8 {
  Float8 f, s;
};

inline Float8 between(Float8 t, Float8 a, Float8 b) { return multiplyAdd(t, b - a, a); }

/// The far field at any point; NaN gives 0.
inline Distance8 farAt(const field::FarField::View& v, const Point8& p) {
  const Float8 x = p.x - splat(v.centre[0]), y = p.y - splat(v.centre[1]), z = p.z - splat(v.centre[2]);
  const Float8 r =
      max(max(abs(x) * splat(v.inv_half[0]), abs(y) * splat(v.inv_half[1])), abs(z) * splat(v.inv_half[2]));
  Int8 level = splatInt(0);
  for (int l = 0; l + 1 < v.levels; ++l) level = level + count(splat(v.width[l]) < r);
  const Float8 inv_h = lookUp(v.inv_h, level), h2 = lookUp(v.h2, level);
  const auto coordinate = [&](Float8 local, int axis, Int8& cell) {
    const Float8 g = multiplyAdd(local, inv_h, splat(v.middle[axis]));
    // The argument order turns NaN into 0.
    const Float8 kept = max(min(g, splat(2.0f * v.middle[axis])), splat(0.0f));
    cell = min(truncate(kept), splatInt(v.n[axis] - 2));
    return kept - toFloat(cell);
  };
  Int8 i, j, k;
  const Float8 tx = coordinate(x, 0, i), ty = coordinate(y, 1, j), tz = coordinate(z, 2, k);
  const int nx = v.n[0], nxy = v.n[0] * v.n[1];
  const Int8 at = ((level * splatInt(v.n[2]) + k) * splatInt(v.n[1]) + j) * splatInt(nx) + i;
  // Interpolates the squares; `plain` gets the interpolated distances.
  const auto along = [&](int offset, Float8& plain) {
    Float8 a, b;
    gatherTwo(v.values + offset, at, a, b);
    plain = between(tx, a, b);
    return between(tx, a * a, b * b);
  };
  Float8 d00, d10, d01, d11;
  const Float8 s00 = along(0, d00), s10 = along(nx, d10), s01 = along(nxy, d01), s11 = along(nxy + nx, d11);
  const Float8 q2 = lookUp(v.q2, level);
  const Float8 sum = between(tz, between(ty, s00, s10), between(ty, s01, s11)) * q2;
  const Float8 plain = between(tz, between(ty, d00, d10), between(ty, d01, d11)) * sqrt(q2);
  const Float8 one = splat(1.0f), zero = splat(0.0f);
  const Float8 loss = h2 * multiplyAdd(tx, one - tx, multiplyAdd(ty, one - ty, tz * (one - tz)));
  const Float8 summed = sum - splat(field::FarField::kSummed) * multiplyAdd(splat(4.0f), h2, sum);
  const Float8 rounding = lookUp(v.rounding, level);
  const Float8 from_ball =
      sqrt(multiplyAdd(x, x, multiplyAdd(y, y, z * z))) * splat(1.0f - field::FarField::kSummed) -
      splat(v.ball);
  const Mask8 beyond = splat(v.outermost) < r;
  const Float8 inside_f = sqrt(max(summed - loss, zero)) - rounding;
  Distance8 d;
  d.f = max(select(beyond, from_ball, max(inside_f, from_ball)), zero);
  // Interpolation is exact in front of a plane, the bound in front of a vertex. Near the body the surface is
  // mostly like a plane; farther away the mean of both is used.
  const Mask8 near = toFloat(level) < splat(0.5f);
  const Float8 smallest = max(inside_f, zero);
  d.s = select(beyond, d.f, select(near, max(plain, smallest), splat(0.5f) * (plain + smallest)));
  return d;
}

/// Float and mixed fields: the near field where it is stored, the far field elsewhere.
class NearLanes {
 public:
  explicit NearLanes(const FieldView& field) : near_(field.near), far_(field.far) {}

  Distance8 points(const Point8& p, const TreeView&, std::uint32_t) const {
    Float8 s;
    const Mask8 there = sample(p, s);
    const int found = bits(there);
    if (found == 0xff) return {lowerFromSample(s), s};
    Distance8 d = farAt(far_, p);
    if (found != 0) d = {select(there, lowerFromSample(s), d.f), select(there, s, d.s)};
    takeDeep(p, d);
    return d;
  }
  /// Lower bound of the distance of all points in the spheres.
  Float8 spheres(const Point8& p, Float8 radius) const {
    Float8 s;
    const Mask8 there = sample(p, s);
    const int found = bits(there);
    if (found == 0xff) return lowerFromSample(s) - radius;
    Distance8 d = farAt(far_, p);
    if (found != 0) d.f = select(there, lowerFromSample(s), d.f);
    takeDeep(p, d);
    return d.f - radius;
  }
  /// Like points(); where s exceeds `largest`, some value of s above it.
  Distance8 within(const Point8& p, const TreeView& tree, std::uint32_t first, float largest) const {
    if (!(largest < near_.band)) return points(p, tree, first);
    Float8 s;
    const Mask8 there = sample(p, s);
    const Float8 band = splat(near_.band);
    Distance8 d{select(there, lowerFromSample(s), band), select(there, s, band)};
    if (bits(there) != 0xff) takeDeep(p, d);
    return d;
  }
  /// m; largest excess of s over the true distance.
  float error() const { return near_.error_bound; }
  /// Lower bound of every estimate s <= `margin` of points in the spheres, from two arguments. The true
  /// distance is at least s - error; and s falls from the sample at the centre by at most slope times radius,
  /// as long as the path stays in stored blocks or leaves them at a distance that the slope cannot use up.
  /// Deep blocks have a larger error, but a path into one passes samples below -kInnerBand voxels plus an
  /// error, hence below a margin that is not negative; for a negative margin the larger error is used and the
  /// slope is not.
  Float8 contacts(const Point8& p, Float8 radius, float margin) const {
    Float8 s;
    const Mask8 there = sample(p, s);
    const bool any_depth = near_.deep == nullptr || margin >= 0.0f;
    const Float8 error = splat(any_depth ? near_.error_bound : near_.deep_error), band = splat(near_.band);
    Float8 f = lowerFromSample(s);
    if (bits(there) != 0xff) {
      // Elsewhere the surface is farther than the band; the far field is sampled where that bound is not
      // enough.
      const int doubtful = bits(band - radius - error <= splat(margin)) & ~bits(there);
      Distance8 d{select(there, f, doubtful == 0 ? band : max(band, farAt(far_, p).f)), s};
      takeDeep(p, d);
      f = d.f;
    }
    if (!any_depth) return f - radius - error;
    const Float8 fall = splat(near_.slope) * radius;
    const Mask8 steady = there & (fall < splat(near_.band - near_.error_bound - margin));
    return max(f - radius - error, select(steady, s - fall, splat(-__builtin_huge_valf())));
  }

 private:
  static constexpr int kRow = field::NearField::kVertices, kSlice = kRow * kRow;

  /// In voxels relative to the grid's corner.
  Point8 inGrid(const Point8& p) const {
    const Float8 inv_h = splat(near_.inv_h);
    return {(p.x - splat(near_.origin[0])) * inv_h, (p.y - splat(near_.origin[1])) * inv_h,
            (p.z - splat(near_.origin[2])) * inv_h};
  }
  Mask8 within(const Point8& g) const {
    const Float8 zero = splat(0.0f);
    // The form of the comparisons also rejects NaN.
    return (zero <= g.x) & (zero <= g.y) & (zero <= g.z) & (g.x < splat(near_.cells[0])) &
           (g.y < splat(near_.cells[1])) & (g.z < splat(near_.cells[2]));
  }

  Mask8 sample(const Point8& p, Float8& s) const {
    const Float8 zero = splat(0.0f);
    const auto [gx, gy, gz] = inGrid(p);
    const Mask8 inside = within({gx, gy, gz});
    s = zero;
    if (bits(inside) == 0) return inside;
    const Int8 i = truncate(select(inside, gx, zero)), j = truncate(select(inside, gy, zero)),
               k = truncate(select(inside, gz, zero));
    const Int8 block_at =
        (shiftRight<3>(k) * splatInt(near_.blocks[1]) + shiftRight<3>(j)) * splatInt(near_.blocks[0]) +
        shiftRight<3>(i);
    const Int8 block = gather(near_.block_index, block_at, inside);
    const Mask8 there = inside & isAtLeastZero(block);
    if (bits(there) == 0) return there;
    const Int8 seven = splatInt(field::NearField::kCells - 1);
    const Int8 at = (block * splatInt(field::NearField::kBlockValues) + (k & seven) * splatInt(kSlice) +
                     (j & seven) * splatInt(kRow) + (i & seven)) *
                    count(there);
    const Float8 x = gx - toFloat(i), y = gy - toFloat(j), z = gz - toFloat(k);
    const auto along = [&](int offset) {
      Float8 a, b;
      gatherTwo(near_.values + offset, at, a, b);
      return between(x, a, b);
    };
    s = between(z, between(y, along(0), along(kRow)), between(y, along(kSlice), along(kSlice + kRow))) *
        splat(near_.quantum);
    return there;
  }

  /// Sets the lanes in deep blocks.
  void takeDeep(const Point8& p, Distance8& d) const {
    if (near_.deep == nullptr) return;
    const Float8 zero = splat(0.0f);
    const Point8 g = inGrid(p);
    const Mask8 inside = within(g);
    const Int8 i = shiftRight<3>(truncate(select(inside, g.x, zero))),
               j = shiftRight<3>(truncate(select(inside, g.y, zero))),
               k = shiftRight<3>(truncate(select(inside, g.z, zero)));
    const Int8 block = gather(near_.block_index,
                              (k * splatInt(near_.blocks[1]) + j) * splatInt(near_.blocks[0]) + i, inside);
    const Mask8 deep = inside & isEqual(block, splatInt(static_cast<int>(field::NearField::kDeepBlock)));
    if (bits(deep) == 0) return;
    const int row = near_.deep_vertices[0], slice = row * near_.deep_vertices[1];
    const Int8 at = (k * splatInt(slice) + j * splatInt(row) + i) * count(deep);
    const Float8 edge = splat(field::NearField::kCells), per_edge = splat(1.0f / field::NearField::kCells);
    const Float8 x = (g.x - toFloat(i) * edge) * per_edge, y = (g.y - toFloat(j) * edge) * per_edge,
                 z = (g.z - toFloat(k) * edge) * per_edge;
    const auto along = [&](int offset) {
      Float8 a, b;
      gatherTwo(near_.deep + offset, at, a, b);
      return between(x, a, b);
    };
    const Float8 s =
        between(z, between(y, along(0), along(row)), between(y, along(slice), along(slice + row))) *
        splat(near_.deep_quantum);
    d = {select(deep, s - splat(near_.deep_error), d.f), select(deep, s, d.s)};
  }

  /// Interpolation of squared distances is too large by at most 3/4 h^2 (far_field.hpp), so s >= sqrt(3)/2 h
  /// proves outside and a distance of at least sqrt(s^2 - 3/4 h^2), apart from quantisation and rounding. For
  /// smaller s the field's error bound is used.
  Float8 lowerFromSample(Float8 s) const {
    const Float8 zero = splat(0.0f);
    const Float8 plain = s - splat(near_.error_bound);
    const Float8 smallest = s - splat(near_.quantum);
    const Float8 rest = smallest * smallest - splat(0.75f * near_.h2);
    const Mask8 outside = (zero < smallest) & (zero < rest);
    return select(outside, max(plain, sqrt(max(rest, zero)) - splat(near_.quantum)), plain);
  }

  const field::NearField::View& near_;
  const field::FarField::View& far_;
};

/// The thesis's layers, one lane at a time, with the far field beyond.
class LayeredLanes {
 public:
  explicit LayeredLanes(const FieldView& field) : field_(field) {}

  /// V(P) = n . e + v s with e from the point to the voxel's centre [thesis eq. 2.4]; distance = -V.
  Distance8 points(const Point8& p, const TreeView& tree, std::uint32_t first) const {
    const Distance8 far = farAt(field_.far, p);
    float x[8], y[8], z[8], f[8], s[8];
    store(x, p.x);
    store(y, p.y);
    store(z, p.z);
    store(f, far.f);
    store(s, far.s);
    for (int lane = 0; lane < 8; ++lane) {
      int voxel[3];
      const float at[3] = {x[lane], y[lane], z[lane]};
      if (!voxelOf(at, voxel)) continue;
      const field::LayerOfVoxel of = field::layerOf(field_.layers, voxel[0], voxel[1], voxel[2]);
      f[lane] = lower(of, f[lane]);
      const float n[3] = {tree.nx[first + lane], tree.ny[first + lane], tree.nz[first + lane]};
      float along = 0.0f;
      for (int a = 0; a < 3; ++a) {
        const float n_F = tree.X_FP[4 * a] * n[0] + tree.X_FP[4 * a + 1] * n[1] + tree.X_FP[4 * a + 2] * n[2];
        along += n_F * (field_.first_centre[a] + static_cast<float>(voxel[a]) * field_.voxel - at[a]);
      }
      s[lane] = -(along + static_cast<float>(of.layer) * field_.voxel);
    }
    return {load(f), load(s)};
  }
  Float8 spheres(const Point8& p, Float8 radius) const {
    float x[8], y[8], z[8], f[8];
    store(x, p.x);
    store(y, p.y);
    store(z, p.z);
    store(f, farAt(field_.far, p).f);
    for (int lane = 0; lane < 8; ++lane) {
      int voxel[3];
      const float at[3] = {x[lane], y[lane], z[lane]};
      if (voxelOf(at, voxel))
        f[lane] = lower(field::layerOf(field_.layers, voxel[0], voxel[1], voxel[2]), f[lane]);
    }
    return load(f) - radius;
  }
  Distance8 within(const Point8& p, const TreeView& tree, std::uint32_t first, float) const {
    return points(p, tree, first);
  }
  /// The result of contacts() is below the true distance here.
  float error() const { return 0.0f; }
  Float8 contacts(const Point8& p, Float8 radius, float) const {
    return spheres(p, radius) - splat(2.0f * kDiagonal * field_.voxel);
  }

 private:
  static constexpr float kDiagonal = 1.7320508f;

  bool voxelOf(const float p[3], int voxel[3]) const {
    for (int a = 0; a < 3; ++a) {
      const float local = (p[a] - field_.first_centre[a]) / field_.voxel;
      // The form of the comparison also rejects NaN.
      if (!(local > -0.5f && local < static_cast<float>(field_.size[a]) - 0.5f)) return false;
      voxel[a] = static_cast<int>(local + 0.5f);
      if (voxel[a] >= field_.size[a]) return false;
    }
    return true;
  }
  /// Layers are Chebyshev steps between voxels: layer -k leaves at least k - 1 whole voxels between, and
  /// inside no point of a voxel k steps from the surface voxels is deeper than k + 1 voxel diagonals.
  float lower(field::LayerOfVoxel of, float far) const {
    if (of.layer >= 0) return -static_cast<float>(of.layer + of.slack + 1) * kDiagonal * field_.voxel;
    const float steps = static_cast<float>(-of.layer - of.slack - 1) * field_.voxel;
    return steps > far ? steps : far;
  }

  const FieldView& field_;
};

}  // namespace
}  // namespace abstand::kernels
