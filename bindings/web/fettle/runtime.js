// The library in WebAssembly: loading it, its memory, its errors, and the objects that stand for ids.

import { addressOf, addWorld, imports as called, lend, removeWorld } from "./called.js";

/** The functions of the library. */
export let c;
let memory;
/** Views of its memory, made anew when it has grown. */
export const view = { u8: new Uint8Array(0) };
export let classes;

function refresh() {
  const { buffer } = memory;
  view.u8 = new Uint8Array(buffer);
  view.i32 = new Int32Array(buffer);
  view.u32 = new Uint32Array(buffer);
  view.f32 = new Float32Array(buffer);
  view.u64 = new BigUint64Array(buffer);
}

// --- Errors ---------------------------------------------------------------------------------------

export class FettleError extends Error {}
export class Invalid extends FettleError {}
export class Stale extends FettleError {}
export class Locked extends FettleError {}
export class NoMemory extends FettleError {}
const errors = [, Invalid, Stale, Locked, NoMemory], lockedCode = errors.indexOf(Locked);

let raised;  // what a function of the program has thrown inside this call

/** Throws what a function of the program has thrown, or the error that a code stands for. */
export function check(code) {
  if (view.u8.length === 0) refresh();
  if (raised !== undefined) {
    const { error } = raised;
    raised = undefined;
    throw error;
  }
  if (wasAbandoned(code)) throw new FettleError("world: JavaScript has ended an earlier call in its middle, since its stack was full; it can only be destroyed");
  if (code !== 0) throw new (errors[code] ?? FettleError)(text(c.fettle_last_error()));
}

/** Whether the code says that a world is in the middle of a call although no call is running: JavaScript has ended that call when its stack was full. */
const wasAbandoned = (code) => code === lockedCode && depth === 0;

function shown(value) {
  return typeof value === "string" ? JSON.stringify(value) : String(value);
}
export function number(value, name) {
  if (typeof value !== "number") throw new Invalid(`${name} = ${shown(value)}: expected a number`);
  return value;
}
export function whole(value, name, low, high) {
  if (!Number.isInteger(value) || value < low || value > high) throw new Invalid(`${name} = ${shown(value)}: expected a whole number from ${low} to ${high}`);
  return value;
}
export function bits(value, name) {
  if (typeof value === "bigint" ? value >= 0n && value < 1n << 64n : Number.isSafeInteger(value) && value >= 0) return BigInt(value);
  throw new Invalid(`${name} = ${shown(value)}: expected a whole number from 0 to 2^64 - 1`);
}
export function flag(value, name) {
  if (typeof value !== "boolean") throw new Invalid(`${name} = ${shown(value)}: expected true or false`);
  return value ? 1 : 0;
}
export function xOf(value, name) {
  const x = member(value, "x");
  if (typeof x !== "number" || typeof member(value, "y") !== "number") throw new Invalid(`${name} = ${shown(value)}: expected { x, y } with two numbers`);
  return x;
}
export const yOf = (value) => member(value, "y");

// --- Memory of one call ---------------------------------------------------------------------------

// Arguments and results of a call are in one block; those of calls that a function of the program makes meanwhile follow them. Data that is
// too large for the block is freed by the next call.
const blockSize = 1 << 16, mostSize = 1 << 30;
let block = 0, bottom = 0, top = 0;
/** Functions that the next call runs first, to release what the last call needed. */
export const cleanups = [];
let cleanupsFrom = 0;
// The stack of the library between two calls. JavaScript ends a call in the middle when its own stack is full; the next one begins here.
let stack = 0, depth = 0;
const mostDepth = 32;

export function begin() {
  if (view.u8.length === 0) refresh();
  c.stackRestore(stack);
  top = bottom;
  while (cleanups.length > cleanupsFrom) cleanups.pop()();
}

