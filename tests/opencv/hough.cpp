// SPDX-License-Identifier: MIT
//
// The robust peer: OpenCV's HoughCircles (GRADIENT) beside the library's cone of rays on
// the masks of accuracy_ball_occlusion, the ball within half a pixel of the axis.
//
//   opencv_hough [TABLE.txt [TRIALS [SEED]]]
#include <cmath>
#include <cstdlib>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "ball_scene.h"
#include "report.h"

namespace {

const double SHARE[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5};
const double RADIUS_PX = 40.0;

struct circle_t {
    double x;
    double y;
    double radius;
};

struct cell_t {
    double centre = 0.0; // sums of squares: px
    double radius = 0.0; // per cent
    double worst = 0.0;  // of the radius
    size_t answered = 0;

    void add(const circle_t &circle, const ref_ellipse_t &truth) {
        const double off = 100.0 * (circle.radius / std::sqrt(truth.a * truth.b) - 1.0);
        const double apart = std::hypot(circle.x - truth.cx, circle.y - truth.cy);
        centre += apart * apart;
        radius += off * off;
        worst = std::fmax(worst, std::fabs(off));
        answered++;
    }
    double radius_rms() const {
        return std::sqrt(radius / static_cast<double>(answered));
    }
    void print(report_t &report) const {
        report_line(&report, " | %7.3f %7.3f %7.2f %5zu", radius_rms(),
                    std::sqrt(centre / static_cast<double>(answered)), worst, answered);
    }
};

void by_hough(uint8_t *mask, const ref_ellipse_t &truth, cell_t &cell) {
    cv::Mat image = cv::Mat(SCENE_HEIGHT, SCENE_WIDTH, CV_8UC1, mask) * 255;
    std::vector<cv::Vec3f> circles;
    cv::GaussianBlur(image, image, cv::Size(5, 5), 1.0);
    cv::HoughCircles(image, circles, cv::HOUGH_GRADIENT, 1.0, 200.0, 100.0, 10.0, 20, 80);
    if (!circles.empty()) {
        cell.add({circles[0][0], circles[0][1], circles[0][2]}, truth);
    }
}

void by_cone(const uint8_t *mask, const ref_ellipse_t &truth, cell_t &cell) {
    static ocel_eye_t eye;
    ocel_camera_t camera;
    ocel_detection_t detection;
    ocel_cone_t cone;
    ocel_ellipse_t outline;
    scene_camera(&camera);
    (void)scene_look(mask, &eye, &detection);
    if ((ocel_eye_cone(&eye, &camera, &detection, &cone) == OCEL_OK) &&
        (ocel_cone_outline(&camera, &cone, &outline) == OCEL_OK)) {
        const double area = static_cast<double>(outline.a_px_q16) * outline.b_px_q16;
        cell.add(
            {outline.cx_px_q16 / 65536.0, outline.cy_px_q16 / 65536.0, std::sqrt(area) / 65536.0},
            truth);
    }
}

} // namespace

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t trials = (argc > 2) ? std::strtoul(argv[2], nullptr, 10) : 500UL;
    const unsigned long long seed = (argc > 3) ? std::strtoull(argv[3], nullptr, 10) : 1998ULL;
    rng_t rng = rng_seed(seed);
    double ratio = 0.0;
    size_t unanswered = 0;
    report_line(
        &report,
        "Balls of 40 px radius, an edge hiding a share of the area; HoughCircles GRADIENT of\n"
        "OpenCV %s (dp 1, thresholds 100 and 10, Gaussian 5x5), then the cone of rays; %zu\n"
        "trials each, seed %llu: RMS error of the radius, %%, of the centre, px, worst of the\n"
        "radius, %%, and how many answers.\n\n",
        CV_VERSION, trials, seed);
    for (const double share : SHARE) {
        static uint8_t mask[SCENE_PIXELS];
        cell_t hough;
        cell_t cone;
        for (size_t trial = 0; trial < trials; trial++) {
            scene_t scene;
            scene_occluded(&scene, RADIUS_PX, share, false, &rng);
            scene_draw(&scene, &rng, mask);
            const ref_ellipse_t truth = scene_outline(&scene.ball);
            by_hough(mask, truth, hough);
            by_cone(mask, truth, cone);
        }
        report_line(&report, "%2.0f %%", 100.0 * share);
        hough.print(report);
        cone.print(report);
        report_line(&report, "\n");
        ratio = std::fmax(ratio, cone.radius_rms() / hough.radius_rms());
        unanswered += trials - cone.answered;
    }
    report_line(&report, "\n");
    report_claim(&report, "radius RMS of the cone over Hough's, worst share", ratio, 0.1);
    report_claim(&report, "masks without status ok", static_cast<double>(unanswered), 0.0);
    return report_close(&report);
}
