// SPDX-License-Identifier: MIT
//
// ocellus detect: the largest blob of a colour, and the ellipse of its outline.
// Pictures go to the library line by line, as a camera would deliver them.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <ocellus/eye.h>
#include <ocellus/sphere.h>

#include "annotate.hpp"
#include "camera_lines.hpp"
#include "colour_spec.hpp"
#include "commands.hpp"
#include "decimal.hpp"
#include "error.hpp"
#include "input.hpp"
#include "json_out.hpp"
#include "placing.hpp"

namespace cli {

namespace {

namespace fs = std::filesystem;

struct DetectArguments {
    std::string colour;
    std::string teach;
    std::string teach_space;
    std::string method; // empty: sphere with a camera, else b2ac
    std::string perturb = "auto";
    std::string connectivity = "8";
    std::string format = "auto";
    std::string annotate;
    PlacingArguments placing;
    std::uint32_t min_area = 16;
    std::vector<std::string> paths;
};

constexpr const char *kFooter =
    R"(Finds the largest blob of a colour and fits an ellipse to its outline.
IMAGE: PNG, PGM or PPM, at most 4096 x 4096; - is stdin. Palettes are expanded,
16 bits reduced to 8, transparency dropped. With more than one image there is
one line each, with the field `file`, and the exit code is the worst one.

SPEC is a range of colours, both ends included, whole numbers 0..255:
  rgb:r0-r1,g0-g1,b0-b1
  hsv:h0-h1,s0-s1,v0-v1   h in degrees 0..360, may wrap: hsv:340-20,90-255,60-255
  yuv:y0-y1,u0-u1,v0-v1   full-range BT.601
  gray:v0-v1
Quick start: --teach x,y,w,h learns the range from a rectangle on the ball, in
the first image, and prints it as `colour`; give that to --colour afterwards.

With --camera and --radius the ball is placed in space. The method is then sphere: the
cone of rays that touch the ball, fitted to the part of the outline that is the ball's
(half of it may be hidden); the ellipse is the cone's. With another method the ball is
placed by its ellipse's centre and area.

Output: status, method, blob:{left,top,width,height,area,cx,cy},
ellipse:{cx,cy,a,b,angle_deg}, arc_coverage (0..1: how much of the outline's turn
was seen), rms_px, centre_sigma_px of an ellipse's fit that is not ok (how far the centre
may be off), sphere:{x,y,z,inliers,sigma:{x,y,z}} with a camera (x right, y down, z
forward, in the radius' unit; inliers are the outline's points that were the ball's),
and colour when it was taught. What does not exist for a status is left out. ok:
vouched for; clipped: cut by the image's edge; partial: too short an arc; not_seen: no
blob of at least --min-area pixels. With --distortion the ellipse of method sphere is
that of the image without it.

Examples:
  ocellus detect --colour gray:122-255 coins.png
  ocellus detect --teach 150,110,16,16 --annotate out.png ball.png
  ocellus detect --teach 150,110,16,16 --camera 257,257,160,120 --radius 35 ball.png
  ocellus detect --colour hsv:5-45,120-255,40-255 --format rgb565 \
      --annotate out/ frame_*.png)";

ocel_eye_config_t configuration(const DetectArguments &arguments, const Image &image) {
    ocel_eye_config_t config{};
    config.width = static_cast<std::uint16_t>(image.width);
    config.height = static_cast<std::uint16_t>(image.height);
    config.min_area = arguments.min_area;
    config.connectivity =
        static_cast<ocel_connectivity_t>(parse_connectivity(arguments.connectivity));
    return config;
}

// What the answer calls its method.
std::string method_of(const DetectArguments &arguments) {
    const bool placed = !arguments.placing.camera.empty();
    return arguments.method.empty() ? (placed ? "sphere" : "b2ac") : arguments.method;
}

ocel_fit_options_t fit_options(const DetectArguments &arguments) {
    const std::string method = method_of(arguments);
    ocel_fit_options_t options{};
    options.method =
        method == "sphere" ? OCEL_FIT_B2AC : parse_method(method, "sphere, b2ac, lcse or hyper");
    options.perturb = parse_perturb(arguments.perturb);
    return options;
}

// Everything that is wrong before a picture has been read.
void check_arguments(const DetectArguments &arguments) {
    if (arguments.colour.empty() == arguments.teach.empty()) {
        throw InputError(std::string("expected either --colour SPEC or --teach x,y,w,h; found ") +
                         (arguments.colour.empty() ? "neither" : "both") + "; SPEC is " +
                         kColourGrammar);
    }
    if (!arguments.teach_space.empty() && arguments.teach.empty()) {
        throw InputError("--teach-space needs --teach x,y,w,h");
    }
    if (arguments.min_area == 0) {
        throw InputError("--min-area 0: expected at least 1 pixel");
    }
    if (arguments.paths.size() > 1 && !arguments.annotate.empty() &&
        !fs::is_directory(arguments.annotate)) {
        throw InputError("--annotate " + arguments.annotate +
                         ": expected a folder that exists, as there is more than one image: make "
                         "the folder first");
    }
}

// Learns the range of the rectangle in `image`.
ocel_colour_range_t teach(const DetectArguments &arguments, const std::string &name,
                          const Image &image, CameraLines &lines) {
    const ocel_rect_t rect = parse_rectangle(arguments.teach);
    const ocel_space_t usual = image.channels == 1 ? OCEL_SPACE_GRAY : OCEL_SPACE_HSV;
    const ocel_space_t space =
        arguments.teach_space.empty() ? usual : parse_space(arguments.teach_space);
    if (rect.left + rect.width > static_cast<int>(image.width) ||
        rect.top + rect.height > static_cast<int>(image.height)) {
        throw InputError("--teach " + quoted(arguments.teach) + ": reaches out of " + name +
                         ", which has " + std::to_string(image.width) + " x " +
                         std::to_string(image.height) +
                         " pixels; expected a rectangle x,y,w,h inside it");
    }
    const auto teacher = std::make_unique<ocel_teach_t>();
    (void)exit_code_of(ocel_teach_begin(teacher.get(), space, lines.format()));
    for (unsigned y = rect.top; y < static_cast<unsigned>(rect.top) + rect.height; ++y) {
        (void)exit_code_of(ocel_teach_line(teacher.get(), lines.line(y), lines.line_bytes(),
                                           rect.left, rect.width));
    }
    ocel_colour_range_t range{};
    const ocel_status_t status = ocel_teach_end(teacher.get(), &range);
    if (status == OCEL_TOO_FEW_POINTS) {
        throw InputError("--teach " + quoted(arguments.teach) +
                         ": too few pixels; expected at least 16 of them, such as x,y,8,8");
    }
    (void)exit_code_of(status);
    return range;
}

fs::path annotated_path(const DetectArguments &arguments, const std::string &path) {
    if (!fs::is_directory(arguments.annotate)) {
        return arguments.annotate;
    }
    const std::string stem = path == "-" ? "stdin" : fs::path(path).stem().string();
    return fs::path(arguments.annotate) / (stem + ".png");
}

// What is known of one picture's ball.
struct Finding {
    ocel_detection_t detection{};
    std::optional<ocel_camera_t> camera;
    ocel_cone_t cone{};
    bool by_cone = false; // the cone was fitted to the boundary, and its ellipse is its outline
    std::optional<ocel_sphere_t> sphere;
};

// What a cone's fit adds to the picture.
Overlay overlay_of(const Finding &finding) {
    Overlay overlay;
    if (finding.by_cone && finding.cone.point_count != 0U) {
        overlay.label = std::to_string(finding.cone.inlier_count) + "/" +
                        std::to_string(finding.cone.point_count);
        overlay.lens = finding.camera->distorted ? &*finding.camera : nullptr;
    }
    return overlay;
}

void write_annotated(const DetectArguments &arguments, const std::string &path, const Image &image,
                     const Finding &finding) {
    const fs::path target = annotated_path(arguments, path);
    std::error_code ignored;
    if (path != "-" && fs::equivalent(target, path, ignored)) {
        throw InputError("--annotate " + target.string() +
                         ": is the image itself; expected another name, so that it is not lost");
    }
    write_png(target.string(), annotated(image, finding.detection, overlay_of(finding)));
}

// One run of the command: the context, and the colour once it is known.
class Detector {
  public:
    explicit Detector(const DetectArguments &arguments)
        : arguments_(arguments), method_(method_of(arguments)), options_(fit_options(arguments)) {
        const PlacingArguments &placing = arguments.placing;
        if (method_ == "sphere" || !placing.camera.empty() || !placing.radius.empty() ||
            !placing.distortion.empty()) {
            placing_.emplace(placing);
        }
        if (!arguments.colour.empty()) {
            range_ = parse_colour(arguments.colour);
        }
    }

