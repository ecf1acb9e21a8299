#pragma once
// Earlier poses of the selected instance, and later ones after going back.

#include <imgui.h>

#include <cstdint>
#include <deque>
#include <functional>

#include <fettle/property/transform.h>
#include <fettle/property/tree.h>

#include <branches/present_branch.h>
#include <look/pen.h>
#include <observed/review.h>

namespace fettle::console {

class OnionSkins {
  public:
    static constexpr std::size_t most = 3600;  // poses
    static constexpr std::int64_t apart = 15;  // steps between two poses that are drawn
    static constexpr int drawn = 12;           // poses on each side of the present one

    explicit OnionSkins(property::Tree& tree) : tree_(tree), branch_(tree) {}

    /// The instance whose poses are kept; a null handle: none.
    void follow(property::Handle instance);
    /// Keeps the pose after a step; those of later steps are forgotten.
    void after_step();
    /// Reads the poses around the present step, unless they are known: after `follow` was called
    /// for another instance, and after the game has gone to a step far from where it was.
    void between_frames(const Review& review);
    void draw(ImDrawList& list, const ToPixels& to_pixels) const;

    struct Skin {
        std::int64_t step;
        property::Transform pose;
    };
    /// Ascending by step.
    const std::deque<Skin>& skins() const { return skins_; }
    /// The steps of the poses that are drawn at this step, ascending.
    std::vector<std::int64_t> shown_at(std::int64_t step) const;

  private:
    void take(std::int64_t step);
    void drop_far_from(std::int64_t step);
    void follow_branch();

    property::Tree& tree_;
    PresentBranch branch_;
    property::Handle instance_;
    std::deque<Skin> skins_;
    // The poses of all kept steps between these are known; from > to: of none.
    std::int64_t known_from_ = 0, known_to_ = -1;
    std::int64_t newest_ = 0;  // kept step, as far as it is known
};

}  // namespace fettle::console
