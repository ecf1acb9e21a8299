// Descriptions of the kinds of values other than instances.

#include <reference/language.h>

namespace fettle::script {

namespace {

TypeDoc vec_type() {
    return {
        "vec",
        "A vector or point in the plane. One that was read from a property writes back when a "
        "component is assigned: ball.velocity.x = 3.",
        {{"x", "number", "To the right."},
         {"y", "number", "Up."},
         {"angle", "angle(self: vec): number",
          "Its direction in radians, counter-clockwise from the x axis."},
         {"cross", "cross(self: vec, other: vec): number",
          "Cross product: above 0 when the other lies counter-clockwise."},
         {"distance", "distance(self: vec, to: vec): number", "How far it is from another point."},
         {"dot", "dot(self: vec, other: vec): number", "Scalar product."},
         {"floor", "floor(self: vec): vec",
          "Both components rounded down: the cell of a grid in which it lies."},
         {"length", "length(self: vec): number", "How long it is."},
         {"lerp", "lerp(self: vec, to: vec, share: number): vec",
          "The point on the way to the other: 0 is here, 1 is there."},
         {"limited", "limited(self: vec, length: number): vec",
          "The same direction, and not longer than that."},
         {"normalized", "normalized(self: vec): vec",
          "The same direction with length 1; the zero vector stays what it is."},
         {"round", "round(self: vec): vec", "Both components rounded to the nearest whole number."},
         {"rotated", "rotated(self: vec, angle: number): vec",
          "Turned counter-clockwise by an angle in radians."}},
        {"add(vec): vec", "sub(vec): vec", "mul(number): vec", "div(number): vec", "unm: vec"}};
}

TypeDoc color_type() {
    return {"color",
            "A color with opacity. One that was read from a property writes back when a channel is "
            "assigned.",
            {{"r", "number", "Red, 0 to 1."},
             {"g", "number", "Green, 0 to 1."},
             {"b", "number", "Blue, 0 to 1."},
             {"a", "number", "Opacity, 0 to 1."},
             {"lerp", "lerp(self: color, to: color, share: number): color",
              "A color between the two: 0 is this one, 1 the other."}}};
}

TypeDoc set_type() {
    return {"Set",
            "Instances in order: what find, all, children and query return. Its functions work on "
            "all of them at once.",
            {{"[integer]", "Object", "The instances, from 1."},
             {"add", "add(self: Set, property: string, value: any): Set",
              "Adds the value to that property of each."},
             {"delete", "delete(self: Set)", "Deletes them, with everything below."},
             {"each", "each(self: Set, action: fun(instance: Object)): Set",
              "Calls the function with each."},
             {"set", "set(self: Set, property: string, value: any): Set",
              "Writes that property of each; nil restores the default."}}};
}

TypeDoc store_type() {
    return {"Store",
            "Values that outlive a run, in the player's folder for the game: texts, numbers, "
            "booleans, vecs, colors, and tables of these with texts or whole numbers as keys. "
            "Assigning copies a table into the store; what is read from there is the table in the "
            "store, and assigning to it writes: store.levels[3] = true. A name that was never "
            "assigned is nil, and assigning nil removes one. The store is written within a second "
            "and at the end of the run. Going back in time, loading a saved game and restoring a "
            "snapshot leave it as it is. A replay begins with the values of the recorded run and "
            "writes nothing. Formulas cannot read it.",
            {{"[string]", "any", "The values, by names or numbers."},
             {"clear", "clear(self: Store)", "Removes everything."},
             {"has", "has(self: Store, name: string|integer): boolean",
              "Whether there is a value of that name."}}};
}

TypeDoc connection_type() {
    return {"Connection",
            "The result of watch, on, after and every.",
            {{"active", "active(self: Connection): boolean",
              "Whether the function can still be called."},
             {"stop", "stop(self: Connection)", "The function is not called again."}}};
}

TypeDoc change_type() {
    return {"Change",
            "The third argument of a watcher, after the new and the old value.",
            {{"cause", "string",
              "Who wrote it and at which step, as a text for people: \"main.lua:14, step 0\", "
              "\"console:1, step 1\", \"simulation, step 1\", \"undo, step 29\", \"restore, step "
              "23\"."},
             {"instance", "Object", "Whose property it is."},
             {"path", "string", "\"world.ball.mass\"."},
             {"property", "string", "Its name."},
             {"restored", "boolean",
              "Whether rewind, restore or load_game has brought the value back: it is that of "
              "another moment, and nothing has happened in the game."},
             {"step", "integer", "The fixed step in which it was written."}}};
}

TypeDoc deletion_type() {
    return {"Existence",
            "The argument of handlers of the events \"created\" and \"deleted\".",
            {{"cause", "string",
              "Who did it and at which step, as that of a Change: \"main.lua:14, step 0\"."},
             {"instance", "Object",
              "The instance; after its deletion it has only alive(), name, class and is_a()."},
             {"last", "table<string, any>", "After a deletion: its last values by name."},
             {"path", "string",
              "Where it is, or was: \"world.ball\". Undo detaches an instance before it deletes "
              "it, and "
              "then this is \"(detached body)\"."},
             {"step", "integer", "The fixed step in which it happened."}}};
}

TypeDoc formula_type() {
    return {"Formula", "What formula(...) makes: assign it to a property.", {}};
}

TypeDoc snapshot_type() {
    return {"Snapshot", "What snapshot() returns: a whole game at a moment, for restore().", {}};
}

TypeDoc saved_game_type() {
    return {"SavedGame",
            "The description of a saved game that saves() returns.",
            {{"picture", "string?",
              "The image that shows it: Image { image = save.picture }; nil if there is none, "
              "because it was saved without a window."},
             {"problem", "string?", "Why it cannot be loaded; nil when it can."},
             {"slot", "string", "The name it was saved under."},
             {"step", "integer", "The fixed step in which it was saved."},
             {"time", "integer", "Time of the save, in seconds since 1970, as in os.time()."}}};
}

TypeDoc class_type() {
    return {
        "Class",
        "A class: Body { ... } makes an instance. Its members can be read, but not changed.",
        {{"base", "Class?", "The class it derives from; nil for Object."},
         {"creatable", "boolean", "Whether instances can be made; there is one `time` only."},
         {"derived", "Class[]", "The classes that derive from it directly."},
         {"doc", "string", "What it is for."},
         {"events", "EventDescription[]", "Its events, by number and by name."},
         {"methods", "MethodDescription[]", "Its methods, by number and by name."},
         {"name", "string", "What it is called."},
         {"properties", "PropertyDescription[]",
          "Its properties, inherited ones included, by number and by name: "
          "Body.properties.mass.unit."},
         {"states", "table<string, table>",
          "The states of a class that declares some, each a table with enter(self, from), "
          "step(self, dt) and leave(self, to)."},
         {"on", "on(self: Class, event: string, handler: fun(record: any)): Connection",
          "Calls the function when the event happens to any instance; \"created\" and \"deleted\" "
          "are events too."},
         {"watch",
          "watch(self: Class, property: string, handler: fun(new: any, old: any, change: Change)): "
          "Connection\n"
          "watch(self: Class, handler: fun(new: any, old: any, change: Change)): Connection",
          "Calls the function after that property, or any, of any instance has changed."}}};
}

TypeDoc property_description() {
    return {"PropertyDescription",
            "What a property is. Read-only.",
            {{"class", "Class?", "The class that a reference, or a list of them, takes."},
             {"clamp", "boolean", "Whether what is out of range is clamped instead of refused."},
             {"default", "any", "nil if the property is computed."},
             {"derives_from", "string[]", "What it is computed from, as paths from its instance."},
             {"doc", "string", "What it means."},
             {"element", "string?", "Type of a list's elements."},
             {"enumerators", "string[]", "The only texts it takes; empty when it takes any."},
             {"inf", "boolean", "Whether it may be infinite."},
             {"max", "number?", "Greatest value."},
             {"min", "number?", "Least value."},
             {"name", "string", "What it is called."},
             {"nullable", "boolean", "Whether nil is a value of its own."},
             {"owner", "Class?", "The class that declares it; nil for one added to an instance."},
             {"read_only", "boolean", "Whether it can only be read."},
             {"simulated", "boolean", "Whether the simulation changes it."},
             {"transient", "boolean", "Whether scene files leave it out."},
             {"type", "string", "\"number\", \"vec2\", \"text\" ..."},
             {"unit", "string", "\"kg\", \"m/s\"; \"\" where it has none."}}};
}

TypeDoc method_description() {
    return {"MethodDescription",
            "What a method is. Read-only.",
            {{"doc", "string", "What it does."},
             {"many", "boolean", "Whether it returns a list of records."},
             {"name", "string", "What it is called."},
             {"owner", "Class?", "The class that declares it."},
             {"parameters", "FieldDescription[]", "What it takes."},
             {"pure", "boolean", "Whether it changes nothing, so that formulas can call it."},
             {"returns", "FieldDescription[]",
              "What it returns: fields of a record, or one entry for a plain value."},
             {"signature", "string", "As help shows it."}}};
}

TypeDoc event_description() {
    return {"EventDescription",
            "What an event is. Read-only.",
            {{"doc", "string", "When it happens."},
             {"fields", "FieldDescription[]", "The fields of the record that handlers get."},
             {"name", "string", "What it is called."},
             {"owner", "Class?", "The class that declares it."}}};
}

TypeDoc field_description() {
    return {"FieldDescription",
            "What a parameter, or a field of a result, is. Read-only.",
            {{"class", "Class?", "The class of a reference, or of a list of them."},
             {"doc", "string", "What it means."},
             {"element", "string?", "Type of a list's elements."},
             {"name", "string", "What it is called."},
             {"nullable", "boolean", "Whether it may be nil."},
             {"optional", "boolean", "Whether a parameter may be left out."},
             {"type", "string", "\"number\", \"vec2\", \"text\" ..."},
             {"unit", "string", "\"m\", \"N s\"; \"\" where it has none."}}};
}

TypeDoc pen_type() {
    TypeDoc pen{
        "Pen",
        "What draw(pen) draws with: world units, y up; inside pen.screen(...) pixels, y down. "
        "Colors are values or names. A fill of false draws none; without one, or with nil, a "
        "figure "
        "is white unless it has a border. A border of nil or false draws none. Lines, points and "
        "texts are white unless they have a color. Borders and lines are measured in pixels, 1.5 "
        "unless a width is given.",
        {{"arc",
          "arc(center: vec, radius: number, from: number, to: number, stroke?: color|string, "
          "width?: number)",
          "A line along a part of a circle, from one angle to the other, in radians: "
          "counter-clockwise if `to` is larger. pen.pie fills such a part."},
         {"box",
          "box(center: vec, width: number, height: number, fill?: color|string|false, border?: "
          "color|string|false, border_width?: number, angle?: number, rounding?: number)",
          "A rectangle, turned by an angle in radians, with corners of the radius `rounding`."},
         {"blend", "blend(mode: \"normal\"|\"add\"|\"multiply\")",
          "How the colors of what follows are put on what is there, until pen.pop() or the end of "
          "the function."},
         {"circle",
          "circle(center: vec, radius: number, fill?: color|string|false, border?: "
          "color|string|false, border_width?: number)",
          "A circle."},
         {"clip", "clip(lower: vec, upper: vec)",
          "What follows is drawn only inside of this box, until pen.pop() or the end of the "
          "function."},
         {"ellipse",
          "ellipse(center: vec, width: number, height: number, fill?: color|string|false, border?: "
          "color|string|false, border_width?: number, angle?: number)",
          "An ellipse, turned by an angle in radians."},
         {"fade", "fade(opacity: number)",
          "Multiplies the opacity of what follows, until pen.pop() or the end of the function."},
         {"image",
          "image(file: string|table, center: vec, width?: number, height?: number, angle?: number, "
          "tint?: "
          "color|string, smooth?: boolean)",
          "An image file of the game, with 32 of its pixels in a meter, and in its own size inside "
          "pen.screen. With one length it keeps its proportions. A table is a frame of a sheet: "
          "{ \"walk.png\", columns = 4, rows = 2, frame = 3 }, or of an export of Aseprite "
          "{ \"walk.json\", frame = 3 }."},
         {"line",
          "line(from: vec, to: vec, stroke?: color|string, width?: number)\nline(points: vec[], "
          "stroke?: color|string, width?: number)",
          "A line between two points, or through all points of a list."},
         {"linear", "linear(from: vec, to: vec, colors: color[]|string[])",
          "The fill of the circles, boxes and polygons that follow changes its color along this "
          "line, until pen.pop() or the end of the function."},
         {"pie",
          "pie(center: vec, radius: number, from: number, to: number, fill?: color|string|false, "
          "border?: color|string|false, border_width?: number)",
          "A piece of a circle from one angle to the other, in radians: counter-clockwise if `to` "
          "is larger."},
         {"point", "point(position: vec, fill?: color|string, size?: number)",
          "A dot as many pixels wide as its size says, 4 without one."},
         {"polygon",
          "polygon(vertices: vec[], fill?: color|string|false, border?: color|string|false, "
          "border_width?: number)",
          "A polygon of three or more vertices, convex or not. If its outline crosses itself, "
          "every area that the outline encloses is filled, and the border follows every line."},
         {"pop", "pop()", "Ends what the last pen.push began."},
         {"push", "push(position?: vec, angle?: number, scale?: number)",
          "What is drawn next is scaled, turned and moved by this, until pen.pop() or the end of "
          "the "
          "function. Widths of borders and lines stay as they are."},
         {"radial", "radial(center: vec, radius: number, colors: color[]|string[])",
          "The fill of the circles, boxes and polygons that follow changes its color from the "
          "center outwards, until pen.pop() or the end of the function."},
         {"screen", "screen(action: fun(pen: Pen))",
          "What the function draws is measured in pixels from the upper left corner."},
         {"text",
          "text(position: vec, text: any, height?: number, fill?: color|string, align?: "
          "\"middle\"|\"left\"|\"right\", font?: string, wrap?: number, outline?: color|string)",
          "A text, half a meter high unless a height is given, and 16 pixels inside pen.screen; "
          "the "
          "position is the middle of its height. It may have several lines, each aligned by "
          "itself, "
          "in the middle unless another alignment is given, and tabs: a line goes on at the next "
          "multiple of twice the height that leaves room for a space. Fonts are sans, bold, mono "
          "and "
          "font files of the game. A line that would be wider than wrap goes on in the next line, "
          "at a space. With a color as outline, the letters have a line of it around them."},
         {"text_size",
          "text_size(text: any, height?: number, font?: string, wrap?: number): number, number",
          "Returns the width and the height of a text."}}};
    pen.by_dot = true;
    return pen;
}

}  // namespace

const std::vector<TypeDoc>& type_docs() {
    static const std::vector<TypeDoc> docs = {
        vec_type(),
        color_type(),
        set_type(),
        store_type(),
        connection_type(),
        change_type(),
        deletion_type(),
        formula_type(),
        snapshot_type(),
        saved_game_type(),
        pen_type(),
        class_type(),
        property_description(),
        method_description(),
        event_description(),
        field_description(),
    };
    return docs;
}

}  // namespace fettle::script
