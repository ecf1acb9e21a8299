// Descriptions of the methods that every instance has.

#include <reference/language.h>

namespace fettle::script {

const std::vector<GlobalDoc>& instance_docs() {
    static const std::vector<GlobalDoc> docs = {
        {"add", "add(self: Object, child: Object, name?: string): Object",
         "Makes a new instance a child of this one and returns it."},
        {"after",
         "after(self: Object, seconds: number, action: fun(self: Object), options?: table): "
         "Connection",
         "Calls the function once with the instance, after that much simulation time, unless the "
         "instance is deleted before. { pauses = false }: after real time."},
        {"alive", "alive(self: Object): boolean", "Whether it has not been deleted."},
        {"all", "all(self: Object, class?: Class|string): Set",
         "Everything below of that class, as a set with :set and :add."},
        {"children", "children(self: Object, class?: Class|string): Set",
         "Its children, as a set."},
        {"clone", "clone(self: Object): Object",
         "A detached copy of it and everything below, with the present values of formulas, and "
         "without handlers of single instances."},
        {"delete", "delete(self: Object)", "Deletes it and everything below."},
        {"describe",
         "describe(self: Object): PropertyDescription[]\n"
         "describe(self: Object, name: string): "
         "PropertyDescription|MethodDescription|EventDescription",
         "What it has: all its properties, or one property, method or event by name."},
        {"each",
         "each(self: Object, class: Class|string, action: fun(instance: Object))\n"
         "each(self: Object, action: fun(instance: Object))",
         "Calls the function with everything below of that class."},
        {"every",
         "every(self: Object, seconds: number, action: fun(self: Object), options?: table): "
         "Connection",
         "Calls the function with the instance repeatedly at that interval of simulation time, 0 "
         "meaning every step, until the instance is deleted. { pauses = false }: in real time, 0 "
         "meaning every picture."},
        {"find",
         "find(self: Object, class: Class|string, condition?: fun(instance: Object): boolean): Set",
         "Everything below of that class for which the condition holds, as a set."},
        {"formula", "formula(self: Object, property: string): function?",
         "The function that is the property's value, or nil."},
        {"has", "has(self: Object, name: string): boolean",
         "Whether it has a property or child of that name."},
        {"is_a", "is_a(self: Object, class: Class|string): boolean",
         "Whether it is of that class or of one derived from it."},
        {"move", "move(self: Object, parent?: Object, name?: string): Object",
         "Gives it another parent; nil detaches it."},
        {"on", "on(self: Object, event: string, handler: fun(record: any)): Connection",
         "Calls the function with a record when the instance has the event."},
        {"problem", "problem(self: Object, property: string): string?",
         "What is wrong with the property's formula, or nil."},
        {"run", "run(self: Object, action: fun(self: Object)): thread",
         "Runs the function with the instance as a coroutine, which may call wait(). It ends "
         "where it waits when the instance is deleted, or by coroutine.close(thread)."},
        {"send", "send(self: Object, event: string, data?: table)",
         "Lets the instance have an event that its class declares, as in class(\"Foe\", Body) { "
         "events = { \"died\", hit = { by = \"\", damage = 0 } } }. What `data` leaves out has the "
         "value of the declaration. Handlers are called at the end of the step, as for other "
         "events."},
        {"tween",
         "tween(self: Object, property: string, to: any, seconds: number, ease?: "
         "string|number[]|fun(time: number): number, options?: table): Tween",
         "The same as tween(instance, ...): moves a property to a value. It ends with the "
         "instance."},
        {"watch",
         "watch(self: Object, property: string, handler: fun(new: any, old: any, change: Change)): "
         "Connection\n"
         "watch(self: Object, handler: fun(new: any, old: any, change: Change)): Connection",
         "Calls the function after that property, or any, has changed."},
    };
    return docs;
}

}  // namespace fettle::script
