// Files of moments: read as written, and damage is found.
#include "app/moment/moment_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/app/viewer/example_moment.hpp"
#include "tests/support/paths.hpp"

namespace abstand::moment {
namespace moment_file_test {

struct MomentFileTest : ::testing::Test {
  testing::ScratchFolder folder;
  std::filesystem::path file = folder.path() / "a.moments";
  std::vector<std::vector<std::byte>> frames;

  void write(std::vector<double> times) {
    for (const double t : times) frames.push_back(exampleFrame(exampleMoment(t)));
    std::size_t next = 0;
    writeMomentFile(file, exampleCard(), [&] {
      return next < frames.size() ? std::span<const std::byte>(frames[next++]) : std::span<const std::byte>();
    });
  }
  std::vector<std::vector<std::byte>> read() {
    std::vector<std::vector<std::byte>> got;
    readMomentFile(
        file, [](const SceneCard& card) { EXPECT_EQ(card, exampleCard()); },
        [&](std::span<const std::byte> frame, const Moment& moment) {
          EXPECT_EQ(moment.shown.pairs[0].result.distance, 0.25);
          got.emplace_back(frame.begin(), frame.end());
        });
    return got;
  }
};

TEST_F(MomentFileTest, IsReadAsWritten) {
  write({1.0, 1.5, 7.25});
  EXPECT_TRUE(isMomentFile(file));
  EXPECT_EQ(read(), frames);
  EXPECT_FALSE(isMomentFile(folder.write("b.csv", "t,a.r00\n")));
  EXPECT_FALSE(isMomentFile(folder.path() / "none"));
}

TEST_F(MomentFileTest, EveryCutAndChangedByteIsFound) {
  write({1.0, 1.5});
  const std::string whole = readFile(file);
  const auto put = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
  };
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    put(changed);
    EXPECT_THROW(read(), ParseError) << at;
    put(whole.substr(0, at));
    EXPECT_THROW(read(), ParseError) << at;
  }
}

TEST_F(MomentFileTest, TimesRiseAndThereIsAMoment) {
  write({1.0, 1.0});
  EXPECT_THROW(read(), ParseError);
  frames.clear();
  write({});
  EXPECT_THROW(read(), ParseError);
}

}  // namespace moment_file_test
}  // namespace abstand::moment