/** Calls a function of the program inside a call. If it throws, the result is `otherwise`, and the outer call throws the error when it is over. */
export function nested(otherwise, act) {
  const outer = [bottom, top, cleanupsFrom, stack], before = raised;
  let result = otherwise, error;
  [bottom, cleanupsFrom, stack, raised] = [top, cleanups.length, c.stackSave(), undefined];
  ++depth;
  try {
    if (depth > mostDepth) throw new Locked(`functions that worlds call are nested more than ${mostDepth} deep`);
    if (view.u8.length === 0) refresh();
    result = act();
  } catch (caught) {
    error = { error: caught };
  }
  try {
    begin();
  } finally {
    --depth;
    [bottom, top, cleanupsFrom, stack] = outer;
    raised = before ?? error;
  }
  return result;
}
/** A member of a value of the program. It may be a getter that calls the library: the memory of that call follows. */
function member(value, key) {
  if (value === null || value === undefined) return undefined;
  const outerBottom = bottom, outerFrom = cleanupsFrom;
  bottom = top;
  cleanupsFrom = cleanups.length;
  try {
    return value[key];
  } finally {
    if (top !== bottom || cleanups.length !== cleanupsFrom) begin();
    bottom = outerBottom;
    cleanupsFrom = outerFrom;
  }
}
/** The address of `size` bytes, aligned to 8, not initialized. */
export function allocate(size) {
  if (!(size <= mostSize)) throw new NoMemory(`no memory for ${size} bytes`);
  let p = top;
  const needed = (size + 7) & ~7;
  if (p + needed > block + blockSize) {
    p = c.malloc(needed) >>> 0;
    if (p === 0) throw new NoMemory(`no memory for ${size} bytes`);
    if (view.u8.length === 0) refresh();
    cleanups.push(() => c.free(p));
  } else top += needed;
  return p;
}

export function text(p) {
  if (view.u8.length === 0) refresh();
  return p === 0 ? "" : new TextDecoder().decode(view.u8.subarray(p, view.u8.indexOf(0, p)));
}
export function copyOf(p, size) {
  return view.u8.slice(p, p + size);
}
export function bytes(value, name) {
  if (!(value instanceof Uint8Array)) throw new Invalid(`${name}: expected a Uint8Array`);
  const p = allocate(value.length);
  view.u8.set(value, p);
  return [p, value.length];
}
/** The address of a text that ends with a zero. */
export function chars(value, name) {
  if (typeof value !== "string" || value.includes("\0")) throw new Invalid(`${name} = ${shown(value)}: expected a text without a zero`);
  const encoded = new TextEncoder().encode(value), p = allocate(encoded.length + 1);
  view.u8.set(encoded, p);
  view.u8[p + encoded.length] = 0;
  return p;
}
/** Writes the elements of an array. Returns the address of the first one and their number. */
export function list(values, size, name, write) {
  const count = member(values, "length");
  if (typeof values !== "object" || typeof count !== "number") throw new Invalid(`${name} = ${shown(values)}: expected an array`);
  whole(count, `${name}.length`, 0, Math.floor(mostSize / size));
  const p = allocate(count * size);
  view.u8.fill(0, p, p + count * size);
  for (let i = 0; i < count; ++i) write(p + i * size, member(values, i), `${name}[${i}]`);
  return [p, count];
}
export function optional(value, write) {
  if (value === null || value === undefined) return 0;
  const p = allocate(8);
  write(p);
  return p;
}
/** The address of a structure with its defaults and the members of `value`; 0 where there is no value. */
export function struct(value, size, name, write, defaults) {
  if (value === null || value === undefined) return 0;
  if (typeof value !== "object") throw new Invalid(`${name} = ${shown(value)}: expected an object`);
  const p = allocate(size);
  view.u8.fill(0, p, p + size);
  if (defaults) check(defaults(p));
  write(p, value, name);
  return p;
}
export function typeOf(value, name) {
  return whole(member(value, "type"), `${name}.type`, 0, 255);
}
/** How many letters must be inserted, removed or replaced to make one word of another. */
function editDistance(from, to) {
  let row = Array.from({ length: to.length + 1 }, (_, i) => i);
  for (let i = 1; i <= from.length; ++i) {
    const next = [i];
    for (let j = 1; j <= to.length; ++j) next[j] = Math.min(next[j - 1] + 1, row[j] + 1, row[j - 1] + (from[i - 1] === to[j - 1] ? 0 : 1));
    row = next;
  }
  return row[to.length];
}
/** Text that suggests the name most similar to a wrong one, if it is similar enough. A name as in C matches the one in camel case. */
function suggestion(wrong, names) {
  const plain = (name) => name.replaceAll("_", "").toLowerCase(), how = (name) => editDistance(plain(wrong), plain(name));
  const nearest = names.reduce((a, b) => (how(b) < how(a) ? b : a));
  return how(nearest) <= Math.max(1, wrong.length / 3) ? ` (did you mean "${nearest}"?)` : "";
}
/** Writes the members of an object at `p`. `all`: none may be missing, because there are no defaults. */
export function members(p, value, name, known, all = false) {
  if (typeof value !== "object" || value === null) throw new Invalid(`${name} = ${shown(value)}: expected an object`);
  for (const key of Object.keys(value)) {
    if (!Object.hasOwn(known, key)) throw new Invalid(`${name} has no member "${key}"${suggestion(key, Object.keys(known))}; it has ${Object.keys(known).join(", ")}`);
    const of = member(value, key);
    if (of !== undefined) known[key](p, of, name);
  }
  if (!all) return;
  const missing = Object.keys(known).find((key) => member(value, key) === undefined);
  if (missing !== undefined) throw new Invalid(`${name} has no "${missing}": expected ${Object.keys(known).join(", ")}`);
}
export function readList(p, count, size, read) {
  const found = new Array(count);
  for (let i = 0; i < count; ++i) found[i] = read(p + i * size);
  return found;
}
/** All elements of a list: asks again with more room where there are more. */
export function readAll(size, call, read) {
  const count = allocate(4);
  let most = 32;
  for (;;) {
    const out = allocate(most * size);
    check(call(out, most, count));
    const have = view.u32[count >> 2];
    if (have <= most) return readList(out, have, size, read);
    most = have;
  }
}

