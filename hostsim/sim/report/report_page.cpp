// SPDX-License-Identifier: MIT
#include "report/report_page.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace sim {

namespace {

constexpr const char *kStyle = R"css(
:root { --ink: #1d2327; --soft: #5b6670; --line: #d8dee3; --ground: #ffffff; --wash: #f4f6f8;
  --accent: #005f8f; --good: #00694a; --good-wash: #e3f4ec; --bad: #a03a00; --bad-wash: #fdebe0; }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; }
body { margin: 0; color: var(--ink); background: var(--ground);
  font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
header { background: #12344a; color: #fff; padding: 2.2rem 1.5rem 1.8rem; }
header > div { max-width: 70rem; margin: 0 auto; }
header h1 { margin: 0 0 .5rem; font-size: 1.9rem; line-height: 1.2; }
header p { margin: .3rem 0; max-width: 52rem; color: #dbe8f0; }
nav { position: sticky; top: 0; z-index: 1; background: var(--wash);
  border-bottom: 1px solid var(--line); }
nav ul { max-width: 73rem; margin: 0 auto; padding: .45rem 1.5rem; list-style: none;
  display: flex; flex-wrap: wrap; gap: .15rem 1.2rem; font-size: .92rem; }
a { color: var(--accent); }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
main { max-width: 73rem; margin: 0 auto; padding: 0 1.5rem 4rem; }
section { padding-top: 2.2rem; scroll-margin-top: 2.2rem; }
h2 { font-size: 1.45rem; line-height: 1.25; margin: 0 0 .8rem; padding-bottom: .3rem;
  border-bottom: 2px solid var(--line); }
h3 { font-size: 1.1rem; margin: 1.8rem 0 .4rem; }
p, li { max-width: 52rem; }
code { font: .9em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--wash);
  padding: .08em .3em; border-radius: 3px; }
pre { background: var(--wash); border: 1px solid var(--line); border-radius: 5px;
  padding: .8rem 1rem; overflow-x: auto; }
pre code { background: none; padding: 0; }
figure { margin: 1.4rem 0; border: 1px solid var(--line); border-radius: 6px; overflow: hidden; }
figure svg, figure img { display: block; width: 100%; height: auto; }
figcaption { padding: .7rem 1rem; background: var(--wash); border-top: 1px solid var(--line);
  font-size: .93rem; color: #333d45; }
.wide { overflow-x: auto; margin: 1.2rem 0; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: 0 0 .45rem; color: var(--soft); font-size: .92rem; }
th, td { padding: .28rem .6rem; border-bottom: 1px solid var(--line); text-align: right;
  vertical-align: top; }
thead th { border-bottom: 2px solid #9aa7b1; color: #333d45; }
tbody th, thead th:first-child { text-align: left; font-weight: 600; white-space: nowrap; }
th.words, td.words { text-align: left; }
td.words { min-width: 12rem; }
h3 code { font-weight: inherit; font-size: .95em; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--accent); }
td.good, td.bad { white-space: nowrap; }
td.good { background: var(--good-wash); color: var(--good); font-weight: 600; }
td.bad { background: var(--bad-wash); color: var(--bad); font-weight: 600; }
td.none { color: #8a949c; }
td.f1 { background: #fdf3d8; } td.f2 { background: #fbd9a6; } td.f3 { background: #f0a878; }
.notice { border-left: 4px solid #b06a00; background: #fff6e5; padding: .6rem 1rem;
  margin: 1rem 0; max-width: 54rem; }
footer { border-top: 1px solid var(--line); color: var(--soft); padding: 1.2rem 1.5rem;
  text-align: center; font-size: .9rem; }
@media print { nav { display: none; } figure, table { break-inside: avoid; } }
)css";

std::string base64(const std::string &bytes) {
    constexpr const char *kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t given = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < given ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= given ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return text;
}

std::string cell(const char *tag, const std::string &html, const std::string &css_class) {
    return css_class.empty() ? fmt::format("<{0}>{1}</{0}>", tag, html)
                             : fmt::format("<{0} class=\"{2}\">{1}</{0}>", tag, html, css_class);
}

std::string navigation(const std::vector<Section> &sections) {
    std::string items;
    for (const Section &section : sections) {
        items += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, section.title);
    }
    return "<nav aria-label=\"Sections\"><ul>\n" + items + "</ul></nav>\n";
}

} // namespace

std::string escaped(const std::string &text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        default:
            html += c;
            break;
        }
    }
    return html;
}

std::string paragraph(const std::string &html) {
    return "<p>" + html + "</p>\n";
}

std::string heading(const std::string &html) {
    return "<h3>" + html + "</h3>\n";
}

std::string notice(const std::string &html) {
    return "<div class=\"notice\">" + html + "</div>\n";
}

std::string folded(const std::string &line, const std::string &html) {
    return "<details><summary>" + line + "</summary>\n" + html + "</details>\n";
}

std::string figure(const Plot &plot, const std::string &caption) {
    return fmt::format("<figure id=\"{}\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
                       plot.name, plot_svg(plot), caption);
}

std::string picture_figure(const std::string &path, const std::string &caption) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return notice("There is no picture <code>" + escaped(path) + "</code>.");
    }
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return fmt::format("<figure>\n<img alt=\"{}\" src=\"data:image/png;base64,{}\"/>\n"
                       "<figcaption>{}</figcaption>\n</figure>\n",
                       escaped(std::filesystem::path(path).filename().string()), base64(bytes),
                       caption);
}

Table::Table(const std::string &key, const std::string &caption,
             const std::vector<std::string> &head, const std::vector<std::string> &head_classes)
    : html_(fmt::format("<div class=\"wide\"><table data-key=\"{}\">\n<caption>{}</caption>\n"
                        "<thead><tr>",
                        key, caption)) {
    for (std::size_t i = 0; i < head.size(); ++i) {
        html_ += cell("th", head[i], i < head_classes.size() ? head_classes[i] : "");
    }
    html_ += "</tr></thead>\n<tbody>\n";
}

void Table::add(const std::vector<std::string> &cells, const std::vector<std::string> &classes) {
    html_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        html_ += cell(i == 0 ? "th" : "td", cells[i], i < classes.size() ? classes[i] : "");
    }
    html_ += "</tr>\n";
}

std::string Table::html() const {
    return html_ + "</tbody></table></div>\n";
}

std::string page(const std::string &title, const std::string &lead,
                 const std::vector<Section> &sections) {
    std::string body;
    for (const Section &section : sections) {
        body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id,
                            section.title, section.html);
    }
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
                       "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n"
                       "<header><div><h1>{}</h1>\n{}</div></header>\n",
                       title, kStyle, title, lead) +
           navigation(sections) + "<main>\n" + body + "</main>\n" +
           "<footer>Made by <code>ocellus-sim report</code> from the files beside it.</footer>\n"
           "</body>\n</html>\n";
}

} // namespace sim
