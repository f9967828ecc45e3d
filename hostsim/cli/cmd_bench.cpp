// SPDX-License-Identifier: MIT
//
// ocellus bench: what each stage costs on this machine, on one built-in frame.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include <ocellus/ocellus.h>

#include "camera_lines.hpp"
#include "colour_spec.hpp"
#include "commands.hpp"
#include "decimal.hpp"
#include "error.hpp"
#include "json_out.hpp"
#include "scene.hpp"

namespace cli {

namespace {

constexpr const char *kFooter =
    R"(The frame is built in: 320 x 240, one ball of radius 40 before a textured
ground. `ns` is wall time on this machine, the best of many runs: it is no bound
and differs between machines. `operations` is a count, the same everywhere, and
`bound` is the most it can be for a frame of this size, whatever the frame shows.
A lens is undone in a fixed number of steps a point, and the cone fit tries a fixed
number of hypotheses, whatever the points are. The library of this program is built
for 4096 x 4096, so its moment sums have 64 bits; one built for 320 x 240 has 32.

Examples:
  ocellus bench
  ocellus bench --json)";

constexpr std::uint16_t kWidth = 320;
constexpr std::uint16_t kHeight = 240;
constexpr Ball kBall{158.3, 121.7, 40.0};
constexpr std::uint64_t kSeed = 1;

// A stage is run in batches until this long; the fastest batch counts.
constexpr std::chrono::milliseconds kStageTime{60};
constexpr int kBatchesMin = 5;

struct Stage {
    std::string name;
    std::string input;
    std::string unit; // of operations
    std::uint64_t operations;
    std::uint64_t bound;
    double ns;
};

double fastest_ns(const std::function<void()> &work) {
    using Clock = std::chrono::steady_clock;
    double best = 0;
    const Clock::time_point start = Clock::now();
    for (int batch = 0; batch < kBatchesMin || Clock::now() - start < kStageTime; ++batch) {
        const Clock::time_point before = Clock::now();
        work();
        const double ns = std::chrono::duration<double, std::nano>(Clock::now() - before).count();
        best = batch == 0 ? ns : std::min(best, ns);
    }
    return best;
}

void require_ok(ocel_status_t status) {
    if (status != OCEL_OK) {
        throw InputError(std::string("bench: a stage failed on the built-in frame: ") +
                         ocel_status_name(status));
    }
}

// The frame in one pixel format, and the compiled colour that finds the ball.
class Frame {
  public:
    Frame(const Image &image, ocel_format_t format, const char *colour) {
        CameraLines lines(image, format);
        line_bytes_ = lines.line_bytes();
        for (std::size_t y = 0; y < kHeight; ++y) {
            const std::uint8_t *const line = lines.line(y);
            pixels_.insert(pixels_.end(), line, line + line_bytes_);
        }
        const ocel_colour_range_t range = parse_colour(colour);
        require_ok(ocel_colour_compile(&colour_, &range, format, &table_));
    }
    Frame(const Frame &) = delete;
    Frame &operator=(const Frame &) = delete;

    const ocel_colour_t *colour() const {
        return &colour_;
    }
    const std::uint8_t *pixels() const {
        return pixels_.data();
    }
    std::size_t line_bytes() const {
        return line_bytes_;
    }
    void classify(std::uint16_t y, std::uint32_t *row) const {
        require_ok(
            ocel_colour_row(&colour_, pixels_.data() + y * line_bytes_, line_bytes_, kWidth, row));
    }

  private:
    ocel_colour_table_t table_{};
    ocel_colour_t colour_{};
    std::size_t line_bytes_ = 0;
    std::vector<std::uint8_t> pixels_;
};

class Bench {
  public:
    std::vector<Stage> run() {
        const Image image = render_scene(kWidth, kHeight, kBall, kSeed);
        const Image grey = grey_of(image);
        const Frame bgr(image, OCEL_FORMAT_BGR888, kBallColour);
        const Frame rgb565(image, OCEL_FORMAT_RGB565, kBallColour);
        const Frame gray(grey, OCEL_FORMAT_GRAY8, "gray:160-255");
        colour_stage("colour BGR888", bgr);
        colour_stage("colour RGB565", rgb565);
        colour_stage("colour GRAY8", gray);
        label_stages(bgr);
        fit_stage(OCEL_FIT_B2AC);
        fit_stage(OCEL_FIT_LCSE);
        fit_stage(OCEL_FIT_HYPER);
        camera_stage("camera rays", 0);
        camera_stage("lens rays", -0x400000); // k1 = -1/4
        cone_stage();
        sphere_stage();
        frame_stage("frame BGR888", bgr);
        frame_stage("frame RGB565", rgb565);
        return stages_;
    }

