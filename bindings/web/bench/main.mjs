// Prints a table: milliseconds of processor time a step of each engine that is installed, and the final state of the scene in it.
//
//   node main.mjs [SECONDS] [SCENE ...]    SECONDS: the limit for a scene in an engine; 10 by default
//
// Each engine makes as many steps as fit into the limit. Its time, and the final state of the scene, are compared with those of Fettle after the
// same number of steps. Each engine makes some steps of a scene before it is measured, since a program of JavaScript or WebAssembly is slow until it has run
// for a while.

import { engines } from "./engines.mjs";
import { scenes } from "./scenes.mjs";

const seconds = Number(process.argv[2] ?? 10), wanted = process.argv.slice(3);
const chosen = scenes.filter(({ name }) => wanted.length === 0 || wanted.includes(name));

function processorTime() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e3;
}

/** Makes `most` steps of a scene, or as many as fit into `seconds`. `time`: ms of the processor. */
function run(make, scene, most, seconds) {
  const world = make(scene), end = performance.now() + seconds * 1e3, began = processorTime();
  let steps = 0;
  do {
    world.step();
    ++steps;
  } while (steps < most && performance.now() < end);
  const time = processorTime() - began, motions = world.motions();
  world.free();
  return { steps, time, motions };
}

const opened = new Map();
for (const [name, open] of Object.entries(engines)) {
  try {
    opened.set(name, await open());
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    console.log(`${name} is not installed`);
  }
}

console.log(`${"scene".padEnd(16)}${"engine".padEnd(11)}${"steps".padStart(5)}${"ms a step".padStart(11)}${"x Fettle".padStart(10)}  final state`);
function print(scene, engine, steps, time, ratio, figure) {
  console.log(`${scene.padEnd(16)}${engine.padEnd(11)}${String(steps).padStart(5)}${time.padStart(11)}${ratio.padStart(10)}  ${figure}`);
}

for (const scene of chosen)
  for (const [name, make] of opened) {
    if (scene.without[name]) {
      print(scene.name, name, "", "", "", scene.without[name]);
      continue;
    }
    run(make, scene, scene.steps, Math.min(2, seconds / 3));
    const { steps, time, motions } = run(make, scene, scene.steps, seconds);
    const ours = name === "fettle" || !opened.has("fettle") ? null : run(opened.get("fettle"), scene, steps, Infinity);
    const figure = (of) => scene.figure(of, scene).map((told) => (typeof told !== "number" || Number.isInteger(told) ? told : told.toFixed(3)));
    const [what, became] = figure(motions), then = ours === null ? "" : `; Fettle then ${figure(ours.motions)[1]}`;
    print(scene.name, name, steps, (time / steps).toFixed(3), (time / (ours?.time ?? time)).toFixed(2), `${what} ${became}${then}`);
  }
if (opened.size === 0 || chosen.length === 0) process.exit(1);
