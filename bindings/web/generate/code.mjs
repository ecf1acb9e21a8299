// Writes interface.js: the structures, and the methods and properties of each class.

import { camel, classes, kindsOfCalls, moverProperties, pascal, settableMembers } from "./shape.mjs";
import { sizeOf, visibleMembers } from "./layout.mjs";

// What runtime.js and called.js export to the code that is written. Arguments with these names are renamed.
const helpers = [
  "Edit", "Handle", "MoverBase", "WorldBase", "allocate", "begin", "bits", "bytes", "c", "chars", "check", "copyOf", "flag", "handle", "idOf", "keep", "lend", "list", "members", "number", "optional",
  "pointerOf", "readAll", "readList", "register", "struct", "text", "typeOf", "view", "whole", "xOf", "yOf",
];
const inCalled = ["Edit", "keep", "lend"];
const variable = (input) => (helpers.includes(input.name) ? input.name + "Given" : input.name);

const short = (type) => type.replace(/^fettle_/, "");
const readScalar = {
  float: (p) => `view.f32[(${p}) >> 2]`,
  bool: (p) => `view.u8[${p}] !== 0`,
  int32_t: (p) => `view.i32[(${p}) >> 2]`,
  uint32_t: (p) => `view.u32[(${p}) >> 2]`,
  size_t: (p) => `view.u32[(${p}) >> 2]`,
  uint64_t: (p) => `view.u64[(${p}) >> 3]`,
};
const scalarOf = {
  float: (v, name) => `number(${v}, ${name})`,
  bool: (v, name) => `flag(${v}, ${name})`,
  int32_t: (v, name) => `whole(${v}, ${name}, -2147483648, 2147483647)`,
  uint32_t: (v, name) => `whole(${v}, ${name}, 0, 4294967295)`,
  size_t: (v, name) => `whole(${v}, ${name}, 0, 4294967295)`,
  uint64_t: (v, name) => `bits(${v}, ${name})`,
};

/** An expression that reads a value of a type at p. */
function read(type, p, world) {
  if (readScalar[type]) return readScalar[type](p);
  if (type === "fettle_id") return `handle(${world}, ${p})`;
  return `read_${short(type)}(${p}, ${world})`;
}

/** A statement that writes v at p. */
function write(type, p, v, name) {
  const array = { float: "f32", int32_t: "i32", uint32_t: "u32", size_t: "u32", uint64_t: "u64" }[type];
  if (type === "bool") return `view.u8[${p}] = ${scalarOf.bool(v, name)};`;
  if (array) return `view.${array}[(${p}) >> ${array === "u64" ? 3 : 2}] = ${scalarOf[type](v, name)};`;
  if (type === "fettle_id") return `view.u64[(${p}) >> 3] = idOf(${v}, ${name});`;
  // A vector may come from another library and have more members.
  // Getters of the program may make memory grow, and then `view` is made anew. So they are called before `view` is read.
  if (type === "fettle_vec2") return `{ const x = xOf(${v}, ${name}), y = yOf(${v}); view.f32[(${p}) >> 2] = x; view.f32[((${p}) >> 2) + 1] = y; }`;
  return `write_${short(type)}(${p}, ${v}, ${name});`;
}

const at = (offset) => (offset ? `p + ${offset}` : "p");

