// Functions of the program that the library calls, and recordings: node --test, in a project that has the package.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as fettle from "fettle-physics";

const { BodyType, Invalid, Locked, Replay, Stale, World, box, chain, circle, load } = fettle;
await load();

const near = (value, expected, most) => assert.ok(Math.abs(value - expected) <= most, `${value} is not ${expected}`);
const standing = (y = 2) => {
  const world = new World({ gravity: { x: 0, y: -10 } });
  const ground = world.createBody({ type: BodyType.STATIC });
  const floor = ground.add(box(40, 1));
  const ball = world.createBody({ position: { x: 0, y } });
  const shape = ball.add(circle(0.5));
  return { world, ground, floor, ball, shape };
};
const run = (world, steps) => { for (let i = 0; i < steps; ++i) world.step(1 / 60); };

test("a filter says which shapes may collide", () => {
  const { world, floor, ball, shape } = standing();
  const asked = [];
  world.setFilter((a, b) => (asked.push(a, b), false));
  run(world, 60);
  assert.ok(ball.position.y < 0);
  assert.deepEqual(new Set(asked), new Set([floor, shape]));
  world.setFilter(null);
  ball.position = { x: 0, y: 3 };
  ball.velocity = { x: 0, y: 0 };
  run(world, 120);
  near(ball.position.y, 1, 0.02);
});

test("a contact is mixed and edited and ignored", () => {
  const { world, floor, ball, shape } = standing();
  world.setMixing((contact) => { contact.restitution = 0.9; });
  let seen;
  world.setBeforeSolve((contact) => {
    seen = contact;
    assert.deepEqual(new Set([contact.shapeA, contact.shapeB]), new Set([floor, shape]));
    near(Math.abs(contact.normal.y), 1, 1e-4);
    assert.throws(() => { contact.normal = { x: 1, y: 0 }; }, TypeError);
    assert.throws(() => { contact.friction = "much"; }, Invalid);
    assert.throws(() => { contact.colour = 1; }, TypeError);
  });
  run(world, 60);
  assert.ok(ball.position.y > 1.05 || ball.velocity.y > 1, "it bounces");
  assert.throws(() => seen.friction, Stale);
  assert.throws(() => { seen.friction = 1; }, Stale);
  world.setBeforeSolve((contact) => { contact.ignored = true; });
  run(world, 120);
  assert.ok(ball.position.y < 0);
});

test("limits that cross are refused", () => {
  const { world, ball } = standing();
  assert.throws(() => world.createRevoluteJoint({ bodyB: ball, lowerAngle: 2, upperAngle: 1 }),
    (error) => error instanceof Invalid && /= 2: expected at most .*, which is 1/.test(error.message));
});

test("functions move a body", () => {
  const { world, ball } = standing();
  let steps = 0;
  ball.setVelocityFunction((edit) => {
    assert.equal(edit.body, ball);
    near(edit.dt, 1 / 60, 1e-6);
    edit.velocity = { x: 0, y: 1 };
    ++steps;
  });
  run(world, 60);
  near(ball.position.y, 3, 0.05);
  assert.equal(steps, 60);
  ball.setVelocityFunction(null);
  ball.setPositionFunction((edit) => { edit.pose = { position: { x: 1, y: edit.pose.position.y }, angle: 0.25 }; });
  run(world, 10);
  near(ball.position.x, 1, 1e-4);
  near(ball.angle, 0.25, 1e-4);
});

test("inside a function the world can be read and asked, and edits are refused", () => {
  const { world, ground, floor, ball } = standing();
  const found = [];
  let calls = 0;
  world.visitAabb({ min: { x: -1, y: -1 }, max: { x: 1, y: 9 } }, (shape) => {
    assert.throws(() => { ball.position = { x: 5, y: 5 }; }, Locked);
    assert.throws(() => world.step(1 / 60), Locked);
    // A call inside, with more results than there is room for at first, and a function in it.
    const all = world.queryAabb({ min: { x: -9, y: -9 }, max: { x: 9, y: 9 } }, { accept: (other) => (++calls, other === floor) });
    assert.deepEqual(all, [floor]);
    assert.deepEqual(world.bodies, [ground, ball]);
    found.push(shape);
  }, { sensors: true, accept: (shape) => shape.body !== null });
  assert.equal(found.length, 2);
  assert.equal(calls, 4);
  assert.equal(ball.position.x, 0);
});

