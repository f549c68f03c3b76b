#include "core/robot_file/mech_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/robot_file/mech_extras.hpp"
#include "core/text/message_text.hpp"

namespace abstand::robot_file {
namespace {

// Larger values are errors; sums and products of smaller ones stay finite.
constexpr double kLargest = 1e6;
// A rotation typed with four digits is accepted and made orthonormal.
constexpr double kCenterTolerance = 1e-3;

struct RawFrame {
  MechNumber id, a, alpha, d, theta;
  int parent{-1};
  mechanism::JointType type{mechanism::JointType::kFixed};
};

struct RawDof {
  MechNumber frame_id, offset, scale{1.0};
  int dof{0};
  bool mimic{false};
};

struct RawLink {
  std::optional<MechNumber> id;
  std::vector<MechNumber> center;
};

/// Reads raw values first and converts units afterwards, as the environments may be in any order.
class MechParser : private MechReader {
 public:
  MechParser(std::string_view text, std::string name) : MechReader(text, std::move(name)) {}

  Robot parse() {
    while (const MechLine* line = nextLine()) {
      const MechLine& begin = *line;
      const auto word = begin.words.front().text;
      if (word == "units") {
        expectAlone(begin);
        units(begin);
      } else if (word == "mapping") {
        expectAlone(begin);
        mapping(begin);
      } else if (word == "chain") {
        expectAlone(begin);
        chain(begin);
      } else if (word == "link") {
        expectAlone(begin);
        link(begin);
      } else if (!extras_.read(begin)) {
        unknown(begin, 0, "an environment: units, mapping, chain, link, names, limits, inertia or geometry",
                {"units", "mapping", "chain", "link", "names", "limits", "inertia", "geometry"});
      }
    }
    if (frames_.empty()) throw ParseError({fileName()}, "found no frame, expected at least one chain");
    Robot robot{fileName(), build(), {}, {}, {}};
    extras_.apply({length_, angle_}, robot);
    return robot;
  }

 private:
  void units(const MechLine& begin) {
    if (has_units_) fail(begin.line, begin.words[0].column, "found a second units environment, expected one");
    has_units_ = true;
    bool has_length = false, has_angle = false;
    while (const MechLine* line = command(begin, {"length", "angle"})) {
      const bool is_length = line->words[0].text == "length";
      bool& has = is_length ? has_length : has_angle;
      if (has)
        fail(line->line, line->words[0].column,
             "found a second " + text::inQuotes(line->words[0].text) + ", expected one");
      has = true;
      expectValues(*line, 1, is_length ? "mm, cm, m or inches" : "degrees or radians");
      const auto word = line->words[1].text;
      if (is_length) {
        if (word == "m")
          length_ = 1.0;
        else if (word == "mm")
          length_ = unit::mm(1.0);
        else if (word == "cm")
          length_ = unit::cm(1.0);
        else if (word == "inches")
          length_ = unit::inch(1.0);
        else
          unknown(*line, 1, "a unit of length: mm, cm, m or inches", {"mm", "cm", "m", "inches"});
      } else if (word == "radians" || word == "degrees") {
        angle_ = word == "degrees" ? unit::deg(1.0) : 1.0;
      } else {
        unknown(*line, 1, "a unit of angle: degrees or radians", {"degrees", "radians"});
      }
    }
  }

  void mapping(const MechLine& begin) {
    if (has_mapping_)
      fail(begin.line, begin.words[0].column, "found a second mapping environment, expected one");
    has_mapping_ = true;
    while (const MechLine* line = command(begin, {"dof", "mimic"})) {
      const bool mimic = line->words[0].text == "mimic";
      const std::size_t count = line->words.size() - 1;
      if (count != 2 && count != 4)
        fail(line->line, count > 4 ? line->words[5].column : line->end_column,
             "found " + std::to_string(count) + (count == 1 ? " value" : " values") + " behind " +
                 text::inQuotes(line->words[0].text) +
                 ", expected 2 or 4: id, frame and, if wanted, offset and scale");
      const MechNumber id = integer(*line, 1, 0, "the id of a degree of freedom");
      if (mimic && id.value >= static_cast<double>(dof_count_))
        fail(id, "found a mimic of dof " + text::inQuotes(line->words[1].text) +
                     ", expected one that is defined before");
      if (!mimic && id.value != static_cast<double>(dof_count_))
        fail(id, "found dof " + text::inQuotes(line->words[1].text) + ", expected " +
                     std::to_string(dof_count_) + ": ids count 0, 1, 2, ...");
      RawDof dof;
      dof.dof = static_cast<int>(id.value);
      dof.mimic = mimic;
      if (!mimic) ++dof_count_;
      dof.frame_id = integer(*line, 2, 1, "the id of a frame");
      if (count == 4) {
        dof.offset = number(*line, 3, "an offset");
        dof.scale = number(*line, 4, "a scale");
        if (dof.scale.value == 0.0)
          fail(dof.scale, "found the scale 0, expected another number: the dof would move nothing");
      }
      dofs_.push_back(dof);
    }
  }

