// The form of a function of C in JavaScript: a method or a property of a class, its arguments and its result.

export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
export const pascal = (name) => camel("_" + name);

const kinds = { body: "Body", shape: "Shape", joint: "Joint", field: "Field" };
const jointTypes = ["mouse", "distance", "revolute", "prismatic", "wheel", "weld", "motor", "pulley", "gear", "groove", "pin_slot", "ratchet", "filter",
  "rotary_limit"];

/** The classes, in the order in which they extend each other, with the prefix of their functions. */
export const classes = [
  { name: "World", prefix: "world_" },
  { name: "Body", prefix: "body_", id: "body" },
  { name: "Shape", prefix: "shape_", id: "shape" },
  { name: "Field", prefix: "field_", id: "field" },
  { name: "Joint", prefix: "joint_", id: "joint" },
  ...jointTypes.map((type) => ({ name: pascal(type) + "Joint", prefix: type + "_joint_", id: "joint", base: "Joint" })),
  { name: "Mover", prefix: "mover_", base: "MoverBase" },
];

/** The class of a joint is found by the number of its type, so the list above must be that of the headers. */
function checkJointTypes(headers) {
  const declared = headers.enums.find((e) => e.name === "joint_type").values.map(({ name, value }) => `${value} ${name.toLowerCase()}`);
  const known = jointTypes.map((type, i) => `${i} joint_${type}`);
  if (declared.join() !== known.join()) throw new Error(`types of joints are ${declared.join(", ")}; shape.mjs has ${known.join(", ")}`);
}

/** The class of the object that an id refers to, by the name of the parameter or member. */
export function handleOf(name, inFunction = "") {
  const plain = name === "out" ? inFunction : name;
  if (/sensor_body|visitor_body|bod(y|ies)|slept|woke/.test(plain)) return "Body";
  if (/joint/.test(plain)) return "Joint";
  if (/field/.test(plain)) return "Field";
  if (/shape|sensor|visitor|query|^(ground|wall|dropped|own|other)$/.test(plain)) return "Shape";
  return kinds[plain] ?? "Body";
}

// Functions that are written by hand in runtime.js and replay.js.
const byHand = /^fettle_replay_|_init$|^fettle_(last_error|world_create|world_destroy|world_columns|world_draw)$|_is_valid$/;

/** What a program in JavaScript does not have, and why. */
const leftOut = new Map([
  [/^fettle_slot$/, "`slot` of an object"],
  [/^fettle_owner_|^fettle_world_set_owner$/, "for engines that keep data for every object of a world"],
  [/^fettle_world_(on_)?refresh$/, "for hosts that read the memory of a world while it is edited"],
  [/^fettle_world_set_scheduler$/, "the package has one thread"],
  [/^fettle_world_(set_)?parallel_callbacks$/, "the package has one thread"],
  [/^fettle_worlds_/, "saves calls from languages that are slower than JavaScript"],
]);

/** What the functions of the program are called for, by the type in C, with their types in TypeScript. */
export const kindsOfCalls = {
  pair_filter: "(shapeA: Shape, shapeB: Shape) => boolean",
  contact_callback: "(contact: ContactEdit) => void",
  velocity_function: "(edit: VelocityEdit) => void",
  position_function: "(edit: PositionEdit) => void",
  accept: "(shape: Shape) => boolean",
  shape_visitor: "(shape: Shape) => boolean | void",
  ray_visitor: "(hit: RayHit) => boolean | void",
  recording_sink: "(bytes: Uint8Array) => void",
  after_step: "() => void",
  log_function: "(level: number, text: string) => void",
  failure_function: "(what: string) => void",
};

/** Structures that the library passes to such functions, with the members that these may set. */
export const settableMembers = {
  fettle_contact_edit: ["friction", "restitution", "surface_speed", "enabled", "ignored"],
  fettle_velocity_edit: ["velocity", "angular_velocity"],
  fettle_position_edit: ["pose"],
};

/** The functions with their plans; `without` are those that are left out. */
export function plansOf(headers) {
  checkJointTypes(headers);
  const plans = [], without = [], reasons = new Set(leftOut.keys());
  for (const fn of headers.functions) {
    const reason = [...leftOut.keys()].find((names) => names.test(fn.name));
    reasons.delete(reason);
    if (reason) without.push(fn.name);
    else if (!byHand.test(fn.name)) plans.push(planOf(fn, headers));
  }
  if (reasons.size) throw new Error(`no function of the headers has these names: ${[...reasons].join(", ")}`);
  return { plans, without };
}