test("a visitor ends a query, and a filter can be left out", () => {
  const world = new World();
  for (let x = 0; x < 5; ++x) world.createBody({ type: BodyType.STATIC, position: { x, y: 0 } }).add(box(0.5, 0.5));
  const visits = [
    (see) => world.visitRay({ x: -9, y: 0 }, { x: 9, y: 0 }, see),
    (see) => world.visitAabb({ min: { x: -9, y: -1 }, max: { x: 9, y: 1 } }, see),
    (see) => world.visitOverlapGeometry(box(20, 1), null, see),
  ];
  for (const visit of visits) {
    let seen = 0;
    visit(() => { ++seen; });
    assert.equal(seen, 5);
    visit(() => { ++seen; return false; });
    assert.equal(seen, 6);
    assert.throws(() => visit(3), /visitor = 3: expected a function/);
  }
  const distances = [];
  world.visitRay({ x: -9, y: 0 }, { x: 9, y: 0 }, (hit) => { distances.push(hit.fraction); });
  assert.deepEqual(distances, [...distances].sort((a, b) => a - b));
  let points = 0;
  world.visitPoint({ x: 1, y: 0 }, (shape) => { points += shape.body.position.x; });
  assert.equal(points, 1);
});

test("what a function throws comes out of the call that led to it", () => {
  const { world, ball } = standing(1);
  const mine = new Error("mine");
  let calls = 0;
  world.setBeforeSolve(() => { ++calls; throw mine; });
  assert.throws(() => run(world, 30), (error) => error === mine);
  assert.ok(calls > 0);
  world.setBeforeSolve(null);
  run(world, 1);
  assert.throws(() => world.setFilter(() => { throw undefined; }), (error) => error === undefined);
  world.setFilter(null);
  // An error inside is caught there, and is none of the outer call.
  world.visitPoint(ball.position, () => { assert.throws(() => world.visitPoint(ball.position, () => { throw mine; }), /mine/); });
  // After one function has failed, those that are called later in the step still get answers of the library.
  world.setMixing(() => { throw mine; });
  let heard = 0;
  world.setBeforeSolve((contact) => { heard += contact.shapeA.friction; });
  assert.throws(() => run(world, 5), /mine/);
  assert.ok(heard > 0);
});

test("functions for the end of a step run once and in order and may edit", () => {
  const { world, ball } = standing(1);
  const order = [];
  world.afterStep(() => order.push("first"));
  world.afterStep(() => { order.push("second"); world.createBody(); });
  world.setBeforeSolve(() => { if (order.length === 2) { order.push("burst"); world.afterStep(() => ball.destroy()); } });
  run(world, 3);
  run(world, 3);
  assert.deepEqual(order.slice(0, 2), order.includes("burst") ? ["first", "second"] : order);
  assert.equal(order.filter((each) => each === "first").length, 1);
  assert.equal(ball.isValid, !order.includes("burst"));
  assert.equal(world.bodies.length, order.includes("burst") ? 2 : 3);
});

test("a recording is repeated with the edits and the answers of functions", () => {
  const { world, ball } = standing();
  const parts = [];
  world.setBeforeSolve((contact) => { contact.restitution = 0.5; });
  world.startRecording((bytes) => parts.push(bytes));
  assert.equal(world.isRecorded, true);
  assert.throws(() => world.startRecording(() => {}), Invalid);
  run(world, 40);
  ball.velocity = { x: 3, y: 1 };
  run(world, 40);
  world.stopRecording();
  assert.equal(world.isRecorded, false);
  const recording = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) { recording.set(part, at); at += part.length; }
  const replay = new Replay(recording);
  assert.equal(replay.steps, 80n);
  const steps = [...replay];
  assert.equal(steps.length, 80);
  assert.ok(steps.every((step) => step.same && step.hash === step.recordedHash));
  assert.match(steps[40].calls, /set_velocity/);
  assert.equal(replay.world.hash, world.hash);
  replay.destroy();
  replay.destroy();
  assert.throws(() => replay.step(), Stale);
  assert.throws(() => { replay.stepz = 1; }, TypeError);
  recording[recording.length >> 1] ^= 1;
  assert.throws(() => new Replay(recording), Invalid);
});

test("a function that throws ends the recording that it takes", () => {
  const { world } = standing();
  const parts = [];
  let room = 0;
  const take = (bytes) => {
    if (parts.length >= room) throw new Error("the disk is full");
    parts.push(bytes);
  };
  assert.throws(() => world.startRecording(take), /the disk is full/);
  assert.equal(world.isRecorded, false);
  room = 6;
  world.startRecording(take);
  assert.throws(() => run(world, 10), /the disk is full/);
  assert.equal(world.isRecorded, false);
  room = 100;
  run(world, 10);
  assert.equal(parts.length, 6);
  const replay = new Replay(new Uint8Array(parts.flatMap((part) => [...part])));
  assert.equal(replay.steps, 3n);
  assert.ok([...replay].every((step) => step.same));
});

