---@meta fettle
-- Written by `fettle docs`.

---A vector or point in the plane. One that was read from a property writes back when a component is assigned: ball.velocity.x = 3.
---@class vec
---@field x number To the right.
---@field y number Up.
---@operator add(vec): vec
---@operator sub(vec): vec
---@operator mul(number): vec
---@operator div(number): vec
---@operator unm: vec
local fettle_vec = {}

---Its direction in radians, counter-clockwise from the x axis.
---@return number
function fettle_vec:angle() end

---Cross product: above 0 when the other lies counter-clockwise.
---@param other vec
---@return number
function fettle_vec:cross(other) end

---How far it is from another point.
---@param to vec
---@return number
function fettle_vec:distance(to) end

---Scalar product.
---@param other vec
---@return number
function fettle_vec:dot(other) end

---Both components rounded down: the cell of a grid in which it lies.
---@return vec
function fettle_vec:floor() end

---How long it is.
---@return number
function fettle_vec:length() end

---The point on the way to the other: 0 is here, 1 is there.
---@param to vec
---@param share number
---@return vec
function fettle_vec:lerp(to, share) end

---The same direction, and not longer than that.
---@param length number
---@return vec
function fettle_vec:limited(length) end

---The same direction with length 1; the zero vector stays what it is.
---@return vec
function fettle_vec:normalized() end

---Both components rounded to the nearest whole number.
---@return vec
function fettle_vec:round() end

---Turned counter-clockwise by an angle in radians.
---@param angle number
---@return vec
function fettle_vec:rotated(angle) end

---A color with opacity. One that was read from a property writes back when a channel is assigned.
---@class color
---@field r number Red, 0 to 1.
---@field g number Green, 0 to 1.
---@field b number Blue, 0 to 1.
---@field a number Opacity, 0 to 1.
local fettle_color = {}

---A color between the two: 0 is this one, 1 the other.
---@param to color
---@param share number
---@return color
function fettle_color:lerp(to, share) end

---Instances in order: what find, all, children and query return. Its functions work on all of them at once.
---@class Set
---@field [integer] Object The instances, from 1.
local fettle_Set = {}

---Adds the value to that property of each.
---@param property string
---@param value any
---@return Set
function fettle_Set:add(property, value) end

---Deletes them, with everything below.
function fettle_Set:delete() end

---Calls the function with each.
---@param action fun(instance: Object)
---@return Set
function fettle_Set:each(action) end

---Writes that property of each; nil restores the default.
---@param property string
---@param value any
---@return Set
function fettle_Set:set(property, value) end

---Values that outlive a run, in the player's folder for the game: texts, numbers, booleans, vecs, colors, and tables of these with texts or whole numbers as keys. Assigning copies a table into the store; what is read from there is the table in the store, and assigning to it writes: store.levels[3] = true. A name that was never assigned is nil, and assigning nil removes one. The store is written within a second and at the end of the run. Going back in time, loading a saved game and restoring a snapshot leave it as it is. A replay begins with the values of the recorded run and writes nothing. Formulas cannot read it.
---@class Store
---@field [string] any The values, by names or numbers.
local fettle_Store = {}

---Removes everything.
function fettle_Store:clear() end

---Whether there is a value of that name.
---@param name string|integer
---@return boolean
function fettle_Store:has(name) end

---The result of watch, on, after and every.
---@class Connection
local fettle_Connection = {}

---Whether the function can still be called.
---@return boolean
function fettle_Connection:active() end

---The function is not called again.
function fettle_Connection:stop() end

---The third argument of a watcher, after the new and the old value.
---@class Change
---@field cause string Who wrote it and at which step, as a text for people: "main.lua:14, step 0", "console:1, step 1", "simulation, step 1", "undo, step 29", "restore, step 23".
---@field instance Object Whose property it is.
---@field path string "world.ball.mass".
---@field property string Its name.
---@field restored boolean Whether rewind, restore or load_game has brought the value back: it is that of another moment, and nothing has happened in the game.
---@field step integer The fixed step in which it was written.
local fettle_Change = {}

---The argument of handlers of the events "created" and "deleted".
---@class Existence
---@field cause string Who did it and at which step, as that of a Change: "main.lua:14, step 0".
---@field instance Object The instance; after its deletion it has only alive(), name, class and is_a().
---@field last table<string, any> After a deletion: its last values by name.
---@field path string Where it is, or was: "world.ball". Undo detaches an instance before it deletes it, and then this is "(detached body)".
---@field step integer The fixed step in which it happened.
local fettle_Existence = {}

---What formula(...) makes: assign it to a property.
---@class Formula
local fettle_Formula = {}

---What snapshot() returns: a whole game at a moment, for restore().
---@class Snapshot
local fettle_Snapshot = {}

---The description of a saved game that saves() returns.
---@class SavedGame
---@field picture string? The image that shows it: Image { image = save.picture }; nil if there is none, because it was saved without a window.
---@field problem string? Why it cannot be loaded; nil when it can.
---@field slot string The name it was saved under.
---@field step integer The fixed step in which it was saved.
---@field time integer Time of the save, in seconds since 1970, as in os.time().
local fettle_SavedGame = {}

---What draw(pen) draws with: world units, y up; inside pen.screen(...) pixels, y down. Colors are values or names. A fill of false draws none; without one, or with nil, a figure is white unless it has a border. A border of nil or false draws none. Lines, points and texts are white unless they have a color. Borders and lines are measured in pixels, 1.5 unless a width is given.
---@class Pen
local fettle_Pen = {}

---A line along a part of a circle, from one angle to the other, in radians: counter-clockwise if `to` is larger. pen.pie fills such a part.
---@param center vec
---@param radius number
---@param from number
---@param to number
---@param stroke? color|string
---@param width? number
function fettle_Pen.arc(center, radius, from, to, stroke, width) end

---A rectangle, turned by an angle in radians, with corners of the radius `rounding`.
---@param center vec
---@param width number
---@param height number
---@param fill? color|string|false
---@param border? color|string|false
---@param border_width? number
---@param angle? number
---@param rounding? number
function fettle_Pen.box(center, width, height, fill, border, border_width, angle, rounding) end

---How the colors of what follows are put on what is there, until pen.pop() or the end of the function.
---@param mode "normal"|"add"|"multiply"
function fettle_Pen.blend(mode) end

---A circle.
---@param center vec
---@param radius number
---@param fill? color|string|false
---@param border? color|string|false
---@param border_width? number
function fettle_Pen.circle(center, radius, fill, border, border_width) end

---What follows is drawn only inside of this box, until pen.pop() or the end of the function.
---@param lower vec
---@param upper vec
function fettle_Pen.clip(lower, upper) end

---An ellipse, turned by an angle in radians.
---@param center vec
---@param width number
---@param height number
---@param fill? color|string|false
---@param border? color|string|false
---@param border_width? number
---@param angle? number
function fettle_Pen.ellipse(center, width, height, fill, border, border_width, angle) end

---Multiplies the opacity of what follows, until pen.pop() or the end of the function.
---@param opacity number
function fettle_Pen.fade(opacity) end

---An image file of the game, with 32 of its pixels in a meter, and in its own size inside pen.screen. With one length it keeps its proportions. A table is a frame of a sheet: { "walk.png", columns = 4, rows = 2, frame = 3 }, or of an export of Aseprite { "walk.json", frame = 3 }.
---@param file string|table
---@param center vec
---@param width? number
---@param height? number
---@param angle? number
---@param tint? color|string
---@param smooth? boolean
function fettle_Pen.image(file, center, width, height, angle, tint, smooth) end

---A line between two points, or through all points of a list.
---@param from vec
---@param to vec
---@param stroke? color|string
---@param width? number
---@overload fun(points: vec[], stroke?: color|string, width?: number)
function fettle_Pen.line(from, to, stroke, width) end

---The fill of the circles, boxes and polygons that follow changes its color along this line, until pen.pop() or the end of the function.
---@param from vec
---@param to vec
---@param colors color[]|string[]
function fettle_Pen.linear(from, to, colors) end

---A piece of a circle from one angle to the other, in radians: counter-clockwise if `to` is larger.
---@param center vec
---@param radius number
---@param from number
---@param to number
---@param fill? color|string|false
---@param border? color|string|false
---@param border_width? number
function fettle_Pen.pie(center, radius, from, to, fill, border, border_width) end

---A dot as many pixels wide as its size says, 4 without one.
---@param position vec
---@param fill? color|string
---@param size? number
function fettle_Pen.point(position, fill, size) end

---A polygon of three or more vertices, convex or not. If its outline crosses itself, every area that the outline encloses is filled, and the border follows every line.
---@param vertices vec[]
---@param fill? color|string|false
---@param border? color|string|false
---@param border_width? number
function fettle_Pen.polygon(vertices, fill, border, border_width) end

---Ends what the last pen.push began.
function fettle_Pen.pop() end

---What is drawn next is scaled, turned and moved by this, until pen.pop() or the end of the function. Widths of borders and lines stay as they are.
---@param position? vec
---@param angle? number
---@param scale? number
function fettle_Pen.push(position, angle, scale) end

---The fill of the circles, boxes and polygons that follow changes its color from the center outwards, until pen.pop() or the end of the function.
---@param center vec
---@param radius number
---@param colors color[]|string[]
function fettle_Pen.radial(center, radius, colors) end

---What the function draws is measured in pixels from the upper left corner.
---@param action fun(pen: Pen)
function fettle_Pen.screen(action) end

---A text, half a meter high unless a height is given, and 16 pixels inside pen.screen; the position is the middle of its height. It may have several lines, each aligned by itself, in the middle unless another alignment is given, and tabs: a line goes on at the next multiple of twice the height that leaves room for a space. Fonts are sans, bold, mono and font files of the game. A line that would be wider than wrap goes on in the next line, at a space. With a color as outline, the letters have a line of it around them.
---@param position vec
---@param text any
---@param height? number
---@param fill? color|string
---@param align? "middle"|"left"|"right"
---@param font? string
---@param wrap? number
---@param outline? color|string
function fettle_Pen.text(position, text, height, fill, align, font, wrap, outline) end

---Returns the width and the height of a text.
---@param text any
---@param height? number
---@param font? string
---@param wrap? number
---@return number
---@return number
function fettle_Pen.text_size(text, height, font, wrap) end

---A class: Body { ... } makes an instance. Its members can be read, but not changed.
---@class Class
---@field base Class? The class it derives from; nil for Object.
---@field creatable boolean Whether instances can be made; there is one `time` only.
---@field derived Class[] The classes that derive from it directly.
---@field doc string What it is for.
---@field events EventDescription[] Its events, by number and by name.
---@field methods MethodDescription[] Its methods, by number and by name.
---@field name string What it is called.
---@field properties PropertyDescription[] Its properties, inherited ones included, by number and by name: Body.properties.mass.unit.
---@field states table<string, table> The states of a class that declares some, each a table with enter(self, from), step(self, dt) and leave(self, to).
local fettle_Class = {}

---Calls the function when the event happens to any instance; "created" and "deleted" are events too.
---@param event string
---@param handler fun(record: any)
---@return Connection
function fettle_Class:on(event, handler) end

---Calls the function after that property, or any, of any instance has changed.
---@param property string
---@param handler fun(new: any, old: any, change: Change)
---@return Connection
---@overload fun(self: Class, handler: fun(new: any, old: any, change: Change)): Connection
function fettle_Class:watch(property, handler) end

---What a property is. Read-only.
---@class PropertyDescription
---@field class Class? The class that a reference, or a list of them, takes.
---@field clamp boolean Whether what is out of range is clamped instead of refused.
---@field default any nil if the property is computed.
---@field derives_from string[] What it is computed from, as paths from its instance.
---@field doc string What it means.
---@field element string? Type of a list's elements.
---@field enumerators string[] The only texts it takes; empty when it takes any.
---@field inf boolean Whether it may be infinite.
---@field max number? Greatest value.
---@field min number? Least value.
---@field name string What it is called.
---@field nullable boolean Whether nil is a value of its own.
---@field owner Class? The class that declares it; nil for one added to an instance.
---@field read_only boolean Whether it can only be read.
---@field simulated boolean Whether the simulation changes it.
---@field transient boolean Whether scene files leave it out.
---@field type string "number", "vec2", "text" ...
---@field unit string "kg", "m/s"; "" where it has none.
local fettle_PropertyDescription = {}

---What a method is. Read-only.
---@class MethodDescription
---@field doc string What it does.
---@field many boolean Whether it returns a list of records.
---@field name string What it is called.
---@field owner Class? The class that declares it.
---@field parameters FieldDescription[] What it takes.
---@field pure boolean Whether it changes nothing, so that formulas can call it.
---@field returns FieldDescription[] What it returns: fields of a record, or one entry for a plain value.
---@field signature string As help shows it.
local fettle_MethodDescription = {}

---What an event is. Read-only.
---@class EventDescription
---@field doc string When it happens.
---@field fields FieldDescription[] The fields of the record that handlers get.
---@field name string What it is called.
---@field owner Class? The class that declares it.
local fettle_EventDescription = {}

---What a parameter, or a field of a result, is. Read-only.
---@class FieldDescription
---@field class Class? The class of a reference, or of a list of them.
---@field doc string What it means.
---@field element string? Type of a list's elements.
---@field name string What it is called.
---@field nullable boolean Whether it may be nil.
---@field optional boolean Whether a parameter may be left out.
---@field type string "number", "vec2", "text" ...
---@field unit string "m", "N s"; "" where it has none.
local fettle_FieldDescription = {}

---It has been made, with all its properties and children.
---@class Object.ready
---@field instance Object The instance with the event.
---@field step integer The fixed step in which it happened.

---A plain node: a place for children and for properties of your own.
---@class Object
---@field class string The name of its class. · any text · read-only
---@field name string Its name among the children of its parent: the last part of its path. · any text · default computed · not saved
---@field parent Object? The instance of which it is a child. · any instance · default computed · not saved
---@field z number The order of drawing: a larger z is drawn later, over a smaller one; equal ones in the order of the tree. It is added to the z of everything below. · -1e9 to 1e9 · default 0
local fettle_Object = {}

---Makes a new instance a child of this one and returns it.
---@param child Object
---@param name? string
---@return Object
function fettle_Object:add(child, name) end

---Calls the function once with the instance, after that much simulation time, unless the instance is deleted before. { pauses = false }: after real time.
---@param seconds number
---@param action fun(self: Object)
---@param options? table
---@return Connection
function fettle_Object:after(seconds, action, options) end

---Whether it has not been deleted.
---@return boolean
function fettle_Object:alive() end

---Everything below of that class, as a set with :set and :add.
---@param class? Class|string
---@return Set
function fettle_Object:all(class) end

---Its children, as a set.
---@param class? Class|string
---@return Set
function fettle_Object:children(class) end

---A detached copy of it and everything below, with the present values of formulas, and without handlers of single instances.
---@return Object
function fettle_Object:clone() end

---Deletes it and everything below.
function fettle_Object:delete() end

---What it has: all its properties, or one property, method or event by name.
---@return PropertyDescription[]
---@overload fun(self: Object, name: string): PropertyDescription|MethodDescription|EventDescription
function fettle_Object:describe() end

---Calls the function with everything below of that class.
---@param class Class|string
---@param action fun(instance: Object)
---@overload fun(self: Object, action: fun(instance: Object))
function fettle_Object:each(class, action) end

---Calls the function with the instance repeatedly at that interval of simulation time, 0 meaning every step, until the instance is deleted. { pauses = false }: in real time, 0 meaning every picture.
---@param seconds number
---@param action fun(self: Object)
---@param options? table
---@return Connection
function fettle_Object:every(seconds, action, options) end

---Everything below of that class for which the condition holds, as a set.
---@param class Class|string
---@param condition? fun(instance: Object): boolean
---@return Set
function fettle_Object:find(class, condition) end

---The function that is the property's value, or nil.
---@param property string
---@return function?
function fettle_Object:formula(property) end

---Whether it has a property or child of that name.
---@param name string
---@return boolean
function fettle_Object:has(name) end

---Whether it is of that class or of one derived from it.
---@param class Class|string
---@return boolean
function fettle_Object:is_a(class) end

---Gives it another parent; nil detaches it.
---@param parent? Object
---@param name? string
---@return Object
function fettle_Object:move(parent, name) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Object, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Object, event: "deleted", handler: fun(record: Existence)): Connection
function fettle_Object:on(event, handler) end

---What is wrong with the property's formula, or nil.
---@param property string
---@return string?
function fettle_Object:problem(property) end

---Runs the function with the instance as a coroutine, which may call wait(). It ends where it waits when the instance is deleted, or by coroutine.close(thread).
---@param action fun(self: Object)
---@return thread
function fettle_Object:run(action) end

---Lets the instance have an event that its class declares, as in class("Foe", Body) { events = { "died", hit = { by = "", damage = 0 } } }. What `data` leaves out has the value of the declaration. Handlers are called at the end of the step, as for other events.
---@param event string
---@param data? table
function fettle_Object:send(event, data) end

---The same as tween(instance, ...): moves a property to a value. It ends with the instance.
---@param property string
---@param to any
---@param seconds number
---@param ease? string|number[]|fun(time: number): number
---@param options? table
---@return Tween
function fettle_Object:tween(property, to, seconds, ease, options) end

---Calls the function after that property, or any, has changed.
---@param property string
---@param handler fun(new: any, old: any, change: Change)
---@return Connection
---@overload fun(self: Object, handler: fun(new: any, old: any, change: Change)): Connection
function fettle_Object:watch(property, handler) end

---Its angle in the world, in the picture that is being drawn. Outside of `draw`: that after the last step.
---@return number angle Counter-clockwise. · rad
function fettle_Object:drawn_angle() end

---Where it is in the picture that is being drawn: pictures are drawn between the last two steps. Outside of `draw`: where it is after the last step. Without a `position`, it is where its parent is.
---@return vec position The position in the world. · m
function fettle_Object:drawn_position() end

---Where a point of it is in the picture that is being drawn. Outside of `draw`: where it is after the last step.
---@param point vec A point in its own coordinates. · m
---@return vec point The point in the world. · m
function fettle_Object:to_drawn(point) end

---A plain node: a place for children and for properties of your own.
---@class Class.Object : Class
---@overload fun(members?: table): Object
Object = {}

---A snapshot was restored, or time rewound: everything in the tree is as it was then. Variables of scripts that are not in the tree are not.
---@class Game.restored
---@field step integer Where simulation time goes on from.
---@field left integer The step at which the game was before.
---@field instance Game The instance with the event.

---The root of the tree: its children are the services and whatever a game puts beside them.
---@class Game : Object
---@field audio Audio Everything that is heard.
---@field console Console The in-game console and inspector.
---@field input Input What the player does: keys, mouse, gamepads, and the actions bound to them.
---@field interface Interface What all widgets have in common.
---@field time Time Simulation time: how fast it passes, and how much has passed.
---@field view View Which part of the world is seen, and what lies over it.
---@field world World Bodies below it are simulated together. Its child `step` describes the last step.
local fettle_Game = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Game, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Game, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Game, event: "restored", handler: fun(record: Game.restored)): Connection
function fettle_Game:on(event, handler) end

---The root of the tree: its children are the services and whatever a game puts beside them.
---@class Class.Game : Class
Game = {}

---Statistics of the last step of a world, and the time that it took.
---@class StepStatistics : Object
---@field awake_bodies integer Number of bodies that took part in the step. · any integer · read-only, simulated
---@field awake_contacts integer Number of pairs of shapes near each other with a body that is awake. · any integer · read-only, simulated
---@field awake_joints integer Number of joints on a body that is awake. · any integer · read-only, simulated
---@field bodies integer Number of bodies in the world. · any integer · read-only, simulated
---@field contacts integer Number of pairs of shapes near each other. · any integer · read-only, simulated
---@field direct_failures integer Number of problems too large for the direct solver, or without a solution, which were solved by iteration instead. · any integer · read-only, simulated
---@field direct_solves integer Number of problems that the direct solver solved: two in a part of a step for every group of bodies that touch. · any integer · read-only, simulated
---@field edits_ms number Time to bring edited data up to date. · ms · any finite number · read-only, simulated
---@field finish_ms number Time of poses, boxes and continuous collision. · ms · any finite number · read-only, simulated
---@field islands integer Number of groups of bodies that sleep together. · any integer · read-only, simulated
---@field joints integer Number of joints that act on a body. · any integer · read-only, simulated
---@field moved_proxies integer Number of shapes that left their box in the tree. · any integer · read-only, simulated
---@field narrow_ms number Time of the manifolds. · ms · any finite number · read-only, simulated
---@field pairs_ms number Time of the broad phase. · ms · any finite number · read-only, simulated
---@field shapes integer Number of shapes of all bodies. · any integer · read-only, simulated
---@field sleep_ms number Time to find resting bodies. · ms · any finite number · read-only, simulated
---@field solve_ms number Time of forces, contacts and joints. · ms · any finite number · read-only, simulated
---@field steps integer Number of steps since the world was made. · any integer · read-only, simulated
---@field total_ms number Time of the whole step. · ms · any finite number · read-only, simulated
---@field touching integer Number of pairs near enough to be solved. · any integer · read-only, simulated
local fettle_StepStatistics = {}

---Statistics of the last step of a world, and the time that it took.
---@class Class.StepStatistics : Class
StepStatistics = {}

---Asked in the step when two shapes whose filters agree come near each other: whether they collide. The handler cannot write anything else.
---@class World.filter_pair
---@field shape Object One of the two shapes; nil for the bounds of the world and the capsule of a mover.
---@field other_shape Object The second shape; nil for the capsule of a mover.
---@field body Object Body of the first shape; the world itself for its bounds.
---@field other Object Body of the second shape.
---@field collide boolean True if they collide; may be changed.
---@field instance World The instance with the event.
---@field step integer The fixed step in which it happened.

---Asked in the step for every contact: the friction and restitution of two surfaces together. The handler cannot write anything else.
---@class World.mix_surfaces
---@field shape Object One of the two shapes; nil for the bounds of the world and the capsule of a mover.
---@field other_shape Object The second shape; nil for the capsule of a mover.
---@field body Object Body of the first shape; the world itself for its bounds.
---@field other Object Body of the second shape.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from the first shape to the second.
---@field impulse number Impulse between them in the step before. · N s
---@field speed number Speed at which they approach each other. · m/s
---@field friction number Friction mixed by the rule of the world; may be changed.
---@field restitution number Restitution mixed by the rule of the world; may be changed.
---@field surface_speed number Speed of both surfaces together; may be changed. · m/s
---@field instance World The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape nearest to a point, or nil. Sensors and the bounds do not count.
---@class World.closest.result
---@field shape Shape? The nearest shape; nil for the bounds of the world and the capsule of a mover.
---@field body Object Its body.
---@field point vec The nearest point of its surface in the world; inside of the shape, the given point. · m
---@field normal vec Normal of the surface at the point, outward; the zero vector inside of the shape.
---@field distance number 0 inside. · m

---Every point at which two bodies touch now.
---@class World.contacts.result
---@field body_a Body One of the two bodies.
---@field body_b Object The other body; the world itself for its bounds.
---@field shape_a Shape? The shape of body_a; nil for the capsule of a mover.
---@field shape_b Shape? The shape of body_b; nil for the bounds and the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from a to b; its length is 1.
---@field separation number Distance of the surfaces; below 0: the depth of their overlap. · m
---@field force number Force that separates them. · N

---Distance between two shapes or bodies.
---@class World.distance.result
---@field distance number Distance; 0 if they overlap. · m
---@field point_a vec The point of the first that is nearest to the second. · m
---@field point_b vec The point of the second that is nearest to the first. · m
---@field normal vec Direction from the first to the second; the zero vector if they overlap.