function planOf(fn, headers) {
  const bare = fn.name.slice("fettle_".length);
  const params = [...fn.params];
  // The longest prefix: wheel_joint_ and not joint_.
  let owner = classes.filter((c) => bare.startsWith(c.prefix)).sort((a, b) => b.prefix.length - a.prefix.length)[0];
  if (owner && params[0]?.type !== "fettle_world") owner = undefined;
  const plan = { fn, owner: owner?.name, inputs: [], outputs: [], arguments: [], returns: fn.result };
  if (owner) {
    plan.arguments.push(owner.name === "World" ? "this.pointer" : "this.world.pointer");
    params.shift();
    if (owner.id) {
      plan.arguments.push("this.id");
      params.shift();
    }
    if (owner.name === "Mover") {
      plan.arguments.push("...mover");  // the addresses of its definition and of its state
      params.splice(0, 2);
    }
  }
  plan.bare = owner ? bare.slice(owner.prefix.length) : bare;
  while (params.length) take(params, plan, headers);
  // A filter is the last argument, since it can be left out.
  plan.inputs.sort((a, b) => (a.kind === "function" ? 0 : /_filter$/.test(a.type)) - (b.kind === "function" ? 0 : /_filter$/.test(b.type)));
  plan.name = camel(plan.bare);
  plan.result = resultOf(plan);
  const setter = plan.bare.match(/^set_(\w+)$/);
  if (owner && setter && plan.inputs.length === 1 && !plan.result) {
    plan.sets = camel(setter[1]);
    if (plan.inputs[0].kind === "vec2") plan.inputs[0].name = plan.sets;
  }
  const makes = plan.outputs.some((output) => output.kind === "world");
  if (owner && owner.name !== "Mover" && plan.inputs.length === 0 && plan.result && fn.params[0].constant && !makes) plan.gets = plan.name;
  return plan;
}

/** Removes the first parameters in C from `params`: those that make one argument or one result in JavaScript. */
function take(params, plan, headers) {
  const [a, b, c] = params;
  const input = (count, kind, more = {}) => {
    params.splice(0, count);
    plan.inputs.push({ kind, name: camel(a.name), type: a.type, ...more });
    plan.arguments.push(plan.inputs.at(-1));
  };
  const output = (count, kind, more = {}) => {
    params.splice(0, count);
    plan.outputs.push({ kind, name: camel(a.name), type: a.type, ...more });
    plan.arguments.push(plan.outputs.at(-1));
  };
  const scalar = ["float", "bool", "int32_t", "uint32_t", "uint64_t", "size_t"].includes(a.type);
  if (headers.callbacks.has(a.type)) {
    if (b?.name !== "user" || !kindsOfCalls[a.type.slice("fettle_".length)]) throw new Error(`${plan.fn.name}: there is no code for a ${a.type}`);
    plan.keeps = /^(set_|start_recording|after_step)/.test(plan.bare);
    return input(2, "function", { call: a.type.slice("fettle_".length), ...(a.name === "function" && { name: "called" }) });
  }
  if (b?.name === "room") return output(3, "list", { handle: handleOf(a.name, plan.fn.name) });
  if (a.type === "void" && a.pointer === 2) return output(2, "bytes");
  if (a.type === "void") return input(2, "bytes");
  if (a.type === "char" && a.pointer === 2) return output(1, "text");
  if (a.type === "char" && a.constant) return input(1, "text");
  if (a.type === "fettle_world") return a.pointer === 2 ? output(1, "world") : input(1, "world");
  if (a.constant && a.pointer === 1 && b && /count$/.test(b.name)) return input(2, "array");
  if (a.pointer === 0 && a.type === "float" && b?.type === "float" && /(^|_)x$/.test(a.name) && /(^|_)y$/.test(b.name)) {
    input(2, "vec2");
    plan.inputs.at(-1).name = camel(a.name.replace(/_?x$/, "")) || nameOfPoint(plan.fn.name);
    return;
  }
  if (a.pointer === 0 && a.type === "fettle_id") return input(1, "id", { handle: handleOf(a.name) });
  if (a.pointer === 0) return input(1, "scalar");
  if (a.constant) return input(1, scalar ? "optional" : "struct");
  if (a.type === "bool" && /^(is_set|found)$/.test(a.name)) {
    params.shift();
    plan.arguments.push({ kind: "flag" });
    plan.maybe = true;
    return;
  }
  if (a.type === "fettle_id") return output(1, "id", { handle: handleOf(a.name) });
  return output(1, scalar ? "scalar" : "struct");
}

function nameOfPoint(name) {
  return name.match(/apply_(\w+?)(_at)?$/)?.[1] ?? (/vector/.test(name) ? "vector" : "point");
}

/** undefined, one output, or several as an object. */
function resultOf(plan) {
  if (plan.returns !== "fettle_code") return { direct: plan.returns };
  if (plan.outputs.length === 0) return undefined;
  return plan.outputs.length === 1 ? plan.outputs[0] : { several: plan.outputs };
}

/** The properties of a mover: members of its definition and of its state, with the structure that has them. A height is changed only where
    there is room for it, by setHeight; what the moves find is only read. The position is in runtime.js. */
export function moverProperties(structs) {
  const of = (struct, isSet) => structs.get(struct).members
    .filter((member) => member.name !== "size" && member.name !== "position")
    .map((member) => ({ ...member, from: struct === "fettle_mover_def" ? "def" : "state", isSet: isSet(member.name) }));
  return [...of("fettle_mover_def", (name) => name !== "height"), ...of("fettle_mover_state", (name) => name === "climbing")];
}
