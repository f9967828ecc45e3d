// SPDX-License-Identifier: MIT
#include "json_out.hpp"

#include <iostream>

#include <ocellus/label.h>

#include "decimal.hpp"
#include "error.hpp"

namespace cli {

const char *method_name(ocel_fit_method_t method) {
    switch (method) {
    case OCEL_FIT_LCSE:
        return "lcse";
    case OCEL_FIT_HYPER:
        return "hyper";
    case OCEL_FIT_B2AC:
    default:
        return "b2ac";
    }
}

Json json_of_blob(const ocel_blob_t &blob) {
    std::int32_t cx_px_q16 = 0;
    std::int32_t cy_px_q16 = 0;
    ocel_blob_centroid(&blob, &cx_px_q16, &cy_px_q16);
    return Json{
        {"left", blob.box.left},          {"top", blob.box.top}, {"width", blob.box.width},
        {"height", blob.box.height},      {"area", blob.area},   {"cx", decimal_of_q16(cx_px_q16)},
        {"cy", decimal_of_q16(cy_px_q16)}};
}

void add_ellipse(Json &object, const ocel_ellipse_t &ellipse) {
    object["cx"] = decimal_of_q16(ellipse.cx_px_q16);
    object["cy"] = decimal_of_q16(ellipse.cy_px_q16);
    object["a"] = decimal_of_q16(ellipse.a_px_q16);
    object["b"] = decimal_of_q16(ellipse.b_px_q16);
    object["angle_deg"] = degrees_of_turn_q32(ellipse.angle_turn_q32);
}

void add_quality(Json &object, ocel_status_t status, const ocel_ellipse_t &ellipse) {
    object["rms_px"] = decimal_of_q16(ellipse.rms_px_q16);
    if (status != OCEL_OK) {
        object["centre_sigma_px"] = decimal_of_q16(ellipse.centre_sigma_px_q16);
    }
}

void print_line(const Json &object) {
    std::cout << object.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

void print_blobs(ocel_status_t status, const std::vector<ocel_blob_t> &blobs) {
    const Json head{{"status", ocel_status_name(status)}, {"count", blobs.size()}};
    std::string line = head.dump();
    line.pop_back(); // its closing brace
    std::cout << line << ",\"blobs\":[";
    const char *separator = "";
    for (const ocel_blob_t &blob : blobs) {
        std::cout << separator << json_of_blob(blob).dump();
        separator = ",";
    }
    std::cout << "]}\n";
}

int exit_code_of(ocel_status_t status) {
    if (status >= OCEL_NULL_ARGUMENT) {
        throw InputError(std::string("the library refused the call: ") + ocel_status_name(status));
    }
    return status == OCEL_OK ? kExitOk : kExitAnswer;
}

} // namespace cli