---What will move in the next seconds, and where, if only the physics goes on: a copy of the world makes the steps, with the length of the last step. This world does not change, and no function of a script is called: what scripts would do in `step` or in handlers is not in it. With more than 2500 bodies awake it ends earlier: after 300 000 bodies times steps.
---@class World.ghosts.result
---@field body Body A body that will move.
---@field points vec[] Its position now and after each step. · m
---@field angle number Its angle at the end. · rad

---The first shape that a ray hits, or nil. Sensors and shapes in which the ray begins do not count.
---@class World.raycast.result
---@field shape Shape? The shape that was hit; nil for the bounds of the world and the capsule of a mover.
---@field body Object The body of the shape; the world itself for its bounds.
---@field point vec Point of the hit in the world. · m
---@field normal vec Normal of the surface at the point, outward; its length is 1. If a shape that is cast overlaps the other one from the beginning: against the motion.
---@field fraction number Distance along the ray, as a share from 0 to 1.

---Every shape that a ray hits, the nearest first. Sensors and shapes in which the ray begins do not count.
---@class World.raycast_all.result
---@field shape Shape? The shape that was hit; nil for the bounds of the world and the capsule of a mover.
---@field body Object The body of the shape; the world itself for its bounds.
---@field point vec Point of the hit in the world. · m
---@field normal vec Normal of the surface at the point, outward; its length is 1. If a shape that is cast overlaps the other one from the beginning: against the motion.
---@field fraction number Distance along the ray, as a share from 0 to 1.

---The first shape that a moving shape or body would hit, or nil. Sensors do not count.
---@class World.shapecast.result
---@field shape Shape? The shape that was hit; nil for the bounds of the world and the capsule of a mover.
---@field body Object The body of the shape; the world itself for its bounds.
---@field point vec Point of the hit in the world. · m
---@field normal vec Normal of the surface at the point, outward; its length is 1. If a shape that is cast overlaps the other one from the beginning: against the motion.
---@field fraction number Distance along the ray, as a share from 0 to 1.

---Bodies below it are simulated together. Its child `step` describes the last step.
---@class World : Object
---@field bounds vec[]? Walls around the world, given by their lower left and upper right corner; nil: none. They are of category 1, so a shape whose `mask` lacks that bit passes through them. · m · -1e8 to 1e8 · default nil · may be nil
---@field bounds_friction number Friction of the walls of the bounds. · at least 0 · default 0.6
---@field bounds_restitution number Share of the speed with which bodies separate from the walls of the bounds. · 0 to 1 · default 0
---@field contact_damping number Damping ratio of contacts. · at least 0 · default 10
---@field contact_hertz number Stiffness of contacts, at most a quarter of the rate of sub-steps. · Hz · at least 0 · default 60
---@field continuous boolean True if bodies cannot pass through static ones at any speed. · true or false · default true
---@field friction_mix "average"|"minimum"|"maximum"|"multiply"|"geometric" Friction of a contact from those of its two surfaces: "geometric" is the root of their product. · "average", "minimum", "maximum", "multiply", "geometric" · default "geometric"
---@field gravity vec Acceleration of every dynamic body, times its gravity_scale. · m/s² · any finite vec · default vec(0, -10)
---@field hit_threshold number Slower impacts cause no contact_hit. · m/s · at least 0 · default 1
---@field max_speed number Limit of the speed of every body. Body.max_speed is the limit of one. · m/s · 1e-30 to 10000 · default 10000
---@field push_speed number Largest speed at which two bodies that overlap are pushed apart. Of many in one place, the outer ones are faster: each is pushed by the one inside of it. · m/s · at least 0 · default 3
---@field restitution_mix "average"|"minimum"|"maximum"|"multiply"|"geometric" Restitution of a contact from those of its two surfaces. · "average", "minimum", "maximum", "multiply", "geometric" · default "maximum"
---@field restitution_threshold number Slower impacts do not bounce. · m/s · at least 0 · default 1
---@field sleep_delay number Time for which a body must rest before it falls asleep. · s · at least 0 · default 0.5
---@field sleep_speed number A body that is slower than this rests. · m/s · at least 0 · default 0.05
---@field sleeping boolean True if resting bodies fall asleep, which saves time, until they are disturbed. · true or false · default true
---@field solver "soft_step"|"sequential"|"direct" How contacts and joints are solved: "soft_step" solves them one after the other in small steps with warm starting, and is right for nearly all games; "direct" solves all that touch each other as one problem: slow for many bodies, and it holds bodies some hundreds of times heavier than those below them; "sequential" solves the contacts once, the worst first, as was usual in 2008, to compare: it does not hold a heavy box on a light one. · "soft_step", "sequential", "direct" · default "soft_step"
---@field substeps integer Number of parts in which a step is solved: more is stiffer and slower. A step that is longer than 1/60 s, or much longer than the last one, gets up to four times as many. · 1 to 64 · default 4
---@field threads integer Number of threads for a step; at most as many run at a time as the machine has processors. The number changes no result. · 1 to 64 · default 1 · not saved
---@field step StepStatistics Statistics of the last step of a world, and the time that it took.
local fettle_World = {}

---The body at a point, or nil. If there are several, the one with the smallest shape. Sensors count, too.
---@param point vec A point in the world. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return Body? body The body, or nil.
function fettle_World:at(point, mask, group, accept) end

---The shape nearest to a point, or nil. Sensors and the bounds do not count.
---@param point vec A point in the world. · m
---@param reach? number Largest distance. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return World.closest.result?
function fettle_World:closest(point, reach, mask, group, accept) end

---Every point at which two bodies touch now.
---@return World.contacts.result[]
function fettle_World:contacts() end

---Distance between two shapes or bodies.
---@param a Object A shape or a body.
---@param b Object Another.
---@return World.distance.result?
function fettle_World:distance(a, b) end

---Pushes bodies away from a point; the impulse decreases with the distance.
---@param point vec Center of the explosion in the world. · m
---@param radius number Radius of the explosion. · m
---@param impulse number Impulse for a body at the point. · N s
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
function fettle_World:explode(point, radius, impulse, mask, accept) end

---Pushes bodies away from a point, large ones more than small ones.
---@param point vec Center of the explosion in the world. · m
---@param radius number Nearer shapes get the full impulse. · m
---@param falloff number The impulse decreases to 0 over this distance beyond the radius. · m
---@param impulse_per_length number Impulse for each meter of a shape's outline as seen from the point. · N s
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
function fettle_World:explode_surfaces(point, radius, falloff, impulse_per_length, mask, accept) end

---What will move in the next seconds, and where, if only the physics goes on: a copy of the world makes the steps, with the length of the last step. This world does not change, and no function of a script is called: what scripts would do in `step` or in handlers is not in it. With more than 2500 bodies awake it ends earlier: after 300 000 bodies times steps.
---@param seconds? number How far to look ahead; 2 if it is left out. · s
---@return World.ghosts.result[]
function fettle_World:ghosts(seconds) end

---The bodies that overlap a shape or a body; not its own body. A shape without a body is at its own coordinates.
---@param shape Object A shape or a body, of any world or of none.
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return Body[] bodies Each body once, in any order.
function fettle_World:overlap(shape, mask, group, accept) end

---The bodies that overlap a box. Sensors count, too.
---@param corner vec A corner of the box. · m
---@param opposite vec The opposite corner. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return Body[] bodies Each body once, in any order.
function fettle_World:overlap_box(corner, opposite, mask, group, accept) end

---The first shape that a ray hits, or nil. Sensors and shapes in which the ray begins do not count.
---@param from vec Beginning of the ray. · m
---@param to vec End of the ray. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return World.raycast.result?
function fettle_World:raycast(from, to, mask, group, accept) end

---Every shape that a ray hits, the nearest first. Sensors and shapes in which the ray begins do not count.
---@param from vec Beginning of the ray. · m
---@param to vec End of the ray. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return World.raycast_all.result[]
function fettle_World:raycast_all(from, to, mask, group, accept) end

---The first shape that a moving shape or body would hit, or nil. Sensors do not count.
---@param shape Object A shape or a body, of any world or of none.
---@param motion vec Distance and direction of the motion. · m
---@param mask? integer Categories to look for, as bits; all if it is left out.
---@param group? integer Only shapes of this group are found if it is positive, and none of them if it is negative.
---@param accept? any A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, and returns whether it counts. It may read and search, but not change anything.
---@return World.shapecast.result?
function fettle_World:shapecast(shape, motion, mask, group, accept) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: World, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: World, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: World, event: "mix_surfaces", handler: fun(record: World.mix_surfaces)): Connection
---@overload fun(self: World, event: "filter_pair", handler: fun(record: World.filter_pair)): Connection
function fettle_World:on(event, handler) end

---Bodies below it are simulated together. Its child `step` describes the last step.
---@class Class.World : Class
---@overload fun(members?: table): World
World = {}

---Asked in the step, before a contact of the body acts: the handler may change friction and restitution, and with enabled = false both pass through each other in this step. Asked once for two shapes, however many parts of them touch. The handler cannot write anything else.
---@class Body.before_solve
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse between them in the step before; 0 if they have just met. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field enabled boolean True if the contact acts in this step.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body began to touch another. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Body.contact_begin
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse of their first contact. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body stopped touching another. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Body.contact_end
---@field other Object The other body; the world itself for its bounds. It may have been deleted: then the record's other_alive is false, and only alive(), name, class and is_a() can be used.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body was hit faster than the world's hit_threshold.
---@class Body.contact_hit
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse that would stop the impact at the point with the highest speed of impact. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body still touches another: reported in every step after the first.
---@class Body.contact_persist
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse between them in this step. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body entered a sensor, or a shape entered this sensor. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Body.sensor_begin
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The body left a sensor, or a shape left this sensor. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Body.sensor_end
---@field other Object The other body; the world itself for its bounds. It may have been deleted: then the record's other_alive is false, and only alive(), name, class and is_a() can be used.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---It rested long enough and fell asleep.
---@class Body.slept
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---Its sleep was disturbed.
---@class Body.woke
---@field instance Body The instance with the event.
---@field step integer The fixed step in which it happened.

---The touches of `contacts` with points and impulses: one record for each pair of shapes.
---@class Body.touches.result
---@field other Object The other body; the world itself for its bounds.
---@field shape Object The shape of this body; nil for the capsule of a mover.
---@field other_shape Object The shape of the other; nil for the bounds and the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other.
---@field impulse number Impulse that separated them in the last step. · N s
---@field tangent_impulse number Impulse of friction, clockwise around this body. · N s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.

---A rigid body: its shapes are its children. It is simulated while it is below a World.
---@class Body : Object
---@field angle number Angle by which it is turned, counter-clockwise; not wrapped after a full turn. · rad · -1e8 to 1e8 · default 0 · simulated
---@field angular_damping number Share of its angular velocity that it loses in a second, for small values. · 1/s · at least 0 · default 0
---@field angular_velocity number Angular velocity, counter-clockwise, about its `center`. A step limits it to 3 rad in each of its parts (`World.substeps`): 720 rad/s with the defaults. · rad/s · any finite number · default 0 · simulated
---@field awake boolean True if it takes part in the step. A body that rests for a while falls asleep, together with all bodies that it touches, until one of them is disturbed. · true or false · default true · simulated
---@field bullet boolean True if it cannot pass through other moving bodies at any speed. · true or false · default false
---@field can_sleep boolean True if it may fall asleep. · true or false · default true
---@field center vec Center of mass in the coordinates of the body, computed from the shapes unless it is set; nil computes it again. A kinematic body turns about its `position`, as a door about its hinge: its center is (0, 0) unless it is set. · m · -1e8 to 1e8 · default computed · simulated
---@field color color? Color of its shapes that have no own color; nil: a color for the type of the body. · channels 0 to 1 · default nil · may be nil
---@field contact_force number Sum of the forces of its contacts. · N · any finite number · read-only, simulated
---@field contact_impulses number[] Impulses that separated the two in the last step. · N s · any length · read-only, simulated
---@field contact_normals vec[] Directions from this body to the touched one; of length 1. · any length · read-only, simulated
---@field contact_points vec[] Points of the contacts in the world. · m · any length · read-only, simulated
---@field contact_shapes Object[] The shapes that it touches now, one for each touch; the world itself for its bounds. `contact_points`, `contact_normals` and `contact_impulses` have as many entries, in the same order. · any length · read-only, simulated
---@field contacts Object[] The bodies that it touches now; the world itself if it touches the bounds. Sensors do not count. · any length · read-only, simulated
---@field enabled boolean False if it takes no part in the world: it does not move, nothing collides with it, no query finds it, and its joints do not act. It is drawn, and keeps its velocity. · true or false · default true
---@field force vec Force on its center of mass in every step until it is changed. · N · any finite vec · default vec(0, 0)
---@field gravity_scale number Factor of the world's gravity for this body: 0 floats, -1 falls upwards. · any finite number · default 1
---@field inertia number Rotational inertia about the center of mass, computed from the shapes unless it is set; nil computes it again. Segments without rounding have no area: a dynamic body of nothing else has its mass along them, like a wire. With infinite inertia, or more than 1e18, nothing turns it. · kg m² · 1e-30 to inf · default computed · simulated, may be infinite
---@field linear_damping number Share of its velocity that it loses in a second, for small values. · 1/s · at least 0 · default 0
---@field locked_rotation boolean True if it cannot turn. · true or false · default false
---@field locked_x boolean True if it cannot move along x. · true or false · default false
---@field locked_y boolean True if it cannot move along y. · true or false · default false
---@field mass number Mass: area times density of its shapes, unless it is set; nil computes it again. With infinite mass, or 1e18 kg and more, nothing moves it, not even gravity. A dynamic body without shapes, or of lines alone, has 1 kg. · kg · 1e-30 to inf · default computed · simulated, may be infinite
---@field max_speed number Limit of the speed. World.substeps says how often it is applied in a step. · m/s · 1e-30 to inf · default inf · may be infinite
---@field position vec Position of its origin in the world. A write moves it at once. · m · -1e8 to 1e8 · default vec(0, 0) · simulated
---@field sleep_speed number Speed below which it counts as at rest. Unless it is set, that of the world; nil uses that of the world again. · m/s · at least 0 · default 0.05 · simulated
---@field torque number Torque in every step until it is changed. · N m · any finite number · default 0
---@field type "static"|"kinematic"|"dynamic" How it moves. "static": not at all; "kinematic": with its velocity, and no force changes that; "dynamic": by forces, contacts and joints. · "static", "kinematic", "dynamic" · default "dynamic"
---@field velocity vec Velocity of its `center`. A step limits it to 10000 m/s. · m/s · any finite vec · default vec(0, 0) · simulated
local fettle_Body = {}

---Changes its angular velocity at once.
---@param impulse number Inertia times the change of angular velocity, counter-clockwise. · N m s
function fettle_Body:apply_angular_impulse(impulse) end

---Applies a force during the next step only; the property `force` is not changed. It is constant for the whole step: a spring needs a joint or an Attractor, or it gains energy.
---@param force vec Force in world coordinates. · N
---@param point? vec A point in the world; the center of mass if it is left out. · m
function fettle_Body:apply_force(force, point) end

---Changes its velocity at once.
---@param impulse vec Mass times the change of velocity. · N s
---@param point? vec A point in the world; the center of mass if it is left out. · m
function fettle_Body:apply_impulse(impulse, point) end

---Applies a torque during the next step only; the property `torque` is not changed.
---@param torque number Counter-clockwise. · N m
function fettle_Body:apply_torque(torque) end

---Its angle in the picture that is being drawn. Outside of `draw`: its angle.
---@return number angle Counter-clockwise. · rad
function fettle_Body:drawn_angle() end

---Position of its origin in the picture that is being drawn: pictures are drawn between the last two steps. Outside of `draw`: its position.
---@return vec position The position in the world. · m
function fettle_Body:drawn_position() end

---Converts a point of the body to the picture that is being drawn. Outside of `draw`: as `to_world`.
---@param point vec A point in the coordinates of the body. · m
---@return vec point The point in the world. · m
function fettle_Body:to_drawn(point) end

---Converts a point of the world to the coordinates of the body.
---@param point vec A point in the world. · m
---@return vec point The point in the coordinates of the body. · m
function fettle_Body:to_local(point) end

---Converts a point of the body to the world.
---@param point vec A point in the coordinates of the body. · m
---@return vec point The point in the world. · m
function fettle_Body:to_world(point) end

---The touches of `contacts` with points and impulses: one record for each pair of shapes.
---@return Body.touches.result[]
function fettle_Body:touches() end

---Velocity of a point of the body.
---@param point vec A point in the world. · m
---@return vec velocity Velocity of that point in the world. · m/s
function fettle_Body:velocity_at(point) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Body, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Body, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Body, event: "contact_begin", handler: fun(record: Body.contact_begin)): Connection
---@overload fun(self: Body, event: "contact_persist", handler: fun(record: Body.contact_persist)): Connection
---@overload fun(self: Body, event: "before_solve", handler: fun(record: Body.before_solve)): Connection
---@overload fun(self: Body, event: "contact_end", handler: fun(record: Body.contact_end)): Connection
---@overload fun(self: Body, event: "contact_hit", handler: fun(record: Body.contact_hit)): Connection
---@overload fun(self: Body, event: "sensor_begin", handler: fun(record: Body.sensor_begin)): Connection
---@overload fun(self: Body, event: "sensor_end", handler: fun(record: Body.sensor_end)): Connection
---@overload fun(self: Body, event: "woke", handler: fun(record: Body.woke)): Connection
---@overload fun(self: Body, event: "slept", handler: fun(record: Body.slept)): Connection
function fettle_Body:on(event, handler) end

---A rigid body: its shapes are its children. It is simulated while it is below a World.
---@class Class.Body : Class
---@overload fun(members?: table): Body
Body = {}

---Asked in the step, before a contact of the shape acts: the handler may change friction and restitution, and with enabled = false both pass through each other in this step. Asked once for two shapes, however many parts of them touch. The handler cannot write anything else.
---@class Shape.before_solve
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse between them in the step before; 0 if they have just met. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field enabled boolean True if the contact acts in this step.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape began to touch another. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Shape.contact_begin
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse of their first contact. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape stopped touching another. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Shape.contact_end
---@field other Object The other body; the world itself for its bounds. It may have been deleted: then the record's other_alive is false, and only alive(), name, class and is_a() can be used.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape was hit faster than the world's hit_threshold.
---@class Shape.contact_hit
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse that would stop the impact at the point with the highest speed of impact. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape still touches another: reported in every step after the first.
---@class Shape.contact_persist
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field point vec Point of the contact in the world. · m
---@field normal vec Direction from this body to the other; its length is 1.
---@field impulse number Impulse between them in this step. · N s
---@field speed number Speed at which they approached each other. · m/s
---@field friction number Coefficient mixed from both surfaces.
---@field restitution number Mixed from both surfaces.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape entered a sensor, or a shape entered this sensor. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Shape.sensor_begin
---@field other Object The other body; the world itself for its bounds.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---The shape left a sensor, or a shape left this sensor. Reported once for each pair of shapes: a body of two shapes causes two.
---@class Shape.sensor_end
---@field other Object The other body; the world itself for its bounds. It may have been deleted: then the record's other_alive is false, and only alive(), name, class and is_a() can be used.
---@field shape Shape? The shape of this body; nil for the capsule of a mover.
---@field other_shape Shape? The shape of the other; nil for the bounds and for the capsule of a mover.
---@field instance Shape The instance with the event.
---@field step integer The fixed step in which it happened.

---A part of a body with an outline, a density and a surface.
---@class Shape : Object
---@field aabb vec[] Lower left and upper right corner of its bounding box in the world. · m · any length · read-only, simulated
---@field area number Area of the shape, rounding included. · m² · any finite number · read-only
---@field border color Color of its outline; a darker fill color unless it is set. · channels 0 to 1 · default color("#2c476a")
---@field category integer Its categories, as bits. Two shapes collide if each one's mask has a bit of the other's category. · any integer · default 1
---@field color color Color of the fill. Unless it is set, the color of the body, or a color for the type of the body. · channels 0 to 1 · default color("#619eeb")
---@field contact_events boolean True if its touches are reported: contact_begin, contact_persist and contact_end. Both shapes must agree. It holds from the next touch on: a touch whose begin was reported is reported to its end. · true or false · default true
---@field density number Mass per area. · kg/m² · at least 0 · default 1
---@field friction number Coulomb coefficient: 0 is like ice, 1 like rubber. Two shapes in contact use the geometric mean of their coefficients, or the world's friction_mix. · at least 0 · default 0.6
---@field group integer Shapes with an equal group other than 0 always collide (above 0) or never collide (below 0), whatever their masks are. · -2147483648 to 2147483647 · default 0
---@field mask integer Categories with which it collides, as bits; -1 is all. · any integer · default -1
---@field material integer A number for the game, for example to choose the sound of an impact. It has no effect on the simulation. · 0 to 65535 · default 0
---@field restitution number Share of the speed of approach with which shapes separate. Two shapes in contact use the greater of their values, or the world's restitution_mix. · 0 to 1 · default 0
---@field rolling_resistance number Resistance to rolling: the lever of the resisting torque as a share of the radius, of the other shape if this one has no round side. The radius of an ellipse is that of a circle of the same area. · at least 0 · default 0
---@field sensor boolean True if it reports overlapping shapes and does not push them. It is drawn faint, so that what is in it can be seen, unless it has a color of its own. · true or false · default false
---@field sensor_events boolean True if sensor_begin and sensor_end about it are reported, from the next touch on. Both shapes must agree. · true or false · default true
---@field surface_speed number Speed of the surface, as of a conveyor belt, counter-clockwise around the shape. · m/s · any finite number · default 0
---@field visible boolean True if it is drawn; it collides in any case. · true or false · default true
---@field world_vertices vec[] Its corners or points in the world, without rounding; a circle or an ellipse has none. · m · any length · read-only, simulated
local fettle_Shape = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Shape, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Shape, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Shape, event: "contact_begin", handler: fun(record: Shape.contact_begin)): Connection
---@overload fun(self: Shape, event: "contact_persist", handler: fun(record: Shape.contact_persist)): Connection
---@overload fun(self: Shape, event: "before_solve", handler: fun(record: Shape.before_solve)): Connection
---@overload fun(self: Shape, event: "contact_end", handler: fun(record: Shape.contact_end)): Connection
---@overload fun(self: Shape, event: "contact_hit", handler: fun(record: Shape.contact_hit)): Connection
---@overload fun(self: Shape, event: "sensor_begin", handler: fun(record: Shape.sensor_begin)): Connection
---@overload fun(self: Shape, event: "sensor_end", handler: fun(record: Shape.sensor_end)): Connection
function fettle_Shape:on(event, handler) end

---A part of a body with an outline, a density and a surface.
---@class Class.Shape : Class
Shape = {}

---A disc.
---@class Circle : Shape
---@field center vec Its center in the coordinates of the body. · m · -1e6 to 1e6 · default vec(0, 0)
---@field orientation_mark boolean True if a line from its middle to its rim is drawn, which shows how it is turned. · true or false · default false
---@field radius number Distance from its center to its rim. · m · 0.00001 to 1e6 · default 0.5
local fettle_Circle = {}

---A disc.
---@class Class.Circle : Class
---@overload fun(members?: table): Circle
Circle = {}

---A rectangle.
---@class Box : Shape
---@field angle number Its angle on the body, counter-clockwise. · rad · -1e8 to 1e8 · default 0
---@field center vec Its center in the coordinates of the body. · m · -1e6 to 1e6 · default vec(0, 0)
---@field height number Distance from bottom to top, rounding included. · m · 0.00001 to 1e6 · default 1
---@field rounding number Radius of its corners; more than half the smaller side counts as half. · m · 0 to 1e6 · default 0
---@field width number Distance from its left to its right side, rounding included. · m · 0.00001 to 1e6 · default 1
local fettle_Box = {}

---A rectangle.
---@class Class.Box : Class
---@overload fun(members?: table): Box
Box = {}