// --- Objects --------------------------------------------------------------------------------------

const slotBits = 28, slotMask = (1 << slotBits) - 1;

/** A body, shape, joint or field of a world. The same object always has the same handle. */
export class Handle {
  constructor(world, id, low, high) {
    this.world = world;
    this.id = id;
    this.low = low;
    this.high = high;
    Object.preventExtensions(this);  // a misspelt property is an error
  }
  /** Where it is in the columns of its world. */
  get slot() { return this.low & slotMask; }
  get isValid() { return c[`fettle_${kindNames[this.low >>> slotBits]}_is_valid`](this.world.address, this.id) !== 0; }
  toString() { return `${this.constructor.name} ${this.slot}`; }
}
const kindNames = [, "body", "shape", "joint", "field"];

/** The handle of the id at an address; null for 0. */
export function handle(world, p) {
  const low = view.u32[p >> 2], high = view.u32[(p >> 2) + 1];
  if (low === 0 && high === 0) return null;
  const kind = low >>> slotBits, slot = low & slotMask;
  const known = world.handles[kind][slot];
  if (known !== undefined && known.low === low && known.high === high) return known;
  const id = (BigInt(high) << 32n) | BigInt(low);
  let Class = [, classes.Body, classes.Shape, undefined, classes.Field][kind];
  if (kind === 3) Class = classes.joints[jointType(world, id)];
  return (world.handles[kind][slot] = new Class(world, id, low, high));
}
/** The type of a joint. It does not call `begin`, so arguments that a caller has in memory stay. */
function jointType(world, id) {
  const p = allocate(4);
  return c.fettle_joint_type(world.pointer, id, p) === 0 ? view.i32[p >> 2] : 0;
}
export function idOf(value, name) {
  if (value === null || value === undefined) return 0n;
  if (!(value instanceof Handle)) throw new Invalid(`${name} = ${shown(value)}: expected a body, shape, joint or field`);
  return value.id;
}
export function pointerOf(world, name) {
  if (!(world instanceof WorldBase)) throw new Invalid(`${name} = ${shown(world)}: expected a World`);
  return world.pointer;
}

