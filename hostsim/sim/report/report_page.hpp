// SPDX-License-Identifier: MIT
//
// Pieces of an HTML page that stands alone: its style, figures, tables and pictures are
// inside it.  The text is XML as well, so that any parser can check it.
#ifndef OCELLUS_SIM_REPORT_PAGE_HPP
#define OCELLUS_SIM_REPORT_PAGE_HPP

#include <string>
#include <vector>

#include "report/plot.hpp"

namespace sim {

// Text as text: with & < > " escaped.  All else here takes and returns HTML.
std::string escaped(const std::string &text);

std::string paragraph(const std::string &html);
std::string heading(const std::string &html);

// A box for what the reader must not overlook.
std::string notice(const std::string &html);

// What only some will want to see, behind a line to click on.
std::string folded(const std::string &line, const std::string &html);

// `caption` says what is seen and what to see in it.
std::string figure(const Plot &plot, const std::string &caption);

// A PNG of the run, inside the page.  A notice when there is none.
std::string picture_figure(const std::string &path, const std::string &caption);

// A table whose first column and first row are heads.  `key` tells programs what it is.
// Numbers stand to the right, cells of the class `words` to the left.
class Table {
  public:
    Table(const std::string &key, const std::string &caption, const std::vector<std::string> &head,
          const std::vector<std::string> &head_classes = {});

    // The first cell is the row's head.  `classes`, if any, are one a cell.
    void add(const std::vector<std::string> &cells, const std::vector<std::string> &classes = {});
    std::string html() const;

  private:
    std::string html_;
};

struct Section {
    std::string id;
    std::string title;
    std::string html;
};

// The whole page: title, a navigation of the sections, the sections.
std::string page(const std::string &title, const std::string &lead,
                 const std::vector<Section> &sections);

} // namespace sim

#endif
