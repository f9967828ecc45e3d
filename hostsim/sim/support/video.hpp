// SPDX-License-Identifier: MIT
//
// H.264 in an MP4 file.
#ifndef OCELLUS_SIM_VIDEO_HPP
#define OCELLUS_SIM_VIDEO_HPP

#include <opencv2/videoio.hpp>
#include <string>

#include "image.hpp"

namespace sim {

class Video {
  public:
    Video(const std::string &path, double frames_per_second);

    // All pictures are of the first one's size, both sides even.  The same pictures
    // make the same file.  std::runtime_error when it cannot be written.
    void add(const cli::Image &picture);

  private:
    std::string path_;
    double rate_;
    cv::VideoWriter writer_;
};

} // namespace sim

#endif
