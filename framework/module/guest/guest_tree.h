#pragma once
// property::Tree inside a shared object: the same class with another implementation, which forwards
// every call to the program's table of functions.

#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/module/abi.h>
#include <fettle/property/tree.h>

#include "../../property/classes/class_registry.h"
#include "../../property/values/process_data.h"
#include "../bridge/c_values.h"

namespace fettle::module {

/// The program that opened this shared object; null before. For functions of the tree's library
/// that have no tree.
const fettle_host* program();

/// Contexts with which the program calls properties, methods and classes of the module.
struct GuestProperty {
    property::Tree::State* tree = nullptr;
    property::Binding binding;
};

struct GuestMethod {
    property::Tree::State* tree = nullptr;
    property::Method method;
};

struct GuestClass {
    property::Tree::State* tree = nullptr;
    property::Lifecycle lifecycle;
};

struct GuestEvent {
    const property::Event* event = nullptr;
    fettle_event_tag tag{};
};

}  // namespace fettle::module

namespace fettle::property {

struct Tree::State {
    CountedTree counted;
    Tree* self = nullptr;
    const fettle_host* host = nullptr;
    std::string module;  // its name, for messages
    ClassRegistry classes;
    SnapshotPart* part = nullptr;  // the module, if it saves its rows itself
    module::Outgoing outgoing;     // the last result of a callback, for the program

    // Deques, because the program keeps pointers to the elements.
    std::deque<module::GuestProperty> properties;
    std::deque<module::GuestMethod> methods;
    std::deque<module::GuestClass> lifecycles;
    std::deque<module::GuestEvent> events;
    // Key: address of the program's name of the class.
    mutable std::unordered_map<const void*, const Class*> by_name;

    /// Throws the program's last error unless `status` is FETTLE_OK.
    void require(fettle_status status) const;
    /// Runs a callback of the module and reports an exception to the program.
    template <class Body>
    fettle_status answer(Body&& body) noexcept;
    /// The same for a callback that returns no status: the program takes the reason that was given
    /// to `fail` as an error of the module.
    template <class Body>
    void run(Body&& body) noexcept;
    /// The class of that name; null if there is none. A class of the program is registered here
    /// first, with its bases.
    const Class* known(const char* name);
    /// Copies the program's counts of listeners into the module's events.
    void follow_listeners();
};

template <class Body>
fettle_status Tree::State::answer(Body&& body) noexcept {
    try {
        body();
        return FETTLE_OK;
    } catch (const Error& error) {
        host->fail(host->self, error.what());
        return module::status_of(error.kind());
    } catch (const std::invalid_argument& refused) {
        host->fail(host->self, refused.what());
        return FETTLE_ERR_REJECTED;
    } catch (const std::exception& error) {
        host->fail(host->self, error.what());
    } catch (...) {
        host->fail(host->self, "an exception of no known type");
    }
    return FETTLE_ERR_FAILED;
}

template <class Body>
void Tree::State::run(Body&& body) noexcept {
    (void)answer(std::forward<Body>(body));
}

}  // namespace fettle::property

namespace fettle::module {

/// Describes a class in C and gives it to the program. `descriptor` was given to the registry;
/// `made` is the resulting class.
void export_class(property::Tree::State& tree, const property::ClassDescriptor& descriptor,
                  const property::Class& made);

/// Forwards drawing to the program's painter.
class GuestPainter : public property::Painter {
  public:
    explicit GuestPainter(const fettle_painter& table) : table_(table) {}
    void push(const property::Transform& transform) override;
    void pop() override;
    void fade(float opacity) override { table_.fade(table_.self, opacity); }
    void blend(property::Blend mode) override {
        table_.blend(table_.self, static_cast<std::uint32_t>(mode));
    }
    void clip(const property::Vec2& lower, const property::Vec2& upper) override {
        table_.clip(table_.self, lower.data(), upper.data());
    }
    double pixels_per_unit() const override { return table_.pixels_per_unit(table_.self); }
    double label_scale() const override { return table_.label_scale(table_.self); }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color tint,
                 bool smooth) override;
    void circle(const property::Vec2& center, double radius, const property::Paint& paint) override;
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& paint) override;
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& paint) override;
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override;
    void point(const property::Vec2& position, property::Color color, float size) override;
    void text(const property::Vec2& position, std::string_view text, double height,
              property::Color color, property::TextAlign align) override;
    void part_of(std::uint64_t whole) override { table_.part_of(table_.self, whole); }
    bool shows(property::Overlay overlay) const override;
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override;
    void begin_screen() override { table_.begin_screen(table_.self); }
    void end_screen() override { table_.end_screen(table_.self); }

  private:
    const fettle_painter& table_;
};

}  // namespace fettle::module
