// Collision data of a body: surface, pointshell and distance fields.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "abstand/mesh.hpp"

namespace abstand {

/// Resolution of a structure, and options for building it.
struct StructureOptions {
  /// kMixed: float distances near the surface, a coarser field beyond. kFloat: float distances in the whole
  /// map. kLayered: the integer layers of the thesis (2.2).
  enum class Field { kLayered, kFloat, kMixed };

  double voxel_size{0.005};     ///< m; half of the smallest feature that matters
  double point_spacing{0.005};  ///< m, between points of the pointshell
  int outer_layers{20};         ///< layers of voxels outside the surface
  Field field{Field::kMixed};   ///< type of the distance field
  int threads{0};               ///< for building; 0: all cores; does not affect the bits
  /// Uses the cache folder of the user, shared by all programs of this library, to read and store structures:
  /// ABSTAND_CACHE, otherwise $XDG_CACHE_HOME/abstand, otherwise ~/.cache/abstand.
  bool cache{false};
};

/// Origin of a structure file.
enum class Origin {
  /// Untrusted: surface and options are read and checked, and everything else is built from them.
  kUnknown,
  /// Written by the user's own programs: the data of the engine is used without checks beyond a checksum
  /// against accidental damage. There is no protection against a forged file. If another version of the
  /// engine wrote it, as kUnknown.
  kOwn
};

/// Voxelmap and pointshell of one rigid body (thesis 4.2.2), with its exact surface. Constant and shared by
/// copies: copying is cheap, and any number of threads may use it at the same time.
class Structure {
 public:
  /// Builds the structure of a mesh. Equal vertices are merged. `name` is used in messages and files. Throws
  /// std::runtime_error for coordinates that are not finite, an invalid vertex index, no triangle of positive
  /// area, and options that do not fit the body. Any thread.
  static Structure build(const Mesh& mesh, const StructureOptions& options = {},
                         const std::string& name = "mesh");
  /// Builds the structure of an exact shape; throws likewise.
  static Structure build(const Shape& shape, const StructureOptions& options = {},
                         const std::string& name = "shape");

  /// Reads a file written by save(); docs/structure-files.md describes its layout. Throws std::runtime_error,
  /// one line, for a file that is missing, cut or damaged. `threads` and `cache`: as in StructureOptions. Any
  /// thread.
  static Structure load(const std::filesystem::path& file, Origin origin = Origin::kUnknown, int threads = 0,
                        bool cache = false);
  /// Writes a file, completely or not at all. Throws std::runtime_error. Any thread.
  void save(const std::filesystem::path& file) const;

  /// The name passed to build().
  const std::string& name() const;
  /// Resolution and field; `threads` and `cache` are the defaults.
  StructureOptions options() const;
  /// m^3; for a mesh by the divergence theorem.
  double volume() const;
  /// m, in the frame of the body, for constant density; reference point of torques.
  Eigen::Vector3d centreOfMass() const;
  /// m: upper bound on the distance of surface points from the origin of the frame.
  double radius() const;
  /// True if closed and consistently oriented, so that inside and outside are well-defined.
  bool watertight() const;
  /// m: bound on the error of a field value near the surface plus the covering radius of the pointshell.
  double errorBound() const;
  /// Number of points of the pointshell.
  std::size_t points() const;
  /// Number of voxels that the surface passes through.
  std::size_t surfaceVoxels() const;
  /// Size in memory (bytes).
  std::size_t memoryBytes() const;
  /// The surface as triangles: a tessellation within `sagitta` (m, positive) of a shape, or the mesh itself.
  Mesh mesh(double sagitta = 2e-4) const;

  /// @cond library
  struct Impl;
  explicit Structure(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  const Impl& impl() const { return *impl_; }
  /// @endcond

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace abstand
