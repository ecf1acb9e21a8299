// The engines of the table behind one interface: `make(scene)` gives `step()`, `motions()` (x, y, angle, vx and vy of each body) and `free()`.
// Each has its usual settings.

import { dt } from "./scenes.mjs";

/** Calls `move(index, x, y)` for each body that is moved along a path, before a step. */
function paths(scene, move) {
  const moved = scene.bodies.map((b, i) => [b.path, i]).filter(([path]) => path);
  let time = 0;
  return () => {
    time += dt;
    for (const [path, i] of moved) move(i, ...path(time));
  };
}
const point = ([x, y]) => ({ x, y });

async function fettle() {
  const f = await import("fettle-physics");
  await f.load();
  const types = { fixed: f.BodyType.STATIC, kinematic: f.BodyType.KINEMATIC, dynamic: f.BodyType.DYNAMIC };
  const geometry = (s) => {
    if (s.box) return f.box(2 * (s.box[0] + (s.rounding ?? 0)), 2 * (s.box[1] + (s.rounding ?? 0)), { rounding: s.rounding ?? 0, center: { x: s.x ?? 0, y: s.y ?? 0 } });
    if (s.circle) return f.circle(s.circle);
    if (s.capsule) return f.segment({ x: -s.capsule, y: 0 }, { x: s.capsule, y: 0 }, { rounding: s.radius });
    if (s.segment) return f.segment(point(s.segment), point(s.segment.slice(2)));
    return s.loop ? f.chain(s.loop.map(point), true) : f.polygon(s.polygon.map(point));
  };
  return (scene) => {
    const world = new f.World({ gravity: { x: 0, y: scene.gravity }, sleeping: scene.sleeping });
    const bodies = scene.bodies.map((b) => {
      const body = world.createBody({
        type: types[b.type], position: { x: b.x, y: b.y }, velocity: point(b.velocity ?? [0, 0]), angularVelocity: b.turning ?? 0,
        canSleep: b.canSleep ?? true, awake: !b.asleep,
      });
      for (const s of b.shapes)
        body.add(geometry(s), { density: s.density ?? 1, friction: s.friction, restitution: s.restitution ?? 0, category: s.category ?? 1, mask: s.mask ?? 0xffff });
      if (b.asleep) body.awake = false;
      return body;
    });
    for (const p of scene.pins) {
      const [a, b] = [p.a, p.b].map((i) => ({ x: p.x - scene.bodies[i].x, y: p.y - scene.bodies[i].y }));
      const pin = world.createRevoluteJoint({ bodyA: bodies[p.a], bodyB: bodies[p.b], anchorA: a, anchorB: b });
      if (p.speed) Object.assign(pin, { motorSpeed: p.speed, maxMotorTorque: p.torque });
    }
    const move = paths(scene, (i, x, y) => bodies[i].setTarget({ x, y }, 0, dt));
    const motion = ({ position, angle, velocity }) => ({ ...position, angle, vx: velocity.x, vy: velocity.y });
    return { step: () => { move(); world.step(dt); }, motions: () => bodies.map(motion), free: () => world.destroy() };
  };
}