function structCode(struct, structs) {
  const name = short(struct.name), members = visibleMembers(struct);
  const fields = members.map((member) => {
    const p = at(member.offset);
    let value;
    if (member.type === "fettle_accept") value = "null";  // only written
    else if (member.type === "char") value = `text(view.u32[(${p}) >> 2])`;
    else if (member.pointer) value = `readList(view.u32[(${p}) >> 2], view.u32[(${at(member.counted.offset)}) >> 2], ${sizeOf({ type: member.type }, structs).size}, (p) => ${read(member.type, "p", "world")})`;
    else if (member.count > 1) value = `readList(${p}, ${readScalar[member.counted.type](at(member.counted.offset))}, ${member.stride}, (p) => ${read(member.type, "p", "world")})`;
    else value = read(member.type, p, "world");
    if (member.has) value = `view.u8[${at(member.has.offset)}] ? ${value} : null`;
    return `    ${camel(member.name)}: ${value},\n`;
  });
  const writers = members.filter((member) => (!member.pointer || member.type === "char" || member.name === "points") && member.count === 1).map((member) => {
    const p = at(member.offset), path = `name + ".${camel(member.name)}"`;
    let code;
    if (member.type === "fettle_accept") {
      const user = struct.members.find((other) => other.name === "user").offset;
      code = `if (v === null) return; const [call, user] = lend(v, ${path}, "accept"); view.u32[(${p}) >> 2] = call; view.u32[(${at(user)}) >> 2] = user;`;
    } else if (member.type === "char") code = `const text = chars(v, ${path}); view.u32[(${p}) >> 2] = text;`;
    else if (member.pointer) code = `const [first, count] = list(v, ${sizeOf({ type: member.type }, structs).size}, ${path}, (p, v, name) => { ${write(member.type, "p", "v", "name")} }); view.u32[(${p}) >> 2] = first; view.u32[(${at(member.counted.offset)}) >> 2] = count;`;
    else code = write(member.type, p, "v", path);
    if (member.has) code = `view.u8[${at(member.has.offset)}] = v === null ? 0 : 1; if (v !== null) { ${code} }`;
    return `  ${camel(member.name)}: (p, v, name) => { ${code} },\n`;
  });
  return `function read_${name}(p, world) {\n  return {\n${fields.join("")}  };\n}\nconst members_${name} = {\n${writers.join("")}};\nfunction write_${name}(p, value, name) {\n  members(p, value, name, members_${name}${struct.members[0].name === "size" ? "" : ", true"});\n}\n\n`;
}

/** Code that converts an argument of JavaScript into one or more arguments in C. */
function argumentCode(input, structs) {
  const name = JSON.stringify(input.name), v = variable(input);
  switch (input.kind) {
    case "scalar": return scalarOf[input.type](v, name);
    case "vec2": return `xOf(${v}, ${name}), yOf(${v}, ${name})`;
    case "id": return `idOf(${v}, ${name})`;
    case "world": return `pointerOf(${v}, ${name})`;
    case "text": return `chars(${v}, ${name})`;
    case "function": return `...lend(${v}, ${name}, "${input.call}")`;
    case "bytes": return `...bytes(${v}, ${name})`;
    case "array": return `...list(${v}, ${sizeOf({ type: input.type }, structs).size}, ${name}, (p, v, name) => { ${write(input.type, "p", "v", "name")} })`;
    case "optional": return `optional(${v}, (p) => { ${write(input.type, "p", v, name)} })`;
    case "struct": {
      const struct = structs.get(input.type), begins = struct.members[0].name === "size";
      const typed = /^fettle_(geometry|field_def)$/.test(input.type);
      const start = begins ? `, (p) => c.${input.type}_init(p, ${struct.size}${typed ? `, typeOf(${v}, ${name})` : ""})` : "";
      return `struct(${v}, ${struct.size}, ${name}, write_${short(input.type)}${start})`;
    }
  }
  throw new Error(`no code for ${input.kind}`);
}

