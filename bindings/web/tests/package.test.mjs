// Tests of the installed package: node --test, in a project that has it.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as fettle from "fettle-physics";

const { BodyType, Invalid, Locked, ShapeType, Stale, World, box, circle, clipVelocity, load, polygon, solvePlanes } = fettle;
await load();

const near = (value, expected, most) => assert.ok(Math.abs(value - expected) <= most, `${value} is not ${expected}`);
const standing = () => {
  const world = new World();
  const ground = world.createBody({ type: BodyType.STATIC });
  ground.add(box(20, 1));
  const ball = world.createBody({ position: { x: 0, y: 5 } });
  ball.add(circle(0.5));
  return { world, ground, ball };
};
const run = (world, steps) => { for (let i = 0; i < steps; ++i) world.step(1 / 60); };

// The first test: memory has not grown yet.
test("a list that makes memory grow arrives", () => {
  const world = new World();
  const ground = world.createBody({ type: BodyType.STATIC });
  const points = Array.from({ length: 1000000 }, (_, i) => ({ x: i / 2, y: i % 2 }));
  world.reserve(40000, 0, 0, 0);  // leaves less of the first 16 MB than the points take
  assert.equal(ground.add(fettle.chain(points)).geometry.points.length, points.length);
  world.destroy();
});

test("a ball falls on the ground and rests there", () => {
  const { world, ball } = standing();
  run(world, 180);
  near(ball.position.y, 1, 0.02);
  assert.equal(ball.awake, false);
});

test("properties are read and written", () => {
  const { world, ball } = standing();
  ball.velocity = { x: 3, y: -1 };
  assert.deepEqual(ball.velocity, { x: 3, y: -1 });
  ball.gravityScale = 0.5;
  assert.equal(ball.gravityScale, 0.5);
  ball.mass = 7;
  assert.equal(ball.mass, 7);
  assert.equal(ball.massOverride, 7);
  ball.mass = null;
  assert.equal(ball.massOverride, null);
  world.gravity = { x: 0, y: 0 };
  assert.deepEqual(world.gravity, { x: 0, y: 0 });
});

test("what is wrong is refused, and says why", () => {
  const { world, ball } = standing();
  assert.throws(() => (ball.angle = NaN), Invalid);
  assert.throws(() => (ball.angle = "1"), /angle = "1": expected a number/);
  assert.throws(() => (ball.position = { x: 1 }), Invalid);
  assert.throws(() => world.createBody({ positon: { x: 0, y: 0 } }), /no member "positon" \(did you mean "position"\?\)/);
  assert.throws(() => ball.add({ radius: 1 }), /geometry.type/);
  assert.throws(() => ball.add(circle(-1)), Invalid);
  assert.equal(ball.shapes.length, 1);
});

test("objects that are gone are stale", () => {
  const { world, ball } = standing();
  ball.destroy();
  assert.equal(ball.isValid, false);
  assert.throws(() => ball.position, Stale);
  world.destroy();
  world.destroy();
  assert.throws(() => world.step(1 / 60), Stale);
});

test("an object has one handle", () => {
  const { world, ball } = standing();
  const [shape] = ball.shapes;
  assert.equal(shape, ball.shapes[0]);
  assert.equal(shape.body, ball);
  assert.ok(world.bodies.includes(ball));
  ball.destroy();
  const other = world.createBody();
  assert.notEqual(other, ball);
});

test("a joint has the class of its type", () => {
  const { world, ground, ball } = standing();
  const joint = world.createRevoluteJoint({ bodyA: ground, bodyB: ball, anchorA: { x: 0, y: 5 } });
  assert.ok(joint instanceof fettle.RevoluteJoint && joint instanceof fettle.Joint);
  assert.equal(joint.bodyB, ball);
  assert.equal(ball.joints[0], joint);
  joint.motorSpeed = 2;
  assert.equal(joint.motorSpeed, 2);
  assert.throws(() => (joint.motorSped = 2), TypeError);
});

test("events name shapes and bodies", () => {
  const { world, ground, ball } = standing();
  const touched = [];
  for (let i = 0; i < 120; ++i) {
    world.step(1 / 60);
    for (const event of world.events().contactBegin) touched.push(event);
  }
  assert.equal(touched.length, 1);
  assert.deepEqual(new Set([touched[0].bodyA, touched[0].bodyB]), new Set([ground, ball]));
  near(Math.abs(touched[0].normal.y), 1, 1e-4);
});

