// Compiled with every check of TypeScript on; not run.

import { BodyType, Mover, Replay, World, box, circle, load, type Body, type ContactEvent, type Moved, type RayHit, type Shape } from "fettle-physics";

await load();
const world: World = new World({ gravity: { x: 0, y: -10 }, bounds: null });
const ball: Body = world.createBody({ type: BodyType.DYNAMIC, position: { x: 0, y: 2 } });
ball.add(circle(0.5), { density: 2 });
ball.add(box(1, 2, { rounding: 0.1 }));
const hit: RayHit | null = world.castRay({ x: 0, y: 0 }, { x: 1, y: 0 });
const events: ContactEvent[] = world.events().contactBegin;
const mass: number = ball.mass;
ball.mass = null;
const joint = world.createWheelJoint({ bodyA: ball, hertz: 3, axis: { x: 0, y: 1 } });
joint.motorSpeed = 2;
const hash: bigint = world.hash;
const view: Float32Array = world.states;
const hero = new Mover(world, { radius: 0.3, ledges: 2n }, { x: 0, y: 1 });
const moved: Moved = hero.move({ x: 1, y: 0 }, 1 / 60);
const ground: Shape | null = hero.ground;
hero.climbing = !hero.onGround;
hero.state = { ...hero.state, position: { x: 1, y: hero.definition.height } };
export { events, ground, hash, hit, mass, moved, view };

world.setFilter((a, b) => a.friction > b.friction);
world.setBeforeSolve((contact) => { contact.enabled = contact.normal.y > 0; });
world.setBeforeSolve(null);
world.visitRay({ x: 0, y: 0 }, { x: 1, y: 0 }, (found) => found.fraction < 0.5, { accept: (shape) => shape.sensor });
world.draw({ circle(center, radius) { center.x += radius; } }, { joints: false });
for (const step of new Replay(new Uint8Array())) if (!step.same) break;
// @ts-expect-error the normal is only read
world.setBeforeSolve((contact) => { contact.normal = { x: 0, y: 1 }; });

// @ts-expect-error a mover grows only where there is room: setHeight
hero.height = 2;

// @ts-expect-error a body has no such property
ball.colour = 1;
// @ts-expect-error a vector is not a number
ball.position = 3;
