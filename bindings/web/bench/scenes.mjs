// The scenes of the table, in a form that does not depend on an engine: bodies, shapes and pins in meters, kilograms, seconds and radians.
// They are those of `fettle-bench scenes`, and two of the size that a page has.
//
// body: { type, x, y, velocity, turning, asleep, canSleep, shapes, path }; a fixed one is { type: "fixed" }, one with `path(time)` is moved.
// shape: { box: [half width, half height], rounding, x, y } or { circle } or { capsule: half length, radius } or { polygon } or { segment } or
//        { loop }, with density, friction, restitution, category, mask.
// pin: { a, b, x, y, speed, torque }: bodies by number, and a point of the world, where both are held together.
//
// `figure(motions, scene)` describes its final state: [what, number]; `without` says why an engine cannot have it.

export const dt = 1 / 60;

const friction = 0.6, degree = Math.PI / 180;
const fixed = (x, y, ...shapes) => ({ type: "fixed", x, y, shapes });
const dynamic = (x, y, ...shapes) => ({ type: "dynamic", x, y, shapes });
const box = (w, h = w, more = {}) => ({ box: [w, h], friction, ...more });
const count = (motions, scene, wrong) => motions.filter((m, i) => scene.bodies[i].type === "dynamic" && wrong(m)).length;
const outside = (wrong) => (motions, scene) => ["outside", count(motions, scene, wrong)];

/** How far the body that has moved most is from where it began. */
function farthest(motions, scene) {
  const moved = motions.map((m, i) => Math.hypot(m.x - scene.bodies[i].x, m.y - scene.bodies[i].y));
  return ["moved, m", Math.max(...moved)];
}
/** The widest gap of a pin. */
function widest(motions, scene) {
  const at = (i, p) => {
    const m = motions[i], c = Math.cos(m.angle), s = Math.sin(m.angle), x = p.x - scene.bodies[i].x, y = p.y - scene.bodies[i].y;
    return [m.x + c * x - s * y, m.y + s * x + c * y];
  };
  const gaps = scene.pins.map((p) => {
    const [ax, ay] = at(p.a, p), [bx, by] = at(p.b, p);
    return Math.hypot(ax - bx, ay - by);
  });
  return ["gap, m", Math.max(...gaps)];
}