---A straight line without thickness and without mass.
---@class Segment : Shape
---@field from vec One end in the coordinates of the body. · m · -1e6 to 1e6 · default vec(-0.5, 0)
---@field to vec The other end in the coordinates of the body. · m · -1e6 to 1e6 · default vec(0.5, 0)
local fettle_Segment = {}

---A straight line without thickness and without mass.
---@class Class.Segment : Class
---@overload fun(members?: table): Segment
Segment = {}

---A straight line with round ends and a thickness.
---@class Capsule : Shape
---@field from vec One end in the coordinates of the body. · m · -1e6 to 1e6 · default vec(-0.25, 0)
---@field radius number Radius around the line between its ends. · m · 0.00001 to 1e6 · default 0.25
---@field to vec The other end in the coordinates of the body. · m · -1e6 to 1e6 · default vec(0.25, 0)
local fettle_Capsule = {}

---A straight line with round ends and a thickness.
---@class Class.Capsule : Class
---@overload fun(members?: table): Capsule
Capsule = {}

---A convex polygon.
---@class Polygon : Shape
---@field rounding number Radius that is added on all sides. · m · 0 to 1e6 · default 0
---@field vertices vec[] Its corners in the coordinates of the body, counter-clockwise. The convex hull of the written points becomes the shape. · m · -1e6 to 1e6 · default {vec(-0.5, -0.5), vec(0.5, -0.5), vec(0, 0.5)}
local fettle_Polygon = {}

---Extends the polygon to that point; a point inside changes nothing.
---@param point vec A point in the coordinates of the body. · m
function fettle_Polygon:add_vertex(point) end

---A convex polygon.
---@class Class.Polygon : Class
---@overload fun(members?: table): Polygon
Polygon = {}

---An exact ellipse, without corners.
---@class Ellipse : Shape
---@field angle number Its angle on the body, counter-clockwise. · rad · -1e8 to 1e8 · default 0
---@field center vec Its center in the coordinates of the body. · m · -1e6 to 1e6 · default vec(0, 0)
---@field orientation_mark boolean True if a line from its middle to its rim is drawn, which shows how it is turned. · true or false · default false
---@field radius_x number Half its width at angle 0. · m · 0.00001 to 1e6 · default 0.5
---@field radius_y number Half its height at angle 0. · m · 0.00001 to 1e6 · default 0.25
local fettle_Ellipse = {}

---An exact ellipse, without corners.
---@class Class.Ellipse : Class
---@overload fun(members?: table): Ellipse
Ellipse = {}

---A polygon that may be concave. It collides in convex pieces, but is one shape.
---@class Concave : Shape
---@field vertices vec[] Its corners in the coordinates of the body, clockwise or counter-clockwise. An outline that crosses or touches itself is refused, and so is a hole; at most 16384. · m · -1e6 to 1e6 · default {vec(-0.5, -0.5), vec(0.5, -0.5), vec(0.5, 0), vec(0, 0), vec(0, 0.5), vec(-0.5, 0.5)}
local fettle_Concave = {}

---A polygon that may be concave. It collides in convex pieces, but is one shape.
---@class Class.Concave : Class
---@overload fun(members?: table): Concave
Concave = {}

---A line of segments without seams, solid on its left: points from left to right are ground; a closed counter-clockwise chain is a container. Bodies pass through it from the other side.
---@class Chain : Shape
---@field closed boolean True if the last point is connected to the first; this needs three points. · true or false · default false
---@field points vec[] Its points in the coordinates of the body. · m · -1e6 to 1e6 · default {vec(-0.5, 0), vec(0.5, 0)}
---@field segment_friction number[] Friction of each segment, in the order of the points: {0.6, 0} makes the second one ice. Infinity, or no value: that of the chain. A value stays with the number of its segment when points change. · 0 to inf · default {} · may be infinite
---@field segment_material integer[] Material of each segment, from 0 to 65534; -1, or no value: that of the chain. · -1 to 65534 · default {}
---@field segment_restitution number[] Restitution of each segment, from 0 to 1; infinity, or no value: that of the chain. · 0 to inf · default {} · may be infinite
---@field segment_rolling_resistance number[] Resistance to rolling of each segment; infinity, or no value: that of the chain. · 0 to inf · default {} · may be infinite
---@field segment_surface_speed number[] Speed of the surface of each segment, against the order of the points; infinity, or no value: that of the chain. · m/s · any length · default {} · may be infinite
local fettle_Chain = {}

---A line of segments without seams, solid on its left: points from left to right are ground; a closed counter-clockwise chain is a container. Bodies pass through it from the other side.
---@class Class.Chain : Class
---@overload fun(members?: table): Chain
Chain = {}

---A wall or a ceiling stopped it.
---@class Mover.bumped
---@field other Object The body that stopped it.
---@field other_shape Shape? The shape that stopped it; nil for the bounds and another mover.
---@field normal vec Direction away from it.
---@field instance Mover The instance with the event.
---@field step integer The fixed step in which it happened.

---Obstacles press it from several sides, and it overlaps one of them.
---@class Mover.crushed
---@field instance Mover The instance with the event.
---@field step integer The fixed step in which it happened.

---It came onto the ground.
---@class Mover.landed
---@field ground Object The body on which it landed.
---@field speed number Speed of its fall. · m/s
---@field instance Mover The instance with the event.
---@field step integer The fixed step in which it happened.

---It jumped or fell off the ground.
---@class Mover.left_ground
---@field ground Object? The body on which it stood; nil if that was deleted.
---@field instance Mover The instance with the event.
---@field step integer The fixed step in which it happened.

---A character: a body with the shape of an upright capsule, which walks up slopes and steps, rides on platforms, passes through ledges from below and pushes crates. Its position is at its feet. It moves by itself while its type is "kinematic"; with "dynamic" it is a body like others.
---@class Mover : Body
---@field acceleration number Acceleration to the speed `walk` on the ground. · m/s² · at least 0 · default 60
---@field air_acceleration number Acceleration to the speed `walk` in the air. · m/s² · at least 0 · default 20
---@field category integer Its categories, as bits: see `Shape.category`. · any integer · default 1
---@field climb number Speed upwards while it climbs. · m/s · any finite number · default 0
---@field climbing boolean True if it is on a ladder: gravity does not act, and it moves by walk and climb. · true or false · default false · simulated
---@field crouch boolean True if it is to crouch. After false it stands up as soon as there is room; `crouched` says whether it is still low. · true or false · default false
---@field crouch_height number Height while it crouches. · m · 0.02 to 1000 · default 0.9
---@field crouched boolean True if it has the height for crouching. · true or false · read-only, simulated
---@field ground Object? The body on which it stands, or the world for its bounds; nil in the air. · any instance · read-only, simulated, may be nil
---@field ground_normal vec Direction away from the ground; zero in the air. · any finite vec · read-only, simulated
---@field ground_velocity vec Velocity of the ground below its feet. · m/s · any finite vec · read-only, simulated
---@field height number Height while it stands; at least twice the radius is used. Its position is at its feet. · m · 0.02 to 1000 · default 1.8
---@field ledges integer Categories of ledges, as bits: shapes on which it stands and through which it passes from below. Chains are like this without a category. · any integer · default 0
---@field mask integer Categories of the shapes with which it collides, as bits; -1 is all. · any integer · default -1
---@field max_slope number Steepest ground on which it stands; steeper ground is a wall. · rad · 0 to 1.5 · default 0.87
---@field on_ceiling boolean True if a ceiling stopped it. · true or false · read-only, simulated
---@field on_ground boolean True if it stands on the ground. · true or false · read-only, simulated
---@field on_wall boolean True if a wall stopped it. · true or false · read-only, simulated
---@field push_force number Greatest force with which it pushes bodies; the body on which it stands gets the opposite. · N · 0 to 1e9 · default 600
---@field radius number Radius of its capsule: half its width. · m · 0.01 to 500 · default 0.4
---@field snap number While it walks, it stays on ground that falls away by at most this in a step. · m · 0 to 1000 · default 0.25
---@field step_height number Height of the steps that it climbs. · m · 0 to 1000 · default 0.3
---@field visible boolean True if its capsule is drawn; set it to false if a sprite is drawn in its place. · true or false · default true
---@field walk number Target speed along the ground, to its right; negative to its left. In the air it is relative to the ground that it left. · m/s · any finite number · default 0
local fettle_Mover = {}

---Lets it fall through the ledge on which it stands.
---@return boolean dropped False if it stands on no ledge and on no chain.
function fettle_Mover:drop() end

---Gives it this speed upwards, also in the air, and ends climbing.
---@param speed number Speed upwards. · m/s
function fettle_Mover:jump(speed) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Mover, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Mover, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Mover, event: "contact_begin", handler: fun(record: Body.contact_begin)): Connection
---@overload fun(self: Mover, event: "contact_persist", handler: fun(record: Body.contact_persist)): Connection
---@overload fun(self: Mover, event: "before_solve", handler: fun(record: Body.before_solve)): Connection
---@overload fun(self: Mover, event: "contact_end", handler: fun(record: Body.contact_end)): Connection
---@overload fun(self: Mover, event: "contact_hit", handler: fun(record: Body.contact_hit)): Connection
---@overload fun(self: Mover, event: "sensor_begin", handler: fun(record: Body.sensor_begin)): Connection
---@overload fun(self: Mover, event: "sensor_end", handler: fun(record: Body.sensor_end)): Connection
---@overload fun(self: Mover, event: "woke", handler: fun(record: Body.woke)): Connection
---@overload fun(self: Mover, event: "slept", handler: fun(record: Body.slept)): Connection
---@overload fun(self: Mover, event: "landed", handler: fun(record: Mover.landed)): Connection
---@overload fun(self: Mover, event: "left_ground", handler: fun(record: Mover.left_ground)): Connection
---@overload fun(self: Mover, event: "bumped", handler: fun(record: Mover.bumped)): Connection
---@overload fun(self: Mover, event: "crushed", handler: fun(record: Mover.crushed)): Connection
function fettle_Mover:on(event, handler) end

---A character: a body with the shape of an upright capsule, which walks up slopes and steps, rides on platforms, passes through ledges from below and pushes crates. Its position is at its feet. It moves by itself while its type is "kinematic"; with "dynamic" it is a body like others.
---@class Class.Mover : Class
---@overload fun(members?: table): Mover
Mover = {}

---Its force or torque was larger than break_force or break_torque.
---@class Joint.broke
---@field force vec Force of the joint when it broke. · N
---@field torque number Torque of the joint when it broke, not counting that of the force. · N m
---@field instance Joint The instance with the event.
---@field step integer The fixed step in which it happened.

---Its force or torque was larger than report_force or report_torque.
---@class Joint.loaded
---@field force vec Force of the joint in the step. · N
---@field torque number Torque of the joint in the step, not counting that of the force. · N m
---@field instance Joint The instance with the event.
---@field step integer The fixed step in which it happened.

---Connects bodies with each other or with the world. It acts while it and its bodies are in the same world.
---@class Joint : Object
---@field angular_separation number Difference between the angle of its bodies and the angle that it should hold. · rad · any finite number · read-only, simulated
---@field break_force number It breaks if its force is larger, as the mean of a step; infinite: never. · N · 0 to inf · default inf · may be infinite
---@field break_torque number It breaks if its torque, not counting that of its force, is larger. · N m · 0 to inf · default inf · may be infinite
---@field broken boolean True if it broke and does not act; false repairs it. · true or false · default false · simulated
---@field constraint_damping_ratio number Damping ratio of a constraint_hertz above 0. · 0 to 1000 · default 2
---@field constraint_hertz number How fast it corrects an error of its position, at most a quarter of the rate of sub-steps; 0: 60 Hz, and more where it connects bodies of very different masses. · Hz · at least 0 · default 0
---@field enabled boolean True if it may act. · true or false · default true
---@field force vec Force on its body, or on body_b, in the last step. · N · any finite vec · read-only, simulated
---@field report_force number The event loaded is emitted in each step in which its force, as the mean of the step, is larger; infinite: never. · N · 0 to inf · default inf · may be infinite
---@field report_torque number The event loaded is emitted in each step in which its torque, not counting that of its force, is larger. · N m · 0 to inf · default inf · may be infinite
---@field separation number Distance of its bodies from where it should hold them: what a rigid part or a limit has yielded. · m · any finite number · read-only, simulated
---@field torque number Torque on body_b in the last step, not counting that of its force. · N m · any finite number · read-only, simulated
local fettle_Joint = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Joint, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Joint, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Joint, event: "broke", handler: fun(record: Joint.broke)): Connection
---@overload fun(self: Joint, event: "loaded", handler: fun(record: Joint.loaded)): Connection
function fettle_Joint:on(event, handler) end

---Connects bodies with each other or with the world. It acts while it and its bodies are in the same world.
---@class Class.Joint : Class
Joint = {}

---Pulls a point of a body softly towards a target, as for dragging with the mouse.
---@class MouseJoint : Joint
---@field anchor vec The point of the body that is pulled, in its coordinates. Unless it is set, the point that was at the target when the joint began to act. · m · -1e8 to 1e8 · default computed · simulated
---@field body Body? The body that is pulled; nil: none. · any Body · default nil
---@field damping_ratio number Damping ratio; with 1 it comes to rest without swinging. · at least 0 · default 0.7
---@field frequency number Stiffness; 0 is free. · Hz · at least 0 · default 5
---@field max_force number Largest force. · N · 0 to inf · default inf · may be infinite
---@field target vec Position in the world to which it is pulled. · m · -1e8 to 1e8 · default vec(0, 0)
local fettle_MouseJoint = {}

---Pulls a point of a body softly towards a target, as for dragging with the mouse.
---@class Class.MouseJoint : Class
---@overload fun(members?: table): MouseJoint
MouseJoint = {}

---Connects two bodies, or one with the world. While both are the same, it does not act.
---@class PairJoint : Joint
---@field anchor_a vec The point at which that body is held, in its coordinates, or in those of the world. · m · -1e8 to 1e8 · default vec(0, 0)
---@field anchor_b vec The point at which that body is held, in its coordinates, or in those of the world. · m · -1e8 to 1e8 · default vec(0, 0)
---@field body_a Body? One of the two connected bodies; nil: the world. When the body is deleted, the joint does not act until this is set to another body or to nil. · any Body · default nil
---@field body_b Body? One of the two connected bodies; nil: the world. When the body is deleted, the joint does not act until this is set to another body or to nil. · any Body · default nil
---@field collide boolean True if the two bodies collide with each other. · true or false · default false
local fettle_PairJoint = {}

---Connects two bodies, or one with the world. While both are the same, it does not act.
---@class Class.PairJoint : Class
PairJoint = {}

---Keeps two points at a distance: a rod; with a finite hertz a spring; with hertz 0 and a max_length a rope.
---@class DistanceJoint : PairJoint
---@field damping_ratio number Damping ratio of the spring; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field hertz number Stiffness of the spring; infinite is a rod, 0 is free between the limits. · Hz · 0 to inf · default inf · may be infinite
---@field length number Length of the rod, or of the spring at rest. Unless it is set, the distance when the joint began to act. · m · at least 0 · default computed · simulated
---@field lower_spring_force number The spring does not pull with more than this; 0: it only pushes. · N · -inf to 0 · default -inf · may be infinite
---@field max_length number Largest distance of the anchors. If min_length is larger, both are this distance. · m · 0 to inf · default inf · may be infinite
---@field max_motor_force number Largest force of the motor; 0: no motor. · N · 0 to inf · default 0 · may be infinite
---@field min_length number Smallest distance of the anchors. · m · at least 0 · default 0
---@field motor_force number Force of the motor in the last step; positive pushes the anchors apart. · N · any finite number · read-only, simulated
---@field motor_speed number Speed with which the motor changes the distance. A rod has no motor. · m/s · any finite number · default 0
---@field upper_spring_force number The spring does not push with more than this; 0: it only pulls. · N · 0 to inf · default inf · may be infinite
local fettle_DistanceJoint = {}

---Keeps two points at a distance: a rod; with a finite hertz a spring; with hertz 0 and a max_length a rope.
---@class Class.DistanceJoint : Class
---@overload fun(members?: table): DistanceJoint
DistanceJoint = {}

---A pin through two bodies, about which they turn.
---@class RevoluteJoint : PairJoint
---@field angle number Angle of body_b relative to body_a, minus the reference_angle. · rad · any finite number · read-only, simulated
---@field damping_ratio number Damping ratio of the spring; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field hertz number Stiffness of a spring to the target_angle; 0: none. · Hz · at least 0 · default 0
---@field lower_angle number Smallest angle. · rad · any number, infinite too · default -inf · may be infinite
---@field max_motor_torque number Largest torque of the motor; 0: no motor. · N m · 0 to inf · default 0 · may be infinite
---@field motor_speed number Angular velocity to which the motor drives body_b. · rad/s · any finite number · default 0
---@field motor_torque number Torque of the motor in the last step. · N m · any finite number · read-only, simulated
---@field reference_angle number The angle that counts as 0. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
---@field target_angle number Angle at which the spring rests. · rad · any finite number · default 0
---@field upper_angle number Largest angle. If lower_angle is larger, both are this angle. · rad · any number, infinite too · default inf · may be infinite
local fettle_RevoluteJoint = {}

---A pin through two bodies, about which they turn.
---@class Class.RevoluteJoint : Class
---@overload fun(members?: table): RevoluteJoint
RevoluteJoint = {}

---Lets body_b slide along an axis of body_a without turning.
---@class PrismaticJoint : PairJoint
---@field axis vec Direction of sliding, in the coordinates of body_a; of any length but 0. · any finite vec · default vec(1, 0)
---@field damping_ratio number Damping ratio of the spring; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field hertz number Stiffness of a spring to the target_translation; 0: none. · Hz · at least 0 · default 0
---@field lower_translation number Smallest translation. · m · any number, infinite too · default -inf · may be infinite
---@field max_motor_force number Largest force of the motor; 0: no motor. · N · 0 to inf · default 0 · may be infinite
---@field motor_force number Force of the motor in the last step. · N · any finite number · read-only, simulated
---@field motor_speed number Speed to which the motor drives body_b. · m/s · any finite number · default 0
---@field reference_angle number The angle of body_b relative to body_a that it holds. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
---@field target_translation number Translation at which the spring rests. · m · any finite number · default 0
---@field translation number Distance of anchor_b from anchor_a along the axis. · m · any finite number · read-only, simulated
---@field upper_translation number Largest translation. If lower_translation is larger, both are this translation. · m · any number, infinite too · default inf · may be infinite
local fettle_PrismaticJoint = {}

---Lets body_b slide along an axis of body_a without turning.
---@class Class.PrismaticJoint : Class
---@overload fun(members?: table): PrismaticJoint
PrismaticJoint = {}

---A pin of body_b in a straight slot of body_a: it slides, and turns freely.
---@class PinSlotJoint : PairJoint
---@field axis vec Direction of sliding, in the coordinates of body_a; of any length but 0. · any finite vec · default vec(1, 0)
---@field damping_ratio number Damping ratio of the spring; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field hertz number Stiffness of a spring to the target_translation; 0: none. · Hz · at least 0 · default 0
---@field lower_translation number Smallest translation. · m · any number, infinite too · default -inf · may be infinite
---@field max_motor_force number Largest force of the motor; 0: no motor. · N · 0 to inf · default 0 · may be infinite
---@field motor_force number Force of the motor in the last step. · N · any finite number · read-only, simulated
---@field motor_speed number Speed to which the motor drives body_b. · m/s · any finite number · default 0
---@field target_translation number Translation at which the spring rests. · m · any finite number · default 0
---@field translation number Distance of anchor_b from anchor_a along the axis. · m · any finite number · read-only, simulated
---@field upper_translation number Largest translation. If lower_translation is larger, both are this translation. · m · any number, infinite too · default inf · may be infinite
local fettle_PinSlotJoint = {}

---A pin of body_b in a straight slot of body_a: it slides, and turns freely.
---@class Class.PinSlotJoint : Class
---@overload fun(members?: table): PinSlotJoint
PinSlotJoint = {}

---A pin of body_b in a groove of body_a from anchor_a to groove_end.
---@class GrooveJoint : PairJoint
---@field groove_end vec End of the groove in the coordinates of body_a. · m · -1e8 to 1e8 · default vec(1, 0)
---@field translation number Distance of the pin from the beginning of the groove. · m · any finite number · read-only, simulated
local fettle_GrooveJoint = {}

---A pin of body_b in a groove of body_a from anchor_a to groove_end.
---@class Class.GrooveJoint : Class
---@overload fun(members?: table): GrooveJoint
GrooveJoint = {}

---A wheel, body_b, that is sprung along an axis of body_a and may be driven.
---@class WheelJoint : PairJoint
---@field axis vec Direction of the spring, in the coordinates of body_a; of any length but 0. · any finite vec · default vec(0, 1)
---@field damping_ratio number Damping ratio of the spring; with 1 it comes to rest without swinging. · at least 0 · default 0.7
---@field hertz number Stiffness of the spring: how often both bodies swing against each other in a second when nothing else touches them; 0: no spring. A heavy body on light wheels, which stand on the ground, swings slower. · Hz · at least 0 · default 4
---@field lower_translation number Smallest translation of the axle. · m · any number, infinite too · default -inf · may be infinite
---@field max_motor_torque number Largest torque of the motor; 0: no motor. · N m · 0 to inf · default 0 · may be infinite
---@field motor_speed number Angular velocity to which the motor drives the wheel, counter-clockwise. · rad/s · any finite number · default 0
---@field motor_torque number Torque of the motor in the last step. · N m · any finite number · read-only, simulated
---@field translation number Distance of the axle from the position at which the spring rests. · m · any finite number · read-only, simulated
---@field upper_translation number Largest translation of the axle. If lower_translation is larger, both are this translation. · m · any number, infinite too · default inf · may be infinite
local fettle_WheelJoint = {}

---A wheel, body_b, that is sprung along an axis of body_a and may be driven.
---@class Class.WheelJoint : Class
---@overload fun(members?: table): WheelJoint
WheelJoint = {}

---Holds two bodies together, rigidly or as a spring.
---@class WeldJoint : PairJoint
---@field angular_damping_ratio number Damping ratio of the angle; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field angular_hertz number Stiffness of the angle; infinite is rigid, 0 is free. · Hz · 0 to inf · default inf · may be infinite
---@field damping_ratio number Damping ratio; with 1 it comes to rest without swinging. · at least 0 · default 0
---@field hertz number Stiffness of the point; infinite is rigid, 0 is free. · Hz · 0 to inf · default inf · may be infinite
---@field reference_angle number The angle of body_b relative to body_a that it holds. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
local fettle_WeldJoint = {}

---Holds two bodies together, rigidly or as a spring.
---@class Class.WeldJoint : Class
---@overload fun(members?: table): WeldJoint
WeldJoint = {}

---Drives body_b relative to body_a with a limited force and torque: to a velocity or, with a hertz, to an offset. With velocity 0 it is the friction of a game seen from above.
---@class MotorJoint : PairJoint
---@field angular_offset number Target angle of body_b relative to body_a. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
---@field angular_velocity number Target angular velocity of body_b relative to body_a. · rad/s · any finite number · default 0
---@field damping_ratio number Damping ratio of the drive to the offsets; with 1 it comes to rest without swinging. · at least 0 · default 1
---@field hertz number Stiffness of the drive to the offsets; 0: none. · Hz · at least 0 · default 0
---@field linear_offset vec Target position of anchor_b relative to anchor_a, in the coordinates of body_a. · m · -1e8 to 1e8 · default vec(0, 0)
---@field linear_velocity vec Target velocity of anchor_b relative to anchor_a, in the coordinates of body_a. · m/s · any finite vec · default vec(0, 0)
---@field max_force number Largest force. · N · 0 to inf · default 0 · may be infinite
---@field max_torque number Largest torque. · N m · 0 to inf · default 0 · may be infinite
local fettle_MotorJoint = {}

---Drives body_b relative to body_a with a limited force and torque: to a velocity or, with a hertz, to an offset. With velocity 0 it is the friction of a game seen from above.
---@class Class.MotorJoint : Class
---@overload fun(members?: table): MotorJoint
MotorJoint = {}

