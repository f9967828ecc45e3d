// SPDX-License-Identifier: MIT
#include "trials/trial.hpp"

#include <fmt/format.h>

#include "trials/trial_judge.hpp"
#include "trials/trial_occluder.hpp"
#include "world/gaze.hpp"

namespace sim {

namespace {

JointAngles looking_at(double focus) {
    const double inwards = std::atan(kEyeDistance / 2.0 / focus);
    JointAngles angles{};
    angles[kLeftPan] = -inwards;
    angles[kRightPan] = inwards;
    return angles;
}

BallBody held_ball(const TargetChoice &target, const Vec3 &p_world) {
    BallBody ball;
    ball.radius = target.radius;
    ball.mass = 0.0;
    ball.p_world = p_world;
    return ball;
}

// The trial as it goes.
class Run {
  public:
    Run(const Scenario &scenario, const TrialKey &key, Renderer &renderer,
        const std::array<std::unique_ptr<Detector>, kSides> &detectors, Recording *recording)
        : scenario_(scenario), key_(key), renderer_(renderer), detectors_(detectors),
          recording_(recording), p_true_(placement(scenario, key)),
          world_(held_ball(scenario.target, p_true_)),
          checks_(count_bounds(scenario.camera.intrinsics)) {
        Random clutter(seed_of(scenario, key, kClutter));
        drawing_ = make_drawing(scenario, p_true_, clutter);
    }

    TrialRecord record(TrialPictures *pictures) {
        if (scenario_.gaze == Gaze::kStill) {
            world_.head().place(looking_at(scenario_.focus));
            look();
        } else {
            look();
            fixate();
        }
        const double occlusion = occlude(scenario_.occlusion_at(key_.point));
        if (occlusion > 0.0) {
            look();
        }
        TrialRecord record = blank_record();
        record.occlusion = occlusion;
        measure(record, pictures);
        return record;
    }

  private:
    TrialRecord blank_record() const {
        TrialRecord record{};
        record.point = static_cast<std::uint32_t>(key_.point);
        record.trial = key_.trial;
        record.distance = scenario_.distance_at(key_.point);
        std::copy(p_true_.val, p_true_.val + 3, record.p_true);
        record.frames = frames_;
        record.checks = checks_.tally();
        return record;
    }

    std::string place_of_frame(Side side) const {
        return fmt::format("{}, point {}, trial {}, frame {}, {} eye", scenario_.name, key_.point,
                           key_.trial, frames_, side == kLeft ? "left" : "right");
    }

    // A pair of frames, and what the library's eyes see in them.
    void look() {
        for (const Side side : {kLeft, kRight}) {
            cli::Image &frame = frame_[side];
            frame = renderer_.picture(drawing_, world_.head().X_world_cam(side));
            add_noise(scenario_.camera.noise,
                      seed_of(scenario_, key_,
                              mixed_seed(kNoise, static_cast<unsigned>(frames_ * 2 + side))),
                      frame);
            detectors_[side]->look(frame);
            checks_.check(place_of_frame(side), sight_of(*detectors_[side], renderer_.seen_area()));
        }
        if (recording_ != nullptr) {
            recording_->add({key_, frames_, frame_, detectors_, world_.head().angles()});
        }
        ++frames_;
    }

    Seen seen() const {
        Seen seen;
        for (const Side side : {kLeft, kRight}) {
            const ocel_detection_t &detection = detectors_[side]->detection();
            if (detection.has_ellipse) {
                seen[side] = ellipse_of(detection.ellipse).centre;
            }
        }
        return seen;
    }

    void fixate() {
        const Intrinsics &camera = scenario_.camera.intrinsics;
        while (off_middle(seen(), camera) > scenario_.gaze_tolerance &&
               frames_ < scenario_.gaze_frames) {
            follow(seen(), camera, world_);
            look();
        }
    }

    double left_area() {
        return renderer_.target_area(drawing_, world_.head().X_world_cam(kLeft));
    }

    // Moves a plate before the target until this share of it is hidden; returns the
    // share that is.
    double occlude(double wanted) {
        const double whole = wanted > 0.0 ? left_area() : 0.0;
        if (whole == 0.0) {
            return 0.0;
        }
        Random random(seed_of(scenario_, key_, kEdge));
        const Occluder occluder{world_.head().X_world_cam(kLeft).p, p_true_,
                                scenario_.target.radius, random.uniform(0.0, 2.0 * kPi)};
        drawing_.solids.push_back({});
        return search_occlusion(wanted, 1.5 * occluder.target_radius, [&](double reach) {
            drawing_.solids.back() = make_occluder(occluder, reach);
            return 1.0 - left_area() / whole;
        });
    }

    Truth truth() {
        return {p_true_,
                scenario_.distance_at(key_.point),
                {world_.head().angles(),
                 {world_.head().X_world_cam(kLeft), world_.head().X_world_cam(kRight)}}};
    }

    Outlines find_outlines(Method method) const {
        Outlines outlines;
        for (const Side side : {kLeft, kRight}) {
            outlines[side] = find_outline(method, *detectors_[side],
                                          seed_of(scenario_, key_, mixed_seed(kResampling, side)));
        }
        return outlines;
    }

    void measure(TrialRecord &record, TrialPictures *pictures) {
        const Truth now = truth();
        for (const Method method : scenario_.methods) {
            const Outlines outlines = find_outlines(method);
            record.methods[record.method_count++] = judged(method, outlines, scenario_, now);
            if (pictures != nullptr) {
                pictures->outlines.push_back(outlines);
            }
        }
        if (pictures != nullptr) {
            pictures->frames = frame_;
            pictures->truth = now;
        }
    }

    const Scenario &scenario_;
    const TrialKey &key_;
    Renderer &renderer_;
    const std::array<std::unique_ptr<Detector>, kSides> &detectors_;
    Recording *recording_; // null: none
    Vec3 p_true_;
    World world_;
    Drawing drawing_;
    std::array<cli::Image, kSides> frame_;
    FrameChecks checks_;
    int frames_ = 0;
};

} // namespace

Studio::Studio(const Scenario &scenario, Recording *recording)
    : scenario_(scenario), renderer_(scenario.camera.intrinsics, scenario.camera.supersampling),
      recording_(recording) {
    for (auto &detector : detectors_) {
        detector = std::make_unique<Detector>(scenario.camera.intrinsics, scenario.colour,
                                              scenario.min_area);
    }
}

TrialRecord Studio::run(const TrialKey &key, TrialPictures *pictures) {
    return Run(scenario_, key, renderer_, detectors_, recording_).record(pictures);
}

} // namespace sim