async function rapier() {
  const { default: R } = await import("@dimforge/rapier2d-simd-compat");
  await R.init({});
  const { ColliderDesc: C, RigidBodyDesc: B } = R;
  const vertices = (points) => new Float32Array(points.flat());
  const collider = (s) => {
    if (s.box) return (s.rounding ? C.roundCuboid(...s.box, s.rounding) : C.cuboid(...s.box)).setTranslation(s.x ?? 0, s.y ?? 0);
    if (s.circle) return C.ball(s.circle);
    if (s.capsule) return C.capsule(s.capsule, s.radius).setRotation(Math.PI / 2);
    if (s.segment) return C.segment(point(s.segment), point(s.segment.slice(2)));
    return s.loop ? C.polyline(vertices([...s.loop, s.loop[0]])) : C.convexHull(vertices(s.polygon));
  };
  return (scene) => {
    const world = new R.World({ x: 0, y: scene.gravity });
    world.timestep = dt;
    const bodies = scene.bodies.map((b) => {
      const kind = b.type === "dynamic" ? B.dynamic() : b.type === "fixed" ? B.fixed() : b.path ? B.kinematicPositionBased() : B.kinematicVelocityBased();
      const body = world.createRigidBody(kind.setTranslation(b.x, b.y).setLinvel(...(b.velocity ?? [0, 0])).setAngvel(b.turning ?? 0)
        .setCanSleep(scene.sleeping && b.canSleep !== false).setSleeping(b.asleep ?? false));
      for (const s of b.shapes)
        world.createCollider(collider(s).setDensity(s.density ?? 1).setFriction(s.friction).setRestitution(s.restitution ?? 0)
          .setCollisionGroups(((s.category ?? 1) << 16) | (s.mask ?? 0xffff)), body);
      if (b.asleep) body.sleep();
      return body;
    });
    for (const p of scene.pins) {
      const [a, b] = [p.a, p.b].map((i) => ({ x: p.x - scene.bodies[i].x, y: p.y - scene.bodies[i].y }));
      const pin = world.createImpulseJoint(R.JointData.revolute(a, b), bodies[p.a], bodies[p.b], !scene.bodies[p.b].asleep);
      if (p.speed) pin.configureMotorVelocity(p.speed, 1e6);
    }
    const move = paths(scene, (i, x, y) => bodies[i].setNextKinematicTranslation({ x, y }));
    const motion = (body) => ({ ...point([body.translation().x, body.translation().y]), angle: body.rotation(), vx: body.linvel().x, vy: body.linvel().y });
    return { step: () => { move(); world.step(); }, motions: () => bodies.map(motion), free: () => world.free() };
  };
}

async function planck() {
  const pl = await import("planck");
  const at = ([x, y]) => pl.Vec2(x, y);
  const shape = (s) => {
    if (s.box) return new pl.Box(...s.box, pl.Vec2(s.x ?? 0, s.y ?? 0), 0);
    if (s.circle) return new pl.Circle(s.circle);
    if (s.segment) return new pl.Edge(at(s.segment), at(s.segment.slice(2)));
    return new pl.Polygon(s.polygon.map(at));
  };
  const types = { fixed: "static", kinematic: "kinematic", dynamic: "dynamic" };
  return (scene) => {
    const world = new pl.World({ gravity: pl.Vec2(0, scene.gravity), allowSleep: scene.sleeping });
    const bodies = scene.bodies.map((b) => {
      const body = world.createBody({
        type: types[b.type], position: pl.Vec2(b.x, b.y), linearVelocity: at(b.velocity ?? [0, 0]), angularVelocity: b.turning ?? 0, awake: !b.asleep,
      });
      for (const s of b.shapes)
        body.createFixture({
          shape: shape(s), density: s.density ?? 1, friction: s.friction, restitution: s.restitution ?? 0,
          filterCategoryBits: s.category ?? 1, filterMaskBits: s.mask ?? 0xffff,
        });
      return body;
    });
    for (const p of scene.pins) {
      const motor = p.speed ? { enableMotor: true, motorSpeed: p.speed, maxMotorTorque: p.torque } : {};
      world.createJoint(new pl.RevoluteJoint(motor, bodies[p.a], bodies[p.b], pl.Vec2(p.x, p.y)));
    }
    const move = paths(scene, (i, x, y) => {
      const { x: from, y: below } = bodies[i].getPosition();
      bodies[i].setLinearVelocity(pl.Vec2((x - from) / dt, (y - below) / dt));
    });
    const motion = (body) => {
      const { x, y } = body.getPosition(), v = body.getLinearVelocity();
      return { x, y, angle: body.getAngle(), vx: v.x, vy: v.y };
    };
    return { step: () => { move(); world.step(dt); }, motions: () => bodies.map(motion), free: () => {} };
  };
}

