// The engines of the table behind one interface: `make(scene)` gives `step()` and `positions()`. Sleeping is off in all of them,
// and each has its usual settings.

import { dt, friction, gravity } from "./scenes.mjs";

// The ground and two walls of each scene: center and half sizes.
const solids = (scene) => [
  { x: 0, y: -0.5, w: scene.walls * 2, h: 0.5 },
  { x: -scene.walls - 0.5, y: 20, w: 0.5, h: 60 },
  { x: scene.walls + 0.5, y: 20, w: 0.5, h: 60 },
];

async function fettle() {
  const { BodyType, World, box, circle, load } = await import("fettle-physics");
  await load();
  return (scene) => {
    const world = new World({ gravity: { x: 0, y: gravity }, sleeping: false });
    for (const s of solids(scene)) world.createBody({ type: BodyType.STATIC, position: s }).add(box(2 * s.w, 2 * s.h), { friction });
    const bodies = scene.bodies.map(({ x, y, ...form }) => {
      const body = world.createBody({ position: { x, y } });
      body.add(form.box ? box(form.box, form.box) : circle(form.circle), { friction });
      return body;
    });
    return { step: () => world.step(dt), positions: () => bodies.map((body) => body.position), free: () => world.destroy() };
  };
}

async function rapier() {
  const { default: R } = await import("@dimforge/rapier2d-simd-compat");
  await R.init({});
  return (scene) => {
    const world = new R.World({ x: 0, y: gravity });
    world.timestep = dt;
    for (const s of solids(scene))
      world.createCollider(R.ColliderDesc.cuboid(s.w, s.h).setFriction(friction), world.createRigidBody(R.RigidBodyDesc.fixed().setTranslation(s.x, s.y)));
    const bodies = scene.bodies.map(({ x, y, ...form }) => {
      const body = world.createRigidBody(R.RigidBodyDesc.dynamic().setTranslation(x, y).setCanSleep(false));
      const shape = form.box ? R.ColliderDesc.cuboid(form.box / 2, form.box / 2) : R.ColliderDesc.ball(form.circle);
      world.createCollider(shape.setFriction(friction), body);
      return body;
    });
    return { step: () => world.step(), positions: () => bodies.map((body) => body.translation()), free: () => world.free() };
  };
}

async function planck() {
  const pl = await import("planck");
  return (scene) => {
    const world = new pl.World({ gravity: pl.Vec2(0, gravity), allowSleep: false });
    for (const s of solids(scene)) world.createBody({ position: pl.Vec2(s.x, s.y) }).createFixture({ shape: new pl.Box(s.w, s.h), friction });
    const bodies = scene.bodies.map(({ x, y, ...form }) => {
      const body = world.createBody({ type: "dynamic", position: pl.Vec2(x, y) });
      body.createFixture({ shape: form.box ? new pl.Box(form.box / 2, form.box / 2) : new pl.Circle(form.circle), density: 1, friction });
      return body;
    });
    return { step: () => world.step(dt), positions: () => bodies.map((body) => body.getPosition()), free: () => {} };
  };
}

async function matter() {
  const { default: M } = await import("matter-js");
  // Its numbers are made for pixels, and its y goes down: 40 pixels a meter.
  const scale = 40;
  return (scene) => {
    const engine = M.Engine.create({ enableSleeping: false });
    engine.gravity.scale = (-gravity * scale) / 1e6;
    const make = (x, y, form, more) =>
      form.circle
        ? M.Bodies.circle(x * scale, -y * scale, form.circle * scale, { friction, ...more })
        : M.Bodies.rectangle(x * scale, -y * scale, form.w * scale, form.h * scale, { friction, ...more });
    for (const s of solids(scene)) M.Composite.add(engine.world, make(s.x, s.y, { w: 2 * s.w, h: 2 * s.h }, { isStatic: true }));
    const bodies = scene.bodies.map(({ x, y, ...form }) => make(x, y, form.box ? { w: form.box, h: form.box } : form, {}));
    M.Composite.add(engine.world, bodies);
    return {
      step: () => M.Engine.update(engine, dt * 1000),
      positions: () => bodies.map((body) => ({ x: body.position.x / scale, y: -body.position.y / scale })),
      free: () => {},
    };
  };
}

export const engines = { fettle, rapier, planck, "matter-js": matter };
