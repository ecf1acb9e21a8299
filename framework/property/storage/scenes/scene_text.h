#pragma once
// Text of scenes that become a part of another scene.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/tree.h>

#include <values/instance_paths.h>

namespace fettle::property {

/// The texts of the values of some instances, in the form of a scene with full paths. Changes of
/// the instances in the tree do not change them.
class SceneValues {
  public:
    bool has(Handle instance) const { return values_.contains(instance.key()); }
    /// Null if the property has no value in the scene.
    const std::string* value(Handle instance, const std::string& property) const;
    /// Must be called for an instance before its values are set.
    void add(Handle instance) { values_[instance.key()]; }
    void set(Handle instance, const Property& property, std::string text);
    void remove(Handle instance, const std::string& property);
    /// Forgets the instance and those that are below it in the tree.
    void forget(const Tree& tree, Handle instance);
    /// The instances of both get the values that they have in `other`.
    void take_from(const SceneValues& other);
    void clear();
    std::size_t bytes() const;  // that it takes, estimated
    /// Whether any of the values may have references.
    bool may_name() const { return !naming_.empty(); }
    /// Replaces paths in all references. Returns whether there was one that `mention` may name.
    bool rename(const Tree& tree, const std::string& mention, const NewPath& path);

  private:
    std::unordered_map<std::uint64_t, std::map<std::string, std::string>> values_;
    // The only values that may have references.
    std::map<std::pair<std::uint64_t, std::string>, Handle> naming_;
};

/// Like `scene_text`, but all references are paths from the root. So they stay valid wherever the
/// text is placed in a file. `left_out`: whether an instance below `node` is not written, nor what
/// is below it. `noted`: gets all values that are written.
std::string scene_text_with_full_paths(const Tree& tree, Handle node,
                                       std::vector<std::string>* warnings,
                                       const std::function<bool(Handle)>& left_out = {},
                                       SceneValues* noted = nullptr);

/// The scene of those instances of `values` that are `node` or below it: their names and places are
/// the present ones, and the values those of `values`.
std::string scene_text_with_values(const Tree& tree, Handle node, const SceneValues& values);

}  // namespace fettle::property
