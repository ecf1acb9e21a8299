#pragma once
// Instances that show something: pictures, texts, lines, maps, particles, and the layers that they
// are on. They only use the tree, the files of the game and the painter, so a game without a window
// has the same state.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/module/module.h>
#include <fettle/property/media.h>
#include <fettle/visuals/export.h>

FETTLE_VISUALS_BEGIN

namespace fettle::property {
class Assets;
struct Thumbnail;
}  // namespace fettle::property

namespace fettle::visuals {

/// The classes Sprite, Text, Line, Layer, Tilemap, TileLayer and Emitter, for one tree. The
/// destructor deletes their instances if the tree still lives; the classes stay in the tree without
/// instances.
class Visuals : public module::Module {
  public:
    /// `assets`: the files of the game; null if there are none. They must outlive this object.
    explicit Visuals(property::Assets* assets);
    ~Visuals() override;
    Visuals(const Visuals&) = delete;
    Visuals& operator=(const Visuals&) = delete;

    std::string_view name() const override { return "visuals"; }
    void attach(property::Tree& tree) override;
    /// Whether images that are enlarged are smooth, unless an instance says it: the default of
    /// `smooth` in all classes, and of the pen. Before `attach`; empty: as each class says.
    void smooth_by_default(std::optional<bool> smooth);
    /// Advances animations and particles.
    void step(double dt) override;
    void report(property::Tree& tree) override;
    std::uint64_t hash() const override;
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from,
                                  const property::Memory& memory) override;
    /// To be called when that file of the game has changed, and no code of the game runs: reads it
    /// again if it is an image, a font, or a part of a map that is in use. If it cannot be read,
    /// the old one stays, and `on_problem` gets the reason.
    void renew(const std::string& name);
    /// Sets the function that gives the picture of a saved game, which is the image "save:SLOT".
    /// Call `renew("save:SLOT")` when the picture has changed.
    void saved_pictures(std::function<property::Thumbnail(const std::string& slot)> of);
    /// Images and text for `draw(pen)`.
    property::Media& media();
    /// The function gets one line for each file that is missing or cannot be read, once.
    void on_problem(std::function<void(const std::string&)> listener);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::visuals

FETTLE_VISUALS_END
