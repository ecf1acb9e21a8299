"""Steps a second: 256 small worlds at once, and one world with a pyramid of 820 boxes, also in Chipmunk.

Chipmunk is the library that pymunk drives through cffi; here its library of Debian (libchipmunk7) is driven in the same way, if it is there.

    python3 speed.py [SECONDS]    measures each for so long; 2 by default
"""

import sys
import time

import cffi
import numpy

import fettle

seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0


def rate(step):
    """Calls of `step` a second."""
    step()
    count, begin = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - begin) < seconds:
        step()
        count += 1
    return count / elapsed


def cart_pole(world):
    """A cart on the ground with a pole that stands on it."""
    world.body("static", position=(0, -0.5)).add(fettle.Box(100, 1))
    cart = world.body(position=(0, 0.25))
    cart.add(fettle.Box(1, 0.5), friction=0)
    pole = world.body(position=(0, 1.5))
    pole.add(fettle.Box(0.1, 2), mask=0)
    world.joint("revolute", cart, pole, (0, 0.25), (0, -1))
    return [cart, pole]


def pyramid(make_box, rows=40):
    for row in range(rows):
        for i in range(rows - row):
            make_box(1.1 * (i - (rows - row) / 2), 0.5 + 1.05 * row)


def fettle_pyramid():
    world = fettle.World(sleeping=False)
    world.body("static", position=(0, -0.5)).add(fettle.Box(200, 1))
    pyramid(lambda x, y: world.body(position=(x, y)).add(fettle.Box(1, 1)))
    return lambda: world.step(1 / 60)


def chipmunk_pyramid():
    """The same in Chipmunk with the ten iterations that pymunk has; None without its library."""
    c = cffi.FFI()
    c.cdef("""
        typedef struct { double x, y; } cpVect;
        void* cpSpaceNew(void);
        void cpSpaceSetGravity(void* space, cpVect gravity);
        void* cpSpaceGetStaticBody(void* space);
        void* cpSpaceAddBody(void* space, void* body);
        void* cpSpaceAddShape(void* space, void* shape);
        void cpSpaceStep(void* space, double dt);
        void* cpBodyNew(double mass, double moment);
        void cpBodySetPosition(void* body, cpVect position);
        double cpMomentForBox(double mass, double width, double height);
        void* cpBoxShapeNew(void* body, double width, double height, double radius);
        void* cpSegmentShapeNew(void* body, cpVect a, cpVect b, double radius);
        void cpShapeSetFriction(void* shape, double friction);
    """)
    try:
        lib = c.dlopen("libchipmunk.so.7")
    except OSError:
        return None
    space = lib.cpSpaceNew()
    lib.cpSpaceSetGravity(space, (0, -10))

    def add(shape):
        lib.cpShapeSetFriction(shape, 0.6)
        lib.cpSpaceAddShape(space, shape)

    def make_box(x, y):
        body = lib.cpSpaceAddBody(space, lib.cpBodyNew(1, lib.cpMomentForBox(1, 1, 1)))
        lib.cpBodySetPosition(body, (x, y))
        add(lib.cpBoxShapeNew(body, 1, 1, 0))

    add(lib.cpSegmentShapeNew(lib.cpSpaceGetStaticBody(space), (-100, 0), (100, 0), 0))
    pyramid(make_box)
    return lambda: lib.cpSpaceStep(space, 1 / 60)


env = fettle.VectorWorld(cart_pole, count=256)
forces = numpy.zeros((256, 2, 2), dtype=numpy.float32)
forces[:, 0, 0] = numpy.linspace(-3, 3, 256)
print(f"256 worlds with cart and pole: {256 * rate(lambda: env.step(forces)):.0f} steps of a world a second")
print(f"reset of 256 worlds: {rate(env.reset):.0f} times a second")
print(f"pyramid of 820 boxes: {rate(fettle_pyramid()):.0f} steps a second")
chipmunk = chipmunk_pyramid()
print(f"the same in Chipmunk: {rate(chipmunk):.0f} steps a second" if chipmunk else "Chipmunk is not here")
