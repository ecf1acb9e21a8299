// A fort of crates under falling stones. The entities are in bitECS, and those that move have a body of Fettle. Each system
// is a function of the game.

import { addComponent, addEntity, createWorld, hasComponent, query, removeEntity } from "bitecs";
import { BodyType, World, box, circle } from "fettle-physics";
import { Body, addBody, destroyBodiesOfRemoved, entityOf } from "./bodies.js";

export const Crate = { width: [], height: [] };  // m
export const Stone = { radius: [] };             // m
export const Health = [];                        // from 1 to 0; an entity with 0 is removed
export const TimeLeft = [];                      // s; then the entity is removed

const STRENGTH = 60;  // N s, the impact that breaks a whole crate

export function createGame() {
  const game = { entities: createWorld(), physics: new World(), step: 0, broken: 0 };
  destroyBodiesOfRemoved(game.entities);
  const ground = game.physics.createBody({ type: BodyType.STATIC, position: { x: 0, y: -0.5 } });
  ground.add(box(60, 1), { friction: 0.8 });
  for (let column = -4; column <= 4; ++column)
    for (let row = 0; row < 7 - Math.abs(column); ++row)
      addCrate(game, { x: 1.3 * column, y: 0.5 + row }, 1.2, 1);
  return game;
}

function addCrate({ entities, physics }, position, width, height) {
  const entity = addEntity(entities);
  for (const component of [Crate, Health]) addComponent(entities, entity, component);
  Crate.width[entity] = width;
  Crate.height[entity] = height;
  Health[entity] = 1;
  addBody(entities, physics, entity, { position }).add(box(width, height), { friction: 0.6, hitEvents: true });
}

function addStone({ entities, physics }, position, velocity) {
  const entity = addEntity(entities);
  for (const component of [Stone, TimeLeft]) addComponent(entities, entity, component);
  Stone.radius[entity] = 0.5;
  TimeLeft[entity] = 4;
  addBody(entities, physics, entity, { position, velocity, bullet: true }).add(circle(0.5), { density: 8, restitution: 0.2 });
}

function throwStones(game) {
  if (game.step % 45 !== 0) return;
  const side = game.step % 90 === 0 ? -1 : 1;
  addStone(game, { x: 16 * side, y: 6 }, { x: -14 * side, y: 3 + (game.step % 7) });
}

/** Impacts reduce health. Forces between crates that rest on each other are not impacts. */
function damage({ entities, physics }) {
  for (const { bodyA, bodyB, impulse } of physics.events().contactHit)
    for (const body of [bodyA, bodyB]) {
      const entity = entityOf(body);
      if (hasComponent(entities, entity, Health)) Health[entity] -= impulse / STRENGTH;
    }
}

function removeBroken(game) {
  for (const entity of [...query(game.entities, [Health])])
    if (Health[entity] <= 0) {
      removeEntity(game.entities, entity);
      ++game.broken;
    }
}

function removeOld({ entities }, dt) {
  for (const entity of [...query(entities, [TimeLeft])])
    if ((TimeLeft[entity] -= dt) <= 0) removeEntity(entities, entity);
}

export function stepGame(game, dt = 1 / 60) {
  throwStones(game);
  game.physics.step(dt);
  damage(game);
  removeBroken(game);
  removeOld(game, dt);
  ++game.step;
}