test("getters of arguments may call the library", () => {
  const { world, ball } = standing();
  const follower = { get x() { return ball.position.x + 1; }, get y() { return ball.position.y; } };
  const made = world.createBody({ get position() { return ball.position; }, velocity: follower, angle: 0.5 });
  assert.deepEqual([made.position, made.velocity, made.angle], [ball.position, { x: 1, y: 2 }, 0.5]);
  let hits = 0;
  world.visitRay({ x: 0, y: 9 }, { get x() { return ball.position.x; }, y: -9 }, () => { ++hits; }, { mask: 1 });
  assert.equal(hits, 2);
  made.add(fettle.polygon([follower, { x: 0, y: 0 }, { x: 1, y: 0 }]));
  assert.deepEqual(world.validate(), "");
  assert.throws(() => world.createBody({ get angle() { throw new RangeError("not now"); } }), RangeError);
  assert.equal(world.createBody({ angle: 1 }).angle, 1);
});

test("a world is drawn by the methods that a target has", () => {
  const { world } = standing();
  const drawn = [];
  const target = {
    polygon(points, closed, color) { drawn.push(["polygon", points.length, closed, color <= 0xffffff]); },
    circle(center, radius) { drawn.push(["circle", center.y, radius]); },
  };
  world.draw(target);
  assert.deepEqual(drawn, [["polygon", 4, true, true], ["circle", 2, 0.5]]);
  world.draw(target, { region: { min: { x: 100, y: 100 }, max: { x: 101, y: 101 } } });
  assert.equal(drawn.length, 2);
  world.draw({ circle: target.circle });
  assert.equal(drawn.length, 3);
  assert.throws(() => world.draw(target, { colours: true }), /no member "colours"/);
  assert.throws(() => world.draw({ polygon() { throw new RangeError("full"); } }), RangeError);
});

test("what has no defaults must be there", () => {
  const { world, floor } = standing(), min = { x: -1, y: -1 };
  assert.throws(() => world.queryAabb({ min }), /^Error: box has no "max": expected min, max$/);
  assert.throws(() => { world.bounds = {}; }, /bounds has no "min"/);
  assert.throws(() => floor.setSegmentSurface(0, { friction: 1 }), /surface has no "restitution"/);
  assert.throws(() => fettle.joinLines(() => {}), /points = .*: expected an array/);
  assert.throws(() => { new fettle.Mover(world).position = undefined; }, /position = undefined/);
  assert.throws(() => world.draw({ polygons() {} }), /expected an object with some of the methods polygon, circle/);
  assert.throws(() => world.draw(null), Invalid);
});

test("a target colors what is drawn", () => {
  const { world, ball, shape } = standing();
  const colors = [];
  const target = {
    circle(center, radius, angle, color) { colors.push(color); },
    colorOf(body, of) { return body === ball && of === shape ? 0x123456 : 1; },
  };
  world.draw(target);
  assert.deepEqual(colors, [0x123456]);
  assert.throws(() => world.draw({ ...target, colorOf: () => "red" }), /colorOf = "red": expected a whole number/);
  assert.throws(() => world.draw({ ...target, colorOf() { throw new RangeError("none"); } }), RangeError);
});

test("an account tells what changed a velocity", () => {
  const { world, ground, floor, ball, shape } = standing(1);
  assert.equal(world.account(ball), null);
  assert.deepEqual(world.accountContacts(ball), []);
  world.keepAccount(ball);
  ball.applyForce({ x: 3, y: 0 });
  run(world, 1);
  const account = world.account(ball);
  near(account.gravity.y, -10 / 60, 1e-5);
  assert.ok(account.applied.x > 0);
  assert.equal(account.turn.damping, 0);
  const [share] = world.accountContacts(ball);
  assert.equal(share.own, shape);
  assert.equal(share.other, floor);
  assert.equal(share.body, ground);
  near(account.before.y + account.gravity.y + share.change.y + account.rest.y, account.after.y, 1e-6);
  const pin = world.createRevoluteJoint({ bodyA: ground, bodyB: ball });
  run(world, 1);
  assert.deepEqual(world.accountJoints(ball).map(({ joint }) => joint), [pin]);
  ball.destroy();
  assert.throws(() => world.account(ball), Stale);
  assert.throws(() => world.keepAccount("ball"), Invalid);
});

