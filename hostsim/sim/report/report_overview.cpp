// SPDX-License-Identifier: MIT
//
// The report's frame: what was asked and reached, how it was measured, where the files are.
#include <fmt/format.h>

#include "report/report.hpp"
#include "report/report_claims.hpp"
#include "report/report_sections.hpp"

namespace sim {

namespace {

std::string claims_table(const std::vector<Claim> &claims) {
    Table table("claims", "What the simulation must show, decided from this folder's data",
                {"what", "asked", "found", ""}, {"", "words", "words", ""});
    for (const Claim &claim : claims) {
        table.add({claim.what, claim.asked, claim.found, claim.reached ? "reached" : "not reached"},
                  {"", "words", "words", claim.reached ? "good" : "bad"});
    }
    return table.html();
}

std::string tally(const std::vector<Claim> &claims) {
    int reached = 0;
    for (const Claim &claim : claims) {
        reached += claim.reached ? 1 : 0;
    }
    return fmt::format("<b>{} of {} reached.</b> ", reached, claims.size());
}

std::string few_trials_words(const ReportData &data) {
    constexpr int kEnough = 30; // as the paper
    const SweepResult *const c = data.sweep("c_distance");
    if (c == nullptr || c->trials_at_a_point() >= kEnough) {
        return "";
    }
    return notice(fmt::format("This run has {} trials at a point; the paper has at least {}. Means "
                              "of so few scatter, and a figure near its limit may fall on either "
                              "side: <code>ocellus-sim paper --trials {}</code> decides.",
                              c->trials_at_a_point(), kEnough, kEnough));
}

std::string missing_list(const ReportData &data) {
    if (data.missing.empty()) {
        return "";
    }
    std::string items;
    for (const std::string &line : data.missing) {
        items += "<li>" + escaped(line) + "</li>\n";
    }
    return notice("Not everything is here:\n<ul>" + items + "</ul>");
}

std::string method_table() {
    Table table("methods", "The methods, side by side on the same frames", {"method", "what it is"},
                {"", "words"});
    for (const char *const method : {"hough_gradient", "hough_alt", "b2ac_strict", "b2ac", "lcse",
                                     "edfe", "edfe_200", "hyper", "sphere"}) {
        table.add({method, about_method(method)}, {"", "words"});
    }
    return table.html();
}

std::string camera_words(const SweepResult &sweep) {
    return fmt::format("{:.0f}×{:.0f} pixels, focal length {} px, each pixel the mean of {:.0f}×"
                       "{:.0f} samples; the ball's radius is {} SMU",
                       sweep.setting("width"), sweep.setting("height"),
                       plain(sweep.setting("fx"), 2), sweep.setting("supersampling"),
                       sweep.setting("supersampling"), sweep.setting("radius"));
}

} // namespace

std::string absent(const ReportData &data, const std::string &name) {
    for (const std::string &line : data.missing) {
        if (line.find(name) != std::string::npos) {
            return notice("Not here. " + escaped(line) + ".");
        }
    }
    return notice("Not here: " + escaped(name) + ".");
}

Section summary_section(const ReportData &data) {
    const std::vector<Claim> claims = claims_of(data);
    std::string html = few_trials_words(data) + missing_list(data);
    if (!claims.empty()) {
        html += paragraph(tally(claims) + "Where a wish leaves room, our reading of it stands in "
                                          "the column <i>asked</i>. Lengths are in SMU, the iCub "
                                          "simulator's measure unit.") +
                claims_table(claims);
    }
    return {"summary", "What was asked, what was reached", html};
}

Section setting_section(const ReportData &data) {
    std::string html =
        paragraph("A physics engine (Bullet) holds the ball, the occluder and the paper's head "
                  "with its five joints; two cameras are drawn (OSMesa) and their frames go to the "
                  "library line by line as RGB565. The library's colour test makes the mask; every "
                  "method starts from that mask, and the world knows the truth.") +
        paragraph("Each trial is a place drawn by chance from its own seed, in a fresh world. An "
                  "outline is a <b>success</b> when in both eyes its middle is within .25 r and "
                  "its radius within 20 % of the true outline's.") +
        method_table();
    if (const SweepResult *const c = data.sweep("c_distance")) {
        html += paragraph("The cameras: " + camera_words(*c) + ".");
    }
    return {"setting", "How it was measured", html};
}

Section files_section(const ReportData &data) {
    Table table("files", "What lies beside this page", {"file", "what"}, {"", "words"});
    for (const auto &[name, sweep] : data.sweeps) {
        table.add({fmt::format("<a href=\"{0}/trials.csv\">{0}/trials.csv</a>", name),
                   fmt::format("a row for each trial and method; <a "
                               "href=\"{0}/summary.json\">summary.json</a>, what this page is made "
                               "of; <a href=\"{0}/pictures/\">pictures</a>",
                               name)},
                  {"", "words"});
    }
    if (data.thresholds) {
        table.add({fmt::format("<a href=\"{0}\">{0}</a>", kThresholdFile), "Table 3"},
                  {"", "words"});
    }
    for (const TrackRun &track : data.tracks) {
        table.add({fmt::format("<a href=\"{0}/frames.csv\">{0}/frames.csv</a>", track.folder),
                   "a row for each pair of frames of the closed loop"},
                  {"", "words"});
    }
    return {"files", "Files, and how to make them again",
            table.html() +
                "<pre><code>ocellus-sim paper --out DIR --trials 30 --jobs 2   # all of it\n"
                "ocellus-sim report DIR                             # this page, from what lies "
                "in DIR</code></pre>\n" +
                paragraph("The same seed and number of trials give the same figures on the same "
                          "machine, whatever <code>--jobs</code> is; only times differ.")};
}

} // namespace sim