    int run(const std::string &path) {
        const Image image = read_image(path, Purpose::kPicture);
        CameraLines lines(image, line_format(arguments_.format, image));
        if (!range_) {
            range_ = teach(arguments_, display_name(path), image, lines);
        }
        Finding finding;
        finding.detection = detect(image, lines);
        if (placing_) {
            place(image, finding);
        }
        const int exit_code = exit_code_of(finding.detection.status);
        if (!arguments_.annotate.empty()) {
            write_annotated(arguments_, path, image, finding);
        }
        print_line(json_of(finding, path));
        return exit_code;
    }

  private:
    void compile(ocel_format_t format) {
        if (compiled_ != format) {
            (void)exit_code_of(ocel_colour_compile(&colour_, &*range_, format, &table_));
            compiled_ = format;
        }
    }

    ocel_detection_t detect(const Image &image, CameraLines &lines) {
        const ocel_eye_config_t config = configuration(arguments_, image);
        compile(lines.format());
        (void)exit_code_of(ocel_eye_init(eye_.get(), &config));
        (void)exit_code_of(ocel_eye_begin(eye_.get()));
        for (std::uint16_t y = 0; y < config.height; ++y) {
            (void)exit_code_of(
                ocel_eye_line(eye_.get(), &colour_, y, lines.line(y), lines.line_bytes()));
        }
        ocel_detection_t detection{};
        (void)ocel_eye_end(eye_.get(), &detection); // the same as detection.status
        refit(detection);
        return detection;
    }

