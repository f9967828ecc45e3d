// SPDX-License-Identifier: MIT
//
// Plots as SVG text, drawn by gnuplot.
#ifndef OCELLUS_SIM_PLOT_HPP
#define OCELLUS_SIM_PLOT_HPP

#include <optional>
#include <string>
#include <vector>

namespace sim {

struct PlotPoint {
    double x;
    double y;
    double low = y; // ends of the error bar
    double high = y;
};

// How a curve looks, with and without colour.
struct Ink {
    const char *colour; // #rrggbb
    int marker;         // gnuplot's point type
    double width = 1.6; // px
};

enum class Stroke {
    kMarks,  // markers, joined, with error bars
    kSolid,  // a line alone
    kDashed, // the same, dashed
    kDots    // markers alone, small
};

struct Curve {
    std::string title; // in the legend; "": not there
    Ink ink;
    Stroke stroke;
    std::vector<PlotPoint> points;
};

struct PlotSpan {
    double from;
    double to;
};

// A level to compare with, a dotted line; words for the legend.
struct Level {
    double y;
    std::string words;
};

struct Plot {
    std::string name;  // of a letter and letters, digits: for the ids inside a page
    std::string about; // what is seen, for those who do not see it
    std::string x_label;
    std::string y_label;
    bool log_y = false;
    std::optional<PlotSpan> x_range; // an end that is not a number is free
    std::optional<PlotSpan> y_range;
    std::vector<Curve> curves;
    std::vector<Level> levels;
    std::vector<PlotSpan> shaded; // along x
    std::string shaded_words;     // in the legend
};

// An <svg> element that can stand in a page beside others.  std::runtime_error when
// gnuplot fails.
std::string plot_svg(const Plot &plot);

// cli::InputError with the fix when there is no gnuplot on this machine.
void require_gnuplot();

} // namespace sim

#endif
