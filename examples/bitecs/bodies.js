// Bodies of Fettle as a component of bitECS.

import { addComponent, observe, onRemove } from "bitecs";

/** The component: the body of each entity that has one. */
export const Body = [];

/** Gives an entity a body. `definition`: as for `World.createBody`. */
export function addBody(entities, physics, entity, definition) {
  Body[entity] = physics.createBody({ ...definition, userData: BigInt(entity) });
  addComponent(entities, entity, Body);
  return Body[entity];
}

/** The entity that has this body. */
export const entityOf = (body) => Number(body.userData);

/** From now on, a body is destroyed with its entity, and when the component is removed. */
export function destroyBodiesOfRemoved(entities) {
  observe(entities, onRemove(Body), (entity) => {
    Body[entity].destroy();
    Body[entity] = undefined;
  });
}
