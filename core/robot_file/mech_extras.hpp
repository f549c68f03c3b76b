// The environments that extend the thesis's mechanism file: names, limits, inertia, geometry.
#pragma once

#include <optional>
#include <vector>

#include "core/robot_file/mech_reader.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Units of a mechanism file, in SI.
struct MechUnits {
  double length{1.0}, angle{1.0};
};

/// Reads the environments where they stand, and gives them to the robot once its frames are known.
class MechExtras {
 public:
  explicit MechExtras(MechReader& reader) : reader_(reader) {}

  /// False when `begin` begins none of them.
  bool read(const MechLine& begin);
  /// `robot` has its frames with ids. Throws ParseError for frames that are not there and for values that a
  /// robot cannot have.
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

/// A word of the file for any text, as URLs do it: %20 for a blank, %23 for #, %25 for %. And back; nothing
/// for text that is none.
std::string mechWord(const std::string& text);
std::optional<std::string> fromMechWord(std::string_view word);

}  // namespace abstand::robot_file
