#pragma once
// Rules for the properties that users add to the instances of a class. They are for services that
// give such names a meaning: `input.actions.jump = { "space" }` makes an action.

#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Class;
class Tree;

class AddedRules {
  public:
    virtual ~AddedRules() = default;
    /// Called before a value is written to an added property, or adds it. Throws Error to refuse
    /// it. Must not change the tree.
    virtual void check(Handle instance, std::string_view name, const Value& value) const = 0;
    /// Called after an added property was written, also with the value that it has already, or was
    /// removed. May change the tree. It is not called by a restore, and by an undo only where that
    /// writes the property.
    virtual void changed(Handle instance, std::string_view name) = 0;
};

/// Sets the rules for instances of exactly this class; null: none. Not owned: they must live as
/// long as the tree, or until others are set.
void set_added_rules(Tree& tree, const Class& of, AddedRules* rules);
/// Whether there are rules for properties that are added to the instance.
bool has_added_rules(const Tree& tree, Handle instance);

}  // namespace fettle::property

FETTLE_PROPERTY_END
