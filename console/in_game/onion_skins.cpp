#include <in_game/onion_skins.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fettle/property/drawing.h>
#include <fettle/property/pose.h>

#include <look/theme.h>

namespace fettle::console {

using property::Handle;

namespace {

// Steps on each side of the present one. More are read than are drawn, so that not each frame reads
// while one drags the time.
constexpr std::int64_t read_around = 240;
constexpr std::int64_t drawn_around = OnionSkins::apart * (OnionSkins::drawn + 1);

auto skin_at(const std::deque<OnionSkins::Skin>& skins, std::int64_t step) {
    return std::ranges::lower_bound(skins, step, {}, &OnionSkins::Skin::step);
}

}  // namespace

void OnionSkins::follow(Handle instance) {
    if (!tree_.alive(instance)) instance = {};
    if (instance == instance_) return;
    instance_ = instance;
    skins_.clear();
    known_from_ = 0;
    known_to_ = -1;
}

void OnionSkins::take(std::int64_t step) {
    const auto pose = property::place_below(tree_, instance_, false, 1);
    if (!pose) return;
    const auto at = skin_at(skins_, step);
    if (at != skins_.end() && at->step == step)
        skins_[static_cast<std::size_t>(at - skins_.begin())].pose = *pose;
    else
        skins_.insert(at, {step, *pose});
}

/// Drops poses at the end that is farther from the step.
void OnionSkins::drop_far_from(std::int64_t step) {
    for (; skins_.size() > most;) {
        if (step - skins_.front().step > skins_.back().step - step) {
            skins_.pop_front();
            known_from_ = std::max(known_from_, skins_.front().step);
        } else {
            skins_.pop_back();
            known_to_ = std::min(known_to_, skins_.back().step);
        }
    }
}

/// Poses of another branch than the present one are no longer true.
void OnionSkins::follow_branch() {
    const std::optional<std::int64_t> common = branch_.left_after();
    if (!common) return;
    while (!skins_.empty() && skins_.back().step > *common) skins_.pop_back();
    known_to_ = std::min(known_to_, *common);
    newest_ = *common;
}

void OnionSkins::after_step() {
    if (!instance_ || !tree_.alive(instance_)) return;
    follow_branch();
    const auto step = static_cast<std::int64_t>(tree_.step());
    // The game went back and goes on from here.
    while (!skins_.empty() && skins_.back().step >= step) skins_.pop_back();
    take(step);
    drop_far_from(step);
    newest_ = step;
    if (step > known_to_ + 1) known_from_ = step;
    known_to_ = step;
}

void OnionSkins::between_frames(const Review& review) {
    if (!instance_ || !review) return;
    follow_branch();
    const auto here = static_cast<std::int64_t>(tree_.step());
    newest_ = std::max(newest_, here);
    if (here - drawn_around >= known_from_ && std::min(here + drawn_around, newest_) <= known_to_)
        return;
    const std::int64_t from = here - read_around, to = here + read_around;
    review(from, to, [&](std::int64_t step) {
        newest_ = std::max(newest_, step);
        if (tree_.alive(instance_)) take(step);
    });
    const bool gap = from > known_to_ + 1 || to + 1 < known_from_;
    known_from_ = gap ? from : std::min(from, known_from_);
    known_to_ = gap ? to : std::max(to, known_to_);
    drop_far_from(here);
}

std::vector<std::int64_t> OnionSkins::shown_at(std::int64_t step) const {
    // Multiples of the distance: a skin stays where it is while one goes back and forth.
    std::vector<std::int64_t> steps;
    const std::int64_t middle = step / apart;
    for (std::int64_t n = middle - drawn; n <= middle + drawn + 1; ++n) {
        const auto at = skin_at(skins_, n * apart);
        if (n * apart != step && at != skins_.end() && at->step == n * apart)
            steps.push_back(n * apart);
    }
    return steps;
}

void OnionSkins::draw(ImDrawList& list, const ToPixels& to_pixels) const {
    if (!instance_ || !tree_.alive(instance_)) return;
    const double alpha = property::Drawing::alpha();
    const auto now = property::place_below(tree_, instance_, false, alpha);
    if (!now || now->area() == 0) return;
    const auto here = static_cast<std::int64_t>(tree_.step());
    for (const std::int64_t step : shown_at(here)) {
        const double far = static_cast<double>(std::abs(step - here)) / (apart * (drawn + 1.0));
        const ImU32 color = step < here ? palette::accent : palette::note;
        const float opacity = 0.65f - 0.5f * static_cast<float>(std::min(1.0, far));
        Pen pen(list, to_pixels, {.color = with_alpha(color, opacity), .width = 1.5f},
                skin_at(skins_, step)->pose * inverse(*now));
        tree_.draw(instance_, pen, alpha);
    }
}

}  // namespace fettle::console