---A rope from body_a over two wheels of the world to body_b. It only pulls.
---@class PulleyJoint : PairJoint
---@field ground_a vec Position of the wheel over body_a in the world. · m · -1e8 to 1e8 · default vec(-1, 1)
---@field ground_b vec Position of the wheel over body_b in the world. · m · -1e8 to 1e8 · default vec(1, 1)
---@field length number Length of the part at body_a plus ratio times that at body_b. Unless it is set, the length when the joint began to act. · m · at least 0 · default computed · simulated
---@field ratio number Number of parts of the rope that pull body_b. · 0.001 to 1000 · default 1
---@field tension number Force in the rope in the last step. · N · any finite number · read-only, simulated
local fettle_PulleyJoint = {}

---A rope from body_a over two wheels of the world to body_b. It only pulls.
---@class Class.PulleyJoint : Class
---@overload fun(members?: table): PulleyJoint
PulleyJoint = {}

---Turns body_b with body_a.
---@class GearJoint : PairJoint
---@field phase number The angle of body_b minus ratio times that of body_a. Unless it is set, its value when the joint began to act. · rad · any finite number · default computed · simulated
---@field ratio number Turns of body_b for one turn of body_a: negative for wheels that mesh, positive for wheels with a belt. · any finite number · default 1
local fettle_GearJoint = {}

---Turns body_b with body_a.
---@class Class.GearJoint : Class
---@overload fun(members?: table): GearJoint
GearJoint = {}

---Lets body_b turn relative to body_a in one direction only.
---@class RatchetJoint : PairJoint
---@field backwards boolean True if clockwise is the free direction, and not counter-clockwise. · true or false · default false
---@field caught_angle number It does not turn back beyond this angle. · rad · any finite number · read-only, simulated
---@field reference_angle number The angle that counts as 0, at which a tooth is. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
---@field tooth number Angle between two teeth; 0: it holds at any angle. · rad · at least 0 · default 0
local fettle_RatchetJoint = {}

---Lets body_b turn relative to body_a in one direction only.
---@class Class.RatchetJoint : Class
---@overload fun(members?: table): RatchetJoint
RatchetJoint = {}

---Its two bodies do not collide with each other; it does nothing else.
---@class FilterJoint : PairJoint
local fettle_FilterJoint = {}

---Its two bodies do not collide with each other; it does nothing else.
---@class Class.FilterJoint : Class
---@overload fun(members?: table): FilterJoint
FilterJoint = {}

---Keeps the angle of body_b relative to body_a between two angles, wherever the bodies are.
---@class RotaryLimitJoint : PairJoint
---@field angle number Angle of body_b relative to body_a, minus the reference_angle. · rad · any finite number · read-only, simulated
---@field lower_angle number Smallest angle. · rad · any number, infinite too · default -inf · may be infinite
---@field reference_angle number The angle that counts as 0. Unless it is set, the angle when the joint began to act. · rad · any finite number · default computed · simulated
---@field upper_angle number Largest angle. If lower_angle is larger, both are this angle. · rad · any number, infinite too · default inf · may be infinite
local fettle_RotaryLimitJoint = {}

---Keeps the angle of body_b relative to body_a between two angles, wherever the bodies are.
---@class Class.RotaryLimitJoint : Class
---@overload fun(members?: table): RotaryLimitJoint
RotaryLimitJoint = {}

---A field of force: it acts on bodies that are awake in the world above it. An edit of it wakes all bodies.
---@class Field : Object
---@field enabled boolean True if it acts. · true or false · default true
---@field mask integer Categories of the shapes on which it acts, as bits. · any integer · default -1
---@field region vec[]? Region in which it acts, by its lower left and upper right corner: on shapes that overlap it (Buoyancy), or whose body has its center of mass inside; nil: everywhere. · m · -1e8 to 1e8 · default nil · may be nil
local fettle_Field = {}

---A field of force: it acts on bodies that are awake in the world above it. An edit of it wakes all bodies.
---@class Class.Field : Class
Field = {}

---Moving air: pushes every edge that faces it, by the square of its speed.
---@class Wind : Field
---@field density number Density of the air. · kg/m² · at least 0 · default 1.2
---@field velocity vec Velocity of the air. · m/s · any finite vec · default vec(5, 0)
local fettle_Wind = {}

---Moving air: pushes every edge that faces it, by the square of its speed.
---@class Class.Wind : Class
---@overload fun(members?: table): Wind
Wind = {}

---Slows bodies that move relative to a flow, by the area of their shapes.
---@class Drag : Field
---@field flow vec Velocity of the flow. · m/s · any finite vec · default vec(0, 0)
---@field linear number Resistance for each m/s and m². · N s/m³ · at least 0 · default 1
---@field quadratic number Resistance for each (m/s)² and m². · N s²/m⁴ · at least 0 · default 0
local fettle_Drag = {}

---Slows bodies that move relative to a flow, by the area of their shapes.
---@class Class.Drag : Class
---@overload fun(members?: table): Drag
Drag = {}

---A liquid below a straight surface: lifts bodies by exactly the weight of the displaced liquid.
---@class Buoyancy : Field
---@field density number Density of the liquid. · kg/m² · at least 0 · default 2
---@field drag number Share of the displaced mass that resists motion. · 1/s · at least 0 · default 2
---@field flow vec Velocity of the liquid. · m/s · any finite vec · default vec(0, 0)
---@field level number Height of the surface, along its normal from the origin. · m · any finite number · default 0
---@field normal vec Direction up from the surface; of any length but 0. · any finite vec · default vec(0, 1)
local fettle_Buoyancy = {}

---A liquid below a straight surface: lifts bodies by exactly the weight of the displaced liquid.
---@class Class.Buoyancy : Class
---@overload fun(members?: table): Buoyancy
Buoyancy = {}

---Pulls bodies towards a point, as a planet does.
---@class Attractor : Field
---@field center vec Position of the point in the world. · m · -1e8 to 1e8 · default vec(0, 0)
---@field core number At a smaller distance the force is proportional to the distance. · m · at least 0 · default 0.5
---@field falloff integer The acceleration is divided by this power of the distance. · 0 to 3 · default 2
---@field strength number Acceleration at a distance of 1 m; a negative one repels. · m/s² · any finite number · default 10
local fettle_Attractor = {}

---Pulls bodies towards a point, as a planet does.
---@class Class.Attractor : Class
---@overload fun(members?: table): Attractor
Attractor = {}

---The animation came to its end; only without `loop`.
---@class Sprite.finished
---@field instance Sprite The instance with the event.
---@field step integer The fixed step in which it happened.

---A picture in the world or, in a layer, on the screen. Its parent moves it: a body, another sprite, or any instance with a `position`.
---@class Sprite : Object
---@field angle number Counter-clockwise, relative to its parent. · rad · -1e6 to 1e6 · default 0
---@field animation string The frames that are played: a tag of an Aseprite file, or the first and the last frame, such as "3-6". Empty: all frames. · any text · default ""
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field columns integer Number of frames beside each other in the image. · 1 to 10000 · default 1
---@field flip_x boolean Mirrors the image, left and right. · true or false · default false
---@field flip_y boolean Mirrors the image, top and bottom. · true or false · default false
---@field frame integer The frame that is shown, from 1, within the animation. Beyond the last one, counting begins again at the first. · 1 to 1e6 · default 1 · simulated
---@field frame_count integer Number of frames of the animation. · any integer · read-only
---@field frame_size vec? Width and height of a frame. nil: those of the image, divided by columns and rows; otherwise there are as many frames as the image has room for, and columns and rows do not matter. · px · 1 to 100000 · default nil · may be nil
---@field frames_per_second number Speed of the animation. 0: the times in the Aseprite file, or no motion. · 1/s · 0 to 1000 · default 0
---@field image string An image file in the game's folder (PNG, JPEG, BMP, TGA), or a JSON file that Aseprite exported. A checkerboard is drawn for a file that is missing. · any text · default ""
---@field image_height integer Height of the image file, or of the checkerboard. · px · any integer · read-only
---@field image_width integer Width of the image file, or of the checkerboard. · px · any integer · read-only
---@field loop boolean Whether the animation begins again at its end. · true or false · default true
---@field margin number Distance of the frames from the edges of the image. · px · 0 to 100000 · default 0
---@field origin vec The point of the image that is at its position, around which it turns: (0, 0) is the bottom left corner, (1, 1) the top right one. · -1e6 to 1e6 · default vec(0.5, 0.5)
---@field pixels_per_unit number Pixels of the image in a meter, where `size` is nil. In a layer on the screen a pixel of the image is a pixel. · px/m · 0.001 to 1e6 · default 32
---@field playing boolean Whether the animation goes on. At its end without `loop` it stays at the last frame until `animation` changes; `frame` = 1 plays it again. · true or false · default true
---@field position vec Where its origin is, relative to its parent; pixels in a layer on the screen. · m · -1e9 to 1e9 · default vec(0, 0)
---@field rows integer Number of rows of frames in the image. · 1 to 10000 · default 1
---@field scale number Enlarges it, and what is below it. · -1e6 to 1e6 · default 1
---@field sheet integer[] Columns and rows in one value: { columns, rows }. The sheet that Aseprite exported is given by its JSON file as `image`. · 1 to 10000 · default computed · not saved
---@field size vec? Width and height; nil: those of the image, by pixels_per_unit. Pixels in a layer on the screen. · m · 0 to 1e9 · default nil · may be nil
---@field smooth boolean Whether pixels are mixed when the image is enlarged; otherwise each is a square. · true or false · default true
---@field spacing number Distance of two frames in the image. · px · 0 to 100000 · default 0
---@field tint color The colors of the image are multiplied by it. · 0 to 1 · default color("#ffffff")
---@field visible boolean Whether it is drawn. · true or false · default true
local fettle_Sprite = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Sprite, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Sprite, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Sprite, event: "finished", handler: fun(record: Sprite.finished)): Connection
function fettle_Sprite:on(event, handler) end

---A picture in the world or, in a layer, on the screen. Its parent moves it: a body, another sprite, or any instance with a `position`.
---@class Class.Sprite : Class
---@overload fun(members?: table): Sprite
Sprite = {}

---Written text in the world or, in a layer, on the screen. Its parent moves it, as that of a Sprite does.
---@class Text : Object
---@field align "left"|"center"|"right" Where lines begin that are shorter than the longest. · "left", "center", "right" · default "center"
---@field anchor vec The point of the text that is at its position: (0, 0) is the bottom left corner, (1, 1) the top right one. · -1e6 to 1e6 · default vec(0.5, 0.5)
---@field angle number Counter-clockwise, relative to its parent. · rad · -1e6 to 1e6 · default 0
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field color color Color of the letters. · 0 to 1 · default color("#ffffff")
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder. Letters that it lacks are taken from sans, then from other fonts of the system. · any text · default "sans"
---@field outline color Color around the letters; transparent: none. · 0 to 1 · default color("#00000000")
---@field outline_width number Width of the outline as a part of the size. · 0 to 1 · default 0.06
---@field position vec Where its anchor is, relative to its parent; pixels in a layer on the screen. · m · -1e9 to 1e9 · default vec(0, 0)
---@field size number Size of the font; a line is 1.2 times as high. Pixels in a layer on the screen. · m · 0 to 1e6 · default 0.5
---@field text string What is written; it may have several lines. What follows the first 100 000 letters is not shown. · any text · default ""
---@field text_height number Height of all lines. · m · any finite number · read-only
---@field text_width number Width of the longest line. · m · any finite number · read-only
---@field visible boolean Whether it is drawn. · true or false · default true
---@field wrap number Longest line; words beyond it begin another line, and a word that is longer has one of its own. Chinese, Japanese and Korean are divided between characters. 0: no limit. Pixels in a layer on the screen. · m · 0 to 1e9 · default 0
local fettle_Text = {}

---Written text in the world or, in a layer, on the screen. Its parent moves it, as that of a Sprite does.
---@class Class.Text : Class
---@overload fun(members?: table): Text
Text = {}

---A line through several points, with round corners and ends.
---@class Line : Object
---@field angle number Counter-clockwise, relative to its parent. · rad · -1e6 to 1e6 · default 0
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field closed boolean Whether the last point is connected with the first. · true or false · default false
---@field color color Its color. · 0 to 1 · default color("#ffffff")
---@field dashed number Length of dashes with their round ends, and of the gaps between them; 0: no gaps. Pixels in a layer on the screen. · m · 0 to 1e6 · default 0
---@field points vec[] Its corners, relative to its position; pixels in a layer on the screen. · m · any length · default {}
---@field position vec Where its point (0, 0) is, relative to its parent. · m · -1e9 to 1e9 · default vec(0, 0)
---@field visible boolean Whether it is drawn. · true or false · default true
---@field width number Thickness; never less than a pixel. Pixels in a layer on the screen. · m · 0 to 1e6 · default 0.05
local fettle_Line = {}

---A line through several points, with round corners and ends.
---@class Class.Line : Class
---@overload fun(members?: table): Line
Line = {}

---Instances below it are drawn together: far away, repeated, translucent, or on the screen. It does not change where bodies are.
---@class Layer : Object
---@field anchor "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" The point of the screen from which positions are counted, if `space` is screen. · "top_left", "top", "top_right", "left", "center", "right", "bottom_left", "bottom", "bottom_right" · default "top_left"
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field opacity number Multiplies the opacity of everything below it. · 0 to 1 · default 1
---@field parallax vec How fast it moves past when the view moves: 1 as the world, 0.5 half as fast, as if it were far away, 0 not at all. For `space` world. · -1000 to 1000 · default vec(1, 1)
---@field repeat_x number Distance after which its content repeats to the left and right; 0: never. Pixels on the screen. · m · 0 to 1e9 · default 0
---@field repeat_y number Distance after which its content repeats up and down; 0: never. Pixels on the screen. · m · 0 to 1e9 · default 0
---@field scale number Enlarges everything below it, positions included, from the anchor on the screen or from the origin of the world. · 0.001 to 1000 · default 1
---@field space "world"|"screen" world: in meters, y up. screen: in pixels from `anchor`, y down, whatever the view shows. · "world", "screen" · default "world"
---@field visible boolean Whether it is drawn. · true or false · default true
local fettle_Layer = {}

---Instances below it are drawn together: far away, repeated, translucent, or on the screen. It does not change where bodies are.
---@class Class.Layer : Class
---@overload fun(members?: table): Layer
Layer = {}

---set_tile changed a cell.
---@class Tilemap.cell_changed
---@field layer TileLayer The layer of the cell.
---@field x integer Column, from 0.
---@field y integer Row from the top, from 0.
---@field tile integer The tile there now.
---@field before integer The tile before.
---@field instance Tilemap The instance with the event.
---@field step integer The fixed step in which it happened.

---It has instances for its map file. Its collisions follow at the same barrier.
---@class Tilemap.loaded
---@field instance Tilemap The instance with the event.
---@field step integer The fixed step in which it happened.

---A map of the Tiled editor, or one that a script makes of a `tileset`. Its tile layers, image layers and objects become instances below it, and solid tiles a body with smooth outlines. Belongs below a World if bodies are to collide with it.
---@class Tilemap : Object
---@field animation_time number Time since the animations of the tiles began. · s · 0 to 1e9 · default 0 · simulated
---@field cells vec For a map without a file: the number of cells side by side, and of rows. Cells that were written stay when it changes. · 0 to 2048 · default vec(0, 0)
---@field columns integer Number of cells side by side; 0 for an infinite map. · any integer · read-only
---@field corner vec Where the lower left corner of the map is in the world; of an infinite map, the upper left corner of cell (0, 0). Objects are placed once, when they are made. · m · -1e6 to 1e6 · default vec(0, 0)
---@field map string A map file of the Tiled editor in the game's folder (TMJ or TMX). Another name makes the instances of that file in place of those that were made. · any text · default ""
---@field pixels_per_unit number Pixels of the map in a meter. · px/m · 0.001 to 1e6 · default 32
---@field rows integer Number of rows of cells; 0 for an infinite map. · any integer · read-only
---@field size vec Width and height of the map; 0 for an infinite map. · m · any finite vec · read-only
---@field smooth boolean Whether pixels are mixed when tiles are enlarged; otherwise each is a square. · true or false · default false
---@field solid_tiles integer[] For an image `tileset`: the numbers of the solid tiles. · 1 to 1e6 · default {}
---@field tile_size vec Width and height of a tile in the image `tileset`. A tileset file and a map file have their own. · px · 1 to 4096 · default vec(16, 16)
---@field tileset string For a map without a file: an image with tiles, or a tileset file of the Tiled editor (TSJ or TSX). The map has one layer, `tiles`, of empty cells, for `set_tile`. · any text · default ""
local fettle_Tilemap = {}

---The cell at a point of the world.
---@param point vec A point in the world. · m
---@return vec cell Column and row, whole numbers; also outside of the map.
function fettle_Tilemap:cell_at(point) end

---The middle of a cell.
---@param x integer Column, from 0 at the left, as the editor counts.
---@param y integer Row, from 0 at the top, as the editor counts.
---@return vec point The point in the world. · m
function fettle_Tilemap:cell_center(x, y) end

---The shortest way over cells without solid tiles.
---@param from vec A point in the world. · m
---@param to vec A point in the world. · m
---@param diagonals? boolean Whether a step may lead over a corner, if both cells beside it are free; true if it is left out.
---@return vec[]? points The middles of the cells after that of `from`; nil if there is no way, or none that is found in 250 000 cells.
function fettle_Tilemap:path(from, to, diagonals) end

---Reads the map file again and makes its instances again. Changed cells stay changed in layers that the file still has.
function fettle_Tilemap:reload() end

---Changes a cell. Its collisions follow at the next barrier, before the next step.
---@param x integer Column, from 0 at the left, as the editor counts.
---@param y integer Row, from 0 at the top, as the editor counts.
---@param tile integer Number of a tile in the map, from 1: the first tileset has the first numbers. 0: none.
---@param layer? string Name of a tile layer; the first one if it is left out.
---@param flips? string As tile_flips returns them; not flipped if it is left out.
function fettle_Tilemap:set_tile(x, y, tile, layer, flips) end

---Changes many cells at once, from column x and row y to the right and downwards. For a whole level it takes a small part of the time of set_tile for each cell.
---@param x integer Column, from 0 at the left, as the editor counts.
---@param y integer Row, from 0 at the top, as the editor counts.
---@param rows any[] A list of tiles for each row, downwards: 0 is an empty cell, -1 leaves the cell as it is.
---@param layer? string Name of a tile layer; the first one if it is left out.
function fettle_Tilemap:set_tiles(x, y, rows, layer) end

---The tile of a cell; 0 if it is empty or outside of the layer.
---@param x integer Column, from 0 at the left, as the editor counts.
---@param y integer Row, from 0 at the top, as the editor counts.
---@param layer? string Name of a tile layer; the first one if it is left out.
---@return integer tile Number of a tile in the map, from 1: the first tileset has the first numbers. 0: none.
function fettle_Tilemap:tile(x, y, layer) end

---How the tile of a cell is flipped.
---@param x integer Column, from 0 at the left, as the editor counts.
---@param y integer Row, from 0 at the top, as the editor counts.
---@param layer? string Name of a tile layer; the first one if it is left out.
---@return string flips Letters: x for left and right, y for top and bottom, d for the exchange of x and y before these.
function fettle_Tilemap:tile_flips(x, y, layer) end

---A custom property of a tile, as the editor saved it.
---@param tile integer Number of a tile in the map, from 1: the first tileset has the first numbers. 0: none.
---@param name string Name of a custom property, or "class".
---@return any? value Its value; nil if the tile does not have it.
function fettle_Tilemap:tile_property(tile, name) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Tilemap, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Tilemap, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Tilemap, event: "loaded", handler: fun(record: Tilemap.loaded)): Connection
---@overload fun(self: Tilemap, event: "cell_changed", handler: fun(record: Tilemap.cell_changed)): Connection
function fettle_Tilemap:on(event, handler) end

---A map of the Tiled editor, or one that a script makes of a `tileset`. Its tile layers, image layers and objects become instances below it, and solid tiles a body with smooth outlines. Belongs below a World if bodies are to collide with it.
---@class Class.Tilemap : Class
---@overload fun(members?: table): Tilemap
Tilemap = {}

---A layer of tiles of the Tilemap that it is below. The map makes one for each tile layer of its file.
---@class TileLayer : Object
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field changes string[] The cells that differ from the map file, a text for each row, such as "3: 7=12 8=0": in row 3, column 7 has tile 12 and column 8 none. · any length · default {}
---@field friction number Friction of its solid tiles. · 0 to 1e6 · default 0.6
---@field layer integer Number of the layer in the map file, as the editor gave it. · 0 to 1e9 · default 0
---@field offset vec Moves the whole layer, its collisions too. · m · -1e6 to 1e6 · default vec(0, 0)
---@field opacity number Multiplies the opacity of its tiles. · 0 to 1 · default 1
---@field parallax vec How fast it moves past when the view moves: 1 as the world, 0.5 half as fast, 0 not at all. · -1000 to 1000 · default vec(1, 1)
---@field restitution number Share of the speed with which bodies bounce off its solid tiles. · 0 to 1 · default 0
---@field solid boolean Whether bodies collide with its solid tiles: those with collision shapes, and those with the custom property `solid`. · true or false · default true
---@field tint color The colors of its tiles are multiplied by it. · 0 to 1 · default color("#ffffff")
---@field visible boolean Whether it is drawn. · true or false · default true
local fettle_TileLayer = {}

---A layer of tiles of the Tilemap that it is below. The map makes one for each tile layer of its file.
---@class Class.TileLayer : Class
---@overload fun(members?: table): TileLayer
TileLayer = {}

---Its last particle has ended, and no other will begin by itself: `rate` is 0, or it is not playing.
---@class Emitter.finished
---@field instance Emitter The instance with the event.
---@field step integer The fixed step in which it happened.

---Sparks, smoke, rain: many small pictures that begin here, fly, change and end. Its parent moves it: a body, a sprite, or any instance with a `position`.
---@class Emitter : Object
---@field angle number Direction in which particles fly: 0 is to the right, pi / 2 upwards. Relative to its parent. · rad · -1e6 to 1e6 · default 0
---@field area vec Width and height of the shape; pixels in a layer on the screen. · m · 0 to 1e6 · default vec(1, 1)
---@field blend "normal"|"add"|"multiply" How its colors are put on what is there: normal covers it, add makes it lighter, multiply makes it darker. · "normal", "add", "multiply" · default "normal"
---@field burst integer Number of particles that begin at once, when it is placed or when `playing` becomes true. · 0 to 200000 · default 0
---@field color color[] Colors over its life, by which those of the image are multiplied. · 0 to 1 · default {color("#ffffff"), color("#ffffff00")}
---@field count integer Number of particles now. · any integer · read-only, simulated
---@field damping number Share of their velocity that particles lose in a second, for small values. · 1/s · 0 to 10000 · default 0
---@field gravity vec Acceleration of all particles; pixels, y down, in a layer on the screen. · m/s² · -1e6 to 1e6 · default vec(0, 0)
---@field image string An image file in the game's folder; a soft white dot if it is empty. · any text · default ""
---@field lifetime number Time after which a particle ends. · s · 0.001 to 10000 · default 1
---@field limit integer Largest number of particles at a time; no further ones begin. All emitters together have at most 500 000. · 0 to 200000 · default 1000
---@field playing boolean Whether new particles begin. Those that have begun live on. · true or false · default true
---@field position vec Where it is, relative to its parent; pixels in a layer on the screen. · m · -1e9 to 1e9 · default vec(0, 0)
---@field randomness number Share by which lifetime, speed and size of a particle are larger or smaller. · 0 to 1 · default 0.3
---@field rate number Number of particles that begin in a second. · 1/s · 0 to 1e6 · default 20
---@field rotation number How fast particles turn, half of them to either side. Unless it is 0, each begins at an angle of its own. · rad/s · -10000 to 10000 · default 0
---@field seed integer Emitters with the same seed and properties make the same particles. · 0 to 1e15 · default 0
---@field shape "point"|"circle"|"ring"|"box" Where particles begin: at its position, anywhere in an ellipse (circle) or a rectangle (box) of the size `area`, or on the line around the ellipse (ring). · "point", "circle", "ring", "box" · default "point"
---@field size number[] Heights of a particle over its life, at equal distances from its beginning to its end; pixels in a layer on the screen. · m · 0 to 1e6 · default {0.2}
---@field smooth boolean Whether pixels are mixed when the image is enlarged; otherwise each is a square. · true or false · default true
---@field space "world"|"local" world: particles stay where they are when the emitter moves on. local: they move and turn with it. · "world", "local" · default "world"
---@field speed number Speed at which particles begin; pixels in a layer on the screen. · m/s · -1e6 to 1e6 · default 2
---@field spread number Angle between the outermost directions. 2 pi: all directions. · rad · 0 to 6.283185307179586 · default 6.283185307179586
---@field visible boolean Whether it is drawn. · true or false · default true
local fettle_Emitter = {}

