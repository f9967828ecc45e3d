// SPDX-License-Identifier: MIT
//
// The labeller beside OpenCV's connectedComponentsWithStats: the same components
// with the same area, box and centroid, on random and on structured masks, 4- and
// 8-connected.
//
//   opencv_labels [MASKS [SEED]]
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <tuple>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <ocellus/ocellus.h>

#include "frames.h"

namespace {

// left, top, width, height, area, and the sums of x and y: what both report.
using component_t = std::tuple<int, int, int, int, int, long long, long long>;

struct mask_t {
    int width;
    int height;
    std::vector<uint8_t> pixel;

    mask_t(int w, int h)
        : width(w), height(h), pixel(static_cast<size_t>(w) * static_cast<size_t>(h)) {
    }
    uint8_t &at(int x, int y) {
        return pixel[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

std::vector<component_t> by_opencv(const mask_t &mask, int connectivity) {
    const cv::Mat image(mask.height, mask.width, CV_8UC1, const_cast<uint8_t *>(mask.pixel.data()));
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centroids;
    std::vector<component_t> found;
    const int count =
        cv::connectedComponentsWithStats(image, labels, stats, centroids, connectivity, CV_32S);
    for (int k = 1; k < count; k++) {
        const int area = stats.at<int>(k, cv::CC_STAT_AREA);
        found.emplace_back(stats.at<int>(k, cv::CC_STAT_LEFT), stats.at<int>(k, cv::CC_STAT_TOP),
                           stats.at<int>(k, cv::CC_STAT_WIDTH),
                           stats.at<int>(k, cv::CC_STAT_HEIGHT), area,
                           std::llround(centroids.at<double>(k, 0) * area),
                           std::llround(centroids.at<double>(k, 1) * area));
    }
    std::sort(found.begin(), found.end());
    return found;
}

component_t as_component(const ocel_blob_t &blob) {
    return {blob.box.left,
            blob.box.top,
            blob.box.width,
            blob.box.height,
            static_cast<int>(blob.area),
            static_cast<long long>(blob.sum_x),
            static_cast<long long>(blob.sum_y)};
}

bool by_ocellus(const mask_t &mask, ocel_connectivity_t connectivity,
                std::vector<component_t> &found, ocel_blob_t &largest) {
    static ocel_labeller_t labeller;
    static ocel_crack_pool_t pool;
    static ocel_blob_t ended[OCEL_MAX_RUNS + 1];
    const size_t words = (static_cast<size_t>(mask.width) + 31U) / 32U;
    std::vector<uint32_t> rows(words * static_cast<size_t>(mask.height));
    size_t count = 0;
    frame_mask_to_bits(mask.pixel.data(), mask.width, mask.height, rows.data());
    bool good = ocel_label_begin(&labeller, &pool, static_cast<uint16_t>(mask.width),
                                 static_cast<uint16_t>(mask.height), connectivity) == OCEL_OK;
    for (size_t y = 0; good && (y < static_cast<size_t>(mask.height)); y++) {
        good = ocel_label_row(&labeller, &pool, &rows[y * words], ended, &count) == OCEL_OK;
        for (size_t i = 0; good && (i < count); i++) {
            found.push_back(as_component(ended[i]));
        }
    }
    const ocel_status_t status = ocel_label_end(&labeller, &pool, ended, &count, &largest);
    for (size_t i = 0; good && (i < count); i++) {
        found.push_back(as_component(ended[i]));
    }
    std::sort(found.begin(), found.end());
    return good && (status == (found.empty() ? OCEL_NOT_SEEN : OCEL_OK));
}

// One mask both ways; false and a message when they differ.
bool agree(const mask_t &mask, const char *what) {
    for (const ocel_connectivity_t connectivity : {OCEL_CONNECT_8, OCEL_CONNECT_4}) {
        std::vector<component_t> ours;
        ocel_blob_t largest = {};
        const std::vector<component_t> theirs = by_opencv(mask, connectivity);
        const bool good = by_ocellus(mask, connectivity, ours, largest);
        int area = 0;
        for (const auto &component : theirs) {
            area = std::max(area, std::get<4>(component));
        }
        if (!good || (ours != theirs) || (static_cast<int>(largest.area) != area)) {
            std::printf("%s, %dx%d, %d-connected: %zu components, OpenCV %zu; largest %u, OpenCV "
                        "%d\n",
                        what, mask.width, mask.height, static_cast<int>(connectivity), ours.size(),
                        theirs.size(), static_cast<unsigned>(largest.area), area);
            return false;
        }
    }
    return true;
}

// Random pixels, or random overlapping shapes: rings, bars, spirals' teeth.
mask_t random_mask(rng_t &rng) {
    mask_t mask(rng_between(&rng, 1, OCEL_MAX_WIDTH), rng_between(&rng, 1, OCEL_MAX_HEIGHT));
    if (rng_below(&rng, 2) == 0U) {
        const uint32_t share = rng_below(&rng, 101);
        for (auto &p : mask.pixel) {
            p = (rng_below(&rng, 100) < share) ? 1U : 0U;
        }
        return mask;
    }
    const int shapes = rng_between(&rng, 1, 40);
    for (int s = 0; s < shapes; s++) {
        const int cx = rng_between(&rng, 0, mask.width - 1);
        const int cy = rng_between(&rng, 0, mask.height - 1);
        const int outer = rng_between(&rng, 1, 60);
        const int inner = rng_between(&rng, 0, outer);
        const bool bar = rng_below(&rng, 3) == 0U;
        for (int y = std::max(0, cy - outer); y <= std::min(mask.height - 1, cy + outer); y++) {
            for (int x = std::max(0, cx - outer); x <= std::min(mask.width - 1, cx + outer); x++) {
                const int d2 = (x - cx) * (x - cx) + (y - cy) * (y - cy);
                const bool in = bar ? (std::abs(x - cx) * 3 <= inner)
                                    : ((d2 <= outer * outer) && (d2 >= inner * inner));
                mask.at(x, y) ^= in ? 1U : 0U;
            }
        }
    }
    return mask;
}

} // namespace

int main(int argc, char **argv) {
    const int masks = (argc > 1) ? std::atoi(argv[1]) : 1500;
    const unsigned long long seed = (argc > 2) ? std::strtoull(argv[2], nullptr, 10) : 320240ULL;
    rng_t rng = rng_seed(seed);
    int failed = 0;
    for (int k = 0; k < static_cast<int>(FRAME_KINDS); k++) {
        const auto kind = static_cast<frame_kind_t>(k);
        mask_t mask(FRAME_WIDTH, FRAME_HEIGHT);
        frame_mask(kind, mask.width, mask.height, seed, mask.pixel.data());
        failed += agree(mask, frame_name(kind)) ? 0 : 1;
        for (auto &p : mask.pixel) {
            p ^= 1U;
        }
        failed += agree(mask, frame_name(kind)) ? 0 : 1;
    }
    for (int i = 0; i < masks; i++) {
        failed += agree(random_mask(rng), "random") ? 0 : 1;
    }
    std::printf("%d random and %d standard masks, 4- and 8-connected, seed %llu: %d differ from "
                "OpenCV %s\n",
                masks, 2 * static_cast<int>(FRAME_KINDS), seed, failed, CV_VERSION);
    return (failed == 0) ? 0 : 1;
}
