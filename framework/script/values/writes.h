#pragma once
// Every write of a script to the tree goes through here, so that a console command can echo what it
// changed.

#include <string>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Machine;

void write_property(Machine& machine, property::Handle instance, const property::Property& property,
                    const property::Value& value);
/// nil: the default again; nil itself where that is a value; an ad-hoc property goes away.
void clear_property(Machine& machine, property::Handle instance,
                    const property::Property& property);
/// An ad-hoc property was added, with its first value.
void note_added(Machine& machine, property::Handle instance, std::string_view name);
/// The formula is the value from now on; adds the property where there is none.
void write_formula(Machine& machine, property::Handle instance, std::string_view name,
                   property::Formula formula);
/// Gives a detached instance its place.
void place(Machine& machine, property::Handle instance, property::Handle parent,
           std::string_view name, bool first_plain);
/// Gives a detached instance the place and the name of another, which is deleted.
void replace(Machine& machine, property::Handle old, property::Handle by);
void destroy(Machine& machine, property::Handle instance);

}  // namespace fettle::script