---Removes all particles.
function fettle_Emitter:clear() end

---Lets particles begin at once, in the next step, also while it is not playing.
---@param count integer Number of particles, up to `limit` at a time.
function fettle_Emitter:emit(count) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Emitter, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Emitter, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Emitter, event: "finished", handler: fun(record: Emitter.finished)): Connection
function fettle_Emitter:on(event, handler) end

---Sparks, smoke, rain: many small pictures that begin here, fly, change and end. Its parent moves it: a body, a sprite, or any instance with a `position`.
---@class Class.Emitter : Class
---@overload fun(members?: table): Emitter
Emitter = {}

---The branches besides the present one, the oldest first. A branch is what came later, where the game went on from an earlier step. It is kept as long as the past.
---@class Time.branches.result
---@field name string Its name.
---@field fork integer The last step that it has in common with the present branch.
---@field newest integer Its last step.

---Simulation time: how fast it passes, and how much has passed.
---@class Time : Object
---@field alpha number How far the picture is between the last two steps. · 0 to 1 · read-only, simulated
---@field branch string The name of the present branch; time:name_branch changes it. · any text · read-only, simulated
---@field branch_limit integer How many branches are kept besides the present one: what came later, where the game went on from an earlier step. 0: none. · 0 to 16 · default 4 · not saved
---@field dropped_steps integer Steps that were due but given up, since frames took too long. · any integer · read-only, simulated
---@field dt number Length of a fixed step. Smaller steps are more exact and cost more. · s · 0.00001 to 1 · default 0.016666666666666666
---@field fps number Frames a second, smoothed. 0 in a headless run. · 1/s · any finite number · read-only, simulated
---@field frame integer Frames made since the game started. · any integer · read-only, simulated
---@field max_steps integer How many steps a slow frame may make to catch up. What is due beyond that is dropped: the game slows down. · 1 to 1000 · default 5
---@field newest integer The last step made; beyond `step` after going back, until a step is made from there. · any integer · read-only, simulated
---@field now number Simulation time since the game started. · s · any finite number · read-only, simulated
---@field oldest integer The first step to which you can go back. · any integer · read-only, simulated
---@field paused boolean Whether simulation time stands still. update and draw are still called. · true or false · default false · not saved
---@field real number Real time since the game started, also while it is paused: the sum of real_dt of all updates. It is never rewound. In a headless run, a frame is as long as a step. · s · any finite number · read-only, simulated
---@field rewind_limit number How much of the past is kept, for rewind and the time bar; 0: nothing. · s · 0 to 3600 · default 60 · not saved
---@field rewind_memory number How much memory the past and the history of edits may take together; where that is too little, less is kept. Undo has a quarter of it at most. · MiB · 1 to 65536 · default 128 · not saved
---@field scale number Simulated seconds a real second: 0.1 is slow motion. A headless run ignores it. · 0 to 100 · default 1
---@field step integer Fixed steps made since the game started. · any integer · read-only, simulated
---@field step_once boolean Set it to make one step while paused; it is false again when the step is made. · true or false · default false · not saved
---@field timings Timings Where a frame's time goes, smoothed over about half a second. In a headless run a frame is one turn of the loop, and the half second is simulation time.
local fettle_Time = {}

---The branches besides the present one, the oldest first. A branch is what came later, where the game went on from an earlier step. It is kept as long as the past.
---@return Time.branches.result[]
function fettle_Time:branches() end

---Drops a branch, at the next barrier.
---@param branch string The name of a branch.
function fettle_Time:forget_branch(branch) end

---Goes to that step of the past, or back to the present, at the next barrier. When a step is made from there, what came later becomes another branch.
---@param step integer From `oldest` to `newest`.
function fettle_Time:go_to(step) end

---Gives a branch a name. Where there is no room for all, branches without a name are dropped first.
---@param name string The new name, 1 to 40 bytes, of no other branch.
---@param branch? string The old name; the present branch if it is left out.
function fettle_Time:name_branch(name, branch) end

---Makes that branch the present one and goes to its last step, at the next barrier. The branch that was present is kept.
---@param branch string The name of a branch.
function fettle_Time:switch_to(branch) end

---Simulation time: how fast it passes, and how much has passed.
---@class Class.Time : Class
Time = {}

---Where a frame's time goes, smoothed over about half a second. In a headless run a frame is one turn of the loop, and the half second is simulation time.
---@class Timings : Object
---@field draw number Drawing, layers included. · ms · any finite number · read-only, simulated
---@field frame number The whole frame, waiting for the screen included. · ms · any finite number · read-only, simulated
---@field handlers number Barriers: watchers and event handlers. · ms · any finite number · read-only, simulated
---@field input number Delivering input to the game. · ms · any finite number · read-only, simulated
---@field modules number Steps of the modules: the physics. · ms · any finite number · read-only, simulated
---@field scripts number Timers, coroutines and step(dt). · ms · any finite number · read-only, simulated
---@field update number The game's update(dt). · ms · any finite number · read-only, simulated
---@field wait number Waiting for the screen, and what is in no other part; 0 in a headless run. · ms · any finite number · read-only, simulated
local fettle_Timings = {}

---Where a frame's time goes, smoothed over about half a second. In a headless run a frame is one turn of the loop, and the half second is simulation time.
---@class Class.Timings : Class
Timings = {}

---Which part of the world is seen, and what lies over it.
---@class View : Object
---@field angle number The turn of the viewer, counter-clockwise: the picture turns the other way. · rad · -1e6 to 1e6 · default 0
---@field background color The color behind everything. · 0 to 1 · default color("#1b1f27")
---@field center vec The point of the world in the middle of the screen. · m · -1e9 to 1e9 · default vec(0, 0) · simulated
---@field dead_zone vec Width and height of the box round the center: while the followed instance is in this box, the picture does not move. · m · 0 to 1e9 · default vec(0, 0)
---@field design vec The size of the picture for which the game is made, for `fit` letterbox and pixel. · px · 1 to 16384 · default vec(1280, 800)
---@field effect string A fragment shader in GLSL, a file in the game's folder (.frag, .glsl), through which the picture with its menus is drawn; empty: none. Its uniforms are the properties of `view.uniforms`. · any text · default ""
---@field fit "expand"|"letterbox"|"pixel" How the picture fits into the window. expand: all of the window is used. letterbox: what is seen has the proportions of `design`, with black bars beside it. pixel: so that each pixel of `design` is a whole number of pixels. · "expand", "letterbox", "pixel" · default "expand"
---@field follow Object? It moves with this instance, from step to step. · any instance · default nil
---@field follow_damping number The time in which it makes two thirds of the way to what it follows; 0: it is always there. · s · 0 to 1000 · default 0
---@field height number How much of the world is seen from the bottom of the screen to its top. · m · 0.001 to 1e6 · default 20
---@field limits vec[] The lower and the upper corner of the part of the world that may be seen; empty: all of it. If that part is smaller than what is seen, it is in the middle. · m · any length · default {}
---@field lower vec The smallest x and y of the world that are seen: the bottom left corner unless the view is turned. · m · any finite vec · read-only
---@field screen vec Size of the picture on the screen: of the window, without the bars of `fit`. In a headless run, the size that a window would have. · px · any finite vec · read-only, simulated
---@field upper vec The largest x and y of the world that are seen: the top right corner unless the view is turned. · m · any finite vec · read-only
---@field width number How much of the world is seen from side to side. · m · any finite number · read-only
---@field zoom number Pixels a meter. Setting it changes the height, which has a range of its own. · px/m · 0.001 to 1e6 · default computed · simulated, not saved
---@field show Show What is shown over the picture, for looking into a game.
---@field uniforms Uniforms Values for the uniforms of `view.effect`: each property that is added here is the uniform of that name. A number is a float or an int, a boolean a bool, a vec a vec2, a color a vec3 or vec4.
---@field window GameWindow The window of the game. It is not part of saved games, and going back in time leaves it as it is.
local fettle_View = {}

---Shakes the picture, for an explosion or a blow. Only what is drawn moves; a weaker shake does not end a stronger one.
---@param amount number How far the picture is moved at the beginning. · m
---@param seconds? number How long it takes to come to rest; 0.5 if it is left out. · s
function fettle_View:shake(amount, seconds) end

---Where a point of the world is on the screen, from the top left corner, y down.
---@param point vec In the world. · m
---@return vec pixels From the top left corner, y down. · px
function fettle_View:to_screen(point) end

---The point of the world that is seen at a point of the screen.
---@param pixels vec From the top left corner, y down. · px
---@return vec point In the world. · m
function fettle_View:to_world(pixels) end

---Which part of the world is seen, and what lies over it.
---@class Class.View : Class
View = {}

---What is shown over the picture, for looking into a game.
---@class Show : Object
---@field aabbs boolean Axis-aligned bounding boxes of shapes. · true or false · default false · not saved
---@field blame boolean What wrote last: each instance has the color of the line of a script, the console, the inspector or the physics that wrote it. · true or false · default false · not saved
---@field centers boolean Centers of mass. · true or false · default false · not saved
---@field contacts boolean Contact points, their normals and impulses. · true or false · default false · not saved
---@field grid boolean A grid of meters. · true or false · default false · not saved
---@field impulses boolean Impulses of contacts in the last step, as arrows with one scale for all. · true or false · default false · not saved
---@field islands boolean Islands: bodies that sleep and wake together, each island in a color of its own. · true or false · default false · not saved
---@field joints boolean Joints and their anchors. · true or false · default false · not saved
---@field limits boolean Limits of joints: the angles and ways that they allow. · true or false · default false · not saved
---@field names boolean Names of bodies. Where names would overlap, only one is drawn. · true or false · default false · not saved
---@field onion_skins boolean Earlier poses of the selected instance while the console is open, and later ones after going back. · true or false · default false · not saved
---@field shapes boolean Outlines of all shapes, also of those that are not visible because the game draws something else. · true or false · default false · not saved
---@field timings boolean Frames a second, and where a frame's time goes. · true or false · default false · not saved
---@field velocities boolean Velocities of bodies, as lines. · true or false · default false · not saved
---@field wires boolean Formulas: arrows from what a formula reads to what it writes. · true or false · default false · not saved
local fettle_Show = {}

---What is shown over the picture, for looking into a game.
---@class Class.Show : Class
Show = {}

---The window of the game. It is not part of saved games, and going back in time leaves it as it is.
---@class GameWindow : Object
---@field cursor "arrow"|"hand"|"text"|"cross"|"move"|"size_horizontal"|"size_vertical"|"wait"|"help"|"not_allowed" Form of the pointer of the mouse over the window. · "arrow", "hand", "text", "cross", "move", "size_horizontal", "size_vertical", "wait", "help", "not_allowed" · default "arrow" · not saved
---@field cursor_visible boolean Whether the pointer of the mouse is seen over the window. · true or false · default true · not saved
---@field fullscreen boolean Whether the game fills the screen. F11 and Alt+Enter change it, and the next run remembers it. · true or false · default false · not saved
---@field grab_mouse boolean Whether the pointer of the mouse is kept inside the window while the window has the keyboard. · true or false · default false · not saved
---@field icon string An image file in the game's folder (PNG, JPEG, BMP, TGA) that the system shows for the window; at the start that of game.json. Empty: that of the system, or the last one. · any text · default "" · not saved
---@field resizable boolean Whether the player can change the size of the window. · true or false · default true · not saved
---@field size vec Size of the window while it is not fullscreen. view.screen is what is seen now. · px · 1 to 16384 · default vec(1280, 800) · simulated, not saved
---@field title string Title of the window; at the start that of game.json. · any text · default "Fettle" · not saved
---@field vsync boolean Whether frames wait for the screen. false: they are drawn as fast as possible. · true or false · default true · not saved
local fettle_GameWindow = {}

---The window of the game. It is not part of saved games, and going back in time leaves it as it is.
---@class Class.GameWindow : Class
GameWindow = {}

---Everything that is heard.
---@class Audio : Object
---@field max_voices integer How many voices may sound at once. One more ends the oldest; music ends last. · 1 to 256 · default 64
---@field muted boolean Silences everything and leaves the volume as it is. · true or false · default false
---@field voices Object[] The voices that sound, oldest first. · any length · read-only, simulated
---@field volume number Loudness of everything, 1 being that of the recordings. · 0 to 1 · default 1
---@field buses Buses The buses of a game. Add your own: `audio.buses.speech = Bus {}`.
local fettle_Audio = {}

---Ends every voice, without `finished`.
---@param fade? number How long it takes to fade, 0 to 1000. 0: none. · s
function fettle_Audio:stop(fade) end

---Everything that is heard.
---@class Class.Audio : Class
Audio = {}

---The buses of a game. Add your own: `audio.buses.speech = Bus {}`.
---@class Buses : Object
local fettle_Buses = {}

---The buses of a game. Add your own: `audio.buses.speech = Bus {}`.
---@class Class.Buses : Class
Buses = {}

---A group of sounds with a volume of its own. It acts below `audio.buses`.
---@class Bus : Object
---@field muted boolean Silences the bus and leaves its volume as it is. · true or false · default false
---@field pauses boolean Whether its sounds pause with the game (time.paused). false: they go on in real time. · true or false · default true
---@field volume number Loudness of all sounds of the bus. · 0 to 1 · default 1
local fettle_Bus = {}

---A group of sounds with a volume of its own. It acts below `audio.buses`.
---@class Class.Bus : Class
---@overload fun(members?: table): Bus
Bus = {}

---A voice has played to its end. Not for one that was stopped.
---@class SoundSource.finished
---@field voice Voice The voice, which lives until the next step.
---@field instance SoundSource The instance with the event.
---@field step integer The fixed step in which it happened.

---What can be played. Its voices are below it while they sound.
---@class SoundSource : Object
---@field bus string The name of the bus in `audio.buses` whose volume applies to it, too. · any text · default "effects"
---@field duration number How long it sounds at a pitch of 1. · s · any finite number · read-only, simulated
---@field loop boolean Whether a voice begins again at the end. · true or false · default false
---@field max_voices integer How many of its voices may sound at once. One more ends the oldest. · 1 to 256 · default 8
---@field pitch number How fast it is played: 2 is an octave higher and half as long. · 0.01 to 100 · default 1
---@field position vec? Where it is heard from: from the center of the body or other instance with a position that it is below, and turning with it, or else in the world. nil: at that center, or everywhere the same if it is below none. · m · -1e9 to 1e9 · default nil · may be nil
---@field range number How far from the center of the view it can be heard. Only for a sound that is heard from a place. · m · 0.001 to 1e6 · default 50
---@field volume number Loudness, 1 being that of the recording. · 0 to 4 · default 1
local fettle_SoundSource = {}

---Begins a voice. Music that sounds already goes on, and other music of its bus fades out.
---@param volume? number Of this voice.
---@param pitch? number Of this voice.
---@param fade? number How long it takes to become loud, 0 to 1000. · s
---@param time? number Where in the sound it begins. · s
---@param position? vec Where in the world it is heard from. · m
---@return Voice voice The voice, as long as it sounds.
function fettle_SoundSource:play(volume, pitch, fade, time, position) end

---Ends its voices, without `finished`.
---@param fade? number How long it takes to fade, 0 to 1000. 0: none. · s
function fettle_SoundSource:stop(fade) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: SoundSource, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: SoundSource, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: SoundSource, event: "finished", handler: fun(record: SoundSource.finished)): Connection
function fettle_SoundSource:on(event, handler) end

---What can be played. Its voices are below it while they sound.
---@class Class.SoundSource : Class
SoundSource = {}

---A sound from a file, kept decoded: for effects, which may sound many at once.
---@class Sound : SoundSource
---@field file string The file below the game's folder: WAV, OGG or FLAC, and MP3 with SFML 2.6. · any text · default ""
local fettle_Sound = {}

---A sound from a file, kept decoded: for effects, which may sound many at once.
---@class Class.Sound : Class
---@overload fun(members?: table): Sound
Sound = {}

---Music from a file, decoded while it plays. In each bus only one sounds at a time: another one fades in while it fades out.
---@class Music : SoundSource
---@field bus string The name of the bus in `audio.buses` whose volume applies to it, too. · any text · default "music"
---@field fade number How long it takes to fade in, and other music of its bus to fade out. · s · 0 to 1000 · default 1
---@field file string The file below the game's folder: WAV, OGG or FLAC, and MP3 with SFML 2.6. · any text · default ""
---@field loop boolean Whether it begins again at the end. · true or false · default true
local fettle_Music = {}

---Music from a file, decoded while it plays. In each bus only one sounds at a time: another one fades in while it fades out.
---@class Class.Music : Class
---@overload fun(members?: table): Music
Music = {}

---A sound from parameters, without a file. `Synth.coin()`, `jump`, `hit`, `explosion`, `blip` and `power_up` make ready ones. A changed parameter is heard at once, also in voices that sound.
---@class Synth : SoundSource
---@field arpeggio number Semitones by which the pitch jumps at `arpeggio_time`. · -48 to 48 · default 0
---@field arpeggio_time number When the pitch jumps. · s · 0 to 10 · default 0.1
---@field attack number How long the sound takes to become loud. · s · 0 to 10 · default 0
---@field decay number How long it takes to end. · s · 0 to 10 · default 0.2
---@field duty number The part of a period in which a square wave is high. Other waves have none. · 0.01 to 0.99 · default 0.5
---@field duty_slide number How much `duty` grows a second. · 1/s · -100 to 100 · default 0
---@field filter number A short name for `low_pass`. · Hz · 20 to 20000 · default computed · not saved
---@field flanger number The sound is heard a second time, with this delay. 0: once. · ms · 0 to 50 · default 0
---@field flanger_slide number How fast that delay grows. · ms/s · -1000 to 1000 · default 0
---@field frequency number The pitch at the beginning. · Hz · 1 to 20000 · default 440
---@field high_pass number Lower tones than this are weakened, which sounds thin. 0: none. · Hz · 0 to 20000 · default 0
---@field high_pass_slide number Octaves a second by which `high_pass` rises. · 1/s · -100 to 100 · default 0
---@field low_pass number Higher tones than this are weakened, which sounds dull. 20000: none. · Hz · 20 to 20000 · default 20000
---@field low_pass_slide number Octaves a second by which `low_pass` rises. · 1/s · -100 to 100 · default 0
---@field punch number How much louder it is at the beginning of `sustain`: 1 is twice as loud. · 0 to 1 · default 0
---@field resonance number How much tones at `low_pass` stand out. · 0 to 1 · default 0
---@field retrigger number After this time slides and arpeggio begin again, again and again. 0: never. · s · 0 to 10 · default 0
---@field seed integer Which noise it is. The same seed gives the same noise. · 0 to 1e15 · default 1
---@field slide number Octaves a second by which the pitch rises, or falls if negative. · 1/s · -100 to 100 · default 0
---@field slide_change number How fast `slide` itself changes, in octaves a second each second. · 1/s² · -1000 to 1000 · default 0
---@field sustain number How long it stays loud. · s · 0 to 10 · default 0.1
---@field vibrato number How far the pitch swings to either side, in semitones. · 0 to 24 · default 0
---@field vibrato_rate number How often it swings. · Hz · 0 to 200 · default 8
---@field volume number Loudness, 1 being as loud as a file can be. · 0 to 4 · default 0.5
---@field wave "square"|"saw"|"sine"|"triangle"|"noise" The form of the wave. · "square", "saw", "sine", "triangle", "noise" · default "square"
local fettle_Synth = {}

---Changes about half of the numbers by a random amount, with the random numbers of the game.
---@param amount? number How much, 0 to 1: 0.1 is a variation, 1 another sound. Default 0.1.
function fettle_Synth:mutate(amount) end

---Sets all parameters to those of a preset.
---@param name string "coin", "jump", "hit", "explosion", "blip", "power_up".
function fettle_Synth:preset(name) end

---The form of the sound, for a picture of it.
---@param columns integer In how many parts of the same length, 1 to 4096.
---@return vec[] columns For each part its lowest and its highest sample, from -1 to 1: vec(lowest, highest).
function fettle_Synth:wave_form(columns) end

---A sound from parameters, without a file. `Synth.coin()`, `jump`, `hit`, `explosion`, `blip` and `power_up` make ready ones. A changed parameter is heard at once, also in voices that sound.
---@class Class.Synth : Class
---@overload fun(members?: table): Synth
Synth = {}

---It has played to its end.
---@class Voice.finished
---@field instance Voice The instance with the event.
---@field step integer The fixed step in which it happened.

---A Sound, Music or Synth that is playing once; `play` makes it. It ends with the sound, in simulation time.
---@class Voice : Object
---@field fade number Loudness while it fades, on its way to `fade_to`. · 0 to 1 · default 1
---@field fade_time number How long it takes to fade from 0 to 1. · s · 0 to 1000 · default 0
---@field fade_to number The loudness to which it fades. A voice that has faded to 0 ends. · 0 to 1 · default 1
---@field pauses boolean Whether it pauses with the game. false if it began while the game was paused, so that the click of a menu is heard. · true or false · default true
---@field pitch number How fast it is played, in addition to the pitch of its source. · 0.01 to 100 · default 1
---@field playing boolean Whether it goes on; false: it pauses. · true or false · default true
---@field position vec? Where in the world it is heard from. nil: from where its source is. · m · -1e9 to 1e9 · default nil · may be nil
---@field time number How much of the sound it has played. Setting it goes there. · s · 0 to 1e6 · default 0
---@field volume number Loudness, in addition to that of its source. · 0 to 4 · default 1
local fettle_Voice = {}

---Ends it, without `finished`.
---@param fade? number How long it takes to fade, 0 to 1000. 0: none. · s
function fettle_Voice:stop(fade) end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Voice, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Voice, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Voice, event: "finished", handler: fun(record: Voice.finished)): Connection
function fettle_Voice:on(event, handler) end

---A Sound, Music or Synth that is playing once; `play` makes it. It ends with the sound, in simulation time.
---@class Class.Voice : Class
---@overload fun(members?: table): Voice
Voice = {}

---What the player does: keys, mouse, gamepads, and the actions bound to them.
---@class Input : Object
---@field clipboard string The text that was copied last: by the player, or by the game, which sets it. In a window it is the clipboard of the system, as it was when the player last pressed ctrl and V or copied something in the game. · any text · default "" · not saved
---@field dead_zone number How far a stick must be moved before actions react to it. · 0 to 0.9 · default 0.2 · not saved
---@field gamepads Gamepad[] All gamepads, connected or not: input.gamepads[1].left. · any length · read-only
---@field move vec Where the player wants to go, right and up positive, of length 1 at most: from the keys and sticks of `input.actions.move`. · -1 to 1 · read-only, simulated
---@field actions Actions The keys, buttons and sticks of each action, as lists of names: "space", "mouse.left", "gamepad.a", "gamepad_2.left_trigger", "gamepad.left", or a list of four keys: left, right, down, up. Assigning a new name makes an action, nil removes it.
---@field gamepad_1 Gamepad A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@field gamepad_2 Gamepad A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@field gamepad_3 Gamepad A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@field gamepad_4 Gamepad A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@field keys Keys Which keys are held down. Setting one presses or releases it.
---@field mouse Mouse The mouse. Setting a button presses or releases it.
local fettle_Input = {}