function addPyramid(bodies, base, left, ground) {
  for (let i = 0; i < base; ++i)
    for (let j = i; j < base; ++j) bodies.push(dynamic(left + i / 2 + (j - i), ground + (2 * i + 1) / 2, box(0.5)));
}
function pyramid(base) {
  const bodies = [fixed(0, -1, box(100, 1))];
  addPyramid(bodies, base, 0.5 - base / 2, 0);
  return bodies;
}
function manyPyramids() {
  const bodies = [];
  for (let row = 0; row < 20; ++row) {
    bodies.push(fixed(0, 0, { segment: [-110, 11 * row, 110, 11 * row], friction }));
    for (let i = 0; i < 20; ++i) addPyramid(bodies, 10, -110 + 11 * i + 0.5, 11 * row);
  }
  return bodies;
}
/** Boxes and circles in turn that fall into a pit. */
function heap(columns, rows) {
  const wide = 16, bodies = [fixed(0, -0.5, box(2 * wide, 0.5)), fixed(-wide - 0.5, 20, box(0.5, 60)), fixed(wide + 0.5, 20, box(0.5, 60))];
  for (let row = 0; row < rows; ++row)
    for (let i = 0; i < columns; ++i) {
      const shape = (row + i) % 2 ? box(0.45) : { circle: 0.45, friction };
      bodies.push(dynamic((i - columns / 2) * 1.1 + (row % 2) * 0.3, 2 + row * 1.1, shape));
    }
  return bodies;
}
function jointGrid() {
  const side = 100, bodies = [], pins = [];
  for (let k = 0; k < side; ++k)
    for (let i = 0; i < side; ++i) {
      const held = (k) => i === 0 && k >= 47 && k <= 53, self = bodies.length;
      bodies.push({ type: held(k) ? "fixed" : "dynamic", x: k, y: -i, shapes: [{ circle: 0.4, friction, category: 2, mask: 0xfffd }] });
      if (i > 0) pins.push({ a: self - 1, b: self, x: k, y: -i + 0.5 });
      if (k > 0 && !(held(k) && held(k - 1))) pins.push({ a: self - side, b: self, x: k - 0.5, y: -i });
    }
  return { bodies, pins };
}
function smash() {
  const bodies = [{ type: "dynamic", x: -20, y: 0, velocity: [40, 0], shapes: [box(4, 4, { density: 8 })] }];
  for (let i = 0; i < 120; ++i)
    for (let j = 0; j < 80; ++j) bodies.push({ ...dynamic(30 + 0.4 * i, 0.4 * (j - 40), box(0.2)), asleep: true });
  return bodies;
}
function momentum(motions, scene) {
  const mass = (i) => (i === 0 ? 8 * 64 : 0.16), sum = motions.reduce((all, m, i) => all + mass(i) * m.vx, 0);
  return ["momentum, %", 100 * (sum / (mass(0) * 40) - 1)];
}
function tumbler() {
  const walls = [-10, 10].flatMap((s) => [box(0.5, 10, { x: s, density: 50 }), box(10, 0.5, { y: s, density: 50 })]);
  const bodies = [fixed(0, 0), dynamic(0, 10, ...walls)];
  for (let i = 0; i < 45; ++i) for (let j = 0; j < 45; ++j) bodies.push(dynamic(-9 + 0.4 * i, 1 + 0.4 * j, box(0.125)));
  return { bodies, pins: [{ a: 0, b: 1, x: 0, y: 10, speed: 25 * degree, torque: 1e8 }] };
}
function washer() {
  const at = (r, angle) => [r * Math.cos(angle), r * Math.sin(angle)];
  const piece = (inner, outer, from, to) => ({ polygon: [at(inner, from), at(outer, from), at(outer, to), at(inner, to)], friction });
  const drum = { type: "kinematic", x: 0, y: 10, velocity: [0.001, -0.002], turning: 25 * degree, shapes: [] };
  for (let i = 0; i < 36; ++i) {
    drum.shapes.push(piece(16, 18, (10 * i - 1) * degree, (10 * i + 11) * degree));
    if (i % 9 === 0) drum.shapes.push(piece(14, 16, 10 * i * degree, 10 * (i + 1) * degree));
  }
  const bodies = [drum];
  for (let j = 0; j < 90; ++j) for (let i = 0; i < 90; ++i) bodies.push(dynamic(-9.9 + 0.21 * i, 0.1 + 0.21 * j, box(0.1)));
  return bodies;
}
function spinner() {
  const surface = { friction: 0.1, restitution: 0.1, density: 0.25 };
  const loop = Array.from({ length: 360 }, (_, i) => [40 * Math.cos(i * degree), 32 + 40 * Math.sin(i * degree)]);
  const bodies = [fixed(0, 0, { loop, friction: 0.1 }), { ...dynamic(0, 12, box(0.4, 20, { rounding: 0.2, friction: 0 })), canSleep: false }];
  const shapes = [{ capsule: 0.25, radius: 0.25, ...surface }, { circle: 0.35, ...surface }, box(0.35, 0.35, surface)];
  for (let i = 0; i < 6076; ++i) bodies.push(dynamic(-23 + 0.5 * (i % 92), 2 + 0.5 * Math.floor(i / 92), shapes[i % 3]));
  return { bodies, pins: [{ a: 0, b: 1, x: 0, y: 12, speed: 5, torque: 1e30 }] };
}
/** A floor of boxes that overlap, and two walls of them. */
function bin(reach, high) {
  const bodies = [];
  for (let i = -reach; i <= reach; ++i) bodies.push(fixed(i, 0, box(0.55, 0.5)));
  for (const x of [-reach, reach]) for (let i = 0; i < high; ++i) bodies.push(fixed(x, 1 + i, box(0.5, 0.55)));
  return bodies;
}
function compounds() {
  const bodies = [...bin(40, 100), fixed(0, 0, { segment: [-800, -80, 800, -80], friction })];
  const left = { polygon: [[-1, 0], [0.5, 1], [0, 2]], friction: 0.5 }, right = { polygon: [[1, 0], [0, 2], [-0.5, 1]], friction: 0.5 };
  for (let i = 0; i < 20; ++i)
    for (let j = 0; j < 150; ++j) bodies.push(dynamic(2 * i - 19 + (j % 2 ? -0.25 : 0.25), 2.25 * j + 5.575, left, right));
  return bodies;
}
function junkyard() {
  const bodies = bin(80, 50);
  bodies.push({ type: "kinematic", x: 0, y: 0, shapes: [box(2, 4, { y: 4 })], path: (time) => [60 * Math.sin(0.2 * time), 0] });
  const corner = (n) => n * Math.PI * (Math.sqrt(5) - 1);
  const polygon = [0, 2, 4, 1, 3].map((n) => [0.25 * Math.cos(corner(n)), 0.25 * Math.sin(corner(n))]);
  for (let i = 0; i < 200; ++i)
    for (let j = 0; j < 40; ++j) bodies.push(dynamic(0.375 * (2 * i - 200) + (j % 2 ? 0.1 : -0.1), j + 15, { polygon, friction }));
  return bodies;
}

const noMotor = "no motors", noRound = "no capsules and no rounded boxes";
export const scenes = [
  { name: "pyramid of 210", steps: 300, sleeping: false, bodies: pyramid(20), figure: farthest },
  { name: "heap of 1000", steps: 400, sleeping: false, bodies: heap(25, 40), figure: outside((m) => Math.abs(m.x) > 16 || m.y < 0) },
  { name: "large_pyramid", steps: 500, sleeping: false, bodies: pyramid(100), figure: farthest },
  { name: "many_pyramids", steps: 200, sleeping: false, bodies: manyPyramids(), figure: farthest },
  { name: "joint_grid", steps: 500, sleeping: false, ...jointGrid(), figure: widest },
  { name: "smash", steps: 300, sleeping: true, gravity: 0, bodies: smash(), figure: momentum },
  { name: "tumbler", steps: 750, sleeping: true, ...tumbler(), figure: outside((m) => Math.hypot(m.x, m.y - 10) > 14.2), without: { "matter-js": noMotor } },
  {
    name: "spinner", steps: 500, sleeping: true, ...spinner(), figure: outside((m) => Math.hypot(m.x, m.y - 32) > 40),
    without: { "matter-js": noMotor, planck: noRound },
  },
  { name: "washer", steps: 500, sleeping: true, bodies: washer(), figure: outside((m) => Math.hypot(m.x, m.y - 9) > 19) },
  { name: "compounds", steps: 500, sleeping: true, bodies: compounds(), figure: outside((m) => m.y < -3) },
  { name: "junkyard", steps: 800, sleeping: true, bodies: junkyard(), figure: outside((m) => m.y < 0) },
].map((scene) => ({ gravity: -10, pins: [], without: {}, ...scene }));
