// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "error.hpp"
#include "support/temporary_file.hpp"

namespace sim {

namespace {

constexpr int kWidth = 900;
constexpr int kHeight = 430;

// Curves at the same places are drawn beside each other: so far apart at most, of the
// smallest step along x.
constexpr double kDodge = 0.09;

// Text in gnuplot's single quotes, where only a quote means something.
std::string quoted_text(const std::string &text) {
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? "''" : std::string(1, c);
    }
    return quoted + "'";
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.8g}", value) : "NaN";
}

double smallest_step(const Plot &plot) {
    double step = HUGE_VAL;
    for (const Curve &curve : plot.curves) {
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            step = std::min(step, std::fabs(curve.points[i].x - curve.points[i - 1].x));
        }
    }
    return step;
}

// How far each curve with marks is moved along x.
std::vector<double> dodges(const Plot &plot) {
    std::vector<double> shifts(plot.curves.size(), 0.0);
    int marked = 0;
    for (const Curve &curve : plot.curves) {
        marked += curve.stroke == Stroke::kMarks ? 1 : 0;
    }
    const double step = marked > 1 ? 2.0 * kDodge * smallest_step(plot) / (marked - 1) : 0.0;
    int nth = 0;
    for (std::size_t i = 0; i < shifts.size(); ++i) {
        if (plot.curves[i].stroke == Stroke::kMarks && std::isfinite(step)) {
            shifts[i] = step * (nth++ - (marked - 1) / 2.0);
        }
    }
    return shifts;
}

std::string data_block(std::size_t index, const Curve &curve, double shift) {
    std::string block = fmt::format("$curve{} << END\n", index);
    for (const PlotPoint &point : curve.points) {
        block += fmt::format("{} {} {} {}\n", number(point.x + shift), number(point.y),
                             number(point.low), number(point.high));
    }
    return block + "END\n";
}

// An end that is not a number is left to gnuplot.
std::string range(const char *axis, const std::optional<PlotSpan> &span) {
    const auto end = [](double value) { return std::isfinite(value) ? number(value) : "*"; };
    return span ? fmt::format("set {}range [{}:{}]\n", axis, end(span->from), end(span->to)) : "";
}

std::string style_of(const Curve &curve) {
    const std::string line = fmt::format("lc rgb '{}' lw {}", curve.ink.colour, curve.ink.width);
    switch (curve.stroke) {
    case Stroke::kSolid:
        return "with lines " + line;
    case Stroke::kDashed:
        return "with lines dt (8,5) " + line;
    case Stroke::kDots:
        return fmt::format("with points {} pt {} ps 0.4", line, curve.ink.marker);
    case Stroke::kMarks:
    default:
        return fmt::format("with yerrorlines {} pt {} ps 0.75", line, curve.ink.marker);
    }
}

std::string curve_command(std::size_t index, const Curve &curve) {
    return fmt::format("$curve{} using {} {} {}", index,
                       curve.stroke == Stroke::kMarks ? "1:2:3:4" : "1:2", style_of(curve),
                       curve.title.empty() ? "notitle" : "title " + quoted_text(curve.title));
}

std::string shaded_commands(const Plot &plot) {
    std::string text;
    for (const PlotSpan &span : plot.shaded) {
        text += fmt::format("set object rectangle from {}, graph 0 to {}, graph 1 behind "
                            "fillcolor rgb '#d9d9d9' fillstyle solid noborder\n",
                            number(span.from), number(span.to));
    }
    return text;
}

// Further curves of the plot command; the legend's last lines.
std::string level_and_shade_curves(const Plot &plot) {
    std::string text;
    for (const Level &level : plot.levels) {
        text += fmt::format(", \\\n     {} with lines lc rgb '#444444' lw 1.3 dt (2,4) title {}",
                            number(level.y), quoted_text(level.words));
    }
    if (!plot.shaded.empty()) {
        text += fmt::format(", \\\n     NaN with boxes fillstyle solid lc rgb '#d9d9d9' title {}",
                            quoted_text(plot.shaded_words));
    }
    return text;
}

std::string script_of(const Plot &plot) {
    const std::vector<double> shifts = dodges(plot);
    std::string blocks;
    std::string commands;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        blocks += data_block(i, plot.curves[i], shifts[i]);
        commands += (i == 0 ? "plot " : ", \\\n     ") + curve_command(i, plot.curves[i]);
    }
    commands += level_and_shade_curves(plot);
    return fmt::format("set terminal svg size {},{} dynamic noenhanced name '{}' "
                       "font 'sans-serif,14' background '#ffffff'\n",
                       kWidth, kHeight, plot.name) +
           "set encoding utf8\n"
           "set key outside right top Left reverse spacing 1.25 samplen 2.5\n"
           "set border 3 lc rgb '#444444'\n"
           "set tics nomirror\n"
           "set grid lc rgb '#e0e0e0' lw 0.7\n"
           "set bars 0.6\n" +
           "set xlabel " + quoted_text(plot.x_label) + "\nset ylabel " + quoted_text(plot.y_label) +
           "\n" + (plot.log_y ? "set logscale y\nset format y '%g'\n" : "") +
           range("x", plot.x_range) + range("y", plot.y_range) + shaded_commands(plot) + blocks +
           commands + "\n";
}

std::string text_of(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// What gnuplot draws.  What it says beside that (a curve without points, say) only
// matters when it fails.
std::string gnuplot_output(const std::string &script) {
    const TemporaryFile in(script);
    const TemporaryFile out("");
    const TemporaryFile said("");
    const std::string command = "gnuplot " + in.path() + " >" + out.path() + " 2>" + said.path();
    if (std::system(command.c_str()) != 0) {
        throw std::runtime_error("gnuplot fails: " + text_of(said.path()));
    }
    return text_of(out.path());
}

// Those of text boxes, of which there are none.
std::string without_filters(std::string svg) {
    const std::string end = "</filter>";
    for (std::size_t at = 0; (at = svg.find("<filter")) != std::string::npos;) {
        svg.erase(at, svg.find(end, at) + end.size() - at);
    }
    return svg;
}

// The <svg> element alone; names that would clash with those of other plots in the page
// get the plot's own in front, and the addresses of namespaces, which HTML does not need,
// are left out.
std::string embeddable(const std::string &file, const Plot &plot) {
    const std::size_t begin = file.find("<svg");
    if (begin == std::string::npos) {
        throw std::runtime_error("gnuplot draws no SVG: " + file.substr(0, 500));
    }
    std::string svg = without_filters(file.substr(begin));
    svg = std::regex_replace(svg, std::regex(R"re(\s+xmlns(:xlink)?="[^"]*")re"), "");
    svg = std::regex_replace(svg, std::regex(R"re(<(title|desc)>[^<]*</(title|desc)>)re"), "");
    svg = std::regex_replace(svg, std::regex(R"re(xlink:href=(['"])#)re"), "href=$1#" + plot.name);
    svg = std::regex_replace(svg, std::regex(R"re(id=(['"])gp)re"), "id=$1" + plot.name + "gp");
    svg = std::regex_replace(svg, std::regex("<g id=\"gnuplot_canvas\">"), "<g>");
    return std::regex_replace(svg, std::regex("^<svg"),
                              fmt::format("<svg role=\"img\" aria-label=\"{}\"", plot.about));
}

} // namespace

void require_gnuplot() {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) {
        throw cli::InputError("the report's plots need gnuplot, which is not installed: "
                              "apt-get install gnuplot-nox (tools/setup.sh demo does it)");
    }
}

std::string plot_svg(const Plot &plot) {
    return embeddable(gnuplot_output(script_of(plot)), plot);
}

} // namespace sim
