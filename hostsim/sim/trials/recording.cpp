// SPDX-License-Identifier: MIT
#include "trials/recording.hpp"

#include <fmt/format.h>
#include <vector>

#include "camera_lines.hpp"
#include "error.hpp"
#include "geometry/frames.hpp"
#include "trials/answers.h"
#include "world/library_head.hpp"

namespace sim {

namespace {

constexpr int kVersion = 1;
constexpr const char *kPairTitle = "point,trial,frame";

std::ofstream opened(const std::string &path) {
    std::ofstream file(path, std::ios::binary);
    if (!file) {
        throw cli::InputError("--record: " + path +
                              " cannot be written; expected a folder that is "
                              "writable, on a disk with room");
    }
    return file;
}

void must_be_written(const std::ofstream &file, const std::string &folder) {
    if (!file) {
        throw cli::InputError("--record " + folder +
                              ": the recording cannot be written; is the "
                              "disk full?");
    }
}

// A row of a CSV, and its titles.
struct Row {
    std::string titles;
    std::string values;
};

void put_cell(void *to, const char *part, const char *name, int index, std::int64_t value) {
    Row &row = *static_cast<Row *>(to);
    row.titles += fmt::format(",{}.{}", part, name);
    if (index >= 0) {
        row.titles += fmt::format("[{}]", index);
    }
    row.values += fmt::format(",{}", value);
}

pair_answer_t answer_of(const SeenPair &pair, const LibraryJoints &joints, std::int32_t radius_u) {
    pair_answer_t answer{};
    for (const Side side : {kLeft, kRight}) {
        const Detector &detector = *pair.detectors[side];
        answer.eye[side].detection = detector.detection();
        answer_to_sphere(&detector.eye(), &detector.camera(), radius_u, &answer.eye[side]);
    }
    answer_ball(joints.data(), radius_u, &answer);
    return answer;
}

} // namespace

Recording::Recording(const std::string &folder, const Setting &setting)
    : folder_(folder), radius_u_(units(setting.target.radius)),
      frames_(opened(folder + "/frames.rgb565")), pairs_(opened(folder + "/pairs.csv")),
      answers_(opened(folder + "/answers.csv")) {
    write_manifest(setting);
    pairs_ << kPairTitle << ",neck_pitch,neck_roll,neck_yaw,eyes_tilt,eyes_version,eyes_vergence\n";
}

void Recording::write_manifest(const Setting &setting) {
    const ocel_intrinsics_t in = library_intrinsics(setting.camera.intrinsics);
    const ocel_colour_range_t &colour = setting.colour;
    std::ofstream file = opened(folder_ + "/manifest.txt");
    file << fmt::format("version {}\nwidth {}\nheight {}\n", kVersion, in.width, in.height)
         << fmt::format("colour {} {} {}\n", static_cast<int>(colour.space),
                        fmt::join(colour.lo, " "), fmt::join(colour.hi, " "))
         << fmt::format("min_area {}\nradius_u {}\n", setting.min_area, radius_u_)
         << fmt::format("intrinsics {} {} {} {} {} {} {} {} {}\n", in.fx_px_q16, in.fy_px_q16,
                        in.cx_px_q16, in.cy_px_q16, in.k1_q24, in.k2_q24, in.p1_q24, in.p2_q24,
                        in.k3_q24);
    file.flush();
    must_be_written(file, folder_);
}

void Recording::write_frame(const cli::Image &frame) {
    cli::CameraLines lines(frame, OCEL_FORMAT_RGB565);
    for (std::size_t y = 0; y < frame.height; ++y) {
        frames_.write(reinterpret_cast<const char *>(lines.line(y)),
                      static_cast<std::streamsize>(lines.line_bytes()));
    }
}

void Recording::add(const SeenPair &pair) {
    const LibraryJoints joints = library_joints(pair.angles);
    const std::string name = fmt::format("{},{},{}", pair.key.point, pair.key.trial, pair.frame);
    const pair_answer_t answer = answer_of(pair, joints, radius_u_);
    Row row;
    const answer_sink_t sink{put_cell, &row};
    put_pair(&sink, &answer);
    if (!titled_) {
        answers_ << kPairTitle << row.titles << "\n";
        titled_ = true;
    }
    answers_ << name << row.values << "\n";
    pairs_ << name << fmt::format(",{}\n", fmt::join(joints, ","));
    for (const cli::Image &frame : pair.frames) {
        write_frame(frame);
    }
    for (std::ofstream *file : {&frames_, &pairs_, &answers_}) {
        file->flush();
        must_be_written(*file, folder_);
    }
}

} // namespace sim
