#pragma once
// Preferences: values of properties that the player has set, such as a volume or a key. They belong
// to the player and not to the state of the game, so they stay when time jumps.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <fettle/property/observer.h>
#include <fettle/property/path.h>
#include <fettle/property/tree.h>

namespace fettle::interface {

/// The preferences are stored twice: here as they are now, and in a property of the tree. A jump
/// restores the property and not the copy here, so a comparison of the two shows which values the
/// player has changed since the restored step. Other writes to the same properties are state of the
/// game.
class Preferences : public property::Observer {
  public:
    /// The name of the property in the tree.
    static constexpr const char* saved_name = "preferences";

    ~Preferences() override;
    void attach(property::Tree& tree, property::Handle service);
    /// Receives each preference that changes: its path and its value, nil for one that ended.
    void on_change(std::function<void(const std::string&, const property::Value&)> listener) {
        changed_ = std::move(listener);
    }
    void on_problem(std::function<void(const std::string&)> listener) {
        problem_ = std::move(listener);
    }

    /// Whether a widget that writes the property sets a preference: true for the properties of
    /// `audio` and of `input.actions`, and of all below them.
    bool can_be_preference(const property::Place& place) const;
    /// Stores the present value of the property as a preference, if it can be one.
    void store(const property::Place& place);
    /// Writes the property, and stores the value as a preference. With nil, the property is not
    /// written and is no longer a preference. Throws Error.
    void prefer(const std::string& path, const property::Value& value);
    /// A preference of an earlier run, to be written when its property exists.
    void begin_with(const std::string& path, const property::Value& value);

    /// True if time has jumped to a step with other preferences, or if some of an earlier run are
    /// not written yet.
    bool differs() const;
    /// Writes the preferences that the player has changed since the restored step, and those of an
    /// earlier run whose property exists now.
    void restore_changed();

    void restored() override { jumped_ = true; }
    void wrote_plain(const property::PlainWrites&) override {
        // Only jumps matter here.
    }

  private:
    void put(const std::string& path, const property::Value& value);
    void save();
    bool write(const std::string& path, const property::Value& value);
    property::Place place_of(const std::string& path) const;

    property::Tree* tree_ = nullptr;
    std::weak_ptr<const property::Tree*> life_;
    property::Handle service_{};
    property::List now_;      // lists of a path and a value
    property::List waiting_;  // of an earlier run, not written yet
    bool jumped_ = false;
    std::function<void(const std::string&, const property::Value&)> changed_;
    std::function<void(const std::string&)> problem_;
};

}  // namespace fettle::interface