  void chain(const MechLine& begin) {
    int parent = -1;
    bool is_first = true, has_frame = false;
    while (const MechLine* line = command(begin, {"frame", "reference"})) {
      if (line->words[0].text == "reference") {
        if (!is_first)
          fail(line->line, line->words[0].column,
               "found 'reference', expected it once, before the frames of the chain");
        expectValues(*line, 1, "the id of the reference frame");
        const MechNumber id = integer(*line, 1, 0, "the id of the reference frame");
        if (id.value != 0.0) {
          const auto at = index_.find(static_cast<int>(id.value));
          if (at == index_.end())
            fail(id, "found the reference " + text::inQuotes(line->words[1].text) +
                         ", expected 0 or a frame of a chain that is defined before this one");
          parent = at->second;
        }
      } else {
        parent = frame(*line, parent);
        has_frame = true;
      }
      is_first = false;
    }
    if (!has_frame)
      fail(begin.line, begin.words[0].column, "found a chain without a frame, expected at least one");
  }

  /// Returns the new frame's index.
  int frame(const MechLine& line, int parent) {
    expectValues(line, 5, "id, a, alpha, d, theta");
    RawFrame f;
    f.parent = parent;
    f.id = integer(line, 1, 1, "the id of a frame");
    const int index = static_cast<int>(frames_.size());
    if (!index_.emplace(static_cast<int>(f.id.value), index).second)
      fail(f.id, "found the frame id " + text::inQuotes(line.words[1].text) +
                     " a second time, expected unique ids");
    f.a = number(line, 2, "a");
    f.alpha = number(line, 3, "alpha");
    const bool d_varies = line.words[4].text == "d", theta_varies = line.words[5].text == "theta";
    if (d_varies && theta_varies)
      fail(line.line, line.words[5].column,
           "found d and theta both variable, expected at most one variable per frame");
    f.d = variableOr(line, 4, "d", d_varies);
    f.theta = variableOr(line, 5, "theta", theta_varies);
    f.type = d_varies       ? mechanism::JointType::kPrismatic
             : theta_varies ? mechanism::JointType::kRevolute
                            : mechanism::JointType::kFixed;
    frames_.push_back(f);
    return index;
  }

  MechNumber variableOr(const MechLine& line, std::size_t i, const std::string& name, bool varies) const {
    const auto& word = line.words[i];
    if (varies) return {0.0, line.line, word.column};
    if (!parseDouble(word.text))
      unknown(line, i, name + ": a finite number, or the word " + name + " where it is the variable", {name});
    return number(line, i, name);
  }

  void link(const MechLine& begin) {
    RawLink link;
    while (const MechLine* line = command(begin, {"id", "center"})) {
      const bool is_id = line->words[0].text == "id";
      if (is_id ? link.id.has_value() : !link.center.empty())
        fail(line->line, line->words[0].column,
             "found a second " + text::inQuotes(line->words[0].text) + ", expected one a link");
      if (is_id) {
        expectValues(*line, 1, "the id of a frame");
        link.id = integer(*line, 1, 1, "the id of a frame");
      } else {
        expectValues(*line, 12, "the rows of [R|t]");
        for (std::size_t i = 1; i <= 12; ++i) link.center.push_back(number(*line, i, "an entry of [R|t]"));
      }
    }
    if (!link.id) fail(begin.line, begin.words[0].column, "found a link without 'id', expected one");
    if (link.center.empty())
      fail(begin.line, begin.words[0].column, "found a link without 'center', expected one");
    links_.push_back(std::move(link));
  }

