#pragma once
// What a scene file says and nothing here understands: a property of a newer version of a class, a
// note of an editor. It lives in the tree, as JSON in the ad-hoc text property `unknown_keys` of
// the instance it was said about, so that it can be seen and removed like everything else, and goes
// where the instance goes: into snapshots, through undo, back into the file.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// Of an instance, the keys with a meaning, in the order they are written.
inline constexpr std::array<std::string_view, 5> instance_keys = {"class", "name", "properties",
                                                                  "ad_hoc", "children"};
/// Of the topmost instance: the version of the format.
inline constexpr std::string_view version_key = "fettle_scene";

/// Gathered while loading: members of the instance's object, of its "properties" and of its
/// "ad_hoc".
class UnknownKeys {
  public:
    enum class Place { instance, properties, ad_hoc };
    void add(Place place, const Document& document, const Document::Node& member);
    bool empty() const { return keys_[0].empty() && keys_[1].empty() && keys_[2].empty(); }
    /// As JSON; the values as they were written.
    std::string text() const;

  private:
    std::array<std::string, 3> keys_;
};

/// What `unknown_keys` of an instance holds; nothing when it has none, or when the text is no JSON
/// object (it is then a property of the user's like any other).
std::optional<Document> unknown_keys(const Tree& tree, Handle instance);

}  // namespace fettle::property