/** The center of area of a convex polygon, as the sum of triangles at its first corner. */
function centroid([first, ...rest]) {
  let area = 0, x = 0, y = 0;
  for (let i = 0; i + 1 < rest.length; ++i) {
    const a = rest[i], b = rest[i + 1], twice = (a.x - first.x) * (b.y - first.y) - (a.y - first.y) * (b.x - first.x);
    area += twice;
    x += (twice * (first.x + a.x + b.x)) / 3;
    y += (twice * (first.y + a.y + b.y)) / 3;
  }
  return { x: x / area, y: y / area };
}

async function matter() {
  const { default: M } = await import("matter-js");
  const scale = 40;  // its numbers are made for pixels
  const part = (s, b) => {
    const more = { friction: s.friction, restitution: s.restitution ?? 0, density: (s.density ?? 1) / scale ** 2 };
    if (s.category) more.collisionFilter = { category: s.category, mask: s.mask };
    if (s.circle) return M.Bodies.circle(b.x * scale, b.y * scale, s.circle * scale, more);
    const [w, h] = s.box ?? [];
    let corners = s.box ? [[-w, -h], [w, -h], [w, h], [-w, h]].map(([x, y]) => [x + (s.x ?? 0), y + (s.y ?? 0)]) : s.polygon;
    // It has no segments: a board below one.
    if (s.segment) corners = [[s.segment[0], s.segment[1] - 1], [s.segment[2], s.segment[3] - 1], s.segment.slice(2), s.segment.slice(0, 2)];
    const vertices = M.Vertices.clockwiseSort(corners.map(([x, y]) => ({ x: (b.x + x) * scale, y: (b.y + y) * scale })));
    return M.Body.create({ position: centroid(vertices), vertices, ...more });
  };
  return (scene) => {
    const engine = M.Engine.create({ enableSleeping: scene.sleeping });
    engine.gravity.y = -1;
    engine.gravity.scale = (-scene.gravity * scale) / 1e6;
    const bodies = scene.bodies.map((b) => {
      const parts = b.shapes.map((s) => part(s, b));
      const body = parts.length === 1 ? parts[0] : M.Body.create({ parts });
      // Where the scene has the origin of the body, from its center of mass.
      body.plugin.origin = { x: b.x * scale - body.position.x, y: b.y * scale - body.position.y };
      if (b.type !== "dynamic") M.Body.setStatic(body, true);
      if (b.velocity && b.type === "dynamic") M.Body.setVelocity(body, { x: b.velocity[0] * scale * dt, y: b.velocity[1] * scale * dt });
      if (b.asleep) M.Sleeping.set(body, true);
      return body;
    });
    M.Composite.add(engine.world, bodies);
    for (const p of scene.pins) {
      const [a, b] = [p.a, p.b].map((i) => ({ x: p.x * scale - bodies[i].position.x, y: p.y * scale - bodies[i].position.y }));
      M.Composite.add(engine.world, M.Constraint.create({ bodyA: bodies[p.a], bodyB: bodies[p.b], pointA: a, pointB: b, length: 0, stiffness: 1 }));
    }
    const turned = scene.bodies.map((b, i) => [b, bodies[i]]).filter(([b]) => b.turning && b.type === "kinematic");
    const move = paths(scene, (i, x, y) => {
      const { origin } = bodies[i].plugin;
      M.Body.setPosition(bodies[i], { x: x * scale - origin.x, y: y * scale - origin.y }, true);
    });
    const step = () => {
      move();
      for (const [b, body] of turned) {
        M.Body.translate(body, { x: b.velocity[0] * dt * scale, y: b.velocity[1] * dt * scale }, true);
        M.Body.rotate(body, b.turning * dt, undefined, true);
      }
      M.Engine.update(engine, dt * 1000);
    };
    const motion = (body) => {
      const { origin } = body.plugin, c = Math.cos(body.angle), s = Math.sin(body.angle), per = 1 / scale;
      return {
        x: (body.position.x + c * origin.x - s * origin.y) * per, y: (body.position.y + s * origin.x + c * origin.y) * per, angle: body.angle,
        vx: (body.velocity.x * per) / dt, vy: (body.velocity.y * per) / dt,
      };
    };
    return { step, motions: () => bodies.map(motion), free: () => M.Engine.clear(engine) };
  };
}

export const engines = { fettle, rapier, planck, "matter-js": matter };