---What the player does: keys, mouse, gamepads, and the actions bound to them.
---@class Class.Input : Class
Input = {}

---Which keys are held down. Setting one presses or releases it.
---@class Keys : Object
---@field ["0"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["1"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["2"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["3"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["4"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["5"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["6"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["7"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["8"] boolean Whether the key is held down. · true or false · default false · not saved
---@field ["9"] boolean Whether the key is held down. · true or false · default false · not saved
---@field a boolean Whether the key is held down. · true or false · default false · not saved
---@field apostrophe boolean Whether the key is held down. · true or false · default false · not saved
---@field b boolean Whether the key is held down. · true or false · default false · not saved
---@field backslash boolean Whether the key is held down. · true or false · default false · not saved
---@field backspace boolean Whether the key is held down. · true or false · default false · not saved
---@field c boolean Whether the key is held down. · true or false · default false · not saved
---@field comma boolean Whether the key is held down. · true or false · default false · not saved
---@field d boolean Whether the key is held down. · true or false · default false · not saved
---@field delete boolean Whether the key is held down. · true or false · default false · not saved
---@field down boolean Whether the key is held down. · true or false · default false · not saved
---@field e boolean Whether the key is held down. · true or false · default false · not saved
---@field ["end"] boolean Whether the key is held down. · true or false · default false · not saved
---@field enter boolean Whether the key is held down. · true or false · default false · not saved
---@field equal boolean Whether the key is held down. · true or false · default false · not saved
---@field escape boolean Whether the key is held down. · true or false · default false · not saved
---@field f boolean Whether the key is held down. · true or false · default false · not saved
---@field f1 boolean Whether the key is held down. · true or false · default false · not saved
---@field f2 boolean Whether the key is held down. · true or false · default false · not saved
---@field f3 boolean Whether the key is held down. · true or false · default false · not saved
---@field f4 boolean Whether the key is held down. · true or false · default false · not saved
---@field f5 boolean Whether the key is held down. · true or false · default false · not saved
---@field f6 boolean Whether the key is held down. · true or false · default false · not saved
---@field f7 boolean Whether the key is held down. · true or false · default false · not saved
---@field f8 boolean Whether the key is held down. · true or false · default false · not saved
---@field f9 boolean Whether the key is held down. · true or false · default false · not saved
---@field f10 boolean Whether the key is held down. · true or false · default false · not saved
---@field f11 boolean Whether the key is held down. · true or false · default false · not saved
---@field f12 boolean Whether the key is held down. · true or false · default false · not saved
---@field f13 boolean Whether the key is held down. · true or false · default false · not saved
---@field f14 boolean Whether the key is held down. · true or false · default false · not saved
---@field f15 boolean Whether the key is held down. · true or false · default false · not saved
---@field g boolean Whether the key is held down. · true or false · default false · not saved
---@field grave boolean Whether the key is held down. · true or false · default false · not saved
---@field h boolean Whether the key is held down. · true or false · default false · not saved
---@field home boolean Whether the key is held down. · true or false · default false · not saved
---@field i boolean Whether the key is held down. · true or false · default false · not saved
---@field insert boolean Whether the key is held down. · true or false · default false · not saved
---@field j boolean Whether the key is held down. · true or false · default false · not saved
---@field k boolean Whether the key is held down. · true or false · default false · not saved
---@field l boolean Whether the key is held down. · true or false · default false · not saved
---@field left boolean Whether the key is held down. · true or false · default false · not saved
---@field left_alt boolean Whether the key is held down. · true or false · default false · not saved
---@field left_bracket boolean Whether the key is held down. · true or false · default false · not saved
---@field left_control boolean Whether the key is held down. · true or false · default false · not saved
---@field left_shift boolean Whether the key is held down. · true or false · default false · not saved
---@field left_system boolean Whether the key is held down. · true or false · default false · not saved
---@field m boolean Whether the key is held down. · true or false · default false · not saved
---@field menu boolean Whether the key is held down. · true or false · default false · not saved
---@field minus boolean Whether the key is held down. · true or false · default false · not saved
---@field n boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_0 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_1 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_2 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_3 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_4 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_5 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_6 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_7 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_8 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_9 boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_add boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_divide boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_multiply boolean Whether the key is held down. · true or false · default false · not saved
---@field numpad_subtract boolean Whether the key is held down. · true or false · default false · not saved
---@field o boolean Whether the key is held down. · true or false · default false · not saved
---@field p boolean Whether the key is held down. · true or false · default false · not saved
---@field page_down boolean Whether the key is held down. · true or false · default false · not saved
---@field page_up boolean Whether the key is held down. · true or false · default false · not saved
---@field pause boolean Whether the key is held down. · true or false · default false · not saved
---@field period boolean Whether the key is held down. · true or false · default false · not saved
---@field q boolean Whether the key is held down. · true or false · default false · not saved
---@field r boolean Whether the key is held down. · true or false · default false · not saved
---@field right boolean Whether the key is held down. · true or false · default false · not saved
---@field right_alt boolean Whether the key is held down. · true or false · default false · not saved
---@field right_bracket boolean Whether the key is held down. · true or false · default false · not saved
---@field right_control boolean Whether the key is held down. · true or false · default false · not saved
---@field right_shift boolean Whether the key is held down. · true or false · default false · not saved
---@field right_system boolean Whether the key is held down. · true or false · default false · not saved
---@field s boolean Whether the key is held down. · true or false · default false · not saved
---@field semicolon boolean Whether the key is held down. · true or false · default false · not saved
---@field slash boolean Whether the key is held down. · true or false · default false · not saved
---@field space boolean Whether the key is held down. · true or false · default false · not saved
---@field t boolean Whether the key is held down. · true or false · default false · not saved
---@field tab boolean Whether the key is held down. · true or false · default false · not saved
---@field u boolean Whether the key is held down. · true or false · default false · not saved
---@field up boolean Whether the key is held down. · true or false · default false · not saved
---@field v boolean Whether the key is held down. · true or false · default false · not saved
---@field w boolean Whether the key is held down. · true or false · default false · not saved
---@field x boolean Whether the key is held down. · true or false · default false · not saved
---@field y boolean Whether the key is held down. · true or false · default false · not saved
---@field z boolean Whether the key is held down. · true or false · default false · not saved
local fettle_Keys = {}

---Which keys are held down. Setting one presses or releases it.
---@class Class.Keys : Class
Keys = {}

---The mouse. Setting a button presses or releases it.
---@class Mouse : Object
---@field extra_1 boolean Whether the button is held down. · true or false · default false · not saved
---@field extra_2 boolean Whether the button is held down. · true or false · default false · not saved
---@field left boolean Whether the button is held down. · true or false · default false · not saved
---@field middle boolean Whether the button is held down. · true or false · default false · not saved
---@field right boolean Whether the button is held down. · true or false · default false · not saved
---@field screen vec Where the mouse is on the screen, from the top left corner, y down. · px · any finite vec · default computed · simulated, not saved
---@field wheel number Notches the wheel was turned in this frame, away from the user positive. Setting it turns it by the difference: `wheel` is called in the next frame, in which it reads these notches. · any finite number · default 0 · simulated, not saved
---@field world vec Where the mouse is in the world. Setting it moves the mouse for the game. · m · any finite vec · default computed · simulated, not saved
local fettle_Mouse = {}

---The mouse. Setting a button presses or releases it.
---@class Class.Mouse : Class
Mouse = {}

---A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@class Gamepad : Object
---@field a boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "a". · true or false · default false · not saved
---@field b boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "b". · true or false · default false · not saved
---@field back boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "back". · true or false · default false · not saved
---@field button_1 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "1". · true or false · default false · not saved
---@field button_2 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "2". · true or false · default false · not saved
---@field button_3 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "3". · true or false · default false · not saved
---@field button_4 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "4". · true or false · default false · not saved
---@field button_5 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "5". · true or false · default false · not saved
---@field button_6 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "6". · true or false · default false · not saved
---@field button_7 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "7". · true or false · default false · not saved
---@field button_8 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "8". · true or false · default false · not saved
---@field button_9 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "9". · true or false · default false · not saved
---@field button_10 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "10". · true or false · default false · not saved
---@field button_11 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "11". · true or false · default false · not saved
---@field button_12 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "12". · true or false · default false · not saved
---@field button_13 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "13". · true or false · default false · not saved
---@field button_14 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "14". · true or false · default false · not saved
---@field button_15 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "15". · true or false · default false · not saved
---@field button_16 boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "16". · true or false · default false · not saved
---@field connected boolean Whether there is such a gamepad. Before it disconnects, all its buttons and axes are released. · true or false · default false · not saved
---@field dpad_down boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "dpad_down". · true or false · default false · not saved
---@field dpad_left boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "dpad_left". · true or false · default false · not saved
---@field dpad_right boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "dpad_right". · true or false · default false · not saved
---@field dpad_up boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "dpad_up". · true or false · default false · not saved
---@field guide boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "guide". · true or false · default false · not saved
---@field left vec The left stick, right and up positive. Setting it moves it: gamepad_axis is called with "left_x" and "left_y". · -1 to 1 · default vec(0, 0) · not saved
---@field left_shoulder boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "left_shoulder". · true or false · default false · not saved
---@field left_stick boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "left_stick". · true or false · default false · not saved
---@field left_trigger number How far the left trigger is pulled. Setting it pulls it: gamepad_axis is called with "left_trigger". · 0 to 1 · default 0 · not saved
---@field mapping string Which button and axis of the device has which name: "xbox", "playstation", "switch_pro", or a text in the format of the community's mapping files, such as "a:b0,b:b1,leftx:a0,dpup:h0.1". · any text · default "xbox" · not saved
---@field pad vec The directional pad, right and up positive. A player moves it to -1, 0 or 1; a script may set what lies between. Setting it moves it: gamepad_axis is called with "pad_x" and "pad_y". · -1 to 1 · default vec(0, 0) · not saved
---@field right vec The right stick, right and up positive. Setting it moves it: gamepad_axis is called with "right_x" and "right_y". · -1 to 1 · default vec(0, 0) · not saved
---@field right_shoulder boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "right_shoulder". · true or false · default false · not saved
---@field right_stick boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "right_stick". · true or false · default false · not saved
---@field right_trigger number How far the right trigger is pulled. Setting it pulls it: gamepad_axis is called with "right_trigger". · 0 to 1 · default 0 · not saved
---@field start boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "start". · true or false · default false · not saved
---@field x boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "x". · true or false · default false · not saved
---@field y boolean Whether the button is held down. Setting it presses or releases it: gamepad_pressed or gamepad_released is called with "y". · true or false · default false · not saved
local fettle_Gamepad = {}

---A gamepad: two sticks, a directional pad, two triggers and up to sixteen buttons, by number and, as far as `mapping` knows them, by name. Setting one moves, pulls or presses it.
---@class Class.Gamepad : Class
Gamepad = {}

---The keys, buttons and sticks of each action, as lists of names: "space", "mouse.left", "gamepad.a", "gamepad_2.left_trigger", "gamepad.left", or a list of four keys: left, right, down, up. Assigning a new name makes an action, nil removes it.
---@class Actions : Object
---@field move any[] What `input.move` is computed from. · any length · default {{"a", "d", "s", "w"}, {"left", "right", "down", "up"}, "gamepad.left", "gamepad.pad"}
local fettle_Actions = {}

---The keys, buttons and sticks of each action, as lists of names: "space", "mouse.left", "gamepad.a", "gamepad_2.left_trigger", "gamepad.left", or a list of four keys: left, right, down, up. Assigning a new name makes an action, nil removes it.
---@class Class.Actions : Class
Actions = {}

---It began to be held.
---@class Action.press
---@field instance Action The instance with the event.
---@field step integer The fixed step in which it happened.

---It ceased to be held.
---@class Action.release
---@field instance Action The instance with the event.
---@field step integer The fixed step in which it happened.

---What the player wants, from any of several keys, buttons and sticks. input.actions.jump = { "space", "gamepad.a" } makes input.jump.
---@class Action : Object
---@field direction vec The direction of its sticks and sets of four keys, right and up positive, of length 1 at most. · any finite vec · read-only, simulated
---@field held boolean Whether it is held. Setting it to true holds it until it is set to false. · true or false · default false · simulated, not saved
---@field pressed boolean Whether it began to be held: true in one step, and in one update. · true or false · read-only, simulated
---@field released boolean Whether it ceased to be held: true in one step, and in one update. · true or false · read-only, simulated
---@field strength number How far the strongest of its keys, buttons and axes is pressed, 0 to 1: triggers and sticks have values in between. · any finite number · read-only, simulated
local fettle_Action = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Action, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Action, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Action, event: "press", handler: fun(record: Action.press)): Connection
---@overload fun(self: Action, event: "release", handler: fun(record: Action.release)): Connection
function fettle_Action:on(event, handler) end

---What the player wants, from any of several keys, buttons and sticks. input.actions.jump = { "space", "gamepad.a" } makes input.jump.
---@class Class.Action : Class
---@overload fun(members?: table): Action
Action = {}

---Another picture of the world in a part of the screen, for a split screen or a small map. It shows what the view shows, from another place, without layers on the screen: these are drawn over all cameras.
---@class Camera : Object
---@field angle number The turn of the viewer, counter-clockwise: the picture turns the other way. · rad · -1e6 to 1e6 · default 0
---@field background color? The color behind everything; nil: that of the view. · 0 to 1 · default nil · may be nil
---@field center vec The point of the world in its middle. · m · -1e9 to 1e9 · default vec(0, 0)
---@field dead_zone vec Width and height of the box round the center: while the followed instance is in this box, the picture does not move. · m · 0 to 1e9 · default vec(0, 0)
---@field follow Object? It moves with this instance, from step to step. · any instance · default nil
---@field follow_damping number The time in which it makes two thirds of the way to what it follows; 0: it is always there. · s · 0 to 1000 · default 0
---@field height number How much of the world is seen from the bottom of its viewport to its top. · m · 0.001 to 1e6 · default 20
---@field limits vec[] The lower and the upper corner of the part of the world that may be seen; empty: all of it. If that part is smaller than what is seen, it is in the middle. · m · any length · default {}
---@field viewport vec[] The part of the picture that it fills: the upper left and the lower right corner, as parts of width and height from the top left. Without two different corners, it shows nothing. · 0 to 1 · default {vec(0, 0), vec(1, 1)}
---@field visible boolean Whether its picture is drawn. · true or false · default true
---@field zoom number Pixels a meter. Setting it changes the height, which has a range of its own. · px/m · 0.001 to 1e6 · default computed · simulated, not saved
local fettle_Camera = {}

---Shakes the picture, for an explosion or a blow. Only what is drawn moves; a weaker shake does not end a stronger one.
---@param amount number How far the picture is moved at the beginning. · m
---@param seconds? number How long it takes to come to rest; 0.5 if it is left out. · s
function fettle_Camera:shake(amount, seconds) end

---Where it shows a point of the world.
---@param point vec In the world. · m
---@return vec pixels From the top left corner of the picture, y down. · px
function fettle_Camera:to_screen(point) end

---The point of the world that it shows at a pixel.
---@param pixels vec From the top left corner of the picture, y down. · px
---@return vec point In the world. · m
function fettle_Camera:to_world(pixels) end

---Another picture of the world in a part of the screen, for a split screen or a small map. It shows what the view shows, from another place, without layers on the screen: these are drawn over all cameras.
---@class Class.Camera : Class
---@overload fun(members?: table): Camera
Camera = {}

---Values for the uniforms of `view.effect`: each property that is added here is the uniform of that name. A number is a float or an int, a boolean a bool, a vec a vec2, a color a vec3 or vec4.
---@class Uniforms : Object
local fettle_Uniforms = {}

---Values for the uniforms of `view.effect`: each property that is added here is the uniform of that name. A number is a float or an int, a boolean a bool, a vec a vec2, a color a vec3 or vec4.
---@class Class.Uniforms : Class
Uniforms = {}

---Colors, font and distances of widgets. A widget has that of its property `theme`, else that of the widget above it, else interface.theme.
---@class Theme : Object
---@field accent color What is chosen or switched on, and the most important button. · 0 to 1 · default color("#2f6fed")
---@field border color Line around panels and fields. · 0 to 1 · default color("#ffffff21")
---@field control color Buttons, and the tracks of sliders. · 0 to 1 · default color("#323b4d")
---@field field color Background of text fields and lists. · 0 to 1 · default color("#12161e")
---@field focus color Ring around the widget that has the keyboard. · 0 to 1 · default color("#90c1ff")
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder. · any text · default "sans"
---@field font_size number Size of texts. · px · 1 to 1000 · default 17
---@field muted color Text of less importance, such as a placeholder. · 0 to 1 · default color("#aab6c9")
---@field on_accent color Text on the color `accent`. · 0 to 1 · default color("#ffffff")
---@field padding number Distance between the edge of a panel and what is in it. · px · 0 to 1000 · default 22
---@field panel color Background of panels. · 0 to 1 · default color("#1c222e")
---@field radius number Radius of corners. · px · 0 to 1000 · default 9
---@field shade color Covers what is behind a modal widget. · 0 to 1 · default color("#05070b99")
---@field spacing number Distance between the widgets of a row, a column or a list. · px · 0 to 1000 · default 10
---@field text color Text. · 0 to 1 · default color("#f1f4f9")
local fettle_Theme = {}

---Colors, font and distances of widgets. A widget has that of its property `theme`, else that of the widget above it, else interface.theme.
---@class Class.Theme : Class
---@overload fun(members?: table): Theme
Theme = {}

---What panels, buttons and all other parts of menus have in common. They are on the screen, over everything else, in pixels of the layout, which interface.scale makes larger on large screens.
---@class Widget : Object
---@field anchor "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Which point of the panel, or of the screen, it is at, with its own point of that name. Rows, columns and lists place their widgets themselves. · "top_left", "top", "top_right", "left", "center", "right", "bottom_left", "bottom", "bottom_right" · default "top_left"
---@field disabled boolean Whether it is pale and does nothing, with everything below it. · true or false · default false
---@field fill "none"|"width"|"height"|"both" Whether it takes all the width or height that there is. · "none", "width", "height", "both" · default "none"
---@field focused boolean Whether it has the keyboard. · true or false · read-only, simulated
---@field grow number Its share of the length that is left over in a row or column; 0: none. · 0 to 1e6 · default 0
---@field held boolean Whether the player holds it down. · true or false · read-only, simulated
---@field hovered boolean Whether the mouse is over it. · true or false · read-only, simulated
---@field min_size vec The least width and height. · px · 0 to 100000 · default vec(0, 0)
---@field offset vec By how much it is moved from its place, y down. · px · -100000 to 100000 · default vec(0, 0)
---@field opacity number Multiplies the opacity of it and of everything below it. · 0 to 1 · default 1
---@field screen_position vec Where its top left corner is on the screen. · px · any finite vec · read-only, simulated
---@field screen_size vec Its width and height on the screen. · px · any finite vec · read-only, simulated
---@field shown boolean Whether it is on the screen: it and all widgets around it are visible. · true or false · read-only, simulated
---@field size vec Width and height; 0: as large as what is in it needs. · px · 0 to 100000 · default vec(0, 0)
---@field theme Theme? Colors, font and distances of it and of everything below it; nil: those of the widget above it, at the top those of interface.theme. · any Theme · default nil
---@field visible boolean Whether it is drawn and takes up room, with everything below it. · true or false · default true
local fettle_Widget = {}

---Gives it the keyboard. The text of a text field is selected then.
function fettle_Widget:focus() end

---What panels, buttons and all other parts of menus have in common. They are on the screen, over everything else, in pixels of the layout, which interface.scale makes larger on large screens.
---@class Class.Widget : Class
Widget = {}

---It is modal, and the player pressed escape, or B on the gamepad.
---@class Panel.cancelled
---@field instance Panel The instance with the event.
---@field step integer The fixed step in which it happened.

---A box with a background. Each of its widgets is at its own anchor, so it mostly holds one column or row.
---@class Panel : Widget
---@field anchor "top_left"|"top"|"top_right"|"left"|"center"|"right"|"bottom_left"|"bottom"|"bottom_right" Which point of the panel, or of the screen, it is at, with its own point of that name. Rows, columns and lists place their widgets themselves. · "top_left", "top", "top_right", "left", "center", "right", "bottom_left", "bottom", "bottom_right" · default "center"
---@field color color? Its background. nil: that of the theme; rows and columns have none. · 0 to 1 · default nil · may be nil
---@field modal boolean While it is visible, it gets all keys, buttons and clicks: nothing reaches the game or other widgets. If it has a background, a shade covers what is behind it. · true or false · default false
---@field padding number? Distance between its edge and what is in it. nil: that of the theme for panels, 5 for lists, 0 for rows and columns. · px · 0 to 100000 · default nil · may be nil
---@field radius number? Radius of its corners; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
local fettle_Panel = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Panel, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Panel, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Panel, event: "cancelled", handler: fun(record: Panel.cancelled)): Connection
function fettle_Panel:on(event, handler) end

---A box with a background. Each of its widgets is at its own anchor, so it mostly holds one column or row.
---@class Class.Panel : Class
---@overload fun(members?: table): Panel
Panel = {}

---It is modal, and the player pressed escape, or B on the gamepad.
---@class Row.cancelled
---@field instance Row The instance with the event.
---@field step integer The fixed step in which it happened.

---Widgets side by side.
---@class Row : Widget
---@field align "start"|"center"|"end"|"stretch" Where its widgets are across its direction; stretch: they are as wide as it is. · "start", "center", "end", "stretch" · default "center"
---@field color color? Its background. nil: that of the theme; rows and columns have none. · 0 to 1 · default nil · may be nil
---@field justify "start"|"center"|"end" Where its widgets are along its direction if they leave room. · "start", "center", "end" · default "start"
---@field modal boolean While it is visible, it gets all keys, buttons and clicks: nothing reaches the game or other widgets. If it has a background, a shade covers what is behind it. · true or false · default false
---@field padding number? Distance between its edge and what is in it. nil: that of the theme for panels, 5 for lists, 0 for rows and columns. · px · 0 to 100000 · default nil · may be nil
---@field radius number? Radius of its corners; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
---@field spacing number? Distance between its widgets; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
local fettle_Row = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Row, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Row, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Row, event: "cancelled", handler: fun(record: Row.cancelled)): Connection
function fettle_Row:on(event, handler) end

---Widgets side by side.
---@class Class.Row : Class
---@overload fun(members?: table): Row
Row = {}

---It is modal, and the player pressed escape, or B on the gamepad.
---@class Column.cancelled
---@field instance Column The instance with the event.
---@field step integer The fixed step in which it happened.

---Widgets below each other, or in a grid with several columns.
---@class Column : Widget
---@field align "start"|"center"|"end"|"stretch" Where its widgets are across its direction; stretch: they are as wide as it is. · "start", "center", "end", "stretch" · default "stretch"
---@field color color? Its background. nil: that of the theme; rows and columns have none. · 0 to 1 · default nil · may be nil
---@field columns integer How many widgets are side by side: with 4, the first four widgets are the first row of a grid. All columns are as wide as the widest, unless a widget grows: then each is as wide as its widest widget, and those with widgets that grow share what is left. · 1 to 1000 · default 1
---@field justify "start"|"center"|"end" Where its widgets are along its direction if they leave room. · "start", "center", "end" · default "start"
---@field modal boolean While it is visible, it gets all keys, buttons and clicks: nothing reaches the game or other widgets. If it has a background, a shade covers what is behind it. · true or false · default false
---@field padding number? Distance between its edge and what is in it. nil: that of the theme for panels, 5 for lists, 0 for rows and columns. · px · 0 to 100000 · default nil · may be nil
---@field radius number? Radius of its corners; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
---@field spacing number? Distance between its widgets; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
local fettle_Column = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Column, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Column, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Column, event: "cancelled", handler: fun(record: Column.cancelled)): Connection
function fettle_Column:on(event, handler) end

---Widgets below each other, or in a grid with several columns.
---@class Class.Column : Class
---@overload fun(members?: table): Column
Column = {}

---It is modal, and the player pressed escape, or B on the gamepad.
---@class List.cancelled
---@field instance List The instance with the event.
---@field step integer The fixed step in which it happened.

---The player has chosen another line.
---@class List.changed
---@field selected integer Number of the line.
---@field instance List The instance with the event.
---@field step integer The fixed step in which it happened.

---The player has pressed Enter on a line, or clicked on the chosen one.
---@class List.submitted
---@field selected integer Number of the line.
---@field instance List The instance with the event.
---@field step integer The fixed step in which it happened.

---Lines of text to choose from, or widgets below each other; it scrolls if there is no room for all.
---@class List : Widget
---@field bind string Path of a property that is the chosen line: a text, or its number. Without items, its lines are the values that the property can have. · any text · default ""
---@field color color? Its background. nil: that of the theme; rows and columns have none. · 0 to 1 · default nil · may be nil
---@field focusable boolean Whether it can have the keyboard. · true or false · default true
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field items string[] Its lines. If there are none, it shows the widgets below it. · any length · default {}
---@field modal boolean While it is visible, it gets all keys, buttons and clicks: nothing reaches the game or other widgets. If it has a background, a shade covers what is behind it. · true or false · default false
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "cut"
---@field padding number? Distance between its edge and what is in it. nil: that of the theme for panels, 5 for lists, 0 for rows and columns. · px · 0 to 100000 · default nil · may be nil
---@field radius number? Radius of its corners; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
---@field scroll number How far down it is scrolled. · px · 0 to 1e9 · default 0
---@field selected integer Number of the chosen line, from 1; 0, or more than there are: none. · 0 to 1e9 · default 0
---@field spacing number? Distance between its widgets; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "left"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
local fettle_List = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: List, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: List, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: List, event: "cancelled", handler: fun(record: List.cancelled)): Connection
---@overload fun(self: List, event: "changed", handler: fun(record: List.changed)): Connection
---@overload fun(self: List, event: "submitted", handler: fun(record: List.submitted)): Connection
function fettle_List:on(event, handler) end

---Lines of text to choose from, or widgets below each other; it scrolls if there is no room for all.
---@class Class.List : Class
---@overload fun(members?: table): List
List = {}

---It was listening, and the player has pressed a key or button.
---@class Button.captured
---@field name string As in input.actions: "space", "mouse.left", "gamepad.a".
---@field instance Button The instance with the event.
---@field step integer The fixed step in which it happened.

---The player has pressed and released it.
---@class Button.pressed
---@field instance Button The instance with the event.
---@field step integer The fixed step in which it happened.

---Something to press: with the mouse, Enter or Space, or A on the gamepad.
---@class Button : Widget
---@field bind string Path of the keys of an action, such as input.actions.jump: the button shows them, and after a press the player chooses another one. · any text · default ""
---@field color color? Its background; nil: that of its look. · 0 to 1 · default nil · may be nil
---@field focusable boolean Whether it can have the keyboard. · true or false · default true
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field image string A picture before its text: a file in the game's folder. · any text · default ""
---@field listening boolean Whether it waits for a key or button of any device. The event `captured` reports the next one, which does nothing else; escape ends it. · true or false · default false
---@field look "normal"|"accent"|"quiet" accent: it stands out. quiet: only its text is seen. · "normal", "accent", "quiet" · default "normal"
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "cut"
---@field prompt string What is written on it while it is listening. · any text · default "press a key"
---@field radius number? Radius of its corners; nil: that of the theme. · px · 0 to 100000 · default nil · may be nil
---@field text string What is written on it. · any text · default ""
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "center"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
local fettle_Button = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Button, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Button, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Button, event: "pressed", handler: fun(record: Button.pressed)): Connection
---@overload fun(self: Button, event: "captured", handler: fun(record: Button.captured)): Connection
function fettle_Button:on(event, handler) end

---Something to press: with the mouse, Enter or Space, or A on the gamepad.
---@class Class.Button : Class
---@overload fun(members?: table): Button
Button = {}

---A text.
---@class Label : Widget
---@field bind string Path of a property; the text is its value. · any text · default ""
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "wrap"
---@field text string What is written; it may have several lines. · any text · default ""
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "left"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
local fettle_Label = {}

---A text.
---@class Class.Label : Class
---@overload fun(members?: table): Label
Label = {}

---A picture, as large as fits without being distorted.
---@class Image : Widget
---@field image string A file in the game's folder. · any text · default ""
---@field tint color Multiplies the picture's colors. · 0 to 1 · default color("#ffffff")
local fettle_Image = {}

---A picture, as large as fits without being distorted.
---@class Class.Image : Class
---@overload fun(members?: table): Image
Image = {}

---The player has changed it. A change by a script is not an event: watch the property.
---@class Slider.changed
---@field value number The new value.
---@field instance Slider The instance with the event.
---@field step integer The fixed step in which it happened.

---A number to choose with the mouse, the arrow keys or the gamepad.
---@class Slider : Widget
---@field bind string Path of a property that is the number, such as audio.volume; both always have the same value. · any text · default ""
---@field color color? The part up to the value; nil: accent. · 0 to 1 · default nil · may be nil
---@field focusable boolean Whether it can have the keyboard. · true or false · default true
---@field max number? The value at the right end; it may be less than min, and then values decrease to the right. nil: the greatest one of the bound property, else 1, but min at least. · -1e12 to 1e12 · default nil · may be nil
---@field min number? The value at the left end. nil: the least one of the bound property, else 0. · -1e12 to 1e12 · default nil · may be nil
---@field step number The player chooses multiples of it, counted from min; 0: any number. Integers have a step of 1 at least. · 0 to 1e12 · default 0
---@field value number The number. · -1e12 to 1e12 · default 0
local fettle_Slider = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Slider, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Slider, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Slider, event: "changed", handler: fun(record: Slider.changed)): Connection
function fettle_Slider:on(event, handler) end

---A number to choose with the mouse, the arrow keys or the gamepad.
---@class Class.Slider : Class
---@overload fun(members?: table): Slider
Slider = {}

---The player has changed it. A change by a script is not an event: watch the property.
---@class Toggle.changed
---@field value boolean The new value.
---@field instance Toggle The instance with the event.
---@field step integer The fixed step in which it happened.

---A switch with a text.
---@class Toggle : Widget
---@field bind string Path of a boolean property; both always have the same value. · any text · default ""
---@field color color? Its color if on; nil: accent. · 0 to 1 · default nil · may be nil
---@field focusable boolean Whether it can have the keyboard. · true or false · default true
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "cut"
---@field text string What is written beside it. · any text · default ""
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "left"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
---@field value boolean Whether it is on. · true or false · default false
local fettle_Toggle = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Toggle, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Toggle, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Toggle, event: "changed", handler: fun(record: Toggle.changed)): Connection
function fettle_Toggle:on(event, handler) end