test("rays and boxes find shapes", () => {
  const { world, ball } = standing();
  const hit = world.castRay({ x: -5, y: 5 }, { x: 5, y: 5 });
  assert.equal(hit.shape.body, ball);
  near(hit.point.x, -0.5, 1e-4);
  assert.equal(world.castRay({ x: -5, y: 9 }, { x: 5, y: 9 }), null);
  assert.equal(world.queryAabb({ min: { x: -1, y: 4 }, max: { x: 1, y: 6 } }).length, 1);
  assert.equal(world.queryAabb({ min: { x: -1, y: 4 }, max: { x: 1, y: 6 } }, { mask: 2n }).length, 0);
});

test("lists that are longer than the usual room", () => {
  const world = new World();
  for (let i = 0; i < 5000; ++i) world.createBody({ position: { x: i, y: 0 } });
  const bodies = world.bodies;
  assert.equal(bodies.length, 5000);
  assert.equal(new Set(bodies).size, 5000);
});

test("geometry with many points", () => {
  const world = new World();
  const points = Array.from({ length: 9000 }, (_, i) => ({ x: i, y: Math.sin(i) }));
  const shape = world.createBody({ type: BodyType.STATIC }).add(fettle.chain(points));
  assert.equal(shape.type, ShapeType.CHAIN);
  assert.equal(shape.vertices.length, 9000);
  assert.throws(() => world.createBody().add(polygon([{ x: 0, y: 0 }, { x: 1, y: 0 }])), Invalid);
});

test("a list whose length is no length is refused", () => {
  const { world, ball } = standing();
  for (const length of [-1, -5, NaN, 1.5, 1e9, 2 ** 29, 2 ** 32, Infinity])
    assert.throws(() => ball.add(polygon({ length })), /points\.length = .*: expected a whole number/);
  assert.throws(() => ball.add(polygon({ length: 3 })), /points\[0\] = undefined/);
  assert.equal(world.validate(), "");
  run(world, 10);
});

test("poses without copies", () => {
  const { world, ball } = standing();
  run(world, 30);
  const { states } = world, { position, velocity } = ball, at = 8 * ball.slot;
  assert.equal(states[at], position.x);
  assert.equal(states[at + 1], position.y);
  assert.equal(states[at + 5], velocity.y);
});

test("saves restore a world", () => {
  const { world, ball } = standing();
  run(world, 20);
  const saved = world.save(), hash = world.hash, { y } = ball.position;
  run(world, 20);
  assert.notEqual(ball.position.y, y);
  world.restore(saved);
  assert.equal(ball.position.y, y);
  assert.equal(world.hash, hash);
  saved[saved.length >> 1] ^= 1;
  assert.throws(() => world.restore(saved), Invalid);
  assert.equal(world.hash, hash);
  const copy = world.clone();
  assert.equal(copy.hash, hash);
});

test("memory grows while views are in use", () => {
  const worlds = [];
  for (let i = 0; i < 40; ++i) {
    const { world } = standing();
    for (let k = 0; k < 500; ++k) world.createBody({ position: { x: k, y: 3 } }).add(circle(0.3));
    world.step(1 / 60);
    worlds.push(world);
  }
  assert.equal(new Set(worlds.map((world) => world.hash)).size, 1);
});

test("a misspelt setting of a world and a value that is no bool are errors", () => {
  const world = new World();
  assert.throws(() => (world.gravty = { x: 0, y: 0 }), TypeError);
  assert.throws(() => (world.sleeping = "no"), { name: "Error", message: 'sleeping = "no": expected true or false' });
  assert.throws(() => world.createBody({ bullet: 1 }), fettle.Invalid);
  assert.equal(world.sleeping, true);
  class Level extends World { score = 0; }  // a class of the program has what it adds
  assert.equal(new Level().score, 0);
  assert.throws(() => (world.clone().gravty = 1), TypeError);
});

