// Pictures are outputs like those of the command line: whole or not at all, and where a link leads.
#include "ui/style/picture_file.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/write_error.hpp"
#include "tests/support/paths.hpp"

namespace abstand::ui {
namespace picture_file_test {

namespace fs = std::filesystem;

struct PictureFile : ::testing::Test {
  PictureFile() { picture.fill(Qt::red); }
  QString in(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
  }
  abstand::testing::ScratchFolder folder;
  QImage picture{20, 10, QImage::Format_RGB32};
};

TEST_F(PictureFile, FormatFollowsFileName) {
  savePicture(picture, in("a.png"));
  EXPECT_EQ(QImage(in("a.png"), "png").convertToFormat(QImage::Format_RGB32), picture);
  savePicture(picture, in("b"));
  EXPECT_FALSE(QImage(in("b"), "png").isNull());
  savePicture(picture, in("c.JPG"));
  EXPECT_FALSE(QImage(in("c.JPG"), "jpg").isNull());
  EXPECT_THROW(savePicture(picture, in("d.xyz")), UsageError);
  EXPECT_EQ(files(), 3u);
}

TEST_F(PictureFile, FollowsLinkAndRejectsDirectory) {
  fs::create_symlink("target.png", folder.path() / "link.png");
  savePicture(picture, in("link.png"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.png"));
  EXPECT_FALSE(QImage(in("target.png"), "png").isNull());
  fs::create_directory(folder.path() / "folder.png");
  EXPECT_THROW(savePicture(picture, in("folder.png")), UsageError);
  EXPECT_THROW(savePicture(picture, in("no/where.png")), UsageError);
  EXPECT_EQ(files(), 3u);
}

TEST_F(PictureFile, IsWrittenIntoDevice) {
  fs::create_symlink("/dev/null", folder.path() / "null.png");
  savePicture(picture, in("null.png"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "null.png"));
  fs::create_symlink("/dev/full", folder.path() / "full.png");
  EXPECT_THROW(savePicture(picture, in("full.png")), WriteError);
  EXPECT_EQ(files(), 2u);
}

}  // namespace picture_file_test
}  // namespace abstand::ui
