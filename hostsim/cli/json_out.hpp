// SPDX-License-Identifier: MIT
//
// Results as JSON, one object a line, with the field names and the order that
// scripts rely on.
#ifndef OCELLUS_CLI_JSON_OUT_HPP
#define OCELLUS_CLI_JSON_OUT_HPP

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <ocellus/eye.h>
#include <ocellus/status.h>
#include <ocellus/types.h>

namespace cli {

using Json = nlohmann::ordered_json;

// `b2ac`, `lcse` or `hyper`.
const char *method_name(ocel_fit_method_t method);

Json json_of_blob(const ocel_blob_t &blob);

// {cx, cy, a, b, angle_deg}, appended to `object`.
void add_ellipse(Json &object, const ocel_ellipse_t &ellipse);

// The residual, and for an estimate how far its centre may be off.
void add_quality(Json &object, ocel_status_t status, const ocel_ellipse_t &ellipse);

// Prints one line.  The text of a file name need not be UTF-8.
void print_line(const Json &object);

// Prints {"status", "count", "blobs": [...]} as one line, blob by blob: a frame
// may hold four million of them.
void print_blobs(ocel_status_t status, const std::vector<ocel_blob_t> &blobs);

// The exit code for an answer; InputError when `status` says that the library
// was called wrongly, which no input should bring about.
int exit_code_of(ocel_status_t status);

} // namespace cli

#endif