  double toSi(const MechNumber& n, double unit) const {
    const double si = n.value * unit;
    if (std::abs(si) > kLargest)
      fail(n, "found " + formatDouble(n.value) + ", expected at most " + formatDouble(kLargest / unit) +
                  " in size");
    return si;
  }

  /// Index of the frame with this id; throws if there is none.
  std::size_t known(const MechNumber& id) const {
    const auto at = index_.find(static_cast<int>(id.value));
    if (at == index_.end())
      fail(id, "found the frame " + formatDouble(id.value) + ", expected a frame that a chain defines");
    return static_cast<std::size_t>(at->second);
  }

  mechanism::Mechanism build() const {
    mechanism::Mechanism m;
    m.frames.reserve(frames_.size());
    for (const auto& raw : frames_) {
      mechanism::MechanismFrame f;
      f.id = static_cast<int>(raw.id.value);
      f.name = std::to_string(f.id);
      f.parent = raw.parent;
      f.type = raw.type;
      f.a = toSi(raw.a, length_);
      f.alpha = toSi(raw.alpha, angle_);
      f.d = toSi(raw.d, length_);
      f.theta = toSi(raw.theta, angle_);
      m.frames.push_back(std::move(f));
    }
    connectDofs(m);
    for (const auto& link : links_) placeCenter(link, m);
    m.prepare();
    return m;
  }

  void connectDofs(mechanism::Mechanism& m) const {
    if (!has_mapping_) {
      for (auto& f : m.frames)
        if (f.type != mechanism::JointType::kFixed) f.dof = m.dof++;
      return;
    }
    for (const auto& raw : dofs_) {
      auto& f = m.frames[known(raw.frame_id)];
      if (f.type == mechanism::JointType::kFixed)
        fail(raw.frame_id,
             "found frame " + f.name + ", which is constant, expected one with d or theta as its variable");
      if (f.dof >= 0)
        fail(raw.frame_id, "found frame " + f.name + " a second time, expected one dof per frame");
      f.dof = raw.dof;
      f.mimic = raw.mimic;
      m.dof = dof_count_;
      f.offset = toSi(raw.offset, f.type == mechanism::JointType::kPrismatic ? length_ : angle_);
      f.scale = toSi(raw.scale, 1.0);
    }
    for (std::size_t i = 0; i < m.frames.size(); ++i)
      if (m.frames[i].type != mechanism::JointType::kFixed && m.frames[i].dof < 0)
        fail(frames_[i].id, "found the variable of frame " + m.frames[i].name +
                                " in no dof, expected the mapping to name every variable");
  }

  void placeCenter(const RawLink& link, mechanism::Mechanism& m) const {
    auto& f = m.frames[known(*link.id)];
    if (f.has_center) fail(*link.id, "found a second link with id " + f.name + ", expected one per frame");
    Matrix3d R;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        R(static_cast<int>(row), static_cast<int>(column)) = toSi(link.center[row * 4 + column], 1.0);
      f.X_FC.translation()[static_cast<int>(row)] = toSi(link.center[row * 4 + 3], length_);
    }
    Transform X = Transform::Identity();
    X.linear() = R;
    if (!isPose(X, kCenterTolerance))
      fail(link.center.front(),
           "found a matrix that is no pose, expected the rows of [R|t] with a rotation R");
    f.X_FC.linear() = Quaterniond(R).normalized().toRotationMatrix();
    f.has_center = true;
  }

  bool has_units_{false}, has_mapping_{false};
  double length_{1.0}, angle_{1.0};
  std::vector<RawFrame> frames_;
  std::unordered_map<int, int> index_;
  std::vector<RawDof> dofs_;
  int dof_count_{0};
  std::vector<RawLink> links_;
  MechExtras extras_{*this};
};

}  // namespace

Robot parseMech(const std::string& text, const std::string& name) {
  Robot robot = MechParser(text, name).parse();
  robot.mechanism.name = std::filesystem::path(name).stem().string();
  return robot;
}

mechanism::Mechanism parseMechanism(const std::string& text, const std::string& name) {
  return parseMech(text, name).mechanism;
}

mechanism::Mechanism loadMechanism(const std::filesystem::path& file) {
  return parseMechanism(readFile(file, kMaxRobotBytes), file.string());
}

}  // namespace abstand::robot_file
