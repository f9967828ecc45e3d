// SPDX-License-Identifier: MIT
//
// ball_sequence: renders a ball that bounces through the picture and leaves it,
// with the truth beside it, for tools/demo.sh.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "error.hpp"
#include "scene.hpp"

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

struct Arguments {
    std::string folder;
    unsigned frames = 24;
    std::uint64_t seed = 1;
};

// From left to right in two hops; the last frames are cut by the right edge.
cli::Ball ball_at(double t) {
    const double hop = std::fmod(2.3 * t + 0.3, 1.0);
    const double height = 4 * hop * (1 - hop);
    const double radius = 24 + 12 * t;
    return {46 + 268 * t, 196 - radius * 0.4 - 110 * (1 - 0.4 * t) * height, radius};
}

void render(const Arguments &arguments) {
    fs::create_directories(arguments.folder);
    std::ofstream truth(fs::path(arguments.folder) / "truth.csv");
    truth << "file,cx,cy,radius\n" << std::fixed << std::setprecision(6);
    for (unsigned i = 0; i < arguments.frames; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "frame_%03u.png", i);
        const double t = arguments.frames > 1 ? i / (arguments.frames - 1.0) : 0.0;
        const cli::Ball ball = ball_at(t);
        cli::write_png((fs::path(arguments.folder) / name).string(),
                       cli::render_scene(kWidth, kHeight, ball, arguments.seed));
        truth << name << ',' << ball.cx << ',' << ball.cy << ',' << ball.radius << '\n';
    }
    if (!truth.flush()) {
        throw cli::InputError(arguments.folder + "/truth.csv: cannot be written");
    }
}

} // namespace

int main(int argc, char **argv) {
    Arguments arguments;
    CLI::App app("Renders a moving ball, 320 x 240, to PNG files, and truth.csv:\n"
                 "file,cx,cy,radius in pixels. The same seed gives the same pictures.",
                 "ball_sequence");
    app.add_option("--out", arguments.folder, "the folder; made when missing")->required();
    app.add_option("--frames", arguments.frames, "how many (24)")->check(CLI::Range(1, 999));
    app.add_option("--seed", arguments.seed, "of the ground's texture (1)");
    try {
        app.parse(argc, argv);
        render(arguments);
    } catch (const CLI::ParseError &mistake) {
        return app.exit(mistake) == 0 ? cli::kExitOk : cli::kExitInput;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "ball_sequence: error: %s\n", error.what());
        return cli::kExitInput;
    }
    return cli::kExitOk;
}
