#pragma once
// The class Emitter: many small pictures that begin, move and end.

#include <cstdint>
#include <functional>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <emitters/particles.h>
#include <images/images.h>

namespace fettle::visuals {

class Emitters {
  public:
    explicit Emitters(Images& images);
    void define(property::Tree& tree);
    void step(double dt);
    /// Emits `finished` for the emitters whose last particle has ended in the step.
    void report();
    std::uint64_t hash() const;
    // The part of a snapshot.
    void save(property::ByteWriter& to) const;
    std::function<void()> restore(property::ByteReader& from);

  private:
    /// The state that the tree does not store, without the particles. Only numbers.
    struct State {
        property::Handle self{};   // null: the row is free
        std::uint64_t born = 0;    // number of particles that ever began
        double owed = 0;           // fraction of the next particle that is due
        double last_dt = 0;        // s, length of the last step
        property::Transform at{};  // where it was at the end of the last step
        std::uint32_t wanted = 0;  // particles to begin in the next step, by `emit`
        bool placed = false;       // `at` is known: a place in the world
        bool burst = false;        // the particles of `burst` have begun
        bool busy = false;         // it has particles, or had some in the last step
    };
    struct Row {
        State state{};
        std::vector<Particle> particles{};
        property::Value image{};               // the name of the sheet
        std::shared_ptr<const Sheet> sheet{};  // null without an image
    };
    struct Properties {
        const property::Property *rate, *burst, *lifetime, *speed, *spread, *randomness, *gravity,
            *damping, *size, *color, *rotation, *image, *shape, *area, *space, *limit, *seed,
            *playing, *position, *angle, *blend, *visible, *smooth;
    };

    // --- emitter_class.cpp
    std::vector<property::Property> flow_properties();
    std::vector<property::Property> motion_properties();
    std::vector<property::Property> look_properties();
    std::vector<property::Method> methods();
    property::Lifecycle lifecycle();

    // --- emitters.cpp
    property::Row add(property::Handle self);
    void advance(Row& row, double dt);
    Motion motion_of(const Row& row) const;
    Birth birth_of(const Row& row, const property::Transform& now, bool on_screen) const;
    bool on_screen(property::Handle self) const;

    // --- emitter_drawing.cpp
    const Sheet* sheet_of(Row& row);
    void draw(Row& row, property::Painter& painter, double alpha);

    Images& images_;
    property::Tree* tree_ = nullptr;
    const property::Class* class_ = nullptr;
    Properties of_{};
    const property::Event* finished_ = nullptr;
    property::Picture dot_{};  // for emitters without an image
    std::vector<Row> rows_;
    std::vector<property::Row> free_;
    std::vector<property::Handle> ended_;
    std::size_t all_ = 0;  // particles of all emitters
};

}  // namespace fettle::visuals