const collected = new FinalizationRegistry((pointer) => {
  c.fettle_world_destroy(pointer);
  removeWorld(pointer);
});

/** The members of a world that are not made from functions in C. */
export class WorldBase {
  constructor(definition) {
    if (c === undefined) throw new FettleError("the library is not loaded yet: await load()");
    begin();
    const def = struct(definition, classes.worldDefSize, "definition", classes.writeWorldDef, (p) => c.fettle_world_def_init(p, classes.worldDefSize));
    const out = allocate(4);
    check(c.fettle_world_create(def, out));
    this.own(view.u32[out >> 2]);
    // A misspelt property is an error. Classes that a program derives may add properties.
    if (new.target === classes.World) Object.preventExtensions(this);
  }
  /** A world that the library has made. */
  static of(pointer) {
    const world = Object.create(this.prototype);
    world.own(pointer);
    return Object.preventExtensions(world);
  }
  own(pointer) {
    this.address = pointer;  // 0: destroyed; a later world may get the memory
    this.handles = [, [], [], [], []];
    addWorld(this);
    collected.register(this, pointer, this);
  }
  get pointer() {
    if (this.address === 0) throw new Stale("world: it was destroyed");
    return this.address;
  }
  /** Destroys the world and all in it; it can be called again. */
  destroy() {
    if (this.address === 0) return;
    const code = c.fettle_world_destroy(this.address);
    if (!wasAbandoned(code)) check(code);  // otherwise its memory stays taken
    this.address = 0;
    collected.unregister(this);
    this.handles = [, [], [], [], []];
  }
  draw(target, options = {}) {
    const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
    begin();
    const { size, write, functions } = classes.debugDraw;
    const def = struct(options, size, "options", write, (p) => c.fettle_debug_draw_init(p, size));
    const has = (name) => name !== "user" && typeof target?.[camel(name)] === "function";
    if (!Object.keys(functions).some(has))
      throw new Invalid(`target = ${shown(target)}: expected an object with some of the methods ${Object.keys(functions).filter((name) => name !== "user").map(camel).join(", ")}`);
    const [, number] = lend(target, "target");
    for (const [name, offset] of Object.entries(functions))
      view.u32[(def + offset) >> 2] = name === "user" ? number : has(name) ? addressOf(name) : 0;
    check(c.fettle_world_draw(this.pointer, def));
  }
  column(offset, floats) {
    begin();
    const p = allocate(12);
    check(c.fettle_world_columns(this.pointer, p));
    return new Float32Array(view.u8.buffer, view.u32[(p + offset) >> 2], view.u32[(p + 8) >> 2] * floats);
  }
  /** x, y, angle, angular velocity, velocity x and y, cosine and sine of the body in each slot. */
  get states() { return this.column(0, 8); }
  /** x, y and angle before the last step, of the body in each slot. */
  get previousPoses() { return this.column(4, 3); }
}

