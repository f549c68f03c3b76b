// What queries read of a body: its surface, points on it and a field of distances about it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "abstand/mesh.hpp"

namespace abstand {

/// How fine a structure is, and how it is made.
struct StructureOptions {
  /// kMixed: float distances near the surface, a coarser field beyond. kFloat: over the whole map. kLayered:
  /// the integer layers of the thesis (2.2).
  enum class Field { kLayered, kFloat, kMixed };

  double voxel_size{0.005};     ///< m; half of the smallest feature that matters
  double point_spacing{0.005};  ///< m, from point to point of the pointshell
  int outer_layers{20};         ///< layers of voxels outside the surface
  Field field{Field::kMixed};   ///< of distances
  int threads{0};               ///< for building; 0: all cores. The bits do not depend on it.
  /// Look into the user's cache folder, where programs of this library keep what they built, and keep there
  /// what is built: ABSTAND_CACHE, else $XDG_CACHE_HOME/abstand, else ~/.cache/abstand.
  bool cache{false};
};

/// Whom a file of a structure is from.
enum class Origin {
  /// Anybody: surface and options are read, with all checks, and the rest is built from them.
  kUnknown,
  /// This user's own programs: what the engine had in memory is taken as it stands, after a checksum against
  /// accidents. Nothing protects from a file that somebody forged. Of another version of the engine, as
  /// kUnknown.
  kOwn
};

/// Voxelmap and pointshell of one rigid body (thesis 4.2.2), with its exact surface. Constant, and shared by
/// copies: copying is cheap, and any number of threads may use one at once.
class Structure {
 public:
  /// Takes a mesh. Equal vertices are merged. `name` goes into messages and files. Throws std::runtime_error
  /// for coordinates that are not finite, an index beyond the vertices, no triangle of positive area, and
  /// options that do not fit the body. Any thread.
  static Structure build(const Mesh& mesh, const StructureOptions& options = {},
                         const std::string& name = "mesh");
  /// Takes an exact shape; throws likewise.
  static Structure build(const Shape& shape, const StructureOptions& options = {},
                         const std::string& name = "shape");

  /// Reads a file of save(); docs/structure-files.md has its layout. Throws std::runtime_error, one line, for
  /// a file that is cut, damaged, or none. With `threads` and `cache` as in StructureOptions. Any thread.
  static Structure load(const std::filesystem::path& file, Origin origin = Origin::kUnknown, int threads = 0,
                        bool cache = false);
  /// Writes a file, whole or not at all. Throws std::runtime_error. Any thread.
  void save(const std::filesystem::path& file) const;

  /// As it was given to build().
  const std::string& name() const;
  /// Resolution and field; `threads` and `cache` are the defaults.
  StructureOptions options() const;
  /// m^3. Of a mesh by the divergence theorem.
  double volume() const;
  /// m, in the body's frame; torques are about it. Of constant density.
  Eigen::Vector3d centreOfMass() const;
  /// m: a point of the surface is at most this far from the frame's origin.
  double radius() const;
  /// Closed and consistently oriented: inside and outside are certain.
  bool watertight() const;
  /// m: how far a field value near the surface, and the distance between points and surface, may be off.
  double errorBound() const;
  /// Of the pointshell.
  std::size_t points() const;
  /// Of the voxelmap: those that the surface passes through.
  std::size_t surfaceVoxels() const;
  /// Bytes in memory.
  std::size_t memoryBytes() const;
  /// The surface as triangles, within `sagitta` (m, positive) of a shape; of a mesh the mesh itself.
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
