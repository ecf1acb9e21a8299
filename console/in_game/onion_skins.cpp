#include <in_game/onion_skins.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fettle/property/drawing.h>
#include <fettle/property/pose.h>

#include <look/theme.h>

namespace fettle::console {

using property::Handle;

namespace {

constexpr std::int64_t read_past = 240;  // steps

auto skin_at(const std::deque<OnionSkins::Skin>& skins, std::int64_t step) {
    return std::ranges::lower_bound(skins, step, {}, &OnionSkins::Skin::step);
}

}  // namespace

void OnionSkins::follow(Handle instance) {
    if (!tree_.alive(instance)) instance = {};
    if (instance == instance_) return;
    instance_ = instance;
    skins_.clear();
    needs_past_ = static_cast<bool>(instance);
}

void OnionSkins::take(std::int64_t step) {
    const auto pose = property::place_below(tree_, instance_, false, 1);
    if (!pose) return;
    const auto at = skin_at(skins_, step);
    if (at != skins_.end() && at->step == step)
        skins_[static_cast<std::size_t>(at - skins_.begin())].pose = *pose;
    else
        skins_.insert(at, {step, *pose});
    if (skins_.size() > most) skins_.pop_front();
}

void OnionSkins::after_step() {
    if (!instance_ || !tree_.alive(instance_)) return;
    const auto step = static_cast<std::int64_t>(tree_.step());
    // The game went back and goes on from here.
    while (!skins_.empty() && skins_.back().step >= step) skins_.pop_back();
    take(step);
}

void OnionSkins::between_frames(const Review& review) {
    if (!std::exchange(needs_past_, false) || !review) return;
    review(static_cast<std::int64_t>(tree_.step()) - read_past, [&](std::int64_t step) {
        if (tree_.alive(instance_)) take(step);
    });
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