---A switch with a text.
---@class Class.Toggle : Class
---@overload fun(members?: table): Toggle
Toggle = {}

---The player has changed it. A change by a script is not an event: watch the property.
---@class TextField.changed
---@field value string The new value.
---@field instance TextField The instance with the event.
---@field step integer The fixed step in which it happened.

---The player has pressed Enter.
---@class TextField.submitted
---@field text string What is in it.
---@field instance TextField The instance with the event.
---@field step integer The fixed step in which it happened.

---A line of text to type. Shift with the arrow keys, Home and End, or dragging the mouse selects; ctrl with A selects everything, with C, X and V copies, cuts and pastes.
---@class TextField : Widget
---@field bind string Path of a text or number; the player's typing sets it at once. Text that is no number does not change a number, and is replaced by it when the field loses the keyboard. · any text · default ""
---@field caret integer Number of characters before the caret, the text cursor. It is one end of the selection. · 0 to 1e9 · default 0
---@field focusable boolean Whether it can have the keyboard. · true or false · default true
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field mark integer? Number of characters before the other end of the selection; nil: nothing is selected. What the player types takes the place of the selection. · 0 to 1e9 · default nil · may be nil
---@field max_length integer Number of characters that can be typed; 0: no limit. · 0 to 1e6 · default 0
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "cut"
---@field placeholder string Shown while it is empty. · any text · default ""
---@field text string What is in it. · any text · default ""
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "left"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
local fettle_TextField = {}

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: TextField, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: TextField, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: TextField, event: "changed", handler: fun(record: TextField.changed)): Connection
---@overload fun(self: TextField, event: "submitted", handler: fun(record: TextField.submitted)): Connection
function fettle_TextField:on(event, handler) end

---A line of text to type. Shift with the arrow keys, Home and End, or dragging the mouse selects; ctrl with A selects everything, with C, X and V copies, cuts and pastes.
---@class Class.TextField : Class
---@overload fun(members?: table): TextField
TextField = {}

---A bar whose full part shows where its value is between min and max.
---@class ProgressBar : Widget
---@field bind string Path of a property that is the value. · any text · default ""
---@field color color? The full part; nil: accent. · 0 to 1 · default nil · may be nil
---@field font string sans, bold, mono, or a font file (TTF, OTF) in the game's folder; empty: that of the theme. · any text · default ""
---@field font_size number? Size of its text; nil: that of the theme. · px · 1 to 1000 · default nil · may be nil
---@field max number? The value at the right end; it may be less than min, and then values decrease to the right. nil: the greatest one of the bound property, else 1, but min at least. · -1e12 to 1e12 · default nil · may be nil
---@field min number? The value at the left end. nil: the least one of the bound property, else 0. · -1e12 to 1e12 · default nil · may be nil
---@field overflow "cut"|"wrap" What happens with text that is too long for its width: cut ends it with "…", wrap continues it in another line. · "cut", "wrap" · default "cut"
---@field text string Written on it. · any text · default ""
---@field text_align "left"|"center"|"right" Where its text is. · "left", "center", "right" · default "center"
---@field text_color color? Color of its text; nil: that of the theme. · 0 to 1 · default nil · may be nil
---@field value number Between min and max. · -1e12 to 1e12 · default 0
local fettle_ProgressBar = {}

---A bar whose full part shows where its value is between min and max.
---@class Class.ProgressBar : Class
---@overload fun(members?: table): ProgressBar
ProgressBar = {}

---What all widgets have in common.
---@class Interface : Object
---@field focus Widget? The widget that has the keyboard; nil: none. · any Widget · default nil
---@field focus_shown boolean Whether that widget has a ring: after a key or a gamepad's button, not after a click. · true or false · default true
---@field held Widget? The widget that the player holds down; nil: none. · any Widget · default nil
---@field scale number Pixels of the screen for one of the layout; 0: such that the shorter side of the screen is 720 long. · 0 to 16 · default 0
local fettle_Interface = {}

---Writes a property as a setting of the player: no rewind and no saved game changes it, and later runs begin with it. A widget that is bound to a property of audio or input.actions does so by itself.
---@param path string Path of the property, such as "input.actions.jump".
---@param value? any What the player has chosen; nil ends the preference, and the game decides about the value again.
function fettle_Interface:prefer(path, value) end

---The widget that is seen at a point of the screen, the foremost of several. Rows, columns and the like without a color of their own are not seen.
---@param point vec From the top left corner of the screen. · px
---@return Widget? widget The widget; nil if there is none.
function fettle_Interface:widget_at(point) end

---What all widgets have in common.
---@class Class.Interface : Class
Interface = {}

---It has reached its end; it is deleted at the next step.
---@class Tween.finished
---@field instance Tween The instance with the event.
---@field step integer The fixed step in which it happened.

---Moves a property of an instance from its value to another in some time. tween(...) makes it below `game.tweens`, where it runs.
---@class Tween : Object
---@field alternate boolean Whether every second run goes back. · true or false · default false
---@field curve number[] Parts of the way at equal distances of time, joined by straight lines. A function given as ease is kept here as 257 of its values. · any length · default {}
---@field ease "linear"|"out_quad"|"in_quad"|"in_out_quad"|"out_cubic"|"in_cubic"|"in_out_cubic"|"out_quart"|"in_quart"|"in_out_quart"|"out_quint"|"in_quint"|"in_out_quint"|"out_sine"|"in_sine"|"in_out_sine"|"out_expo"|"in_expo"|"in_out_expo"|"out_circ"|"in_circ"|"in_out_circ"|"out_back"|"in_back"|"in_out_back"|"out_elastic"|"in_elastic"|"in_out_elastic"|"out_bounce"|"in_bounce"|"in_out_bounce"|"curve" How the part of the way depends on the part of the time; "curve" takes it from `curve`. · 32 texts · default "linear"
---@field from any The value at the beginning: the one that the property has when the tween begins, unless it is set before. · any value · default nil · may be nil
---@field loops integer How often it runs before it ends; 0: until it is stopped. · 0 to 1e9 · default 1
---@field paused boolean Whether it stands still. · true or false · default false
---@field pauses boolean Whether it pauses with the game and follows time.scale. false: it moves in real time, at each picture, as a pause menu needs it. In a group, that of the outermost group counts. · true or false · default true
---@field progress number The part of the time that has passed in this run. Setting it jumps there at the next step. · 0 to 1 · default 0
---@field property string The name of the property that changes; empty for a pause in a sequence. · any text · default ""
---@field seconds number How long it takes, in simulation time; in real time without `pauses`. · s · 0 to 1e9 · default 1
---@field target Object? The instance whose property changes. The tween ends with it. · any Object · default nil
---@field to any The value at the end. · any value · default nil · may be nil
local fettle_Tween = {}

---Ends it where it is, without the event, and deletes it.
function fettle_Tween:stop() end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: Tween, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: Tween, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: Tween, event: "finished", handler: fun(record: Tween.finished)): Connection
function fettle_Tween:on(event, handler) end

---Moves a property of an instance from its value to another in some time. tween(...) makes it below `game.tweens`, where it runs.
---@class Class.Tween : Class
---@overload fun(members?: table): Tween
Tween = {}

---All in it have ended; it is deleted at the next step.
---@class TweenGroup.finished
---@field instance TweenGroup The instance with the event.
---@field step integer The fixed step in which it happened.

---Tweens that run one after the other, or together. tween.sequence and tween.parallel make it below `game.tweens`, where it runs.
---@class TweenGroup : Object
---@field alternate boolean Whether every second run goes back, the last of a sequence first. · true or false · default false
---@field kind "sequence"|"parallel" Whether one follows the other or all run together. · "sequence", "parallel" · default "sequence"
---@field loops integer How often it runs before it ends; 0: until it is stopped. · 0 to 1e9 · default 1
---@field paused boolean Whether it stands still. · true or false · default false
---@field pauses boolean Whether it pauses with the game and follows time.scale. false: it moves in real time, at each picture, as a pause menu needs it. In a group, that of the outermost group counts. · true or false · default true
---@field progress number The part of the time that has passed in this run. · 0 to 1 · read-only, simulated
local fettle_TweenGroup = {}

---Ends it where it is, without the event, and deletes it.
function fettle_TweenGroup:stop() end

---Calls the function with a record when the instance has the event.
---@param event string
---@param handler fun(record: any)
---@return Connection
---@overload fun(self: TweenGroup, event: "ready", handler: fun(record: Object.ready)): Connection
---@overload fun(self: TweenGroup, event: "deleted", handler: fun(record: Existence)): Connection
---@overload fun(self: TweenGroup, event: "finished", handler: fun(record: TweenGroup.finished)): Connection
function fettle_TweenGroup:on(event, handler) end

---Tweens that run one after the other, or together. tween.sequence and tween.parallel make it below `game.tweens`, where it runs.
---@class Class.TweenGroup : Class
---@overload fun(members?: table): TweenGroup
TweenGroup = {}

---The tweens of the game, in the order in which they run.
---@class Tweens : Object
local fettle_Tweens = {}

---The tweens of the game, in the order in which they run.
---@class Class.Tweens : Class
---@overload fun(members?: table): Tweens
Tweens = {}

---A change of the scene that is being shown: game.transition, made by go_to_scene.
---@class Transition : Object
---@field color color What covers the screen. · 0 to 1 · default color("#000000")
---@field done boolean Whether the scene is replaced. · true or false · default false
---@field kind "none"|"fade"|"wipe"|"iris" fade: through a color. wipe: the color moves across the screen. iris: a circle closes and opens. · "none", "fade", "wipe", "iris" · default "fade"
---@field progress number The part of it that is over. · 0 to 1 · default 0
---@field seconds number How long it takes, in real time. The scene is replaced in the middle. · s · 0 to 3600 · default 0.5
---@field to string The name of the scene. · any text · default ""
local fettle_Transition = {}

---A change of the scene that is being shown: game.transition, made by go_to_scene.
---@class Class.Transition : Class
---@overload fun(members?: table): Transition
Transition = {}

---The in-game console and inspector.
---@class Console : Object
---@field filter string Only lines of the log that contain this text are shown; "" shows all. · any text · default "" · not saved
---@field font_size number Height of the text. · px · 8 to 48 · default 15 · not saved
---@field ghost_time number How far these ghosts look ahead. · s · 0.1 to 10 · default 2 · not saved
---@field ghosts boolean Whether edits of a game that is paused show what would move, and where, as far as the physics says. · true or false · default true · not saved
---@field height number Height of the console as a share of the window. · 0.15 to 1 · default 0.45 · not saved
---@field inspector boolean Whether the inspector is shown with it. · true or false · default true · not saved
---@field inspector_width number Width of the inspector at a scale of 1. · px · 200 to 2000 · default 420 · not saved
---@field key "insert"|"left_system"|"right_system"|"menu"|"pause"|"grave"|"f1"|"f2"|"f3"|"f4"|"f5"|"f6"|"f7"|"f8"|"f9"|"f10"|"f11"|"f12"|"f13"|"f14"|"f15" The key that opens and closes the console, by its name in the class Keys. Keys with which commands are typed and edited, such as "b" and "enter", cannot be it. · 21 texts · default "grave" · not saved
---@field listen boolean Whether `fettle repl --attach` may attach to this game: only this user, on this computer, with the token in the user's runtime folder. · true or false · default false · not saved
---@field memory_limit number How much memory one command may add, by Lua's values and by what it makes in the tree; a command that needs more is stopped. · MB · 1 to 1e6 · default 256 · not saved
---@field opacity number Of the background. Below 1 the game is seen behind the text. · 0.3 to 1 · default 1 · not saved
---@field open boolean Whether the console is shown. · true or false · default false · not saved
---@field overlays boolean Whether the overlays of `view.show` are shown as a row of buttons. · true or false · default false · not saved
---@field pauses boolean Whether time stands still while the console is open. · true or false · default false · not saved
---@field picks boolean Whether a click on a body, a picture or a widget selects it while the console is open. · true or false · default true · not saved
---@field plot_height number Height of the curves of a plot at a scale of 1, as far as the window has room; 0: a height that fits the window. · px · 0 to 4000 · default 0 · not saved
---@field scale number Factor of the size of the text, and of what is measured by it, as far as the window is wide enough. · 0.5 to 4 · default 1 · not saved
---@field time_bar boolean Whether the time bar is shown with it: pause, step, back. · true or false · default true · not saved
---@field tweaks boolean Whether tweaks are listed in place of the log. · true or false · default false · not saved
local fettle_Console = {}

---The in-game console and inspector.
---@class Class.Console : Class
Console = {}

---The result of the console's last command.
---@type any
_ = nil

---The table of all globals.
---@type table
_G = nil

---The version of Lua.
---@type string
_VERSION = nil

---All classes, by number and by name: classes.Body.properties. Read-only.
---@type Class[]
classes = nil

---The root of the tree.
---@type Game
game = nil

---In the console: the instance that is selected.
---@type Object
it = nil

---Values that outlive the run: store.best = 100.
---@type Store
store = nil

---Everything that is heard.
---@type Audio
audio = nil

---The in-game console and inspector.
---@type Console
console = nil

---What the player does: keys, mouse, gamepads, and the actions bound to them.
---@type Input
input = nil

---What all widgets have in common.
---@type Interface
interface = nil

---Simulation time: how fast it passes, and how much has passed.
---@type Time
time = nil

---Which part of the world is seen, and what lies over it.
---@type View
view = nil

---Bodies below it are simulated together. Its child `step` describes the last step.
---@type World
world = nil

coroutine = {}

math = {}

os = {}

scene = {}

string = {}

table = {}

utf8 = {}

---Shows the last seconds twice, side by side: A as they passed, and B with that value of the property from their beginning on. Each picture has the shapes, colors and view of its moment. Scripts do not run again: what they wrote then is written in B, too. seconds: 4 if it is left out, 0.1 to 60. The game does not change. Without a path the comparison ends. ab("world.ball.mass", 3).
---@param path? string
---@param value? any
---@param seconds? number
function ab(path, value, seconds) end

---Calls the function once, after that much simulation time. The function may call wait(). after(1, f, { pauses = false }) counts real time, also while the game is paused; going back in time does not change it, and no saved game contains it.
---@param seconds number
---@param action fun()
---@param options? table
---@return Connection
function after(seconds, action, options) end

---In the console the word stands for the command; what is typed after it is put after the command. Without a command the alias is removed. `alias` alone lists them.
---@param word string
---@param command? string
function alias(word, command) end

---The words that stand for commands, with the commands. In the console the parentheses may be left out.
---@return table<string, string>
function aliases() end

---Runs the command whenever the key goes down, also while the console is closed: bind("f5", "rewind(5)"). Keys have the names of the class Keys. The game does not get the key. Without a command the game gets the key again. `bind` alone lists them.
---@param key string
---@param command? string
function bind(key, command) end

---The keys that run commands, with the commands. In the console the parentheses may be left out.
---@return table<string, string>
function binds() end

---Sets a bookmark on the time bar of the console: at the present step if step is left out. The same name again moves it. Bookmarks end with the run, because another run has other steps. `bookmark` alone, without parentheses, lists them.
---@param name? string
---@param step? integer
function bookmark(name, step) end

---The steps of the bookmarks by their names: time:go_to(bookmarks().start) goes to one.
---@return table
function bookmarks() end

---Pauses the game after the step in which the condition becomes true, and prints its old and new value and what wrote it. If the value is not a boolean, the game pauses when it changes. `break_when` alone, without parentheses, lists the conditions; `unbreak` ends one, and break_when() all.
---@param condition? string|fun(): any
function break_when(condition) end

---The conditions that `break_when` waits for, as texts. In the console the parentheses may be left out.
---@return string[]
function breaks() end

---Defines a class whose instances are in the tree: Ball = class("Ball", Body) { lives = 3 }. Values are properties with their defaults; `doc` describes the class, or its properties by name.
---@param name string
---@param base? Class|string
---@return fun(members: table): Class
function class(name, base) end

---Empties the log of the console.
function clear() end

---A color by name, as "#rgb" or "#rrggbb", with one or two digits more for its opacity, or from channels between 0 and 1.
---@param name string
---@return color
---@overload fun(r: number, g: number, b: number, a?: number): color
function color(name) end

---Shows the present branch of the past and another one side by side, from the step where they part, and lists the values that differ at their last common step. Without a name it is the branch that was left last; ab() ends it. time:branches() lists the branches.
---@param branch? string
function compare_branch(branch) end

---An angle in radians.
---@param degrees number
---@return number
function deg(degrees) end

---Removes a saved game.
---@param slot string
function delete_save(slot) end

---Drops the tweaks that match: they are no longer listed or made again.
---@param pattern string
function drop_tweaks(pattern) end

