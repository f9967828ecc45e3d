// SPDX-License-Identifier: MIT
//
// The library's fits, all on the boundary that the eye found.
#include "geometry/frames.hpp"
#include "methods/methods.hpp"

namespace sim {

namespace {

ocel_fit_method_t fit_method(Method method) {
    switch (method) {
    case Method::kLcse:
        return OCEL_FIT_LCSE;
    case Method::kHyper:
        return OCEL_FIT_HYPER;
    default:
        return OCEL_FIT_B2AC;
    }
}

Outline not_found(ocel_status_t status) {
    Outline outline;
    outline.status = status;
    return outline;
}

Outline ellipse_outline(Method method, const Detector &detector) {
    ocel_detection_t detection = detector.detection();
    if (method != Method::kB2ac) {
        ocel_fit_options_t options{};
        options.method = fit_method(method);
        const ocel_status_t status = ocel_eye_refit(&detector.eye(), &options, &detection);
        if (status == OCEL_BAD_ORDER) { // no boundary: the detection says why
            return not_found(detection.status);
        }
    }
    if (!detection.has_ellipse) {
        return not_found(detection.status);
    }
    return outline_of(ellipse_of(detection.ellipse), detection.status, detector.intrinsics());
}

// The cone's outline in the picture.  The library's leaves the lens out.
std::optional<Ellipse> outline_of_cone(const Detector &detector, const ocel_cone_t &cone) {
    if (detector.intrinsics().lens.bends()) {
        return seen_outline(detector.intrinsics(), unit_vector(cone.axis_cam_q30),
                            cone.sin_q30 / 1073741824.0);
    }
    ocel_ellipse_t ellipse{};
    return ocel_cone_outline(&detector.camera(), &cone, &ellipse) == OCEL_OK
               ? std::optional(ellipse_of(ellipse))
               : std::nullopt;
}

Outline cone_outline(const Detector &detector) {
    Outline outline;
    outline.status =
        ocel_eye_cone(&detector.eye(), &detector.camera(), &detector.detection(), &outline.cone);
    const auto ellipse =
        outline.cone.sin_q30 == 0 ? std::nullopt : outline_of_cone(detector, outline.cone);
    if (!ellipse) {
        return not_found(outline.status == OCEL_OK ? OCEL_OUT_OF_RANGE : outline.status);
    }
    outline.found = true;
    outline.has_cone = true;
    outline.ellipse = *ellipse;
    outline.d_cam = unit_vector(outline.cone.axis_cam_q30);
    return outline;
}

} // namespace

Outline library_outline(Method method, const Detector &detector) {
    return method == Method::kSphere ? cone_outline(detector) : ellipse_outline(method, detector);
}

} // namespace sim
