// SPDX-License-Identifier: MIT
//
// The camera beside OpenCV's: cv::projectPoints with the same lens, and
// cv::undistortPoints, whose iteration stops where the lens is strong.
//
//   opencv_camera [TABLE.txt [CASES [SEED]]]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include <ocellus/camera.h>

#include "accuracy/report.h"
#include "rng.h"

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kIterations = 200; // of OpenCV, which takes 5 unless it is told

struct lens_t {
    const char *name;
    double f;
    double k[5]; // k1 k2 p1 p2 k3
};

constexpr lens_t kLenses[] = {{"none", 300, {0, 0, 0, 0, 0}},
                              {"mild", 525, {.05, -.12, .0006, -.0004, .02}},
                              {"stereo pair", 536, {-.265, -.0467, .0018, -.0003, .252}},
                              {"barrel", 400, {-.3, .1, .001, .001, 0}},
                              {"pincushion", 300, {.2, .05, 0, 0, 0}},
                              {"strong barrel", 300, {-.35, .12, 0, 0, 0}}};

double of_q24(std::int32_t q24) {
    return q24 / 16777216.0;
}

// The same camera for both, to the last bit.
struct cameras_t {
    ocel_camera_t ours{};
    cv::Mat matrix = cv::Mat::eye(3, 3, CV_64F);
    cv::Mat coefficients = cv::Mat::zeros(1, 5, CV_64F);
};

cameras_t cameras_of(const lens_t &lens) {
    cameras_t cameras;
    ocel_intrinsics_t in{};
    std::int32_t *const k_q24[5] = {&in.k1_q24, &in.k2_q24, &in.p1_q24, &in.p2_q24, &in.k3_q24};
    in.fx_px_q16 = static_cast<std::int32_t>(std::lround(lens.f * 65536));
    in.fy_px_q16 = static_cast<std::int32_t>(std::lround(lens.f * 1.07 * 65536));
    in.cx_px_q16 = 322 * 65536;
    in.cy_px_q16 = 231 * 65536;
    in.width = kWidth;
    in.height = kHeight;
    for (int i = 0; i < 5; i++) {
        *k_q24[i] = static_cast<std::int32_t>(std::lround(lens.k[i] * 16777216));
        cameras.coefficients.at<double>(i) = of_q24(*k_q24[i]);
    }
    cameras.matrix.at<double>(0, 0) = in.fx_px_q16 / 65536.0;
    cameras.matrix.at<double>(1, 1) = in.fy_px_q16 / 65536.0;
    cameras.matrix.at<double>(0, 2) = in.cx_px_q16 / 65536.0;
    cameras.matrix.at<double>(1, 2) = in.cy_px_q16 / 65536.0;
    if (ocel_camera_init(&cameras.ours, &in) != OCEL_OK) {
        std::abort();
    }
    return cameras;
}

cv::Point2d by_opencv(const cameras_t &cameras, const cv::Point3d &p) {
    std::vector<cv::Point2d> out;
    cv::projectPoints(std::vector<cv::Point3d>{p}, cv::Vec3d(0, 0, 0), cv::Vec3d(0, 0, 0),
                      cameras.matrix, cameras.coefficients, out);
    return out[0];
}

struct row_t {
    size_t refused = 0;    // by ocellus: pixels without a ray
    double project = 0;    // ocellus from projectPoints, px
    double undistort = 0;  // ocellus from undistortPoints where that is right, px
    double back = 0;       // ocellus' ray by projectPoints from the pixel, px
    size_t theirs_off = 0; // undistortPoints' answer is over 1/64 px from the pixel
};

row_t run(rng_t &rng, const cameras_t &cameras, size_t cases) {
    row_t row;
    const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kIterations,
                                  1e-14);
    for (size_t i = 0; i < cases; i++) {
        const ocel_point_t pixel = {rng_between(&rng, 0, (kWidth - 1) * 65536),
                                    rng_between(&rng, 0, (kHeight - 1) * 65536)};
        const cv::Point2d at(pixel.x_px_q16 / 65536.0, pixel.y_px_q16 / 65536.0);
        std::int32_t d[3];
        if (ocel_camera_ray(&cameras.ours, &pixel, d) != OCEL_OK) {
            row.refused++;
            continue;
        }
        const cv::Point2d ray(static_cast<double>(d[0]) / d[2], static_cast<double>(d[1]) / d[2]);
        row.back = std::fmax(row.back, cv::norm(by_opencv(cameras, {ray.x, ray.y, 1}) - at));

        std::vector<cv::Point2d> theirs;
        cv::undistortPoints(std::vector<cv::Point2d>{at}, theirs, cameras.matrix,
                            cameras.coefficients, cv::noArray(), cv::noArray(), enough);
        const double off = cv::norm(by_opencv(cameras, {theirs[0].x, theirs[0].y, 1}) - at);
        if (off < 1e-6) {
            const double focal = cameras.matrix.at<double>(0, 0);
            row.undistort = std::fmax(row.undistort, focal * cv::norm(theirs[0] - ray));
        }
        row.theirs_off += (off < 1.0 / 64.0) ? 0U : 1U; // a NaN counts

        const std::int32_t p[3] = {d[0] / 2, d[1] / 2, d[2] / 2};
        ocel_point_t seen;
        if (ocel_camera_project(&cameras.ours, p, &seen) != OCEL_OK) {
            row.project = INFINITY;
            continue;
        }
        const cv::Point2d projected(seen.x_px_q16 / 65536.0, seen.y_px_q16 / 65536.0);
        const cv::Point3d point(p[0], p[1], p[2]);
        row.project = std::fmax(row.project, cv::norm(by_opencv(cameras, point) - projected));
    }
    return row;
}

} // namespace

int main(int argc, char **argv) {
    report_t report = report_open(argc, argv);
    const size_t cases = (argc > 2) ? std::strtoul(argv[2], nullptr, 10) : 3000UL;
    const unsigned long long seed = (argc > 3) ? std::strtoull(argv[3], nullptr, 10) : 66ULL;
    rng_t rng = rng_seed(seed);
    double project = 0;
    double undistort = 0;
    double back = 0;
    size_t refused = 0;
    report_line(&report,
                "OpenCV %s projectPoints and undistortPoints (%d iterations) beside the camera;\n"
                "%d x %d, %zu pixels a row, seed %llu; worst distance, px.\n\n"
                "lens              f | project    undistort  ray, projected | refused | "
                "undistortPoints over 1/64 px\n",
                CV_VERSION, kIterations, kWidth, kHeight, cases, seed);
    for (const lens_t &lens : kLenses) {
        const row_t row = run(rng, cameras_of(lens), cases);
        report_line(&report, "%-15s %3.0f | %.2e   %.2e   %.2e       | %7zu | %.1f %%\n", lens.name,
                    lens.f, row.project, row.undistort, row.back, row.refused,
                    100.0 * static_cast<double>(row.theirs_off) / static_cast<double>(cases));
        project = std::fmax(project, row.project);
        undistort = std::fmax(undistort, row.undistort);
        back = std::fmax(back, row.back);
        refused += row.refused;
    }
    report_line(&report, "\n");
    report_claim(&report, "worst distance from projectPoints, px", project, 1e-4);
    report_claim(&report, "worst distance from undistortPoints where that is right, px", undistort,
                 1e-4);
    report_claim(&report, "rays that projectPoints puts elsewhere, worst, px", back, 1e-4);
    report_claim(&report, "pixels without a ray", static_cast<double>(refused), 0.0);
    return report_close(&report);
}
