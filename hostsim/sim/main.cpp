// SPDX-License-Identifier: MIT
//
// ocellus-sim: the paper's experiments in a simulated world.
#include <cstdio>
#include <exception>

#include <ocellus/version.h>

#include "commands.hpp"
#include "error.hpp"

namespace {

constexpr const char *kDescription =
    "ocellus-sim: a simulated robot's head looks at a ball, and the library, OpenCV's Hough\n"
    "transforms and the paper's other fits are measured against the truth.";

constexpr const char *kFooter =
    R"(Exit code: 0 done; 2 usage, unreadable input, or a run that failed.
`ocellus-sim COMMAND --help` tells more.)";

int run(int argc, char **argv) {
    CLI::App app(kDescription, "ocellus-sim");
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("ocellus-sim ") + OCEL_VERSION_STRING);
    app.require_subcommand(1);
    sim::add_run(app);
    sim::add_track(app);
    sim::add_paper(app);
    sim::add_report(app);
    sim::add_merge(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success &wanted) { // --help, --version
        return app.exit(wanted);
    } catch (const CLI::ParseError &mistake) {
        std::fprintf(stderr, "ocellus-sim: error: %s; see ocellus-sim --help\n", mistake.what());
        return cli::kExitInput;
    }
    return cli::kExitOk;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "ocellus-sim: error: %s\n", error.what());
        return cli::kExitInput;
    }
}
