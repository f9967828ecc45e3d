// SPDX-License-Identifier: MIT
//
// One named pipeline on one named frame, N times, for callgrind:
//
//   frame_cost PIPELINE FRAME [N [SEED]]
//
// Each pipeline's work, and nothing else, is in a function that callgrind can
// count by name (measure_*); drawing the frame and compiling the colour happen
// before.  What was found is printed, so that one sees that all pipelines found
// the same ball.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <ocellus/ocellus.h>

#include "frames.h"

namespace {

struct found_t {
    double cx = 0.0;
    double cy = 0.0;
    double width = 0.0;
    double height = 0.0;
    bool any = false;
};

const cv::Scalar RANGE_LO(FRAME_RANGE_B_LO, FRAME_RANGE_G_LO, FRAME_RANGE_R_LO);
const cv::Scalar RANGE_HI(FRAME_RANGE_B_HI, FRAME_RANGE_G_HI, FRAME_RANGE_R_HI);

void take(found_t &found, const cv::RotatedRect &rect) {
    found.cx = rect.center.x;
    found.cy = rect.center.y;
    found.width = rect.size.width;
    found.height = rect.size.height;
    found.any = true;
}

void fit_longest(found_t &found, const std::vector<std::vector<cv::Point>> &contours) {
    const std::vector<cv::Point> *longest = nullptr;
    for (const auto &contour : contours) {
        if ((longest == nullptr) || (contour.size() > longest->size())) {
            longest = &contour;
        }
    }
    if ((longest != nullptr) && (longest->size() >= 5U)) {
        take(found, cv::fitEllipseDirect(*longest));
    }
}

} // namespace

#define MEASURED extern "C" __attribute__((noinline))

// One frame through the whole library: colour, labels, boundary, fit.
MEASURED void measure_ocellus_frame(ocel_eye_t *eye, const ocel_colour_t *colour,
                                    const uint8_t *bgr, ocel_detection_t *detection) {
    (void)ocel_eye_frame(eye, colour, bgr, 3U * FRAME_WIDTH, detection);
}

// The fit alone.
MEASURED void measure_ocellus_fit(const ocel_crack_t *cracks, size_t count,
                                  const ocel_fit_options_t *options, ocel_ellipse_t *ellipse) {
    (void)ocel_fit_cracks(cracks, count, options, ellipse);
}

MEASURED void measure_ocellus_fit_points(const ocel_point_t *points, size_t count,
                                         const ocel_fit_options_t *options,
                                         ocel_ellipse_t *ellipse) {
    (void)ocel_fit_points(points, count, options, ellipse);
}

// The robust cone fit, which looks through a camera.
MEASURED void measure_ocellus_cone(const ocel_camera_t *camera, const ocel_crack_t *cracks,
                                   size_t count, ocel_cone_t *cone) {
    (void)ocel_cone_fit_cracks(camera, cracks, count, cone);
}

// inRange, components with statistics, the largest one's contour, ellipse.
MEASURED void measure_opencv_ccl(const cv::Mat *bgr, found_t *found) {
    cv::Mat mask;
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centroids;
    cv::inRange(*bgr, RANGE_LO, RANGE_HI, mask);
    const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
    int best = 0;
    for (int k = 1; k < count; k++) {
        if ((best == 0) ||
            (stats.at<int>(k, cv::CC_STAT_AREA) > stats.at<int>(best, cv::CC_STAT_AREA))) {
            best = k;
        }
    }
    if (best != 0) {
        const cv::Rect box(
            stats.at<int>(best, cv::CC_STAT_LEFT), stats.at<int>(best, cv::CC_STAT_TOP),
            stats.at<int>(best, cv::CC_STAT_WIDTH), stats.at<int>(best, cv::CC_STAT_HEIGHT));
        std::vector<std::vector<cv::Point>> contours;
        const cv::Mat blob = (labels(box) == best);
        cv::findContours(blob, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, box.tl());
        fit_longest(*found, contours);
    }
}

// inRange, all contours, the longest one's ellipse.
MEASURED void measure_opencv_contours(const cv::Mat *bgr, found_t *found) {
    cv::Mat mask;
    std::vector<std::vector<cv::Point>> contours;
    cv::inRange(*bgr, RANGE_LO, RANGE_HI, mask);
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    fit_longest(*found, contours);
}

MEASURED void measure_opencv_direct(const std::vector<cv::Point2f> *points, found_t *found) {
    take(*found, cv::fitEllipseDirect(*points));
}

