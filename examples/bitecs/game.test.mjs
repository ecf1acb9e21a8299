// node --test, in a project that has fettle-physics and bitecs.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addEntity, query, removeComponent, removeEntity } from "bitecs";
import { World, circle, load } from "fettle-physics";
import { Body, addBody, destroyBodiesOfRemoved, entityOf } from "./bodies.js";
import { Crate, Health, Stone, createGame, stepGame } from "./game.js";

await load();

test("the bodies of removed entities are destroyed", () => {
  const { entities, physics } = createGame();
  const [first, second] = query(entities, [Body, Crate]);
  const bodies = physics.bodies.length, [one, other] = [Body[first], Body[second]];
  removeEntity(entities, first);
  removeComponent(entities, second, Body);
  assert.equal(physics.bodies.length, bodies - 2);
  assert.equal(one.isValid, false);
  assert.equal(other.isValid, false);
  assert.equal(query(entities, [Body, Crate]).includes(second), false);
});

test("an event leads to the entities of its bodies", () => {
  const { entities, physics } = createGame();
  const above = addEntity(entities);
  addBody(entities, physics, above, { position: { x: 0, y: 8 } }).add(circle(0.4));
  const met = new Set();
  for (let i = 0; i < 60; ++i) {
    physics.step(1 / 60);
    for (const { bodyA, bodyB } of physics.events().contactBegin)
      for (const body of [bodyA, bodyB]) if (body.userData > 0n) met.add(entityOf(body));
  }
  assert.ok(met.has(above));
});

test("stones break crates, and the fort stands without them", () => {
  const game = createGame(), crates = query(game.entities, [Crate]).length;
  for (let i = 0; i < 120; ++i) game.physics.step(1 / 60);
  for (const entity of query(game.entities, [Crate])) assert.ok(Body[entity].velocity.y > -0.01);
  for (let i = 0; i < 600; ++i) stepGame(game);
  assert.ok(game.broken > 0);
  assert.equal(query(game.entities, [Crate]).length, crates - game.broken);
  for (const entity of query(game.entities, [Crate])) assert.ok(Health[entity] > 0);
  assert.ok(query(game.entities, [Stone]).length <= 6);  // the others are removed, because their time is over
  assert.equal(game.physics.bodies.length, query(game.entities, [Body]).length + 1);
});

test("two games end in the same bits", () => {
  const run = () => {
    const game = createGame();
    for (let i = 0; i < 300; ++i) stepGame(game);
    return game.physics.hash;
  };
  assert.equal(run(), run());
});
