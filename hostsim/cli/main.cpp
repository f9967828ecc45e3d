// SPDX-License-Identifier: MIT
//
// ocellus: the library's command line.  It reads files, calls the library and
// prints what it computed.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include <ocellus/version.h>

#include "commands.hpp"
#include "error.hpp"

namespace {

constexpr const char *kDescription =
    "ocellus: finds a ball in pictures, fits its ellipse and places it in space, in "
    "integers.";

constexpr const char *kFooter =
    R"(Output: one JSON object a line on stdout; messages go to stderr.
Exit code: 0 status ok; 1 another status (partial, clipped, not_seen,
too_few_points, degenerate, not_an_ellipse, overflow, out_of_range);
2 usage or unreadable input.
Pixel (0,0) has its centre at (0,0), x right, y down. Lengths are in pixels;
a >= b are semi-axes; angle_deg is that of the major axis, from +x towards +y,
0 <= angle < 180. The file name - is standard input.

Examples:
  ocellus detect --colour hsv:340-20,90-255,60-255 --annotate out.png ball.png
  ocellus detect --teach 150,110,16,16 ball.png
  ocellus detect --teach 150,110,16,16 --camera 257,257,160,120 --radius 35 ball.png
  ocellus sphere --camera 257,257,160,120 --radius 35 outline.csv
  ocellus fit --method hyper points.csv
  ocellus label --connectivity 4 mask.pgm

`ocellus COMMAND --help` tells more.)";

constexpr const char *kCommands = "fit, label, detect, sphere or bench";

// A word where a command should be, which the parser would call a missing one.
void check_command(const CLI::App &app, int argc, char **argv) {
    const auto is_named = [argv](const CLI::App *command) {
        return command->get_name() == argv[1];
    };
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_named).empty()) {
        throw cli::InputError("found " + cli::quoted(argv[1]) + " where the command should be; " +
                              "expected " + kCommands + ": see ocellus --help");
    }
}

// What went wrong: the first word that belongs to no option, when there is one.
void report(const CLI::App &app, const CLI::ParseError &mistake) {
    std::string command = "ocellus";
    for (const CLI::App *const chosen : app.get_subcommands()) {
        command += " " + chosen->get_name();
    }
    const std::vector<std::string> unknown = app.remaining(true);
    const std::string what = unknown.empty()
                                 ? mistake.what()
                                 : "found " + cli::quoted(unknown[0]) + ", which is no option here";
    std::fprintf(stderr, "%s: error: %s; see %s --help\n", command.c_str(), what.c_str(),
                 command.c_str());
}

// Turns the parser's exceptions into exit codes.
int parse(CLI::App &app, int argc, char **argv) {
    check_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success &wanted) { // --help, --version
        return app.exit(wanted);
    } catch (const CLI::ParseError &mistake) {
        report(app, mistake);
        return cli::kExitInput;
    }
    return cli::kExitOk;
}

int run(int argc, char **argv) {
    int exit_code = cli::kExitOk;
    CLI::App app(kDescription, "ocellus");
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("ocellus ") + OCEL_VERSION_STRING);
    app.require_subcommand(1);
    cli::add_fit(app, exit_code);
    cli::add_label(app, exit_code);
    cli::add_detect(app, exit_code);
    cli::add_sphere(app, exit_code);
    cli::add_bench(app, exit_code);
    const int parsed = parse(app, argc, argv);
    return parsed != cli::kExitOk ? parsed : exit_code;
}

} // namespace

int main(int argc, char **argv) {
    int exit_code = cli::kExitInput;
    try {
        exit_code = run(argc, argv);
        if (!std::cout.flush()) {
            throw cli::InputError("standard output cannot be written");
        }
    } catch (const std::exception &error) {
        std::cout.flush();
        std::fprintf(stderr, "ocellus: error: %s\n", error.what());
        exit_code = cli::kExitInput;
    }
    return exit_code;
}
