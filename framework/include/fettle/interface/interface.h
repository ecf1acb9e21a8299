#pragma once
// The interface of a game: panels, buttons, sliders and other widgets on the screen, as instances
// of the tree. They only use the tree, the input of the game and the painter, so a game without a
// window has the same state.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <fettle/app/foreground.h>
#include <fettle/interface/export.h>
#include <fettle/module/module.h>
#include <fettle/property/media.h>

FETTLE_INTERFACE_BEGIN

namespace fettle::interface {

/// The classes of widgets and `Theme`, and the instance `interface`, for one tree. The destructor
/// deletes their instances if the tree still lives; the classes stay in the tree without instances.
class Interface : public module::Module, public app::Foreground {
  public:
    /// `media`: images and fonts of the game. It must outlive this object.
    explicit Interface(property::Media& media);
    ~Interface() override;
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    std::string_view name() const override { return "interface"; }
    void attach(property::Tree& tree) override;
    /// Does nothing: `report` follows the step.
    void step(double dt) override;
    void report(property::Tree& tree) override;
    std::uint64_t hash() const override;
    /// The function gets one line for each widget whose `bind` fails, once.
    void on_problem(std::function<void(const std::string&)> listener);

    /// The function gets each preference that changes, to be kept for later runs: the path of a
    /// property and its value; nil if it is no longer a preference.
    void on_preference(std::function<void(const std::string&, const property::Value&)> keep);
    /// Writes a preference of an earlier run in the next frame, or as soon as there is such a
    /// property.
    void begin_with(const std::string& path, const property::Value& value);

    bool takes(const app::Act& act) const override;
    void handle(const app::Act& act, bool taken) override;
    void frame(const property::Vec2& mouse, const property::Vec2& screen, double seconds) override;
    void draw(property::Painter& painter) override;

    /// How often widgets were laid out, for tests: nothing is laid out unless something changed.
    std::uint64_t layouts() const;

  private:
    struct FETTLE_INTERFACE_PRIVATE State;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::interface

FETTLE_INTERFACE_END
