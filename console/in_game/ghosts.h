#pragma once
// Ghosts of the bodies that will move in the next seconds: while the game is paused, each edit
// shows the paths that the bodies would take from here.

#include <imgui.h>

#include <cstdint>
#include <vector>

#include <fettle/property/observer.h>
#include <fettle/property/tree.h>

#include <look/pen.h>

namespace fettle::console {

class Ghosts : private property::Observer {
  public:
    explicit Ghosts(property::Tree& tree);
    ~Ghosts() override;
    Ghosts(const Ghosts&) = delete;

    struct Ghost {
        property::Handle instance;
        std::vector<property::Vec2> points;  // m, one for each step
        double angle = 0;                    // rad, at the end
    };

    /// To be called between two frames. While the game is paused, edits of persons are noted; when
    /// it goes on or goes to another step, the ghosts are forgotten.
    void watch(bool on);
    /// To be called for each picture: looks ahead again if something was edited since the last
    /// call. `seconds`: how far.
    void update(double seconds);
    void forget();
    void draw(ImDrawList& list, const ToPixels& to_pixels) const;
    const std::vector<Ghost>& ghosts() const { return ghosts_; }

  private:
    void wrote(property::Handle, const property::Property& property,
               const property::Value&) override;
    void wrote_plain(const property::PlainWrites& writes) override;
    void was_reset(property::Handle, const property::Property&) override { note(); }
    void removed(property::Handle, const property::Property&) override { note(); }
    void formula_changed(property::Handle, const property::Property&) override { note(); }
    void created(property::Handle) override { note(); }
    void destroying(property::Handle) override { note(); }
    void moved(property::Handle) override { note(); }
    void call_ends(property::Handle, const property::Method& of) override {
        if (of.effect != property::Effect::nothing) note();
    }
    void restored() override { forget(); }
    void note();
    void look_ahead(double seconds);

    property::Tree& tree_;
    std::vector<Ghost> ghosts_;
    std::int64_t step_ = -1;  // of the ghosts
    bool watches_ = false;    // edits are noted
    bool edited_ = false;
};

}  // namespace fettle::console