    // The eye itself fits b2ac; another method starts from the same boundary.
    void refit(ocel_detection_t &detection) {
        std::size_t count = 0;
        (void)ocel_eye_boundary(eye_.get(), &count);
        if (count > 0 && options_.method != OCEL_FIT_B2AC) {
            (void)ocel_eye_refit(eye_.get(), &options_, &detection);
        }
    }

    // The ball's centre: by the cone of the boundary, or of the ellipse that was fitted.
    void place(const Image &image, Finding &finding) const {
        finding.camera = placing_->camera(image.width, image.height);
        const bool has_cone =
            method_ == "sphere"
                ? take_cone(finding)
                : finding.detection.has_ellipse &&
                      ocel_cone_of_ellipse(&*finding.camera, &finding.detection.ellipse,
                                           &finding.cone) == OCEL_OK;
        ocel_sphere_t sphere{};
        const ocel_status_t status = has_cone ? placing_->place(finding.cone, sphere) : OCEL_OK;
        if (has_cone && status == OCEL_OK) {
            finding.sphere = sphere;
        } else if (method_ == "sphere" && status != OCEL_OK) {
            finding.detection.status = status;
            finding.detection.has_ellipse = false;
        }
    }

    // The boundary's cone in the place of the eye's ellipse; false when there is none.
    bool take_cone(Finding &finding) const {
        ocel_detection_t &detection = finding.detection;
        finding.by_cone = true;
        detection.status =
            ocel_eye_cone(eye_.get(), &*finding.camera, &finding.detection, &finding.cone);
        const bool has_cone = finding.cone.sin_q30 != 0U;
        detection.has_ellipse = has_cone && ocel_cone_outline(&*finding.camera, &finding.cone,
                                                              &detection.ellipse) == OCEL_OK;
        return has_cone;
    }