---All writes of the function are one step of undo with that name.
---@param name string
---@param action fun()
function edit(name, action) end

---Calls the function repeatedly at that interval of simulation time; 0 means every step. every(1, f, { pauses = false }) counts real time, as `after` does, and calls it once a picture at most.
---@param seconds number
---@param action fun()
---@param options? table
---@return Connection
function every(seconds, action, options) end

---Runs the commands in a file of the game, as if they were typed into the console.
---@param file string
function exec(file) end

---Writes what is plotted to a new file in the player's folder of the game: "csv" with all values, or "png" as a picture. The console prints its path.
---@param kind? string
function export_plot(kind) end

---Lists every name and description that contains the word; for a condition such as "mass > 5 and awake", the instances for which it holds.
---@param word string
function find(word) end

---Assigned to a property, the function computes its value: it is called again whenever something that it reads has changed. If it raises an error, the error is reported once, the module continues with the last value, and reading the property raises the error. More than 50 million instructions are an error, too.
---@param value fun(): any
---@return Formula
function formula(value) end

---Replaces game.scene at the next barrier. The name is that of a class of the game, of which an instance is made, or of a scene file: "level_2" is scenes/level_2.json or level_2.json. What the old scene owns ends with it: its instances with their timers, tweens, coroutines, sounds and handlers, and what its `enter` began. Options: transition = "none" (the default), "fade", "wipe" or "iris"; seconds, of real time (0.5); color; args: what `enter` gets, a value of a property or a table of them by name.
---@param name string
---@param options? table
function go_to_scene(name, options) end

---A command of the console: lets the game go on after an error at which it stopped, and after a pause. After going back, it goes on from there, as another branch.
function go_on() end

---Explains a class, an instance, a method or a path.
---@param anything? any
function help(anything) end

---Lists the edits, the latest first.
function history() end

---Writes the tweaks that match into files which the next run reads: tweaks of an instance of a scene file into that file, tweaks of an instance that a script made into `main.tweaks.json` beside `main.lua` (`NAME.tweaks.json` beside a game that is one file `NAME.lua`). If several instances come from the scene file, the tweaks of one of them are written into `main.tweaks.json`, too, for this one only. keep("world.ball.*").
---@param pattern string
function keep(pattern) end

---Writes the tweaks that match as `keep` does, but into the scene file also if several instances come from it: all of them have the change when the file is loaded again. Values that `keep` has written for one instance in this run are included.
---@param pattern string
function keep_for_all(pattern) end

---Searches the kept past for the last step at which the condition was true, and goes there. If it is true now, it goes to the step at which it became true.
---@param condition string|fun(): any
function last_time(condition) end

---Continues with a saved game at the next barrier. A save that is damaged, newer, of another game or of classes that are not defined is an error, and nothing changes. `game` emits `restored`.
---@param slot string
function load_game(slot) end

---Adds a path or an expression to the watch list of the console: pin("world.ball.mass"). `pin` alone lists what is pinned.
---@param what string|fun(): any
---@param ... string|fun(): any
function pin(what, ...) end

---What is pinned, with the present values. In the console the parentheses may be left out.
---@return table<string, any>
function pins() end

---In the console: shows the last seconds once more, as they were; then the game goes on, unless it was paused before. Without seconds, or with more than is kept, it begins with the oldest step that is kept. After going back it shows what followed.
---@param seconds? number
function play_back(seconds) end

---Shows values over time, of numbers, vectors and booleans, with the past as far as it is kept: plot("world.ball.velocity"). plot() ends the plot; `plot` alone, without parentheses, lists what is plotted.
---@param ... string|fun(): any
function plot(...) end

---Finds what a pattern matches. If its last part is the name of a child, the result is a set of instances: query("world.*.circle"). If it is the name of a property, or a star, which stands for every property, the result is a table of values by path: query("world.*.mass"). If nothing matches, it is an empty set. Formulas in error are left out. A condition gives the set of instances for which it holds: query("Body and mass > 5 and position.x < 0"). It can compare and compute, and calls nothing. The name of a class is a condition, unless `game` has something of that name: query("Body").
---@param pattern string
---@return Set|table<string, any>
function query(pattern) end

---Ends the game with that exit status, 0 to 255; 0 without one. It may be a handler: Button { text = "Quit", pressed = quit }.
---@param status? integer|boolean
function quit(status) end

---A random number in [0, 1), from 1 to n, or between the two arguments; random(x) with an x that is not an integer is between 0 and x; random(0) is any integer, as in Lua. The same seed gives the same numbers.
---@return number
---@overload fun(n: integer): integer
---@overload fun(from: integer, to: integer): integer
---@overload fun(from: number, to: number): number
function random() end

---Makes the matching tweaks of earlier runs again, and instances that were made, deleted or renamed later than this moment, before the game went back to it.
---@param pattern string
function reapply_tweaks(pattern) end

---A command of the console, and the red button of the time bar: writes a recording of the run, from its first step to the present one and then all that follows, until record(false) or the end of the run. `fettle run --replay FILE` plays it again, and compares every step that was made while it was written. The file is in the folder `recordings` of the player's files, and the command prints where. This works for a run in a window until one of its files changes and is read again; for this purpose the first 64 MB of a recording are kept.
---@param on? boolean
function record(on) end

---Repeats the last edit that undo reversed, or as many as `count` says.
---@param count? integer
function redo(count) end

---Runs another file of the game once, and returns what it returned.
---@param name string
---@return any
function require(name) end

---A command of the console: begins the game again in its window, from its files as they are now. Edits that were not kept are listed by tweaks() after it. bind("f5", "restart()") gives it a key.
function restart() end

---Restores the whole tree from a snapshot, at the next barrier between steps. Variables of Lua are not changed; `game` emits `restored`.
---@param taken Snapshot
function restore(taken) end

---Goes back by that much simulation time, at the next barrier between steps, but not further than the timeline (`time.oldest`).
---@param seconds number
function rewind(seconds) end

---Saves the game in that slot at the next barrier: the whole tree, but no variables of Lua; of a formula that uses local variables only the value. The name of a slot consists of letters, digits, spaces, - and _. Several calls for one slot before the barrier make one save, with the state that the last call wants; more than 1000 calls are an error. Saves are in a folder for each game in `~/.local/share/fettle/`.
---@param slot string
function save_game(slot) end

---The saved games by slot, including those that cannot be loaded.
---@return SavedGame[]
function saves() end

---The instances that are selected in the console, `it` last; with a list or an instance, selects these. In a replay nothing is selected.
---@param instances? Object[]|Object
---@return Set?
function selection(instances) end

---Creates the instances of a scene file below the parent; detached without one.
---@param file string
---@param parent? Object
---@param name? string
---@return Object
function scene.load(file, parent, name) end

---Writes an instance and everything below it to a scene file of the game. It may replace a scene file; a file of another kind is left unchanged, which is an error.
---@param file string
---@param instance Object
function scene.save(file, instance) end

---A command of the console: writes this moment of the game into one file, with the game, its edits, and the recording if the run is recorded. `fettle run NAME.fettle` opens the game at this moment, paused. The name has letters, digits, - and _; the file is in the folder `moments` of the player's files, and the command prints where. Variables of scripts that are not in the tree, and timers, are not in it, as in a saved game.
---@param name string
function share(name) end

---The whole tree as it is at the next barrier between steps, when the running function has ended, for restore: with what this function changes afterwards, too.
---@return Snapshot
function snapshot() end

---Declares a variable of the game that is a property of `game`: state("score", 0). From then on, `score` reads and writes game.score, so it is saved, rewound, watched and inspected. The value is set only if there is none yet: one from a saved game or from before a reload stays. Returns the current value.
---@param name string
---@param value any
---@return any
function state(name, value) end

---Lists what people, and scripts inside edit(), changed while the game ran, in this run and in earlier ones, and which of these changes are kept. After going back it lists the changes of this run that hold at that moment.
function tweaks() end

---Moves a property from its value to another in that much simulation time. The property holds a number, an integer, a vector, a color, or a list of these. An ease is a name such as "out_quad" (`Tween.properties.ease.enumerators` lists them), a function from 0..1 to 0..1, or a list of numbers. It begins at the next step; a tween that begins later with the same property ends it. Options are `pauses`, `loops` and `alternate` of the tween: tween(view, "height", 12, 1, "linear", { loops = 0, alternate = true }).
---@param target Object
---@param property string
---@param to any
---@param seconds number
---@param ease? string|number[]|fun(time: number): number
---@param options? table
---@return Tween
function tween(target, property, to, seconds, ease, options) end

---Runs tweens and groups together. The list may have the options `pauses`, `loops` and `alternate` of the group: tween.parallel { a, b, loops = 2 }.
---@param tweens any[]
---@return TweenGroup
function tween.parallel(tweens) end

---Runs tweens and groups one after the other; a number is a pause in seconds. The list may have options of the group: tween.sequence { a, b, loops = 0, alternate = true }.
---@param tweens any[]
---@return TweenGroup
function tween.sequence(tweens) end

---Reverses the latest edit, or as many as `count` says.
---@param count? integer
function undo(count) end

---Removes a bookmark; unbookmark() removes all.
---@param name? string
function unbookmark(name) end

---Ends one condition of `break_when`, which is named by its text; unbreak() ends all.
---@param condition? string
function unbreak(condition) end

---Removes an entry from the watch list; unpin() removes all.
---@param what? string
function unpin(what) end

---A vector or point; a copy of one; the zero vector.
---@param x number
---@param y number
---@return vec
---@overload fun(other: vec): vec
---@overload fun(): vec
function vec(x, y) end

---Inside a coroutine: continues after that much simulation time; real time in a function that a timer in real time has called. In a terminal (`fettle repl`): the next command runs after these seconds, or when the condition is true, after 60 seconds at most or as many as are given: `wait world.ball.position.y < 1`. wait() waits until the game is paused, as by `break_when`.
---@param seconds number
---@overload fun(condition?: string|function, seconds?: number)
function wait(seconds) end

---Calls the function after a property that matches has changed: watch("world.*.velocity", handler).
---@param pattern string
---@param handler fun(new: any, old: any, change: Change)
---@return Connection
function watch(pattern, handler) end

---Prints what wrote a property last, and at which step: "console:1, step 49"; for the path of an instance, what wrote each of its properties. After going back in time, that is the last write before that moment, or "restore, step 30" if none is known. The file and line of a script are known if the property was watched when it was written; otherwise only "script" is printed. For a value that the simulation changes, the last other writer is printed; the simulation is printed only if there is no other writer or the property is watched.
---@param path string
function who(path) end

---Explains where the value of a property comes from: its formula, and the properties that it reads.
---@param path string
function why(path) end

---Raises an error unless the value is true; returns its arguments.
---@param value any
---@param message? any
---@param ... any
---@return any
function assert(value, message, ...) end

---Frees unused memory, or returns how many KiB of memory scripts use.
---@param option? "collect"|"step"|"count"
---@return number
function collectgarbage(option) end

---Ends a coroutine that is suspended, also one that waits: it goes on no more.
---@param thread thread
---@return boolean
---@return any
function coroutine.close(thread) end

---A coroutine that runs the function.
---@param action function
---@return thread
function coroutine.create(action) end

---Whether the running function can yield.
---@return boolean
function coroutine.isyieldable() end

---Starts or continues a coroutine.
---@param thread thread
---@param ... any
---@return boolean
---@return any
function coroutine.resume(thread, ...) end

---The coroutine that runs, and whether it is the main one.
---@return thread
---@return boolean
function coroutine.running() end

---What state a coroutine is in.
---@param thread thread
---@return "running"|"suspended"|"normal"|"dead"
function coroutine.status(thread) end

---A function that starts or continues a new coroutine.
---@param action function
---@return function
function coroutine.wrap(action) end

---Suspends the coroutine; its arguments are what resume returns.
---@param ... any
---@return any
function coroutine.yield(...) end

---Raises an error, which ends the running function.
---@param message any
---@param level? integer
function error(message, level) end

---The metatable of a value, or the value of its field __metatable.
---@param value any
---@return any
function getmetatable(value) end

---Visits elements 1, 2, 3 ...: for i, value in ipairs(list) do.
---@param list table
---@return function
---@return table
---@return integer
function ipairs(list) end

---Compiles a text to a function; nil and a message when it is malformed.
---@param chunk string|function
---@param name? string
---@param mode? string
---@param env? table
---@return function?
---@return string?
function load(chunk, name, mode, env) end

---The distance from 0.
---@param x number
---@return number
function math.abs(x) end

---Arc cosine, in radians.
---@param x number
---@return number
function math.acos(x) end

---Arc sine, in radians.
---@param x number
---@return number
function math.asin(x) end

---Arc tangent of y/x in radians; the signs of both find the quadrant.
---@param y number
---@param x? number
---@return number
function math.atan(y, x) end

---The least integer that is not below x.
---@param x number
---@return integer
function math.ceil(x) end

---Cosine of an angle in radians.
---@param x number
---@return number
function math.cos(x) end

---An angle in degrees, from radians.
---@param x number
---@return number
function math.deg(x) end

---e to the power of x.
---@param x number
---@return number
function math.exp(x) end

---The greatest integer that is not above x.
---@param x number
---@return integer
function math.floor(x) end

---The remainder of x/y, rounded towards 0.
---@param x number
---@param y number
---@return number
function math.fmod(x, y) end

---Infinity: a body of that mass cannot be moved.
---@type number
math.huge = nil

---Logarithm; natural without a base.
---@param x number
---@param base? number
---@return number
function math.log(x, base) end

---The greatest argument.
---@param x number
---@param ... number
---@return number
function math.max(x, ...) end

---The greatest integer.
---@type integer
math.maxinteger = nil

---The least argument.
---@param x number
---@param ... number
---@return number
function math.min(x, ...) end

---The least integer.
---@type integer
math.mininteger = nil

---The integral part and the fraction.
---@param x number
---@return number
---@return number
function math.modf(x) end

---Smooth noise, from -1 to 1 and 0 at whole numbers: near points have near values. The same point always has the same value; add a random number to x for another landscape. Hills: math.noise(x / 8) + 0.5 * math.noise(x / 4).
---@param x number
---@param y? number
---@return number
function math.noise(x, y) end

---Half a turn in radians.
---@type number
math.pi = nil

---An angle in radians, from degrees.
---@param x number
---@return number
function math.rad(x) end

---As in Lua, from the game's own generator; random() is shorter.
---@return number
---@overload fun(n: integer): integer
---@overload fun(from: integer, to: integer): integer
function math.random() end

---Starts the game's generator anew.
---@param seed? number
---@param more? integer
function math.randomseed(seed, more) end

---Sine of an angle in radians.
---@param x number
---@return number
function math.sin(x) end

---Square root.
---@param x number
---@return number
function math.sqrt(x) end

---Tangent of an angle in radians.
---@param x number
---@return number
function math.tan(x) end

---The number as an integer; nil when it is not integral.
---@param x any
---@return integer?
function math.tointeger(x) end

---The kind of number; nil if x is not a number.
---@param x any
---@return "integer"|"float"|nil
function math.type(x) end

---Whether a is less than b, both as unsigned integers.
---@param a integer
---@param b integer
---@return boolean
function math.ult(a, b) end

---The next entry of a table after `key`; pairs visits them in order.
---@param table table
---@param key? any
---@return any
---@return any
function next(table, key) end

---Processor time used, in seconds. It is not recorded.
---@return number
function os.clock() end

---Date and time of day.
---@param format? string
---@param time? integer
---@return string|table
function os.date(format, time) end

---Seconds between two times.
---@param later integer
---@param earlier integer
---@return number
function os.difftime(later, earlier) end

---Seconds since 1970. It is not recorded: a game that keeps it in a property differs in a replay.
---@param date? table
---@return integer
function os.time(date) end

---Visits all entries: numbers first, then names, in order; then instances, in an order that a replay repeats. Other keys (tables, functions) come in any order.
---@param table table
---@return function
---@return table
---@return nil
function pairs(table) end

---Calls the function; false and the error when it raises one.
---@param action function
---@param ... any
---@return boolean
---@return any
function pcall(action, ...) end

---Prints values: to the console, and to the terminal. For a table it prints the entries, on one line.
---@param ... any
function print(...) end

---Whether both are the same, without ==.
---@param a any
---@param b any
---@return boolean
function rawequal(a, b) end

---An entry, without metatables.
---@param table table
---@param key any
---@return any
function rawget(table, key) end

---The length, without metatables.
---@param value table|string
---@return integer
function rawlen(value) end

---Sets an entry, without metatables.
---@param table table
---@param key any
---@param value any
---@return table
function rawset(table, key, value) end

---The arguments from that index on, or their number.
---@param from integer|"#"
---@param ... any
---@return any
function select(from, ...) end

---Gives a table a metatable; finalizers (__gc) are refused.
---@param table table
---@param metatable? table
---@return table
function setmetatable(table, metatable) end

---Bytes of a text as numbers.
---@param text string
---@param from? integer
---@param to? integer
---@return integer
function string.byte(text, from, to) end

---A text from bytes.
---@param ... integer
---@return string
function string.char(...) end

---Where a pattern matches first, and what it captured.
---@param text string
---@param pattern string
---@param from? integer
---@param plain? boolean
---@return integer?
---@return integer?
---@return any
function string.find(text, pattern, from, plain) end

---Values put into a text: "%d", "%.2f", "%s".
---@param format string
---@param ... any
---@return string
function string.format(format, ...) end

---Visits all matches of a pattern.
---@param text string
---@param pattern string
---@param from? integer
---@return function
function string.gmatch(text, pattern, from) end

---Replaces all matches of a pattern, or at most `max`; returns the text and their number.
---@param text string
---@param pattern string
---@param replacement string|table|function
---@param max? integer
---@return string
---@return integer
function string.gsub(text, pattern, replacement, max) end

---How many bytes it has.
---@param text string
---@return integer
function string.len(text) end

---In lower case.
---@param text string
---@return string
function string.lower(text) end

---What a pattern captures where it matches first.
---@param text string
---@param pattern string
---@param from? integer
---@return string?
---@return any
function string.match(text, pattern, from) end

---Values as bytes in a text.
---@param format string
---@param ... any
---@return string
function string.pack(format, ...) end

---How many bytes pack would make.
---@param format string
---@return integer
function string.packsize(format) end

---The text repeated `count` times.
---@param text string
---@param count integer
---@param separator? string
---@return string
function string.rep(text, count, separator) end

---The bytes of a text in reverse order.
---@param text string
---@return string
function string.reverse(text) end

---A part of a text; negative places count from the end.
---@param text string
---@param from integer
---@param to? integer
---@return string
function string.sub(text, from, to) end

---What pack made into bytes.
---@param format string
---@param text string
---@param from? integer
---@return any
function string.unpack(format, text, from) end

---In upper case.
---@param text string
---@return string
function string.upper(text) end

---The elements joined to a text.
---@param list table
---@param separator? string
---@param from? integer
---@param to? integer
---@return string
function table.concat(list, separator, from, to) end

---Puts an element at the end, or at a place.
---@param list table
---@param value any
---@overload fun(list: table, place: integer, value: any)
function table.insert(list, value) end

---Copies elements to a place of the same or another table.
---@param from table
---@param first integer
---@param last integer
---@param place integer
---@param to? table
---@return table
function table.move(from, first, last, place, to) end

---The arguments as a list, with `n`.
---@param ... any
---@return table
function table.pack(...) end

---Takes out the last element, or that at a place.
---@param list table
---@param place? integer
---@return any
function table.remove(list, place) end

---Sorts the elements in place.
---@param list table
---@param before? fun(a: any, b: any): boolean
function table.sort(list, before) end

---The elements, as results.
---@param list table
---@param from? integer
---@param to? integer
---@return any
function table.unpack(list, from, to) end

---A text as a number; nil if it is not one.
---@param value any
---@param base? integer
---@return number?
function tonumber(value, base) end

---The value as text, as print shows it; no addresses.
---@param value any
---@return string
function tostring(value) end

---"number", "table", "userdata" ...
---@param value any
---@return string
function type(value) end

---A text from characters' codes.
---@param ... integer
---@return string
function utf8.char(...) end

---The pattern that matches one character.
---@type string
utf8.charpattern = nil

---Codes of the characters of a text.
---@param text string
---@param from? integer
---@param to? integer
---@return integer
function utf8.codepoint(text, from, to) end

---Visits places and codes of all characters.
---@param text string
---@return function
---@return string
---@return integer
function utf8.codes(text) end

---How many characters it has; nil and the place where it is malformed.
---@param text string
---@param from? integer
---@param to? integer
---@return integer?
---@return integer?
function utf8.len(text, from, to) end

---At which byte the n-th character begins.
---@param text string
---@param n integer
---@param from? integer
---@return integer?
function utf8.offset(text, n, from) end

---Calls the function; the handler is called with an error at the place where it was raised.
---@param action function
---@param handler fun(error: any): any
---@param ... any
---@return boolean
---@return any
function xpcall(action, handler, ...) end

---Called once, when main.lua has run.
function start() end

---Called every frame; dt is the game time since the last one in seconds: real time times time.scale, 0 while the game is paused. real_dt is the real time, also while the game is paused; in a headless run, one step.
---@param dt number
---@param real_dt number
function update(dt, real_dt) end

---Called before every fixed step of the simulation, time.dt seconds long.
---@param dt number
function step(dt) end

---Called for every picture, after the instances that draw themselves.
---@param pen Pen
function draw(pen) end

---Called for every picture, before everything else that is drawn.
---@param pen Pen
function draw_behind(pen) end

---A key went down: "space", "a", "left".
---@param key string
function key_pressed(key) end

---A key came up.
---@param key string
function key_released(key) end

---A character was typed, by one key or several.
---@param text string
function text_input(text) end

---A button went down, at a position in the world and on the screen in pixels.
---@param button string
---@param position vec
---@param screen vec
function mouse_pressed(button, position, screen) end

---A button came up, at a position in the world and on the screen in pixels.
---@param button string
---@param position vec
---@param screen vec
function mouse_released(button, position, screen) end

---The mouse moved to a position in the world and on the screen in pixels.
---@param position vec
---@param screen vec
function mouse_moved(position, screen) end

---The wheel was turned, away from the user positive, over a position in the world.
---@param notches number
---@param position vec
function wheel(notches, position) end

---A button of a gamepad went down; gamepads are counted from 1, and buttons are called "1" to "16". A button with a name calls it twice, with the number and with the name: "a", "left_shoulder", "dpad_up".
---@param gamepad integer
---@param button string
function gamepad_pressed(gamepad, button) end

---A button of a gamepad came up.
---@param gamepad integer
---@param button string
function gamepad_released(gamepad, button) end

---An axis of a gamepad moved: "left_x", "left_y", "right_x", "right_y", "pad_x" or "pad_y" to a value from -1 to 1, right and up positive; "left_trigger" or "right_trigger" to a value from 0 to 1.
---@param gamepad integer
---@param axis string
---@param value number
function gamepad_axis(gamepad, axis, value) end

---The player began to hold an action: one of its keys or buttons in input.actions went down.
---@param action string
function action_pressed(action) end

---The player let go of an action.
---@param action string
function action_released(action) end

---The window got another size, in pixels.
---@param width number
---@param height number
function resized(width, height) end

---The window got the keyboard, or lost it.
---@param focused boolean
function focus(focused) end

---The scene that go_to_scene named is now game.scene; args are those of the call. Not called if the class of the scene has a function of that name.
---@param args any
function enter(args) end

---The scene is about to be replaced and still complete. Not called if the class of the scene has a function of that name.
function leave() end

---Files of the game have changed while it runs, and the game uses them now; start() is not called again.
---@param files string[]
function reloaded(files) end

---The run is about to end: its window is closed, or a signal (Ctrl+C, SIGTERM) was received. quit() and the end of --steps do not call it. After it no update and no draw is called; watchers and handlers of events are still called for what it changed. After a signal it may take five seconds.
function closing() end
