// Makes C3D files for tests, in every encoding.
#pragma once

#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "core/math/transform.hpp"
#include "tracking/c3d/c3d_bytes.hpp"

namespace abstand::testing {

struct SmallC3d {
  tracking::C3dProcessor processor{tracking::C3dProcessor::kIntel};
  bool is_float{true};
  float scale{0.25f};  ///< units a step of the integers; written negative for floats
  std::vector<std::string> labels{"LASI", "RASI", "C7"};
  std::vector<std::vector<Vector3d>> frames;  ///< NaN: a gap
  std::uint16_t analog{2};                    ///< samples a frame
  std::uint16_t first_frame{1};
  int claimed_more{0};      ///< frames that are claimed beyond those that are there
  bool all_invalid{false};  ///< every residual is -1
  int parameter_block{2};
  std::vector<std::pair<std::string, float>> processing;  ///< numbers in PROCESSING
  std::string subject;                                    ///< SUBJECTS:NAMES; empty: none
  std::vector<std::string> subjects;                      ///< the same as an array
  std::vector<float> heights;                             ///< SUBJECTS:HEIGHT, of each
};

/// Blocks: header, nothing up to the parameters, two of parameters, then the data.
inline std::string c3dOf(const SmallC3d& c) {
  const bool big = c.processor == tracking::C3dProcessor::kMips;
  const auto u16 = [big](int v) {
    const char low = static_cast<char>(v & 0xff), high = static_cast<char>(v >> 8 & 0xff);
    return big ? std::string{high, low} : std::string{low, high};
  };
  const auto f32 = [&](float v) {
    auto bits = std::bit_cast<std::uint32_t>(c.processor == tracking::C3dProcessor::kDec ? 4.0f * v : v);
    const int high = static_cast<int>(bits >> 16), low = static_cast<int>(bits & 0xffff);
    return c.processor == tracking::C3dProcessor::kIntel ? u16(low) + u16(high) : u16(high) + u16(low);
  };
  const auto padded = [](std::string s, std::size_t size) {
    s.resize((s.size() + size - 1) / size * size, '\0');
    return s;
  };
  const int data_block = c.parameter_block + 2;
  std::string head;
  head += static_cast<char>(c.parameter_block);
  head += '\x50';
  head += u16(static_cast<int>(c.labels.size())) + u16(c.analog) + u16(c.first_frame) +
          u16(c.first_frame + static_cast<int>(c.frames.size()) + c.claimed_more - 1) + u16(10);
  head += f32(c.is_float ? -c.scale : c.scale) + u16(data_block) + u16(1) + f32(100.0f);

  const auto record = [&](int id, const std::string& name, const std::string& content, bool last = false) {
    return std::string{static_cast<char>(name.size()), static_cast<char>(id)} + name +
           u16(last ? 0 : static_cast<int>(content.size()) + 2) + content;
  };
  const auto text = [](const std::string& s) {
    return std::string{'\xff', '\x01', static_cast<char>(s.size())} + s + '\0';
  };
  const auto texts = [](const std::vector<std::string>& list) {
    std::size_t width = 5;
    for (const auto& s : list) width = std::max(width, s.size());
    std::string all{'\xff', '\x02', static_cast<char>(width), static_cast<char>(list.size())};
    for (const auto& s : list) all += s + std::string(width - s.size(), ' ');
    return all + '\0';
  };
  std::string parameters{'\x01', '\x50', '\x02', static_cast<char>(c.processor)};
  if (!c.subject.empty())
    parameters += record(-2, "SUBJECTS", std::string(1, '\0')) + record(2, "NAMES", text(c.subject));
  if (!c.subjects.empty())
    parameters += record(-2, "SUBJECTS", std::string(1, '\0')) + record(2, "NAMES", texts(c.subjects));
  if (!c.heights.empty()) {
    std::string heights{'\x04', '\x01', static_cast<char>(c.heights.size())};
    for (const float height : c.heights) heights += f32(height);
    parameters += record(2, "HEIGHT", heights + '\0');
  }
  if (!c.processing.empty()) parameters += record(-3, "PROCESSING", std::string(1, '\0'));
  for (const auto& [name, number] : c.processing)
    parameters += record(3, name, std::string{'\x04', '\0'} + f32(number) + '\0');
  parameters += record(-1, "POINT", std::string(1, '\0')) + record(1, "LABELS", texts(c.labels)) +
                record(1, "UNITS", text("mm")) + record(1, "Y_SCREEN", text("+Z"), true);

  std::string data;
  for (const auto& frame : c.frames) {
    for (const Vector3d& p : frame) {
      const bool gap = !p.allFinite();
      const int residual = gap || c.all_invalid ? -1 : 0x0304;
      for (int k = 0; k < 3; ++k) {
        const double v = gap ? 0.0 : p[k];
        data += c.is_float ? f32(static_cast<float>(v))
                           : u16(static_cast<int>(std::lround(v / static_cast<double>(c.scale))));
      }
      data += c.is_float ? f32(static_cast<float>(residual)) : u16(residual);
    }
    for (int i = 0; i < c.analog; ++i) data += c.is_float ? f32(7.5f) : u16(7);
  }
  return padded(padded(head, 512), static_cast<std::size_t>(512 * (c.parameter_block - 1))) +
         padded(padded(parameters, 1024), 1024) + data;
}

}  // namespace abstand::testing
