// Videos as AVI files of JPEG pictures.
#pragma once

#include "ui/model/video_sink.hpp"

namespace abstand::studio {

/// Motion JPEG in AVI, which OpenCV writes without further codecs. Begins a file as ui::VideoMaker says; its
/// name ends in .avi. The width and height are rounded down to even numbers.
std::unique_ptr<ui::VideoSink> makeAviFile(const QString& file, double rate, QSize size);

}  // namespace abstand::studio