    Json json_of(const Finding &finding, const std::string &path) const {
        const ocel_detection_t &detection = finding.detection;
        Json object{{"status", ocel_status_name(detection.status)}, {"method", method_}};
        if (detection.status != OCEL_NOT_SEEN) {
            object["blob"] = json_of_blob(detection.blob);
        }
        if (detection.has_ellipse) {
            object["ellipse"] = Json::object();
            add_ellipse(object["ellipse"], detection.ellipse);
            object["arc_coverage"] = decimal_of_q16(detection.ellipse.arc_coverage_q16);
            // A cone's uncertainty is its sphere's sigma.
            add_quality(object, finding.by_cone ? OCEL_OK : detection.status, detection.ellipse);
        }
        if (finding.sphere) {
            Json &sphere = object["sphere"] = placing_->centre(*finding.sphere);
            sphere["inliers"] = finding.cone.inlier_count;
            sphere["sigma"] = placing_->sigma(*finding.sphere);
        }
        if (!arguments_.teach.empty()) {
            object["colour"] = format_colour(*range_);
        }
        if (arguments_.paths.size() > 1) {
            object["file"] = path;
        }
        return object;
    }

    const DetectArguments &arguments_;
    const std::string method_;
    const ocel_fit_options_t options_;
    std::optional<Placing> placing_;
    std::optional<ocel_colour_range_t> range_;
    ocel_colour_table_t table_{};
    ocel_colour_t colour_{};
    std::optional<ocel_format_t> compiled_;
    std::unique_ptr<ocel_eye_t> eye_ = std::make_unique<ocel_eye_t>();
};

int run_detect(const DetectArguments &arguments) {
    check_arguments(arguments);
    const auto detector = std::make_unique<Detector>(arguments);
    int worst = kExitOk;
    for (const std::string &path : arguments.paths) {
        worst = std::max(worst, detector->run(path));
    }
    return worst;
}

void add_options(CLI::App &command, DetectArguments &arguments) {
    const auto add = [&command](const char *name, auto &value, const char *type,
                                const char *description) {
        return command.add_option(name, value, description)->type_name(type);
    };
    add("--colour,--color", arguments.colour, "SPEC", "the range of colours, see below");
    add("--teach", arguments.teach, "x,y,w,h",
        "learn the range from this rectangle of the first image");
    add("--teach-space", arguments.teach_space, "SPACE",
        "learn in rgb, hsv (default), yuv or gray (default for grey images)");
    add("--method", arguments.method, "NAME",
        "the fit: sphere (default with --camera), b2ac (default without), lcse or hyper, see "
        "`ocellus fit --help`");
    add("--perturb", arguments.perturb, "WHEN",
        "when lcse perturbs the points: auto (default), always or never");
    add("--connectivity", arguments.connectivity, "8|4",
        "8 (default): corners connect; 4: edges only");
    add("--min-area", arguments.min_area, "PIXELS", "a smaller blob is not seen; default 16");
    add("--format", arguments.format, "FORMAT",
        "what the library is fed: auto (default), rgb888, bgr888, gray8, or rgb565 as small "
        "cameras deliver it");
    add("--annotate", arguments.annotate, "OUT.png",
        "write a copy with the blob's box, the ellipse (green when ok, else magenta), its centre "
        "and with method sphere the inliers of all points to this PNG, or into this folder");
    add_placing_options(command, arguments.placing);
    add("IMAGE", arguments.paths, "", "the images; - is stdin")->required();
}

} // namespace

void add_detect(CLI::App &app, int &exit_code) {
    const auto arguments = std::make_shared<DetectArguments>();
    CLI::App *const command = app.add_subcommand(
        "detect", "Find a ball by its colour, fit its ellipse and place it in space");
    command->footer(kFooter);
    add_options(*command, *arguments);
    command->callback([arguments, &exit_code] { exit_code = run_detect(*arguments); });
}

} // namespace cli
