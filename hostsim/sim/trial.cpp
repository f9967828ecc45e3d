// SPDX-License-Identifier: MIT
#include "trial.hpp"

#include <limits>

#include "gaze.hpp"

namespace sim {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// How near the occlusion comes to what is wanted, and in how many drawings.
constexpr double kOcclusionTolerance = 0.0005;
constexpr int kOcclusionTries = 16;

// Chance is drawn from seeds of their own, so that one does not move another.
enum Draw { kPlacement = 1, kClutter, kNoise, kEdge, kResampling };

std::uint64_t seed_of(const Scenario &scenario, const TrialKey &key, std::uint64_t draw) {
    std::uint64_t seed = mixed_seed(text_seed(scenario.name), key.seed);
    seed = mixed_seed(seed, key.point);
    seed = mixed_seed(seed, static_cast<std::uint64_t>(key.trial));
    return mixed_seed(seed, draw);
}

Vec3 placement(const Scenario &scenario, const TrialKey &key) {
    Random random(seed_of(scenario, key, kPlacement));
    const double distance = scenario.distance_at(key.point);
    const double reach = scenario.jitter * distance;
    const double left = random.uniform(-reach, reach);
    const double up = random.uniform(-reach, reach);
    return eyes_middle() + Vec3(distance, left, up);
}

void add_noise(double sigma, std::uint64_t seed, cli::Image &frame) {
    if (sigma > 0.0) {
        Random random(seed);
        for (std::uint8_t &level : frame.pixels) {
            const double noisy = level + sigma * random.normal();
            level = static_cast<std::uint8_t>(std::lround(std::min(std::max(noisy, 0.0), 255.0)));
        }
    }
}

double norm_or_none(const std::optional<Vec3> &p, const Vec3 &p_true) {
    return p ? cv::norm(*p - p_true) : kNone;
}

JointAngles looking_at(double focus) {
    const double inwards = std::atan(kEyeDistance / 2.0 / focus);
    JointAngles angles{};
    angles[kLeftPan] = -inwards;
    angles[kRightPan] = inwards;
    return angles;
}

// The trial as it goes.
class Run {
  public:
    Run(const Scenario &scenario, const TrialKey &key, Renderer &renderer,
        const std::array<std::unique_ptr<Detector>, kSides> &detectors)
        : scenario_(scenario), key_(key), renderer_(renderer), detectors_(detectors),
          p_true_(placement(scenario, key)), world_(held_ball()) {
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
        TrialRecord record{};
        record.point = static_cast<std::uint32_t>(key_.point);
        record.trial = key_.trial;
        record.distance = scenario_.distance_at(key_.point);
        record.occlusion = occlusion;
        std::copy(p_true_.val, p_true_.val + 3, record.p_true);
        record.frames = frames_;
        for (const Method method : scenario_.methods) {
            record.methods[record.method_count++] = measure(method, pictures);
        }
        if (pictures != nullptr) {
            pictures->frames = frame_;
        }
        return record;
    }