  private:
    static constexpr std::uint64_t kPixels = std::uint64_t{kWidth} * kHeight;

    static Image grey_of(const Image &image) {
        Image grey{image.width, image.height, 1, {}};
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
            grey.pixels.push_back(image.pixels[i]); // the red channel shows the ball best
        }
        return grey;
    }

    void colour_stage(const char *name, const Frame &frame) {
        const double ns = fastest_ns([this, &frame] {
            for (std::uint16_t y = 0; y < kHeight; ++y) {
                frame.classify(y, row_);
            }
        });
        stages_.push_back({name, "320x240", "pixels", kPixels, kPixels, ns});
    }

    void label_all(const std::vector<std::uint32_t> &rows) {
        require_ok(ocel_label_begin(&labeller_, &pool_, kWidth, kHeight, OCEL_CONNECT_8));
        for (std::size_t y = 0; y < kHeight; ++y) {
            require_ok(ocel_label_row(&labeller_, &pool_, rows.data() + y * OCEL_ROW_WORDS, nullptr,
                                      nullptr));
        }
        require_ok(ocel_label_end(&labeller_, &pool_, nullptr, nullptr, nullptr));
    }

    // The boundary reuses the pool, so each run of it starts from a copy.
    void label_stages(const Frame &frame) {
        std::vector<std::uint32_t> rows(std::size_t{kHeight} * OCEL_ROW_WORDS);
        for (std::uint16_t y = 0; y < kHeight; ++y) {
            frame.classify(y, rows.data() + std::size_t{y} * OCEL_ROW_WORDS);
        }
        const double label_ns = fastest_ns([this, &rows] { label_all(rows); });
        const ocel_label_stats_t stats = ocel_label_stats(&labeller_);
        stages_.push_back({"label", "320x240", "runs", stats.runs,
                           std::uint64_t{kHeight} * ((kWidth + 1) / 2), label_ns});
        boundary_stage(rows);
    }

    void boundary_stage(const std::vector<std::uint32_t> &rows) {
        double best = 0;
        for (int i = 0; i < 50; ++i) {
            label_all(rows);
            const auto before = std::chrono::steady_clock::now();
            take_boundary();
            const auto after = std::chrono::steady_clock::now();
            const double ns = std::chrono::duration<double, std::nano>(after - before).count();
            best = i == 0 ? ns : std::min(best, ns);
        }
        stages_.push_back(
            {"boundary", "320x240", "points", boundary_.size(), OCEL_MAX_CRACKS, best});
    }

    void take_boundary() {
        const ocel_crack_t *cracks = nullptr;
        std::size_t count = 0;
        require_ok(ocel_label_boundary(&labeller_, &pool_, &cracks, &count, nullptr));
        boundary_.assign(cracks, cracks + count);
    }

    void fit_stage(ocel_fit_method_t method) {
        ocel_fit_options_t options{};
        options.method = method;
        options.closed = true; // a whole boundary, as the eye fits it
        ocel_ellipse_t ellipse{};
        const double ns = fastest_ns([this, &options, &ellipse] {
            require_ok(ocel_fit_cracks(boundary_.data(), boundary_.size(), &options, &ellipse));
        });
        stages_.push_back({std::string("fit ") + method_name(method),
                           std::to_string(boundary_.size()) + " points", "points", boundary_.size(),
                           OCEL_MAX_FIT_POINTS, ns});
    }

    // A camera of the iCub's kind, for the frame's size.
    static ocel_camera_t camera_of(std::int32_t k1_q24) {
        ocel_intrinsics_t intrinsics{};
        intrinsics.fx_px_q16 = 257 * 65536;
        intrinsics.fy_px_q16 = 257 * 65536;
        intrinsics.cx_px_q16 = 160 * 65536;
        intrinsics.cy_px_q16 = 120 * 65536;
        intrinsics.k1_q24 = k1_q24;
        intrinsics.width = kWidth;
        intrinsics.height = kHeight;
        ocel_camera_t camera{};
        require_ok(ocel_camera_init(&camera, &intrinsics));
        return camera;
    }

