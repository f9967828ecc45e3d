// SPDX-License-Identifier: MIT
//
// ocellus label: the connected components of a mask.
#include <algorithm>
#include <memory>
#include <tuple>

#include <ocellus/label.h>

#include "commands.hpp"
#include "error.hpp"
#include "image.hpp"
#include "json_out.hpp"

namespace cli {

namespace {

struct LabelArguments {
    std::string connectivity = "8";
    std::string path;
};

constexpr const char *kFooter =
    R"(MASK: PNG, PBM, PGM or PPM; a pixel with any channel that is not zero belongs to
an object (in PBM: a 1). At most 4096 x 4096. - is stdin.

Output: status, count, blobs:[{left,top,width,height,area,cx,cy}]
in raster order of the blobs' first pixels; cx,cy is the centroid. The status
is not_seen when no pixel is set.

Examples:
  ocellus label mask.png
  ocellus label --connectivity 4 mask.pgm
  printf 'P1 5 2  1 0 1 0 1  0 0 0 0 0' | ocellus label -)";

using Blobs = std::vector<ocel_blob_t>;

// The labeller and its lists, which are too large for a stack at 4096 columns.
class Labelling {
  public:
    Labelling(const Image &mask, ocel_connectivity_t connectivity) {
        check(ocel_label_begin(&labeller_, &pool_, static_cast<std::uint16_t>(mask.width),
                               static_cast<std::uint16_t>(mask.height), connectivity));
        for (std::size_t y = 0; y < mask.height; ++y) {
            take_row(mask, y);
        }
        std::size_t count = 0;
        status_ = ocel_label_end(&labeller_, &pool_, ended_, &count, nullptr);
        check(status_);
        blobs_.insert(blobs_.end(), ended_, ended_ + count);
        std::sort(blobs_.begin(), blobs_.end(), [](const ocel_blob_t &a, const ocel_blob_t &b) {
            return std::tie(a.box.top, a.first_x) < std::tie(b.box.top, b.first_x);
        });
    }

    ocel_status_t status() const {
        return status_;
    }
    const Blobs &blobs() const {
        return blobs_;
    }

  private:
    static void check(ocel_status_t status) {
        (void)exit_code_of(status); // throws for a caller's mistake
    }

    void take_row(const Image &mask, std::size_t y) {
        std::fill(std::begin(row_), std::end(row_), 0U);
        const std::uint8_t *const samples = mask.row(y);
        for (std::size_t i = 0; i < mask.row_bytes(); ++i) {
            const std::size_t x = i / mask.channels;
            row_[x / 32U] |= (samples[i] != 0U ? 1U : 0U) << (x % 32U);
        }
        std::size_t count = 0;
        check(ocel_label_row(&labeller_, &pool_, row_, ended_, &count));
        blobs_.insert(blobs_.end(), ended_, ended_ + count);
    }

    ocel_labeller_t labeller_{};
    ocel_crack_pool_t pool_{};
    std::uint32_t row_[OCEL_ROW_WORDS] = {};
    ocel_blob_t ended_[OCEL_MAX_RUNS + 1] = {};
    Blobs blobs_;
    ocel_status_t status_ = OCEL_NOT_SEEN;
};

int run_label(const LabelArguments &arguments) {
    const auto connectivity =
        static_cast<ocel_connectivity_t>(parse_connectivity(arguments.connectivity));
    const Image mask = read_image(arguments.path, Purpose::kMask);
    const auto labelling = std::make_unique<Labelling>(mask, connectivity);
    print_blobs(labelling->status(), labelling->blobs());
    return exit_code_of(labelling->status());
}

} // namespace

int parse_connectivity(const std::string &text) {
    if (text != "8" && text != "4") {
        throw InputError("--connectivity " + quoted(text) +
                         ": expected 8 (corners connect) or 4 (edges only)");
    }
    return text == "8" ? OCEL_CONNECT_8 : OCEL_CONNECT_4;
}

void add_label(CLI::App &app, int &exit_code) {
    const auto arguments = std::make_shared<LabelArguments>();
    CLI::App *const command =
        app.add_subcommand("label", "List the connected components of a mask");
    command->footer(kFooter);
    command
        ->add_option("--connectivity", arguments->connectivity,
                     "8 (default): corners connect; 4: edges only")
        ->type_name("8|4");
    command->add_option("MASK", arguments->path, "the mask; - is stdin")->type_name("")->required();
    command->callback([arguments, &exit_code] { exit_code = run_label(*arguments); });
}

} // namespace cli
