#pragma once
// All writes of scripts to the tree, so that a console command can echo its changes.

#include <string>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Machine;

void write_property(Machine& machine, property::Handle instance, const property::Property& property,
                    const property::Value& value);
/// Like `write_property`, for an assignment of the whole property by a script: its former value, if
/// it was a list, can still be assigned elsewhere (see MovedLists).
void assign_property(Machine& machine, property::Handle instance,
                     const property::Property& property, const property::Value& value);
/// Writes one element of the list at the place, from 1, which is not in another list; nil removes
/// the last one. False if that cannot be done without the whole list, which is then as it was.
bool write_element(Machine& machine, const Origin& place, std::size_t index, const Value& element);
/// Assigns nil: resets the property to its default, sets nil if it is nullable, or removes an ad
/// hoc property.
void clear_property(Machine& machine, property::Handle instance,
                    const property::Property& property);
/// Records that an ad hoc property was added with its first value.
void note_added(Machine& machine, property::Handle instance, std::string_view name);
/// Sets the formula of a property; adds the property if it does not exist.
void write_formula(Machine& machine, property::Handle instance, std::string_view name,
                   property::Formula formula);
/// Gives a detached instance a parent and a name. `plain_names` is for children without a name in a
/// constructor.
void place(Machine& machine, property::Handle instance, property::Handle parent,
           std::string_view name, property::PlainNames* plain_names = nullptr);
/// Gives a detached instance the place and name of another instance, which is deleted.
void replace(Machine& machine, property::Handle old, property::Handle by);
void destroy(Machine& machine, property::Handle instance);
/// The child with that name, also one that waits for its place during a reload.
property::Handle child_of(Machine& machine, property::Handle instance, std::string_view name);
/// Adds an ad hoc property, or sets one.
void set_or_add(Machine& machine, property::Handle instance, std::string_view name,
                const property::Value& value);

}  // namespace fettle::script
