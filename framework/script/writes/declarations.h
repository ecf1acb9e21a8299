#pragma once
// What the top level of a game declares: the instances that it makes, the values that it gives
// them, and the values that it gives to instances of the framework. A reload compares what the new
// code declares with what the old code declared, and applies the differences. While a game is
// loaded, the top level writes to the tree, and the declarations are only noted. During a reload,
// nothing that is part of the game may change before the whole file has run without an error. So an
// instance that gets a place stays detached, and is found by its name as if it were there; a value
// for an instance of the game is only noted, and read back from here.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/path.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

#include <values/recording.h>

namespace fettle::script {

class Declarations {
  public:
    /// A value that the top level gave to a property.
    struct Assignment {
        property::Value value;  // as the tree stores it
        std::optional<property::Formula> formula;
        property::Value before;  // before the first write; of an instance that it did not make
        bool added = false;      // the top level added the property
        std::string place{};     // "main.lua:3"; known during a reload only
    };
    struct Declared {
        property::Handle instance;
        const property::Class* of = nullptr;
        std::string path;   // its place when the top level ended; "" if it had none or is not noted
        bool made = false;  // by the top level
        std::map<std::string, Assignment> assignments;
    };
    using All = std::vector<Declared>;
    struct Place {
        property::Handle parent;
        std::string name;
    };
    /// A call of a method that changes something, and has no result.
    struct Call {
        property::Handle instance;
        const property::Method* method;
        std::vector<property::Value> arguments;
    };

    Declarations(property::Tree& tree, Recording& recording) : tree_(tree), recording_(recording) {}

    /// Must be called before the top level runs. `reload`: the game is running already.
    void begin(bool reload);
    /// Must be called when the top level has run. Returns its declarations, with the places of all
    /// instances.
    All end();
    bool active() const { return phase_ != Phase::none; }
    bool reloading() const { return phase_ == Phase::reload; }
    /// What the top level declared when it last ran.
    void keep(All all);
    const All& last() const { return last_; }

    // --- Noting

    void made(property::Handle instance);
    /// The same for an instance with everything below it, and the values that it has.
    void made_with_values(property::Handle top);
    /// To be called before and after a write of a script.
    void writing(property::Handle instance, std::string_view name);
    void wrote(property::Handle instance, std::string_view name);
    /// The same for an element of a list, not during a reload. The list is noted when the top level
    /// has ended: as long as a note of it is kept, each further element would copy it.
    void wrote_element(property::Handle instance, std::string_view name);

    // --- During a reload

    /// Whether the instance is part of the game and must not change yet.
    bool defers(property::Handle instance) const;
    /// Notes a value for such an instance. Throws as `Tree::set` and `set_or_add` do.
    void defer(property::Handle instance, std::string_view name, const property::Value& value);
    void defer(property::Handle instance, std::string_view name, property::Formula formula);
    /// The value as the top level sees it: nullptr if the tree has it.
    const property::Value* seen(property::Handle instance, std::string_view name) const;
    /// Whether the top level does not see an instance, or a property that was added to one, because
    /// the old code made it. So `if not world:has("ball")` goes the way that it went at first.
    bool hides(property::Handle instance) const;
    bool hides(property::Handle instance, std::string_view name) const;
    /// The children of an instance as the top level sees them.
    std::vector<property::Handle> children(property::Handle parent) const;
    /// Gives a detached instance a place. An empty name: the next free one of its class.
    void place(property::Handle instance, property::Handle parent, std::string_view name);
    /// Makes an instance that stands for one of the framework which the game has deleted, and gives
    /// it the place of that one. What the top level does with it ends with the reload.
    property::Handle stand_in(const property::Class& of, std::string_view name);
    bool is_stand_in(property::Handle instance) const {
        return stand_ins_.contains(instance.key());
    }
    /// The instance loses its place, if it has one.
    void remove(property::Handle instance);
    bool has_place(property::Handle instance) const { return places_.contains(instance.key()); }
    /// The instance that got that place; a null handle if there is none.
    property::Handle child(property::Handle parent, std::string_view name) const;
    /// Instances with a place, in the order in which they got it.
    const std::vector<property::Handle>& placed() const { return placed_; }
    const Place& place_of(property::Handle instance) const { return places_.at(instance.key()); }
    std::vector<Call> calls;
    /// A scene file that the top level loads during a reload.
    struct Scene {
        std::filesystem::path file;
        std::vector<property::SceneInstance> instances;
        bool named = false;  // by the script
    };
    std::vector<Scene> scenes;
    /// The instance that will have this path, or the property of one.
    std::optional<property::Place> find_future(const std::string& path) const;

  private:
    enum class Phase : std::uint8_t { none, first, reload };
    void note_lists();
    Declared& entry(property::Handle instance);
    const Declared* find(property::Handle instance) const;
    Assignment& assignment(property::Handle instance, std::string_view name);
    const Assignment* last_assignment(property::Handle instance, std::string_view name) const;
    std::string future_path(property::Handle instance) const;
    std::string free_name(property::Handle instance, property::Handle parent);
    void make_its_children(property::Handle instance);

    property::Tree& tree_;
    Recording& recording_;
    Phase phase_ = Phase::none;
    All all_, last_;
    std::unordered_map<std::uint64_t, std::size_t> index_;       // of `all_`
    std::unordered_map<std::uint64_t, std::size_t> last_index_;  // of `last_`
    std::unordered_map<std::uint64_t, Place> places_;
    std::map<std::pair<std::uint64_t, std::string>, property::Handle, std::less<>> children_;
    std::map<std::pair<std::uint64_t, std::string>, int> numbers_;  // last of each stem
    std::vector<property::Handle> placed_;
    std::set<std::uint64_t> stand_ins_;
};

}  // namespace fettle::script
