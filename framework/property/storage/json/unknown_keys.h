#pragma once
// Keys of a scene file that this version does not have: a property of a newer class, a note of an
// editor. Each instance keeps them, as JSON, in its ad-hoc text property `unknown_keys`. There they
// can be seen and removed like other properties, and they are part of snapshots, undo and saved
// files.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// Known keys of an instance, in the order in which they are written.
inline constexpr std::array<std::string_view, 5> instance_keys = {"class", "name", "properties",
                                                                  "ad_hoc", "children"};
/// Key of the topmost instance: the version of the format.
inline constexpr std::string_view version_key = "fettle_scene";

/// Collects unknown keys during loading: members of the instance's object, of its "properties" and
/// of its "ad_hoc".
class UnknownKeys {
  public:
    enum class Place { instance, properties, ad_hoc };
    void add(Place place, const Document& document, const Document::Node& member);
    bool empty() const { return keys_[0].empty() && keys_[1].empty() && keys_[2].empty(); }
    /// As JSON; the values have their original text.
    std::string text() const;

  private:
    std::array<std::string, 3> keys_;
};

/// The content of `unknown_keys` of an instance. nullopt if it has none, or if the text is not a
/// JSON object: then it is an ordinary property of the user.
std::optional<Document> unknown_keys(const Tree& tree, Handle instance);

}  // namespace fettle::property
