// SPDX-License-Identifier: MIT
//
// Table 3, and how often each method fails.
#include <cmath>
#include <fmt/format.h>

#include "error.hpp"
#include "report/report.hpp"
#include "report/report_curves.hpp"
#include "report/report_sections.hpp"
#include "report/report_table3.hpp"
#include "trials/threshold.hpp"

namespace sim {

namespace {

// The paper's Table 3, ATCDS: OpenCV's param2.
const std::vector<PublishedThreshold> kPaperOcclusion = {{0.05, 3.0}, {0.10, 2.6}, {0.15, 2.3},
                                                         {0.20, 2.1}, {0.25, 2.0}, {0.30, 2.0}};
const std::vector<PublishedThreshold> kPaperDistance = {{1.2, 3.4}, {1.6, 3.0}, {2.0, 2.6},
                                                        {2.4, 2.4}, {2.8, 2.1}, {3.2, 2.0}};

std::optional<double> published_at(const std::vector<PublishedThreshold> &published, double at) {
    for (const PublishedThreshold &entry : published) {
        if (std::fabs(entry.at - at) < 1e-9) {
            return entry.atcds;
        }
    }
    return std::nullopt;
}

std::string votes_table(const Table3 &table3) {
    Table table(
        std::string("table3 ") + table3.key,
        fmt::format("The largest whole <code>param2</code> that works, over {}", table3.what),
        {table3.head, "in all trials", "votes / 2πr", "in nine of ten", "trials", "radius, px",
         "paper's ATCDS", "rounded"});
    for (const Json &row : table3.rows) {
        const auto published = published_at(table3.published, row.at("at"));
        table.add({fmt::format("{:.4g}", row.at("at").get<double>() * table3.x_scale),
                   fmt::format("{}", row.at("votes").get<int>()),
                   plain(row.at("votes_of_circumference"), 3),
                   fmt::format("{}", row.at("votes_most").get<int>()),
                   fmt::format("{}", row.at("trials").get<int>()), plain(row.at("radius_px"), 1),
                   published ? fmt::format("{}", *published) : "",
                   published ? fmt::format("{:.0f}", std::nearbyint(*published)) : ""});
    }
    return table.html();
}

Plot votes_plot(const Table3 &table3) {
    Plot plot;
    plot.name = std::string("table3_") + table3.key;
    plot.about = std::string("The largest threshold that works over ") + table3.what;
    plot.x_label = table3.axis;
    plot.y_label = "param2, whole votes";
    plot.y_range = PlotSpan{0.0, NAN};
    const double first = table3.rows.front().at("at").get<double>() * table3.x_scale;
    const double last = table3.rows.back().at("at").get<double>() * table3.x_scale;
    plot.x_range = PlotSpan{first - 0.03 * (last - first), last + 0.03 * (last - first)};
    Curve all{"in all trials", {"#0072B2", 5}, Stroke::kMarks, {}};
    Curve most{"in nine of ten", {"#56B4E9", 4}, Stroke::kMarks, {}};
    for (const Json &row : table3.rows) {
        const double x = row.at("at").get<double>() * table3.x_scale;
        const auto add = [x](Curve &curve, double y) { curve.points.push_back({x, y, y, y}); };
        add(all, row.at("votes"));
        add(most, row.at("votes_most"));
    }
    const double scale = scale_of(table3);
    Curve paper{fmt::format("paper's × {}", plain(scale, 1)), {"#D55E00", 9}, Stroke::kMarks, {}};
    for (const PublishedThreshold &entry : table3.published) {
        const double y = entry.atcds * scale;
        paper.points.push_back({entry.at * table3.x_scale, y, y, y});
    }
    plot.curves = {all, most, paper};
    return plot;
}

std::string table3_html(const Table3 &table3) {
    return figure(votes_plot(table3),
                  fmt::format("<b>Table 3 over {}</b>, beside the paper's numbers times {} (by "
                              "least squares): the fall is the paper's, the unit is not.",
                              table3.what, plain(scale_of(table3), 1))) +
           votes_table(table3);
}

std::string failure_class(double share) {
    if (share > 0.5) {
        return "f3";
    }
    if (share > 0.1) {
        return "f2";
    }
    return share > 0.0 ? "f1" : "none";
}

// Of the trials, in percent: those without success, or those called ok without it.
std::string share_table(const SweepResult &sweep, const std::string &key,
                        const std::string &caption,
                        double (*failed)(double trials, double success, double ok_but_wrong)) {
    const Measure measure{sweep, key, sweep.name() == "b_occlusion" ? 100.0 : 1.0};
    std::vector<std::string> heads = point_heads(measure, "method");
    heads.push_back("all");
    Table table(sweep.name() + " " + key + " percent", caption, heads);
    for (const std::string &method : sweep.methods()) {
        std::vector<std::string> cells{method};
        std::vector<std::string> classes{""};
        const auto add = [&](double trials, double success, double ok_but_wrong) {
            const double share = failed(trials, success, ok_but_wrong) / trials;
            cells.push_back(fmt::format("{:.1f}", 100.0 * share));
            classes.push_back(failure_class(share));
        };
        for (std::size_t i = 0; i < sweep.points().size(); ++i) {
            add(sweep.at(method, i, "trials"), sweep.at(method, i, "success"),
                sweep.at(method, i, "ok_but_wrong"));
        }
        add(sweep.all(method, "trials"), sweep.all(method, "success"),
            sweep.all(method, "ok_but_wrong"));
        table.add(cells, classes);
    }
    return table.html();
}

bool fails_at_all(const SweepResult &sweep) {
    for (const std::string &method : sweep.methods()) {
        if (sweep.all(method, "success") < sweep.all(method, "trials")) {
            return true;
        }
    }
    return false;
}

std::string failures_html(const SweepResult &sweep, const std::string &title) {
    const std::string where =
        sweep.name() == "b_occlusion" ? "at each occlusion (%)" : "at each distance (SMU)";
    if (!fails_at_all(sweep)) {
        return heading(title) +
               paragraph(fmt::format("No method failed in any of the {:.0f} trials.",
                                     sweep.all(sweep.methods()[0], "trials")));
    }
    return heading(title) +
           share_table(sweep, "failed", "Trials without success, % of all, " + where,
                       [](double trials, double success, double) { return trials - success; }) +
           share_table(sweep, "wrong",
                       "Wrong and yet called <code>ok</code>, % of all trials, " + where,
                       [](double, double, double ok_but_wrong) { return ok_but_wrong; });
}

// Json::exception when there is none, or one without a number that is read later.
Json checked_rows(const Json &rows) {
    (void)rows.at(0);
    for (const Json &row : rows) {
        for (const char *const key :
             {"at", "trials", "radius_px", "votes", "votes_of_circumference", "votes_most",
              "pictures", "rounded_alike"}) {
            (void)row.at(key).get<double>();
        }
    }
    return rows;
}

} // namespace

double scale_of(const Table3 &table3) {
    double products = 0.0;
    double squares = 0.0;
    for (const Json &row : table3.rows) {
        const auto published = published_at(table3.published, row.at("at"));
        if (published) {
            products += *published * row.at("votes").get<double>();
            squares += *published * *published;
        }
    }
    return products / squares;
}

std::vector<Table3> tables3_of(const Json &thresholds) {
    try {
        return {{"distance", "distance", "distance, SMU",
                 "distance from the middle of the eyes, SMU", 1.0, kPaperDistance,
                 checked_rows(thresholds.at("distance"))},
                {"occlusion", "occlusion", "hidden, %", "hidden share of the ball, %", 100.0,
                 kPaperOcclusion, checked_rows(thresholds.at("occlusion"))}};
    } catch (const Json::exception &mistake) {
        throw cli::InputError(std::string(kThresholdFile) +
                              ": is not what ocellus-sim paper writes (" + mistake.what() +
                              "); run it again");
    }
}

Section threshold_section(const ReportData &data) {
    std::string html;
    if (data.thresholds) {
        html += paragraph("How high may the accumulator's threshold of OpenCV's Hough transform be "
                          "(<code>param2</code>, the paper's ATCDS) before it loses the ball? For "
                          "each distance of (c) and each occlusion of (b): the largest whole "
                          "number with which the strongest circle is the ball in both eyes, in all "
                          "trials, and in nine of ten. A vote is a boundary pixel that points at "
                          "the centre, so votes / 2πr is the share of the outline that agrees.");
        for (const Table3 &table3 : tables3_of(*data.thresholds)) {
            html += table3_html(table3);
        }
    } else {
        html = absent(data, kThresholdFile);
    }
    return {"table3", "Table 3: Hough's threshold", html};
}

Section failure_section(const ReportData &data) {
    std::string html = paragraph(
        "A trial fails when an outline is missing or, in either eye, its middle is more than .25 r "
        "or its radius more than 20 % off. The second table of each counts what hurts a robot "
        "most: answers that are wrong and do not say so. The library's fits call a boundary with a "
        "chord in it <code>partial</code>; <code>sphere</code> vouches for what it has checked.");
    constexpr const char *kTitles[][2] = {{"a_cylinder", "(a) disc, over distance"},
                                          {"b_occlusion", "(b) ball, over occlusion"},
                                          {"c_distance", "(c) ball, over distance"},
                                          {"c_stretched", "(c) through the stretched camera"}};
    for (const auto &[name, title] : kTitles) {
        if (const SweepResult *const sweep = data.sweep(name)) {
            html += failures_html(*sweep, title);
        }
    }
    return {"failures", "Failures", html};
}

} // namespace sim
