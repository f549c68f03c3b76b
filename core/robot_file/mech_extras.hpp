// Extensions of the thesis's mechanism file: names, limits, inertia, geometry.
#pragma once

#include <optional>
#include <vector>

#include "core/robot_file/mech_reader.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Units of a mechanism file, as factors to SI.
struct MechUnits {
  double length{1.0}, angle{1.0};
};

/// Reads the extension environments and applies them to the robot once its frames are known.
class MechExtras {
 public:
  explicit MechExtras(MechReader& reader) : reader_(reader) {}

  /// False if `begin` does not start one of them.
  bool read(const MechLine& begin);
  /// `robot` has its frames with ids. Throws ParseError for unknown frames and invalid values.
  void apply(const MechUnits& units, Robot& robot) const;

 private:
  struct Item {
    const MechLine* line;
    MechNumber frame;
  };
  void name(const Item& item, Robot& robot) const;
  void limit(const Item& item, const MechUnits& units, mechanism::Mechanism& mechanism) const;
  void body(const Item& item, const MechUnits& units, mechanism::Mechanism& mechanism) const;
  void geometry(const Item& item, const MechUnits& units, Robot& robot) const;
  double si(const MechNumber& n, double unit) const;
  double limitOr(const Item& item, std::size_t i, const char* what, double unit, double none) const;
  Transform pose(const Item& item, std::size_t first, const MechUnits& units) const;
  mechanism::MechanismFrame& frameOf(const Item& item, mechanism::Mechanism& mechanism) const;
  void addShape(const Item& item, const MechUnits& units, LinkGeometry& geometry) const;

  MechReader& reader_;
  std::vector<Item> names_, limits_, bodies_, geometries_;
};

/// Percent-encodes a text as a word of the file: %20 for a blank, %23 for #, %25 for %; and decodes it,
/// nullopt for an invalid code.
std::string mechWord(const std::string& text);
std::optional<std::string> fromMechWord(std::string_view word);

}  // namespace abstand::robot_file
