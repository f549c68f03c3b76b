#include "app/studio/avi_file.hpp"

#include <QFile>
#include <QFileInfo>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/base/write_error.hpp"

namespace abstand::studio {

namespace {

class AviFile : public ui::VideoSink {
 public:
  AviFile(const std::string& file, double rate, cv::Size size) : size_(size), out_(file) {
    // OpenCV goes by the ending, which the file has only when it is complete.
    const std::filesystem::path link = folder_.path() / "video.avi";
    std::filesystem::create_symlink(std::filesystem::absolute(out_.named()), link);
    const int jpeg = cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
    if (!writer_.open(link.string(), cv::CAP_OPENCV_MJPEG, jpeg, rate, size_))
      throw WriteError(file, "the video cannot be written");
  }

  void add(const QImage& picture) override {
    const QImage fitting =
        picture.scaled(size_.width, size_.height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_RGB888);
    // OpenCV only reads it.
    const cv::Mat rgb(size_, CV_8UC3, const_cast<uchar*>(fitting.constBits()),
                      static_cast<std::size_t>(fitting.bytesPerLine()));
    cv::cvtColor(rgb, bgr_, cv::COLOR_RGB2BGR);
    writer_.write(bgr_);
  }

  void finish() override {
    writer_.release();
    out_.commit();
  }

 private:
  cv::Size size_;
  TemporaryFolder folder_;
  OutputFile out_;
  cv::VideoWriter writer_;  // closed before the file that it writes
  cv::Mat bgr_;
};

}  // namespace

std::unique_ptr<ui::VideoSink> makeAviFile(const QString& file, double rate, QSize size) {
  const std::string name = QFile::encodeName(file).toStdString();
  if (QFileInfo(file).suffix().toLower() != QLatin1String("avi"))
    throw UsageError(name + ": found a name with another ending, expected .avi");
  return std::make_unique<AviFile>(name, rate, cv::Size(size.width() & ~1, size.height() & ~1));
}

}  // namespace abstand::studio
