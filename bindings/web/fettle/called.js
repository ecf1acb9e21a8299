// Functions of the program that the library calls. The library has one function for each kind of call, which is called with a number; here
// are the functions by number.

import { allocate, c, check, classes, cleanups, copyOf, handle, Invalid, nested, readList, Stale, text, view, whole } from "./runtime.js";

/** Functions of the process, and those of calls that have not ended. Functions that a world keeps are in `world.functions`. */
const functions = { byNumber: new Map(), byKey: new Map() };
const worlds = new Map();  // by their pointers, weakly: a function may refer to its world
let lastNumber = 0;

export function addWorld(world) {
  worlds.set(world.pointer, new WeakRef(world));
  world.functions = { byNumber: new Map(), byKey: new Map() };
}
export function removeWorld(pointer) {
  if (worlds.get(pointer)?.deref() === undefined) worlds.delete(pointer);
}

const worldAt = (pointer) => worlds.get(pointer >>> 0)?.deref();

function checked(value, name) {
  if (typeof value !== "function") throw new Invalid(`${name} = ${String(value)}: expected a function`);
  return value;
}
export const addressOf = (kind) => c.fettle_called(kinds.indexOf(kind));

/** The address and the number of a function, or of a target of drawing, until the call ends. */
export function lend(value, name, kind) {
  const number = ++lastNumber;
  functions.byNumber.set(number, kind === undefined ? value : checked(value, name));
  cleanups.push(() => functions.byNumber.delete(number));
  return [kind === undefined ? 0 : addressOf(kind), number];
}

/** Gives the parts of a recording to a function. If that throws, the recording ends: what follows would not fit to what it has. */
function recordingSink(world, write) {
  let ended = false, inStep = false;
  return {
    take(part) {
      if (ended) return;
      try {
        write(part);
      } catch (error) {
        ended = true;
        if (inStep) world.afterStep(() => world.stopRecording());
        throw error;
      }
    },
    /** To be called when the call that starts the recording has returned. */
    started() {
      inStep = true;
      if (ended) c.fettle_world_stop_recording(world.pointer);
    },
  };
}

/** Gives the library a function that it keeps, in place of the one with the same key; null: none. */
export function keep(world, key, value, name, kind, set) {
  const kept = world === null ? functions : world.functions;
  const number = value === null || value === undefined ? 0 : ++lastNumber;
  const sink = number && kind === "recording_sink" ? recordingSink(world, checked(value, name)) : undefined;
  if (number) kept.byNumber.set(number, sink?.take ?? checked(value, name));
  const code = set(number ? addressOf(kind) : 0, number);
  sink?.started();
  const before = code === 0 && key ? kept.byKey.get(key) : number;
  if (before !== undefined && (key || code !== 0)) kept.byNumber.delete(before);
  if (code === 0 && key) kept.byKey.set(key, number);
  check(code);
}

/** A structure that the library passes to a function of the program, which may change members of it during the call. */
export class Edit {
  #at;
  constructor(world, p) {
    this.world = world;
    this.#at = p;
    Object.preventExtensions(this);
  }
  get at() {
    if (this.#at === 0) throw new Stale(`${this.constructor.name}: it is valid only during the call that has got it`);
    return this.#at;
  }
  end() { this.#at = 0; }
}

/** The handle of an id that C passes as an argument. */
function handleOf(world, id) {
  const p = allocate(8);
  view.u64[p >> 3] = id;
  return handle(world, p);
}
const editCalls = (name) => (call, world, p) => {
  const edit = new classes[name](world, p);
  try {
    call(edit);
  } finally {
    edit.end();
  }
};
const point = (p) => classes.readVec2(p);

// The arguments of the function of the program, by kind. The result is true where the library is to go on.
const ofWorlds = {
  pair_filter: (call, world, a, b) => call(handleOf(world, a), handleOf(world, b)),
  contact_callback: editCalls("ContactEdit"),
  velocity_function: editCalls("VelocityEdit"),
  position_function: editCalls("PositionEdit"),
  accept: (call, world, shape) => call(handleOf(world, shape)),
  shape_visitor: (call, world, shape) => call(handleOf(world, shape)) !== false,
  ray_visitor: (call, world, hit) => call(classes.readRayHit(hit, world)) !== false,
  recording_sink: (call, world, p, size) => call(copyOf(p, size)),
  after_step: (call) => call(),
};
const ofOthers = {
  log_function: (call, level, p) => call(level, text(p)),
  failure_function: (call, p) => call(text(p)),
  polygon: (target, points, count, closed, color) => target.polygon(readList(points, count, 8, point), closed !== 0, color >>> 0),
  circle: (target, center, radius, angle, color) => target.circle(point(center), radius, angle, color >>> 0),
  segment: (target, from, to, color) => target.segment(point(from), point(to), color >>> 0),
  point: (target, at, color) => target.point(point(at), color >>> 0),
  color_of: (target, pointer, body, shape) => {
    const world = worldAt(pointer);
    return whole(target.colorOf(handleOf(world, body), handleOf(world, shape)), "colorOf", 0, 4294967295);
  },
};
/** In the order of the numbers of `fettle_called`. */
export const kinds = [...Object.keys(ofWorlds), ...Object.keys(ofOthers)];

/** What the library imports. Nothing is thrown through it: the call that led here throws when it is over. */
export const imports = {};
for (const [kind, act] of Object.entries(ofWorlds))
  imports[kind] = (user, pointer, ...values) => nested(kind === "pair_filter", () => {
    const world = worldAt(pointer);
    const call = functions.byNumber.get(user) ?? world?.functions.byNumber.get(user);
    if (call === undefined) return kind === "pair_filter";
    if (kind === "after_step") world.functions.byNumber.delete(user);
    return act(call, world, ...values);
  }) ? 1 : 0;
for (const [kind, act] of Object.entries(ofOthers))
  imports[kind] = (user, ...values) => nested(0, () => {
    const call = functions.byNumber.get(user);
    return call && act(call, ...values);
  });
