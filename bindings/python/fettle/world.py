"""Worlds."""

from collections import deque

from . import _callbacks, fields, geometry as geometries, joints
from ._accounts import account_of
from ._call import Invalid, Locked, check, close_world, closed, definition, ffi, held_together, lib, list_of, open_world, unknown
from ._columns import Columns
from ._drawing import drawing_of
from ._events import events_of
from ._handle import id_of
from ._names import HasProperties, settable
from ._properties import bind, set_members, to_bytes, to_function, to_number
from ._queries import Queries
from ._values import aabb, joint_types, mix_rules, number_of, pair, solvers, to_aabb
from .body import Body
from .shape import Shape, contact_of


def _choice(name, names):
    get, put = getattr(lib, f"fettle_world_{name}"), getattr(lib, f"fettle_world_set_{name}")

    def read(self):
        number = ffi.new("int32_t*")
        check(get(self._pointer, number))
        return names[number[0]]

    def write(self, text):
        check(put(self._pointer, number_of(names, text, name)))

    return property(read, write, doc=f"One of {', '.join(names.values())}.")


def _restored(state):
    world = World()
    world.restore(state)
    return world


@bind("world", has_id=False)
class World(HasProperties, Queries):
    """A world of rigid bodies. Its settings are properties with the names of fettle/physics_c/world_settings.h, and may be
    given at creation: `World(gravity=(0, 0), substeps=8)`. `room`: number of bodies for which there is room, so that arrays of
    it stay valid while they are created. A world belongs to one thread at a time: a call
    raises `Locked` while another thread is in one. Copies by `copy` and `pickle` are as those by
    `clone`; of a world and its handles together, both are copied."""

    __slots__ = ("_pointer", "_columns", "_callbacks", "_waiting", "__weakref__")

    def __init__(self, room=0, **settings):
        self._pointer = ffi.NULL
        made = ffi.new("fettle_world**")
        check(lib.fettle_world_create(ffi.NULL, made))
        self._begin(made[0])
        self.reserve(bodies=room)
        for body in [self.body() for _ in range(room)]:
            body.destroy()
        for name, value in settings.items():
            known = getattr(World, name, None)
            if not isinstance(known, property) or known.fset is None:
                raise unknown(f"a world has no setting {name}", settable(World))
            setattr(self, name, value)

    def _begin(self, pointer):
        self._pointer = pointer
        open_world(pointer)
        self._columns = Columns(self)
        self._callbacks = {}
        self._waiting = deque()  # functions for the end of the step

    @classmethod
    def _of(cls, pointer):
        """The world of a pointer that the library has made."""
        world = cls.__new__(cls)
        world._begin(pointer)
        return world

    def __del__(self):
        if getattr(self, "_pointer", ffi.NULL) != ffi.NULL:
            self._end(lambda code: None)

    def close(self):
        """Destroys the world now; it and its objects raise `Stale` from then on. A second time it does nothing."""
        if self._pointer != closed:
            self._columns.may_move("close")
            if self._pointer in held_together:
                raise Locked("close: the world is being stepped together with others: close it after the call")
            self._end(check)

    def _end(self, check):
        if self._pointer == closed:
            return
        pointer = self._pointer
        check(lib.fettle_world_destroy(pointer))
        self._pointer = closed
        close_world(pointer)

    friction_mix = _choice("friction_mix", mix_rules)
    restitution_mix = _choice("restitution_mix", mix_rules)
    solver = _choice("solver", solvers)

    @property
    def bounds(self):
        """Walls that keep dynamic bodies inside, or None."""
        is_set, box = ffi.new("bool*"), ffi.new("fettle_aabb*")
        check(lib.fettle_world_bounds(self._pointer, is_set, box))
        return aabb(box) if is_set[0] else None

    @bounds.setter
    def bounds(self, box):
        check(lib.fettle_world_set_bounds(self._pointer, ffi.NULL if box is None else to_aabb(box, "bounds")))

    def step(self, dt):
        """Advances by `dt` seconds."""
        check(lib.fettle_world_step(self._pointer, to_number("float", dt, "dt")))

    def wake_all(self):
        check(lib.fettle_world_wake_all(self._pointer))

    def limit_simd_width(self, most):
        """Computes at most 4, 8 or 16 values at a time; changes no result."""
        check(lib.fettle_world_limit_simd_width(self._pointer, to_number("int32_t", most, "most")))

    # --- Objects ---------------------------------------------------------------------------------

    def body(self, type="dynamic", **properties):
        """A new body: `world.body("static", position=(0, -1))`."""
        self._columns.may_grow()
        made = ffi.new("fettle_id*")
        body_def = definition("fettle_body_def")
        for name in ("position", "velocity"):
            if name in properties:
                vector = getattr(body_def, name)
                vector.x, vector.y = pair(properties.pop(name), name)
        check(lib.fettle_world_create_body(self._pointer, body_def, made))
        body = Body(self, made[0])
        try:
            body.type = type
            body._set_all(properties)
        except Exception:
            body.destroy()
            raise
        return body

    def shape(self, geometry, **properties):
        """A new detached shape."""
        given, kept = geometries.to_c(geometry)
        made = ffi.new("fettle_id*")
        check(lib.fettle_world_create_shape(self._pointer, given, Shape._definition(properties), made))
        return Shape(self, made[0])

    def field(self, force):
        """A new field: `world.field(fettle.Wind(velocity=(3, 0)))`."""
        made = ffi.new("fettle_id*")
        check(lib.fettle_world_create_field(self._pointer, fields.to_c(force), made))
        return fields.Field(self, made[0])

    def joint(self, type, body_a=None, body_b=None, anchor_a=(0, 0), anchor_b=(0, 0), **properties):
        """A new joint of one of the types of `fettle.joints.classes`: `world.joint("revolute", None, wheel, (0, 2))`. None stands
        for the world, whose anchors are in world coordinates; the other anchors are in body coordinates. What its definition in C
        leaves open is measured: `world.joint("pulley", a, b, ground_a=(0, 5), ground_b=(2, 5))` is taut."""
        number_of(joint_types, type, "type")
        made = ffi.new("fettle_id*")
        if type == "mouse":
            joint_def = definition("fettle_mouse_joint_def")
            joint_def.body = id_of(body_b, Body)
            joint_def.target = pair(anchor_a, "target")
        else:
            joint_def = definition(f"fettle_{type}_joint_def")
            joint_def.body_a, joint_def.body_b = id_of(body_a, Body), id_of(body_b, Body)
            joint_def.anchor_a, joint_def.anchor_b = pair(anchor_a, "anchor_a"), pair(anchor_b, "anchor_b")
        set_members(joint_def, properties)
        check(getattr(lib, f"fettle_world_create_{type}_joint")(self._pointer, joint_def, made))
        joint = joints.classes[type](self, made[0])
        try:
            joint._set_all(properties)
        except Exception:
            joint.destroy()
            raise
        return joint

    def dormant_joint(self, type):
        """A new joint without bodies, to be set and then connected."""
        made = ffi.new("fettle_id*")
        check(lib.fettle_world_create_joint(self._pointer, number_of(joint_types, type, "type"), 0, made))
        return joints.classes[type](self, made[0])

    def joint_like(self, like):
        """A new joint without bodies, with the settings of another one of any world."""
        made = ffi.new("fettle_id*")
        like_id = id_of(like, joints.Joint)
        check(lib.fettle_world_create_joint_like(self._pointer, like._pointer if like else ffi.NULL, like_id, made))
        return self._joint(made[0])

    def _joint(self, id):
        return joints.classes[joints.Joint(self, id).type](self, id)

    def clear(self):
        """Destroys every body, shape, joint and field."""
        self._columns.may_move("clear")
        check(lib.fettle_world_clear(self._pointer))

    @property
    def bodies(self):
        return [Body(self, i) for i in list_of("fettle_id", lambda *a: lib.fettle_world_bodies(self._pointer, *a))]

    @property
    def shapes(self):
        return [Shape(self, i) for i in list_of("fettle_id", lambda *a: lib.fettle_world_shapes(self._pointer, *a))]

    @property
    def joints(self):
        return [self._joint(i) for i in list_of("fettle_id", lambda *a: lib.fettle_world_joints(self._pointer, *a))]

    @property
    def fields(self):
        return [fields.Field(self, i) for i in list_of("fettle_id", lambda *a: lib.fettle_world_fields(self._pointer, *a))]

    @property
    def contacts(self):
        """Touching contacts of the last step."""
        found = list_of("fettle_contact", lambda *a: lib.fettle_world_contacts(self._pointer, *a))
        return [contact_of(self, c) for c in found]

    def contacts_of(self, a, b):
        """Contacts of two shapes, one for each touching part."""
        ids = id_of(a, Shape), id_of(b, Shape)
        found = list_of("fettle_contact", lambda *out: lib.fettle_world_contacts_of(self._pointer, *ids, *out))
        return [contact_of(self, c) for c in found]

    def is_touching(self, a, b):
        """Whether two shapes touch."""
        out = ffi.new("bool*")
        check(lib.fettle_world_is_touching(self._pointer, id_of(a, Shape), id_of(b, Shape), out))
        return out[0]

    def ignore_until_separated(self, a, b):
        """Two shapes that touch have no contact until they have separated."""
        check(lib.fettle_world_ignore_until_separated(self._pointer, id_of(a, Shape), id_of(b, Shape)))

    def contact_data(self, a, b):
        """A number of the program for two shapes that touch; 0 if there is none."""
        out = ffi.new("uint64_t*")
        check(lib.fettle_world_contact_data(self._pointer, id_of(a, Shape), id_of(b, Shape), out))
        return out[0]

    def set_contact_data(self, a, b, number):
        """Sets a number for two shapes that touch. It is kept as long as they touch."""
        number = to_number("uint64_t", number, "number")
        check(lib.fettle_world_set_contact_data(self._pointer, id_of(a, Shape), id_of(b, Shape), number))

    @property
    def moved_bodies(self):
        """Bodies that the last step has moved."""
        return [Body(self, i) for i in list_of("fettle_id", lambda *a: lib.fettle_world_moved_bodies(self._pointer, *a))]

    def _object_in(self, function, slot, kind):
        out = ffi.new("fettle_id*")
        check(function(self._pointer, to_number("uint32_t", slot, "slot"), out))
        return kind(self, out[0]) if out[0] else None

    def body_in(self, slot):
        """The body of a row of the arrays, or None."""
        return self._object_in(lib.fettle_world_body_in, slot, Body)

    def shape_in(self, slot):
        """The shape in a slot, or None."""
        return self._object_in(lib.fettle_world_shape_in, slot, Shape)

    def reserve(self, bodies=0, shapes=0, contacts=0, joints=0):
        """Reserves memory for at least so many objects."""
        self._columns.may_move("reserve")
        counts = dict(bodies=bodies, shapes=shapes, contacts=contacts, joints=joints)
        check(lib.fettle_world_reserve(self._pointer, *(to_number("uint32_t", n, f"reserve: {name}") for name, n in counts.items())))

    @property
    def memory(self):
        """Bytes in use, and with the room that is reserved, by purpose."""
        found = list_of("fettle_memory_share", lambda *a: lib.fettle_world_memory(self._pointer, *a))
        return {ffi.string(share.purpose).decode(): (share.used, share.reserved) for share in found}

    @property
    def events(self):
        """Events of the last step and of the edits before it."""
        return events_of(self)

    def keep_account(self, body):
        """From the next step on, adds up what changes the velocity of a body. A world keeps eight accounts: with one more, the one
        that began first ends."""
        check(lib.fettle_world_keep_account(self._pointer, id_of(body, Body)))

    def account(self, body):
        """What changed the velocity of a body in the last step: a `VelocityAccount`. None if it was not kept, or if the body was
        asleep or does not move by forces."""
        return account_of(self, body)

    # --- Arrays: row `body.slot` belongs to a body; they show every step and cannot be written ------

    @property
    def states(self):
        """x, y, angle, angular velocity, velocity x, velocity y, cosine and sine of the angle of every body: float32, 8 columns."""
        return self._columns.states()

    @property
    def poses(self):
        """x, y and angle: 3 columns."""
        return self._columns.states()[:, 0:3]

    @property
    def positions(self):
        return self._columns.states()[:, 0:2]

    @property
    def velocities(self):
        return self._columns.states()[:, 4:6]

    @property
    def previous_poses(self):
        """x, y and angle before the last step: 3 columns."""
        return self._columns.previous()

    # --- Snapshots ---------------------------------------------------------------------------------

    def save(self):
        """The complete state as bytes."""
        begin, size = ffi.new("void const**"), ffi.new("size_t*")
        check(lib.fettle_world_save(self._pointer, begin, size))
        return ffi.buffer(begin[0], size[0])[:]

    def restore(self, state):
        """Goes back to bytes of `save`, or to the state of another world. Handles that were valid then are valid again."""
        self._columns.may_move("restore")
        if isinstance(state, World):
            check(lib.fettle_world_assign(self._pointer, state._pointer))
        else:
            data = to_bytes(state, "restore")
            check(lib.fettle_world_restore(self._pointer, data, len(data)))

    def clone(self):
        """A copy that goes on in the same way; ids are valid in both. It has no callbacks."""
        made = ffi.new("fettle_world**")
        check(lib.fettle_world_clone(self._pointer, made))
        return World._of(made[0])

    def take(self, other):
        """Takes over the state of another world without copying it; the other one is empty afterwards."""
        if not isinstance(other, World):
            raise Invalid(f"expected a World, got {other!r}")
        for world in (self, other):
            world._columns.may_move("take")
        check(lib.fettle_world_take(self._pointer, other._pointer))

    def __reduce__(self):
        return _restored, (self.save(),)

    # --- Functions that the world calls ------------------------------------------------------------

    def _set_world_function(self, name, make, function):
        callback = ffi.NULL if to_function(function, name) is None else make(self, function)
        if self.locked:
            raise Locked(f"{name}: the world is calling a function")
        self._set_callback(name, getattr(lib, "fettle_world_" + name), callback)

    def _set_callback(self, kind, set_function, callback, *of):
        """Gives C a function that the world is to call from now on, and keeps it as long as C may call it. `set_function` may
        call it at once; if it raises then, it stays set."""
        code = set_function(self._pointer, *of, callback, ffi.NULL)
        if code == lib.FETTLE_DONE:
            self._callbacks[kind] = callback
        check(code)

    def set_filter(self, function):
        """`function(shape_a, shape_b)` says whether two shapes may collide. None: all may."""
        self._set_world_function("set_filter", _callbacks.pair_filter, function)

    def set_mixing(self, function):
        """`function(contact)` may set friction, restitution and surface_speed of a contact."""
        self._set_world_function("set_mixing", _callbacks.contact_callback, function)

    def set_before_solve(self, function):
        """`function(contact)` may also set `enabled` to False for a step, and `ignored` to True until the shapes
        have separated."""
        self._set_world_function("set_before_solve", _callbacks.contact_callback, function)

    def _set_body_function(self, set_function, kind, body, function):
        make = {"velocity": _callbacks.velocity_function, "position": _callbacks.position_function}[kind]
        callback = ffi.NULL if to_function(function, kind + " function") is None else make(self, function)
        self._set_callback((kind, body.slot), set_function, callback, body.id)

    def after_step(self, function):
        """Calls `function()` once when the running step has ended, or after the next one. It may edit the world."""
        if to_function(function, "after_step") is None:
            raise Invalid("after_step: expected a function, got None")
        callback = self._callbacks.setdefault("after_step", _callbacks.after_step(self))
        check(lib.fettle_world_after_step(self._pointer, callback, ffi.NULL))
        self._waiting.append(function)

    def draw(self, target, **options):
        """Calls `target.polygon(points, closed, color)`, `circle(center, radius, angle, color)`, `segment(begin, end, color)` and
        `point(at, color)` for all that is to be drawn; methods that it does not have are left out. If it has
        `target.color_of(body, shape)`, that returns the color of a shape. `options`: `shapes`, `joints`, `contacts`, `boxes`,
        `centers`, `region`, `fraction`. Colors are 0xRRGGBB."""
        made, kept = drawing_of(self, target, options)
        check(lib.fettle_world_draw(self._pointer, made))

    # --- Recordings: `Replay` repeats them ---------------------------------------------------------

    def start_recording(self, write):
        """Records the world: `write(bytes)` gets its state now and the changes in every step, as `file.write` does. If it raises,
        the recording ends; the call raises the exception, and the part that was written before can be replayed."""
        if to_function(write, "start_recording") is None:
            raise Invalid("start_recording: expected a function, got None")
        sink = _callbacks.RecordingSink(self, write)
        try:
            self._set_callback("recording", lib.fettle_world_start_recording, sink.callback)
        finally:
            sink.in_step = True
            if sink.ended:
                self.stop_recording()

    def stop_recording(self):
        """Ends the recording, if there is one."""
        check(lib.fettle_world_stop_recording(self._pointer))

    @property
    def statistics(self):
        """Numbers and times (ms) of the last step, by name."""
        out = ffi.new("fettle_statistics*")
        check(lib.fettle_world_statistics(self._pointer, out))
        return {name: getattr(out, name) for name, _ in ffi.typeof("fettle_statistics").fields}

    @property
    def fault(self):
        """What is inconsistent in the world, or None. Slow; for tests."""
        text = ffi.new("char const**")
        check(lib.fettle_world_validate(self._pointer, text))
        return None if text[0] == ffi.NULL else ffi.string(text[0]).decode()