test("a world that a function of it destroys stays", () => {
  const { world, ball } = standing();
  world.setFilter(() => world.destroy());
  world.createBody({ position: { x: 0, y: 5 } }).add(fettle.circle(1));
  ball.position = { x: 0, y: 5 };
  assert.throws(() => world.step(1 / 60), fettle.Locked);
  world.setFilter(null);
  assert.equal(world.bodies.find((body) => body === ball), ball);
  world.destroy();
  world.destroy();
  assert.throws(() => world.step(1 / 60), fettle.Stale);
});

test("the definition of a joint has all that its type has", () => {
  const world = new World({ gravity: { x: 0, y: 0 } });
  const bodyA = world.createBody(), bodyB = world.createBody({ position: { x: 3, y: 0 } });
  const wheel = world.createWheelJoint({ bodyA, bodyB, axis: { x: 1, y: 0 }, hertz: 2, motorSpeed: 5, maxMotorTorque: 7 });
  assert.deepEqual([wheel.axis.x, wheel.hertz, wheel.motorSpeed, wheel.maxMotorTorque], [1, 2, 5, 7]);
  const rope = { bodyA, bodyB, groundA: { x: 0, y: 4 }, groundB: { x: 3, y: 5 }, ratio: 2 };
  assert.equal(world.createPulleyJoint(rope).length, 14);  // taut
  assert.equal(world.createPulleyJoint({ ...rope, length: 20 }).length, 20);
  assert.throws(() => world.createWheelJoint({ bodyA, bodyB, ratio: 2 }), Invalid);
});

test("joints of every type have a class", () => {
  const world = new World({ gravity: { x: 0, y: 0 } });
  const bodyA = world.createBody(), bodyB = world.createBody({ position: { x: 1, y: 0 } });
  const limit = world.createRotaryLimitJoint({ bodyA, bodyB });
  assert.ok(limit instanceof fettle.RotaryLimitJoint);
  limit.upperAngle = 0.5;
  assert.equal(limit.upperAngle, 0.5);
  assert.ok(world.createFilterJoint({ bodyA, bodyB }) instanceof fettle.FilterJoint);
  assert.equal(world.joints.length, 2);
});

/** A world with a floor whose surface is at y = 0.5, a step of 0.2 m at x = 2, and a wall at x = 4. */
const course = () => {
  const world = new World();
  const ground = world.createBody({ type: BodyType.STATIC });
  const floor = ground.add(box(40, 1));
  ground.add(box(2, 0.4, { center: { x: 3, y: 0.5 } }));
  const wall = ground.add(box(1, 10, { center: { x: 4.5, y: 0 } }));
  return { world, floor, wall };
};

test("a mover lands and climbs a step and is stopped by a wall", () => {
  const { world, floor, wall } = course();
  const hero = new fettle.Mover(world, { radius: 0.3, height: 1.5 }, { x: 0, y: 2 });
  assert.equal(hero.onGround, false);
  assert.equal(hero.ground, null);
  let velocity = { x: 0, y: 0 };
  for (let i = 0; i < 60; ++i) {
    velocity = hero.move({ x: 0, y: velocity.y - 10 / 60 }, 1 / 60).velocity;
    world.step(1 / 60);
  }
  assert.ok(hero.onGround);
  assert.equal(hero.ground, floor);
  near(hero.position.y, 0.5, 0.03);
  near(hero.groundNormal.y, 1, 1e-4);
  let stepped = 0, last;
  for (let i = 0; i < 240; ++i) {
    last = hero.move({ x: 2, y: 0 }, 1 / 60);
    stepped += last.stepped;
    world.step(1 / 60);
  }
  assert.ok(stepped > 0);
  assert.ok(last.hitWall);
  assert.equal(last.wall, wall);
  near(hero.position.x, 4 - 0.3, 0.05);
  near(hero.position.y, 0.7, 0.03);
});