  private:
    BallBody held_ball() const {
        BallBody ball;
        ball.radius = scenario_.target.radius;
        ball.mass = 0.0;
        ball.p_world = p_true_;
        return ball;
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

    // Moves a plate before the target until this share of it is hidden, by false
    // position with the Illinois rule; returns the share that is.
    double occlude(double wanted) {
        const double whole = wanted > 0.0 ? left_area() : 0.0;
        if (whole == 0.0) {
            return 0.0;
        }
        Random random(seed_of(scenario_, key_, kEdge));
        const Occluder occluder{world_.head().X_world_cam(kLeft).p, p_true_,
                                scenario_.target.radius, random.uniform(0.0, 2.0 * kPi)};
        drawing_.solids.push_back({});
        double low = -1.5 * occluder.target_radius;
        double high = -low;
        double below = -wanted;
        double above = 1.0 - wanted;
        double excess = below;
        int last = 0; // which end moved last
        for (int i = 0; i < kOcclusionTries && std::fabs(excess) > kOcclusionTolerance; ++i) {
            const double reach = low - below * (high - low) / (above - below);
            drawing_.solids.back() = make_occluder(occluder, reach);
            excess = 1.0 - left_area() / whole - wanted;
            if (excess < 0.0) {
                low = reach;
                below = excess;
                above /= last == -1 ? 2.0 : 1.0;
                last = -1;
            } else {
                high = reach;
                above = excess;
                below /= last == 1 ? 2.0 : 1.0;
                last = 1;
            }
        }
        return wanted + excess;
    }

    HeadReading reading() {
        return {world_.head().angles(),
                {world_.head().X_world_cam(kLeft), world_.head().X_world_cam(kRight)}};
    }

    MethodRecord measure(Method method, TrialPictures *pictures) {
        Outlines outlines;
        for (const Side side : {kLeft, kRight}) {
            outlines[side] = find_outline(method, *detectors_[side],
                                          seed_of(scenario_, key_, mixed_seed(kResampling, side)));
        }
        const HeadReading head = reading();
        const Estimate found =
            estimate(outlines, head, scenario_.camera.intrinsics, scenario_.target.radius);
        MethodRecord record{};
        record.error_encoder = kNone;
        record.method = method;
        record.status = found.status;
        record.votes = std::min(outlines[kLeft].votes, outlines[kRight].votes);
        judge_place(found, record);
        judge_outlines(outlines, head, record);
        record.radius = found.radius.value_or(kNone);
        record.radius_error_pct = radius_error_pct(record.radius);
        record.radius_true_depth_error_pct = radius_error_pct(record.radius_true_depth);
        if (pictures != nullptr) {
            pictures->outlines.push_back(outlines);
        }
        return record;
    }

    double radius_error_pct(double radius) const {
        return 100.0 * (radius / scenario_.target.radius - 1.0);
    }

    void judge_place(const Estimate &found, MethodRecord &record) const {
        const Vec3 p = found.p_world.value_or(Vec3(kNone, kNone, kNone));
        std::copy(p.val, p.val + 3, record.p_world);
        record.error = norm_or_none(found.p_world, p_true_);
        if (scenario_.gaze == Gaze::kFixate) {
            record.error_encoder = norm_or_none(found.p_encoder, p_true_);
        }
        record.error_residual = norm_or_none(found.p_residual, p_true_);
        record.error_debiased = kNone;
        if (scenario_.target.shape == Shape::kDisc) {
            const double radius = scenario_.target.radius;
            const double bias = radius * radius / scenario_.distance_at(key_.point);
            record.error_debiased = cv::norm(p - Vec3(bias, 0, 0) - p_true_);
        }
    }

    // Against the true outline, which for a disc is taken to be its ball's.
    void judge_outlines(const Outlines &outlines, const HeadReading &head, MethodRecord &record) {
        record.success = true;
        double radius_sum = 0.0;
        for (const Side side : {kLeft, kRight}) {
            const Vec3 p_cam = inverse(head.X_world_cam[side]) * p_true_;
            const auto truth = outline_of_sphere(camera_matrix(scenario_.camera.intrinsics), p_cam,
                                                 scenario_.target.radius);
            const Outline &outline = outlines[side];
            if (!outline.found || !truth) {
                record.success = false;
                radius_sum = record.centre_error_px = kNone;
                break;
            }
            const double off = cv::norm(outline.ellipse.centre - truth->centre);
            const double true_px = mean_radius(*truth);
            record.centre_error_px = std::max(record.centre_error_px, off);
            record.success = record.success && off <= 0.25 * true_px &&
                             std::fabs(mean_radius(outline.ellipse) - true_px) <= 0.2 * true_px;
            radius_sum += radius_at(outline, scenario_.camera.intrinsics, p_cam);
        }
        record.radius_true_depth = radius_sum / 2.0;
    }

    static double mean_radius(const Ellipse &ellipse) {
        const EllipseAxes axes = axes_of(ellipse);
        return std::sqrt(axes.a * axes.b);
    }

    const Scenario &scenario_;
    const TrialKey &key_;
    Renderer &renderer_;
    const std::array<std::unique_ptr<Detector>, kSides> &detectors_;
    Vec3 p_true_;
    World world_;
    Drawing drawing_;
    std::array<cli::Image, kSides> frame_;
    int frames_ = 0;
};

} // namespace

Studio::Studio(const Scenario &scenario)
    : scenario_(scenario), renderer_(scenario.camera.intrinsics, scenario.camera.supersampling) {
    for (auto &detector : detectors_) {
        detector = std::make_unique<Detector>(scenario.camera.intrinsics, scenario.colour,
                                              scenario.min_area);
    }
}

TrialRecord Studio::run(const TrialKey &key, TrialPictures *pictures) {
    return Run(scenario_, key, renderer_, detectors_).record(pictures);
}

} // namespace sim
