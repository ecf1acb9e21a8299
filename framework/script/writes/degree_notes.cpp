#include <string>

#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <values/recording.h>
#include <writes/degree_notes.h>

namespace fettle::script {

void note_degrees(Machine& machine, Handle instance, const Property& property, double value) {
    constexpr std::size_t most = 20;  // notes for one game
    Recording& recording = machine.recording;
    if (!looks_like_degrees(property, value) || recording.active || !machine.host.on_note) return;
    const std::string of = machine.tree.class_of(instance).name() + "." + property.name;
    if (recording.degrees.size() >= most || !recording.degrees.insert(of).second) return;
    const std::string number = property::number_text(value);
    machine.host.on_note(position(machine.lua.running) + of + " = " + number +
                         " is in radians; for degrees write deg(" + number + ")");
}

}  // namespace fettle::script