/** The members of a mover that are not made from functions in C. It holds the bytes of its definition and of its state. */
export class MoverBase {
  #definition;
  #state;
  constructor(world, definition = {}, position = { x: 0, y: 0 }) {
    begin();
    pointerOf(world, "world");
    Object.defineProperty(this, "world", { value: world });
    const { def, state } = classes.mover;
    this.checkAndStore(this.structOf(definition, "definition", def, c.fettle_mover_def_init), this.structOf({ position }, "state", state, c.fettle_mover_state_init));
    // A misspelt property is an error. Classes that a program derives may add properties.
    if (new.target === classes.Mover) Object.preventExtensions(this);
  }
  /** The address of a structure with the members of `value` and the defaults for the others. */
  structOf(value, name, { size, write }, init) {
    if (typeof value !== "object" || value === null) throw new Invalid(`${name} = ${shown(value)}: expected an object`);
    return struct(value, size, name, write, (p) => init(p, size));
  }
  /** The addresses of copies of both structures, for the duration of a call. */
  copyToMemory() {
    return [this.#definition, this.#state].map((bytesOfOne) => {
      const p = allocate(bytesOfOne.length);
      view.u8.set(bytesOfOne, p);
      return p;
    });
  }
  /** Stores structures that the library has written. */
  store(def, state) {
    this.#definition = copyOf(def, classes.mover.def.size);
    this.#state = copyOf(state, classes.mover.state.size);
  }
  /** Stores structures that the program has given, after the library has checked them. */
  checkAndStore(def, state) {
    const { height } = classes.mover.def.read(def, this.world);
    check(c.fettle_mover_fits(this.world.pointer, def, state, height, allocate(1)));
    this.store(def, state);
  }
  get definition() {
    begin();
    return classes.mover.def.read(this.copyToMemory()[0], this.world);
  }
  set definition(value) {
    begin();
    this.checkAndStore(this.structOf(value, "definition", classes.mover.def, c.fettle_mover_def_init), this.copyToMemory()[1]);
  }
  get state() {
    begin();
    return classes.mover.state.read(this.copyToMemory()[1], this.world);
  }
  set state(value) {
    begin();
    this.checkAndStore(this.copyToMemory()[0], this.structOf(value, "state", classes.mover.state, c.fettle_mover_state_init));
  }
  get position() { return this.state.position; }
  set position(position) {
    xOf(position, "position");
    const { climbing, dropped } = this.state;
    this.state = { climbing, dropped, position };
  }
}

export function register(made) {
  classes = made;
}

// --- Loading --------------------------------------------------------------------------------------

let loading;

/** Loads the library; `source`: the bytes of fettle.wasm, its module, or a promise of its response. */
export function load(source) {
  loading ??= instantiate(source).catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

async function instantiate(source) {
  const { instance } = await compiled(await (source ?? defaultSource()));
  c = instance.exports;
  memory = c.memory;
  refresh();
  c._initialize?.();
  block = bottom = top = c.malloc(blockSize);
  stack = c.stackSave();
  refresh();
}

/** fettle.wasm beside this file. */
async function defaultSource() {
  const url = new URL("./fettle.wasm", import.meta.url);
  if (url.protocol !== "file:") return fetch(url);
  const { readFile } = await import("node:fs/promises");
  return readFile(url);
}

async function compiled(source) {
  if (source instanceof WebAssembly.Module) return { instance: await WebAssembly.instantiate(source, imports) };
  if (typeof Response !== "undefined" && source instanceof Response) {
    if (!source.ok) throw new FettleError(`${source.url}: ${source.status} ${source.statusText}`);
    source = await source.arrayBuffer();
  }
  return WebAssembly.instantiate(source, imports);
}

// The functions that the C library of Emscripten requires of its host: a clock, and output of text.
const now = () => BigInt(Math.round(performance.now() * 1e6));
const fail = (what) => () => { throw new FettleError(what); };
const imports = {
  get fettle() { return called; },
  env: new Proxy({ emscripten_notify_memory_growth() { refresh(); } }, {
    get: (known, name) => known[name] ?? fail(`fettle.wasm asks for ${String(name)}`),
  }),
  wasi_snapshot_preview1: {
    clock_time_get(_clock, _precision, out) {
      if (view.u8.length === 0) refresh();
      view.u64[out >> 3] = now();
      return 0;
    },
    fd_write(_file, parts, count, written) {
      if (view.u8.length === 0) refresh();
      let size = 0;
      for (let i = 0; i < count; ++i) size += view.u32[(parts >> 2) + 2 * i + 1];
      view.u32[written >> 2] = size;
      return 0;
    },
    fd_close: () => 0,
    fd_seek: () => 70,
    fd_read: () => 8,
    environ_sizes_get: (count, size) => ((view.u32[count >> 2] = 0), (view.u32[size >> 2] = 0)),
    environ_get: () => 0,
    proc_exit: fail("the library has ended"),
  },
};