namespace {

void print_found(const char *pipeline, const char *frame, const found_t &found) {
    if (found.any) {
        std::printf("%s %s: centre %.3f %.3f, axes %.3f %.3f\n", pipeline, frame, found.cx,
                    found.cy, found.width, found.height);
    } else {
        std::printf("%s %s: no ellipse\n", pipeline, frame);
    }
}

void take(found_t &found, const ocel_ellipse_t &ellipse) {
    found.cx = ellipse.cx_px_q16 / 65536.0;
    found.cy = ellipse.cy_px_q16 / 65536.0;
    found.width = 2.0 * ellipse.a_px_q16 / 65536.0;
    found.height = 2.0 * ellipse.b_px_q16 / 65536.0;
    found.any = true;
}

[[noreturn]] void usage() {
    std::fprintf(stderr,
                 "usage: frame_cost PIPELINE FRAME [N [SEED]]\n"
                 "  PIPELINE ocellus opencv-ccl opencv-contours, FRAME plain salt checkerboard\n"
                 "           isolated comb random empty (320x240 BGR)\n"
                 "  PIPELINE fit-b2ac fit-lcse fit-hyper points-b2ac points-lcse points-hyper\n"
                 "           opencv-direct cone, FRAME the number of boundary points of a disc\n");
    std::exit(2);
}

// `count` of the cracks of a disc mask, evenly taken: all of them when the disc has
// exactly that many.
std::vector<ocel_crack_t> disc_cracks(size_t count) {
    const double radius = static_cast<double>(count) / 8.0 + 1.0;
    const int side = 2 * static_cast<int>(radius) + 5;
    std::vector<uint8_t> mask(static_cast<size_t>(side) * static_cast<size_t>(side));
    std::vector<ocel_crack_t> all;
    frame_add_disc(mask.data(), side, side, side / 2 + 0.3, side / 2 - 0.4, radius);
    const auto at = [&](int x, int y) {
        return mask[static_cast<size_t>(y) * static_cast<size_t>(side) + static_cast<size_t>(x)];
    };
    for (int y = 0; y < side - 1; y++) {
        for (int x = 0; x < side - 1; x++) {
            if (at(x, y) != at(x + 1, y)) {
                all.push_back({static_cast<int16_t>(2 * x + 1), static_cast<int16_t>(2 * y)});
            }
            if (at(x, y) != at(x, y + 1)) {
                all.push_back({static_cast<int16_t>(2 * x), static_cast<int16_t>(2 * y + 1)});
            }
        }
    }
    std::vector<ocel_crack_t> taken;
    for (size_t i = 0; i < count; i++) {
        taken.push_back(all[i * all.size() / count]);
    }
    return taken;
}

bool fit_method(const char *name, ocel_fit_options_t &options) {
    options = {OCEL_FIT_B2AC, OCEL_PERTURB_AUTO, true};
    if (std::strcmp(name, "lcse") == 0) {
        options = {OCEL_FIT_LCSE, OCEL_PERTURB_ALWAYS, true};
    } else if (std::strcmp(name, "hyper") == 0) {
        options.method = OCEL_FIT_HYPER;
    } else if (std::strcmp(name, "b2ac") != 0) {
        return false;
    }
    return true;
}

// The pipelines that fit points only; false when there is none of that name.
// The cone of a disc in the middle of the image, f = 277 px.
void run_cone(size_t count, int repeats) {
    const std::vector<ocel_crack_t> cracks = disc_cracks(count);
    const int32_t middle_px_q16 = static_cast<int32_t>(count / 8U + 3U) * 65536;
    ocel_intrinsics_t intrinsics = {};
    ocel_camera_t camera = {};
    ocel_cone_t cone = {};
    intrinsics.fx_px_q16 = 277 * 65536;
    intrinsics.fy_px_q16 = 277 * 65536;
    intrinsics.cx_px_q16 = middle_px_q16;
    intrinsics.cy_px_q16 = middle_px_q16;
    if (ocel_camera_init(&camera, &intrinsics) != OCEL_OK) {
        std::exit(1);
    }
    for (int i = 0; i < repeats; i++) {
        measure_ocellus_cone(&camera, cracks.data(), count, &cone);
    }
    std::printf("cone %zu: sine %.6f, %u inliers\n", count, cone.sin_q30 / 1073741824.0,
                static_cast<unsigned>(cone.inlier_count));
}

bool run_fit(const char *pipeline, const char *frame, int repeats) {
    const bool from_cracks = std::strncmp(pipeline, "fit-", 4) == 0;
    const bool from_points = std::strncmp(pipeline, "points-", 7) == 0;
    const bool opencv = std::strcmp(pipeline, "opencv-direct") == 0;
    const bool cone = std::strcmp(pipeline, "cone") == 0;
    ocel_fit_options_t options;
    if (!opencv && !cone && !(from_cracks && fit_method(pipeline + 4, options)) &&
        !(from_points && fit_method(pipeline + 7, options))) {
        return false;
    }
    const size_t count = std::strtoul(frame, nullptr, 10);
    if ((count < 8U) || (count > 8000U)) {
        usage();
    }
    if (cone) {
        run_cone(count, repeats);
        return true;
    }
    const std::vector<ocel_crack_t> cracks = disc_cracks(count);
    std::vector<ocel_point_t> points;
    std::vector<cv::Point2f> floats;
    for (const auto &c : cracks) {
        points.push_back({c.x_hpx * 32768, c.y_hpx * 32768});
        floats.emplace_back(c.x_hpx / 2.0F, c.y_hpx / 2.0F);
    }
    found_t found;
    ocel_ellipse_t ellipse = {};
    for (int i = 0; i < repeats; i++) {
        if (opencv) {
            measure_opencv_direct(&floats, &found);
        } else if (from_cracks) {
            measure_ocellus_fit(cracks.data(), count, &options, &ellipse);
        } else {
            measure_ocellus_fit_points(points.data(), count, &options, &ellipse);
        }
    }
    if (!opencv && (ellipse.point_count != 0U)) {
        take(found, ellipse);
    }
    print_found(pipeline, frame, found);
    return true;
}

bool run_frame(const char *pipeline, frame_kind_t kind, int repeats, uint64_t seed) {
    static uint8_t mask[FRAME_WIDTH * FRAME_HEIGHT];
    static uint8_t bgr[3 * FRAME_WIDTH * FRAME_HEIGHT];
    static ocel_eye_t eye;
    frame_draw_bgr(kind, FRAME_WIDTH, FRAME_HEIGHT, seed, mask, bgr);
    const cv::Mat image(FRAME_HEIGHT, FRAME_WIDTH, CV_8UC3, bgr);
    found_t found;
    if (std::strcmp(pipeline, "ocellus") == 0) {
        const ocel_colour_range_t range = {OCEL_SPACE_RGB,
                                           {FRAME_RANGE_R_LO, FRAME_RANGE_G_LO, FRAME_RANGE_B_LO},
                                           {FRAME_RANGE_R_HI, FRAME_RANGE_G_HI, FRAME_RANGE_B_HI}};
        ocel_eye_config_t config = {};
        ocel_colour_t colour;
        ocel_detection_t detection = {};
        config.width = FRAME_WIDTH;
        config.height = FRAME_HEIGHT;
        if ((ocel_eye_init(&eye, &config) != OCEL_OK) ||
            (ocel_colour_compile(&colour, &range, OCEL_FORMAT_BGR888, nullptr) != OCEL_OK)) {
            std::fprintf(stderr, "frame_cost: the library refused its configuration\n");
            std::exit(1);
        }
        for (int i = 0; i < repeats; i++) {
            measure_ocellus_frame(&eye, &colour, bgr, &detection);
        }
        if (detection.has_ellipse) {
            take(found, detection.ellipse);
        }
        std::printf("status %s, blob of %u px\n", ocel_status_name(detection.status),
                    static_cast<unsigned>(detection.blob.area));
    } else if (std::strcmp(pipeline, "opencv-ccl") == 0) {
        for (int i = 0; i < repeats; i++) {
            measure_opencv_ccl(&image, &found);
        }
    } else if (std::strcmp(pipeline, "opencv-contours") == 0) {
        for (int i = 0; i < repeats; i++) {
            measure_opencv_contours(&image, &found);
        }
    } else {
        return false;
    }
    print_found(pipeline, frame_name(kind), found);
    return true;
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 3) {
        usage();
    }
    const int repeats = (argc > 3) ? std::atoi(argv[3]) : 1;
    const uint64_t seed = (argc > 4) ? std::strtoull(argv[4], nullptr, 10) : 7U;
    frame_kind_t kind = FRAME_PLAIN;
    cv::setNumThreads(0); // callgrind counts one thread
    const bool known = frame_by_name(argv[2], &kind) ? run_frame(argv[1], kind, repeats, seed)
                                                     : run_fit(argv[1], argv[2], repeats);
    if (!known) {
        usage();
    }
    return 0;
}