function methodBody(plan, structs) {
  const world = plan.owner === "World" ? "this" : plan.owner ? "this.world" : "null";
  const fixed = plan.arguments.filter((g) => typeof g === "string"), code = [], after = [];
  const results = plan.outputs.map((output, i) => ({ output, p: `out${i}` }));
  if (plan.result?.direct) {
    const value = `c.${plan.fn.name}(${[...fixed, ...plan.inputs.map((input) => argumentCode(input, structs))].join(", ")})`;
    return `begin(); return ${plan.result.direct === "constchar*" ? `text(${value})` : plan.result.direct === "bool" ? `${value} !== 0` : value};`;
  }
  const list = plan.outputs.find((output) => output.kind === "list");
  code.push("begin();");
  if (plan.keeps) {
    // A function of a body is one for its slot; each of those for the end of a step is called once.
    const key = plan.bare === "after_step" ? "null" : plan.owner === "Body" ? `"${plan.bare} " + this.slot` : `"${plan.bare}"`;
    const [input] = plan.inputs, args = [...fixed, "call", "user"].join(", ");
    if (plan.inputs.length !== 1) throw new Error(`${plan.fn.name}: there is no code for more than a function`);
    return `begin(); keep(${world}, ${key}, ${variable(input)}, ${JSON.stringify(input.name)}, "${input.call}", (call, user) => c.${plan.fn.name}(${args}));`;
  }
  if (plan.owner === "Mover") code.push("const mover = this.copyToMemory();");
  // Arguments are written to memory before the places of the results are taken.
  const args = [];
  for (const [i, g] of plan.arguments.entries()) {
    if (typeof g === "string") args.push(g);
    else if (g.kind === "flag") {
      code.push("const flag = allocate(1);");
      args.push("flag");
    } else if (plan.inputs.includes(g)) {
      if (["struct", "array", "optional", "bytes", "function"].includes(g.kind)) {
        code.push(`const in${i} = [${argumentCode(g, structs)}];`);
        args.push(`...in${i}`);
      } else args.push(argumentCode(g, structs));
    } else {
      const p = results.find((result) => result.output === g).p;
      if (g.kind === "list") args.push("out", "most", "count");
      else if (g.kind === "bytes") {
        code.push(`const ${p} = allocate(4), size = allocate(4);`);
        args.push(p, "size");
      } else {
        const size = ["text", "world"].includes(g.kind) ? 4 : sizeOf({ type: g.type }, structs).size;
        code.push(`const ${p} = allocate(${size});`);
        if (g.kind === "struct" && structs.get(g.type).members[0].name === "size") code.push(`view.u32[${p} >> 2] = ${size};`);
        args.push(p);
      }
    }
  }
  const callOf = `c.${plan.fn.name}(${args.join(", ")})`;
  const value = ({ output, p }) => {
    if (output.kind === "text") return `text(view.u32[${p} >> 2])`;
    if (output.kind === "world") return `World.of(view.u32[${p} >> 2])`;
    if (output.kind === "bytes") return `copyOf(view.u32[${p} >> 2], view.u32[size >> 2])`;
    if (output.kind === "list") return "found";
    return read(output.type, p, world);
  };
  if (list) {
    const { size } = sizeOf({ type: list.type }, structs);
    code.push(`const found = readAll(${size}, (out, most, count) => ${callOf}, (p) => ${read(list.type, "p", world)});`);
  } else code.push(`check(${callOf});`);
  if (plan.owner === "Mover") code.push("this.store(...mover);");
  if (results.length === 1) after.push(`return ${plan.maybe ? "view.u8[flag] === 0 ? null : " : ""}${value(results[0])};`);
  else if (results.length > 1) after.push(`return { ${results.map((r) => `${r.output.name}: ${value(r)}`).join(", ")} };`);
  return [...code, ...after].join(" ");
}

/** A structure that a function gets: its members are read, and some are set, in the memory of the library. */
function editCode(struct) {
  const lines = visibleMembers(struct).map(({ name, type, offset }) => {
    const p = at(offset);
    const get = `  get ${camel(name)}() { const { world, at: p } = this; return ${read(type, p, "world")}; }\n`;
    return settableMembers[struct.name].includes(name) ? get + `  set ${camel(name)}(value) { const p = this.at; ${write(type, p, "value", JSON.stringify(camel(name)))} }\n` : get;
  });
  return `export class ${pascal(short(struct.name))} extends Edit {\n${lines.join("")}}\n\n`;
}

/** A value is written in a copy of the structure, which the library checks before the mover takes it. */
function propertyCode({ name, type, offset, from, isSet }) {
  const p = at(offset).replace("p", from);
  const get = `  get ${camel(name)}() { begin(); const [def, state] = this.copyToMemory(); return ${read(type, p, "this.world")}; }\n`;
  const set = `  set ${camel(name)}(value) { begin(); const [def, state] = this.copyToMemory(); ${write(type, p, "value", JSON.stringify(camel(name)))} this.checkAndStore(def, state); }\n`;
  return isSet ? get + set : get;
}

function classCode(cls, plans, structs) {
  const own = plans.filter((plan) => plan.owner === cls.name);
  const lines = own.map((plan) => {
    const names = plan.inputs.map(variable).join(", ");
    const body = methodBody(plan, structs);
    if (plan.gets) return `  get ${plan.gets}() { ${body} }\n`;
    if (plan.sets && own.some((other) => other.gets === plan.sets)) return `  set ${plan.sets}(${names}) { ${body} }\n`;
    return `  ${plan.name}(${names}) { ${body} }\n`;
  });
  const base = cls.base ?? (cls.id ? "Handle" : "WorldBase");
  if (cls.name === "Mover") lines.unshift(...moverProperties(structs).map(propertyCode));
  return `export class ${cls.name} extends ${base} {\n${lines.join("")}}\n\n`;
}

