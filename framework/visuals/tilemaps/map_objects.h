#pragma once
// Instances for the objects of a map file.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

#include <tilemaps/loaded_map.h>

namespace fettle::visuals {

/// Where a map is in the world.
struct MapPlace {
    property::Vec2 upper_left{0, 0};
    double pixels_per_unit = 1;

    /// Of pixels, y down.
    property::Vec2 length(const property::Vec2& pixels) const {
        return property::Vec2(pixels.x, 0.0 - pixels.y) / pixels_per_unit;
    }
    property::Vec2 point(const property::Vec2& pixels) const { return upper_left + length(pixels); }
    MapPlace moved(const property::Vec2& pixels) const { return {point(pixels), pixels_per_unit}; }
};

/// Makes instances and sets their properties. Reports refused values with their place in the file.
class Maker {
  public:
    Maker(property::Tree& tree, std::function<void(const std::string&)> report)
        : tree_(tree), report_(std::move(report)) {}

    property::Tree& tree() { return tree_; }
    /// Below `parent`, with that name, numbered if it is taken.
    property::Handle add(const property::Class& of, property::Handle parent,
                         const std::string& name);
    /// Later messages begin with this text, such as "object 12".
    void begin_messages(std::string what) { what_ = std::move(what); }
    void report(const std::string& problem) const { report_(what_ + ": " + problem); }
    /// Sets a declared property.
    void set(property::Handle instance, const char* name, const property::Value& value);
    /// Sets the property if the instance has it.
    void set_if_there(property::Handle instance, const char* name, const property::Value& value);
    void set_or_add(property::Handle instance, const std::string& name,
                    const property::Value& value);
    /// Properties from the editor: declared ones are set, others are added to the instance.
    void set_custom(property::Handle instance, const maps::Properties& properties);
    void remember(std::int64_t id, property::Handle instance) { by_id_[id] = instance; }
    /// Properties that name an object become references to its instance.
    void resolve_references();

  private:
    struct Open {
        property::Handle instance;
        const property::Property* property;
        std::int64_t id;
        std::string what;
    };
    property::Tree& tree_;
    std::function<void(const std::string&)> report_;
    std::string what_;
    std::map<std::pair<std::uint32_t, std::string>, int> numbers_;  // by parent and name
    std::map<std::int64_t, property::Handle> by_id_;
    std::vector<Open> open_;
};

/// Makes the instances of an object layer below `parent`.
void make_objects(Maker& make, const LoadedMap& file, const maps::Layer& layer,
                  property::Handle parent, const MapPlace& place, bool smooth);

}  // namespace fettle::visuals