    void camera_stage(const char *name, std::int32_t k1_q24) {
        const ocel_camera_t camera = camera_of(k1_q24);
        const double ns = fastest_ns([this, &camera] {
            for (const ocel_crack_t &crack : boundary_) {
                const ocel_point_t pixel = {crack.x_hpx * 32768, crack.y_hpx * 32768};
                std::int32_t ray[3];
                require_ok(ocel_camera_ray(&camera, &pixel, ray));
            }
        });
        const std::uint64_t each = k1_q24 == 0 ? 1 : OCEL_UNDISTORT_STEPS;
        stages_.push_back({name, std::to_string(boundary_.size()) + " points",
                           k1_q24 == 0 ? "rays" : "steps", each * boundary_.size(),
                           each * OCEL_MAX_FIT_POINTS, ns});
    }

    void cone_stage() {
        const ocel_camera_t camera = camera_of(0);
        const double ns = fastest_ns([this, &camera] {
            require_ok(ocel_cone_fit_cracks(&camera, boundary_.data(), boundary_.size(), &cone_));
        });
        stages_.push_back({"cone fit", std::to_string(boundary_.size()) + " points", "points",
                           boundary_.size(), OCEL_MAX_FIT_POINTS, ns});
    }

    void sphere_stage() {
        ocel_sphere_t sphere{};
        const double ns = fastest_ns(
            [this, &sphere] { require_ok(ocel_sphere_of_cone(&cone_, 35000, &sphere)); });
        stages_.push_back({"sphere", "1 cone", "cones", 1, 1, ns});
    }

    void frame_stage(const char *name, const Frame &frame) {
        ocel_eye_config_t config{};
        config.width = kWidth;
        config.height = kHeight;
        require_ok(ocel_eye_init(&eye_, &config));
        ocel_detection_t detection{};
        const double ns = fastest_ns([this, &frame, &detection] {
            require_ok(ocel_eye_frame(&eye_, frame.colour(), frame.pixels(), frame.line_bytes(),
                                      &detection));
        });
        stages_.push_back({name, "320x240", "pixels", kPixels, kPixels, ns});
    }

    std::uint32_t row_[OCEL_ROW_WORDS] = {};
    ocel_labeller_t labeller_{};
    ocel_crack_pool_t pool_{};
    ocel_eye_t eye_{};
    std::vector<ocel_crack_t> boundary_;
    ocel_cone_t cone_{};
    std::vector<Stage> stages_;
};

void print_json(const Stage &stage) {
    print_line(Json{{"stage", stage.name},
                    {"input", stage.input},
                    {"operations", stage.operations},
                    {"bound", stage.bound},
                    {"unit", stage.unit},
                    {"ns", std::llround(stage.ns)},
                    {"figure", "ns: this machine, best run; operations: exact"}});
}

void print_table(const std::vector<Stage> &stages) {
    std::printf("%-15s %-11s %12s %12s %-7s %12s\n", "stage", "input", "operations", "bound", "of",
                "ns*");
    for (const Stage &stage : stages) {
        std::printf("%-15s %-11s %12llu %12llu %-7s %12.0f\n", stage.name.c_str(),
                    stage.input.c_str(), static_cast<unsigned long long>(stage.operations),
                    static_cast<unsigned long long>(stage.bound), stage.unit.c_str(), stage.ns);
    }
    std::printf(
        "* wall time on this machine, the best of many runs; operations are exact counts\n");
}

int run_bench(bool json) {
    const std::vector<Stage> stages = std::make_unique<Bench>()->run();
    if (json) {
        std::for_each(stages.begin(), stages.end(), print_json);
    } else {
        print_table(stages);
    }
    return kExitOk;
}

} // namespace

void add_bench(CLI::App &app, int &exit_code) {
    const auto json = std::make_shared<bool>(false);
    CLI::App *const command =
        app.add_subcommand("bench", "Time each stage on a built-in frame, and count its work");
    command->footer(kFooter);
    command->add_flag("--json", *json, "one JSON object a line instead of the table");
    command->callback([json, &exit_code] { exit_code = run_bench(*json); });
}

} // namespace cli