export function interfaceCode(headers, plans) {
  const { structs } = headers;
  let code = `// Made from the headers in C by bindings/web/generate; what is changed here is lost.
import { ${helpers.filter((name) => !inCalled.includes(name)).join(", ")} } from "./runtime.js";
import { ${inCalled.join(", ")} } from "./called.js";

`;
  for (const enumeration of headers.enums.filter((e) => e.name !== "codes")) {
    const name = camel("_" + enumeration.name), common = prefixOf(enumeration.values);
    code += `export const ${name} = Object.freeze({ ${enumeration.values.map((v) => `${v.name.slice(common.length)}: ${v.value}`).join(", ")} });\n`;
  }
  code += "\n";
  for (const struct of structs.values()) if (struct.name !== "fettle_columns" && !settableMembers[struct.name]) code += structCode(struct, structs);
  for (const name of Object.keys(settableMembers)) code += editCode(structs.get(name));
  for (const cls of classes) code += classCode(cls, plans, structs);
  for (const plan of plans.filter((p) => !p.owner))
    code += `export function ${plan.name}(${plan.inputs.map(variable).join(", ")}) { ${methodBody(plan, structs)} }\n`;
  const joints = classes.filter((cls) => cls.base === "Joint").map((cls) => cls.name);
  const moverStructs = ["def", "state"].map((name) => `${name}: { size: ${structs.get("fettle_mover_" + name).size}, read: read_mover_${name}, write: write_mover_${name} }`);
  code += `\nregister({ World, Mover, mover: { ${moverStructs.join(", ")} }, Body, Shape, Field, joints: [${joints.join(", ")}], writeWorldDef: write_world_def, worldDefSize: ${structs.get("fettle_world_def").size}, shapes: ShapeType, ${Object.keys(settableMembers).map((name) => pascal(short(name))).join(", ")}, readVec2: read_vec2, readRayHit: read_ray_hit, replayedStep: { size: ${structs.get("fettle_replayed_step").size}, read: read_replayed_step }, debugDraw: { size: ${structs.get("fettle_debug_draw").size}, write: write_debug_draw, functions: { ${functionsOf(structs.get("fettle_debug_draw")).map((member) => `${member.name}: ${member.offset}`).join(", ")} } } });\n`;
  return code;
}

const functionsOf = (struct) => struct.members.filter((member) => member.type === "callback" || member.name === "user");

const callsOf = (headers) => [
  ...Object.keys(kindsOfCalls).map((name) => ({ name, ...headers.callbacks.get("fettle_" + name) })),
  ...headers.structs.get("fettle_debug_draw").members.filter((member) => member.type === "callback"),
];

/** Tells the linker of Emscripten that these names are not missing. */
export function knownCode(headers) {
  return `mergeInto(LibraryManager.library, { ${callsOf(headers).map(({ name }) => `${name}() {}`).join(", ")} });\n`;
}

/** The functions that the library calls in JavaScript: it imports them, and `fettle_called` gives their addresses. */
export function calledCode(headers) {
  const calls = callsOf(headers);
  const declarations = calls.map(({ name, result, params }) => `__attribute__((import_module("fettle"), import_name("${name}"))) ${result} fettle_called_${name}(${params});\n`);
  const cases = calls.map(({ name }, i) => `        case ${i}: return reinterpret_cast<void*>(fettle_called_${name});\n`);
  return `// Made from the headers in C by bindings/web/generate; what is changed here is lost.\n#include <fettle_physics.h>\n\nextern "C" {\n${declarations.join("")}\nvoid* fettle_called(int which);\nvoid* fettle_called(int which) {\n    switch (which) {\n${cases.join("")}        default: return nullptr;\n    }\n}\n}\n`;
}

export function prefixOf(values) {
  const words = values.map((v) => v.name.split("_"));
  let n = 0;
  while (n < words[0].length - 1 && words.every((w) => w.length > n + 1 && w[n] === words[0][n])) ++n;
  return words[0].slice(0, n).join("_") + (n ? "_" : "");
}