test("settings of a mover are properties and checked", () => {
  const { world } = course();
  const hero = new fettle.Mover(world, { mask: 6n }, { x: 0, y: 3 });
  assert.equal(hero.mask, 6n);
  hero.maxSlope = 0.5;
  assert.equal(hero.maxSlope, 0.5);
  assert.throws(() => (hero.radius = -1), Invalid);
  assert.throws(() => (hero.skin = "1"), /skin = "1": expected a number/);
  near(hero.radius, 0.4, 1e-6);
  assert.throws(() => (hero.definition = { hight: 2 }), /no member "hight"/);
  assert.throws(() => new fettle.Mover(world, { up: { x: 0, y: 0 } }), Invalid);
  assert.throws(() => new fettle.Mover({}), /world = .*: expected a World/);
  assert.throws(() => (hero.speed = 2), TypeError);
  assert.throws(() => (hero.height = 2), TypeError);
  const here = hero.position;
  here.x = 9;  // a copy
  assert.equal(hero.position.x, 0);
  class Hero extends fettle.Mover { speed = 3; }
  assert.equal(new Hero(world).speed, 3);
});

test("a mover crouches where there is no room to stand", () => {
  const { world } = course();
  world.createBody({ type: BodyType.STATIC }).add(box(4, 1, { center: { x: 0, y: 2 } }));  // from 1.5 m
  const hero = new fettle.Mover(world, { height: 0.9 }, { x: 0, y: 0.55 });
  assert.equal(hero.fits(1.8), false);
  assert.equal(hero.setHeight(1.8), false);
  near(hero.height, 0.9, 1e-6);
  hero.position = { x: -5, y: 0.55 };
  assert.equal(hero.setHeight(1.8), true);
  near(hero.height, 1.8, 1e-6);
  assert.throws(() => hero.setHeight(0.1), Invalid);
  const [below] = hero.planes(0.5);
  near(clipVelocity({ x: 1, y: -2 }, [below]).y, 0, 1e-6);
  near(solvePlanes({ x: 1, y: -2 }, hero.planes(0.5), 0.1).y, 0.1 - below.separation, 1e-4);
  assert.throws(() => clipVelocity({ x: 1, y: -2 }, [{ ...below, normal: { x: 0, y: 3 } }]), /planes\[0\]: expected a normal of length 1/);
  near(below.normal.y, 1, 1e-4);
  assert.ok(below.shape instanceof fettle.Shape);
});

test("the state of a mover can be kept and set again", () => {
  const { world } = course();
  const hero = new fettle.Mover(world, {}, { x: 0, y: 0.55 });
  const walk = () => { for (let i = 0; i < 30; ++i) hero.move({ x: 1, y: -1 }, 1 / 60); };
  walk();
  const kept = hero.state;
  assert.equal(kept.onGround, true);
  walk();
  const { x } = hero.position;
  assert.ok(x > kept.position.x + 0.4);
  hero.state = kept;
  assert.deepEqual(hero.state, kept);
  walk();
  assert.equal(hero.position.x, x);
  hero.position = { x: 0, y: 5 };
  assert.equal(hero.onGround, false);
  world.destroy();
  assert.throws(() => hero.move({ x: 1, y: 0 }, 1 / 60), Stale);
});

test("a mover drops through a ledge", () => {
  const { world } = course();
  const ledge = world.createBody({ type: BodyType.STATIC }).add(box(4, 0.2, { center: { x: 0, y: 3 } }), { category: 4n });
  const hero = new fettle.Mover(world, { ledges: 4n }, { x: 0, y: 3.12 });
  for (let i = 0; i < 10; ++i) hero.move({ x: 0, y: -1 }, 1 / 60);
  assert.equal(hero.ground, ledge);
  assert.equal(hero.drop(), true);
  assert.equal(hero.dropped, ledge);
  for (let i = 0; i < 60; ++i) hero.move({ x: 0, y: -4 }, 1 / 60);
  near(hero.position.y, 0.5, 0.03);
  assert.equal(hero.drop(), false);
});

test("the library in C is there as a whole", () => {
  assert.match(fettle.physicsVersion(), /^\d+\.\d+\.\d+$/);
  assert.equal(fettle.simdWidth(), 4);
  assert.ok(new Locked("locked") instanceof fettle.FettleError);
});

test("a destroyed world is not the one that has its memory", () => {
  const { world, ball } = standing(), others = [];
  world.destroy();
  for (let i = 0; i < 1500; ++i) {  // the library keeps the memory of a thousand
    others.push(new World());
    new World().destroy();
  }
  assert.throws(() => world.step(1), Stale);
  assert.throws(() => others[0].assign(world), Stale);
  assert.equal(ball.isValid, false);
  world.destroy();
  for (const other of others) {
    other.step(1);
    other.destroy();
  }
});
