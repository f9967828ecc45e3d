// SPDX-License-Identifier: MIT
#include "support/video.hpp"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace sim {

Video::Video(const std::string &path, double frames_per_second)
    : path_(path), rate_(frames_per_second) {
}

void Video::add(const cli::Image &picture) {
    const cv::Size size(static_cast<int>(picture.width), static_cast<int>(picture.height));
    cli::Image copy = picture; // OpenCV takes no constant data
    cv::Mat bgr;
    cv::cvtColor(cv::Mat(size, CV_8UC3, copy.pixels.data()), bgr, cv::COLOR_RGB2BGR);
    if (!writer_.isOpened() &&
        !writer_.open(path_, cv::CAP_FFMPEG, cv::VideoWriter::fourcc('a', 'v', 'c', '1'), rate_,
                      size)) {
        throw std::runtime_error(path_ + ": OpenCV cannot write H.264 here");
    }
    writer_.write(bgr);
}

} // namespace sim
