// Prints a table: milliseconds of processor time a step of each engine that is installed, and what became of the scene in it.
//
//   node main.mjs [STEPS]    STEPS: at most so many in each scene

import { engines } from "./engines.mjs";
import { scenes } from "./scenes.mjs";

const most = Number(process.argv[2] ?? Infinity);

/** How far the body that has moved most is from where it began, m; for a pyramid it should not move. */
function farthest(scene, positions) {
  return Math.max(...positions.map((p, i) => Math.hypot(p.x - scene.bodies[i].x, p.y - scene.bodies[i].y)));
}
/** How many bodies have left the pit. */
const outside = (scene, positions) => positions.filter((p) => !(Math.abs(p.x) < scene.walls && p.y > -0.5)).length;

const rows = [];
for (const [name, open] of Object.entries(engines)) {
  let make;
  try {
    make = await open();
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    console.log(`${name} is not installed`);
    continue;
  }
  for (const scene of scenes) {
    const world = make(scene), steps = Math.min(scene.steps, most), began = process.cpuUsage();
    for (let i = 0; i < steps; ++i) world.step();
    const { user, system } = process.cpuUsage(began), time = (user + system) / 1e3 / steps, positions = world.positions();
    rows.push({
      scene: scene.name, engine: name, "ms a step": time.toFixed(3),
      "moved, m": scene.stands ? farthest(scene, positions).toFixed(2) : "", "outside": outside(scene, positions),
    });
    world.free();
  }
}
rows.sort((a, b) => scenes.findIndex((s) => s.name === a.scene) - scenes.findIndex((s) => s.name === b.scene));
console.table(rows);
if (rows.length === 0) process.exit(1);