test("segments of a chain have surfaces", () => {
  const world = new World();
  const ground = world.createBody({ type: BodyType.STATIC }).add(chain([{ x: 0, y: 0 }, { x: 10, y: 0 }, { x: 20, y: 0 }]), { friction: 0.5 });
  assert.equal(ground.segmentSurfaceOverride(1), null);
  ground.setSegmentSurface(1, { friction: 0, restitution: 0, rollingResistance: 0, surfaceSpeed: 0, material: 4 });
  assert.equal(ground.segmentSurface(1).friction, 0);
  assert.equal(ground.segmentSurfaceOverride(1).material, 4);
  assert.equal(ground.segmentSurface(0).friction, 0.5);
  ground.setSegmentSurface(1, null);
  assert.equal(ground.segmentSurfaceOverride(1), null);
});

test("worlds whose functions step other worlds are nested at most 32 deep", () => {
  let refused = false;  // then no further world is made, however many pairs there are
  const nest = () => {
    if (refused) return true;
    const { world } = standing(0.9);
    world.setFilter(nest);
    try {
      world.step(1 / 60);
    } catch (error) {
      refused = true;
      throw error;
    } finally {
      world.destroy();
    }
    return true;
  };
  assert.throws(nest, (error) => error instanceof Locked && /more than 32 deep/.test(error.message));
  const { world, ball } = standing();
  run(world, 180);
  near(ball.position.y, 1, 0.02);
});

test("a world whose step was ended by a full stack of JavaScript says so and can be destroyed", () => {
  let found = 0;
  for (let i = 0; i < 300 && found < 3; ++i) {
    const { world } = standing(0.9), padding = Array.from({ length: i % 60 }, () => 0);
    let left = 400, ended = false;  // frames near the end of the stack
    const deep = (...all) => {
      try {
        deep(...all);
      } catch (error) {
        if (left-- > 0 && !ended) {
          try {
            world.step(1 / 60);
          } catch (inside) {
            ended = /wasm/.test(inside.stack);
          }
        }
        throw error;
      }
    };
    assert.throws(() => deep(...padding), RangeError);
    let said = null;
    try {
      world.createBody();
    } catch (error) {
      said = error;
    }
    if (said !== null) {
      ++found;
      assert.match(said.message, /has ended an earlier call in its middle.*it can only be destroyed/);
      assert.ok(!(said instanceof Locked));
    }
    world.destroy();
    assert.throws(() => world.step(1 / 60), Stale);
  }
  assert.ok(found > 0);
  const { world, ball } = standing(0.5);
  run(world, 60);
  near(ball.position.y, 1, 0.6);
});

test("a full stack of JavaScript does not damage the library", () => {
  const numbers = Array.from({ length: 150 }, (_, i) => i);
  for (let i = 0; i < 100; ++i) {
    let left = 100;  // frames near the end of the stack
    const deep = (...arguments_) => {
      try {
        deep(...arguments_);
      } catch (full) {
        try {
          if (left-- > 0) new World().destroy();
        } catch (error) {
          assert.ok(error instanceof RangeError, String(error));
        }
        throw full;
      }
    };
    assert.throws(() => deep(...numbers.slice(i)), RangeError);
  }
  const { world, ball } = standing();
  run(world, 180);
  near(ball.position.y, 1, 0.02);
});

test("the log of the process", () => {
  const lines = [], { world, ball } = standing();
  ball.setVelocityFunction((edit) => { edit.velocity = { x: NaN, y: 0 }; });
  fettle.setLog((level, text) => lines.push([level, text]));
  run(world, 2);
  fettle.setLog(null);
  const told = lines.length;
  run(world, 2);
  assert.equal(lines[0][0], fettle.LogLevel.WARNING);
  assert.match(lines[0][1], /^the velocity function of a body .*, for body \d+, set velocity to NaN, which changes nothing$/);
  assert.equal(lines.length, told);
});

test("a world whose functions refer to it is freed", { skip: typeof gc !== "function" }, async () => {
  const freed = [];
  const registry = new FinalizationRegistry((name) => freed.push(name));
  (() => {
    const { world, ball } = standing();
    world.setFilter(() => world.bodies.includes(ball));
    run(world, 5);
    registry.register(world, "world");
  })();
  for (let i = 0; i < 20 && !freed.length; ++i) {
    gc();
    await new Promise((resolve) => setImmediate(resolve));
  }
  assert.deepEqual(freed, ["world"]);
});
