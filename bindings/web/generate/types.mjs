// Writes index.d.ts: the same classes and structures for TypeScript, with the comments of the headers.

import { camel, classes, handleOf, kindsOfCalls, moverProperties, pascal, settableMembers } from "./shape.mjs";
import { visibleMembers } from "./layout.mjs";
import { prefixOf } from "./code.mjs";

const scalars = { float: "number", bool: "boolean", int32_t: "number", uint32_t: "number", size_t: "number", uint64_t: "bigint", fettle_id: "Body" };
const nameOf = (type) => pascal(type.replace(/^fettle_/, ""));
const docOf = (doc, indent = "") => (doc ? `${indent}/** ${doc.replaceAll("*/", "*\\/")} */\n` : "");

/** The type of a value that is read; of one that is written when `isWritten`. */
function typeOf(type, name, fn, isWritten) {
  if (type === "fettle_id") {
    const handle = handleOf(name, fn);
    return /^body_|_body$|^(body|ground|wall|dropped)$/.test(name) ? `${handle} | null` : handle;
  }
  if (type === "uint64_t" && isWritten) return "bigint | number";
  if (type === "char") return "string";
  if (type === "fettle_accept") return kindsOfCalls.accept.replace(/^(.*)$/, "($1) | null");
  return scalars[type] ?? nameOf(type);
}

function structTypes(struct) {
  const optional = struct.members[0].name === "size";
  const lines = visibleMembers(struct).map((member) => {
    let type = typeOf(member.type, member.name, struct.name, optional);
    if ((member.pointer && member.type !== "char") || member.count > 1) type += "[]";
    if (member.has) type += " | null";
    const needed = member.name === "type" && /geometry|field_def/.test(struct.name);
    return docOf(member.doc, "  ") + `  ${camel(member.name)}${optional && !needed ? "?" : ""}: ${type};\n`;
  });
  return `${docOf(struct.doc)}export interface ${nameOf(struct.name)} {\n${lines.join("")}}\n\n`;
}

/** The class of a structure that a function of the program gets. */
function editTypes(struct) {
  const lines = visibleMembers(struct).map(({ name, type, doc }) => `${docOf(doc, "  ")}  ${settableMembers[struct.name].includes(name) ? "" : "readonly "}${camel(name)}: ${typeOf(type, name, struct.name)};\n`);
  return `${docOf(struct.doc)}export declare class ${nameOf(struct.name)} {\n  protected constructor();\n${lines.join("")}}\n\n`;
}

function inputType(input) {
  switch (input.kind) {
    case "scalar": return input.type === "uint64_t" ? "bigint | number" : scalars[input.type];
    case "vec2": return "Vec2";
    case "id": return `${input.handle} | null`;
    case "world": return "World";
    case "bytes": return "Uint8Array";
    case "text": return "string";
    case "array": return `readonly ${typeOf(input.type, input.name, "", true)}[]`;
    case "function": return kindsOfCalls[input.call];
    case "optional": return `${scalars[input.type]} | null`;
    default: return nameOf(input.type);
  }
}
// Definitions, filters and what may be null in C can be left out at the end.
const maybe = (input) => input.kind === "struct" && /_def$|_filter$/.test(input.type) && !/mouse_joint_def|field_def/.test(input.type);
const nullable = (input, plan) => (input.kind === "function" && /^set_/.test(plan.bare)) || input.kind === "struct" && /^set_(center|bounds)$/.test(plan.bare);

function outputType(output, fn) {
  if (output.kind === "list") return `${output.type === "fettle_id" ? output.handle : typeOf(output.type, output.name, fn)}[]`;
  if (output.kind === "bytes") return "Uint8Array";
  if (output.kind === "text") return "string";
  if (output.kind === "world") return "World";
  if (output.kind === "id") return output.name === "body" || /^body[AB]$/.test(output.name) ? (/create/.test(fn) ? "Body" : "Body | null") : output.handle;
  return typeOf(output.type, output.name, fn);
}

function resultType(plan) {
  const joint = plan.bare.match(/^create_(\w+_joint)$/);
  if (joint) return pascal(joint[1]);
  if (!plan.result) return "void";
  if (plan.result.direct) return { "constchar*": "string", bool: "boolean" }[plan.result.direct] ?? "number";
  const one = plan.result.several ? `{ ${plan.result.several.map((o) => `${o.name}: ${outputType(o, plan.fn.name)}`).join("; ")} }` : outputType(plan.result, plan.fn.name);
  return plan.maybe ? `${one} | null` : one;
}

function parameters(plan) {
  return plan.inputs.map((input) => {
    const plain = inputType(input), type = nullable(input, plan) ? (input.kind === "function" ? `(${plain}) | null` : `${plain} | null`) : plain;
    return `${input.name}${maybe(input) ? "?" : ""}: ${type}`;
  }).join(", ");
}

function member(plan, own) {
  const doc = docOf(plan.fn.doc, "  ");
  if (plan.gets) {
    const set = own.find((other) => other.sets === plan.gets);
    return doc + `  get ${plan.gets}(): ${resultType(plan)};\n` + (set ? `  set ${plan.gets}(${parameters(set)});\n` : "");
  }
  if (plan.sets && own.some((other) => other.gets === plan.sets)) return "";
  return doc + `  ${plan.name}(${parameters(plan)}): ${resultType(plan)};\n`;
}

function property({ name, type, doc, isSet }) {
  const get = `${docOf(doc, "  ")}  get ${camel(name)}(): ${typeOf(type, name, "")};\n`;
  return isSet ? `${get}  set ${camel(name)}(value: ${typeOf(type, name, "", type !== "uint64_t")});\n` : get;
}

export function typesCode(headers, plans, byHand) {
  let code = "// Made from the headers in C by bindings/web/generate; what is changed here is lost.\n\n" + byHand;
  for (const enumeration of headers.enums.filter((e) => e.name !== "codes")) {
    const common = prefixOf(enumeration.values);
    code += docOf(enumeration.doc) + `export declare const ${pascal(enumeration.name)}: {\n${enumeration.values.map((v) => `  readonly ${v.name.slice(common.length)}: ${v.value};\n`).join("")}};\n\n`;
  }
  for (const struct of headers.structs.values()) if (struct.name !== "fettle_columns") code += settableMembers[struct.name] ? editTypes(struct) : structTypes(struct);
  for (const cls of classes) {
    const own = plans.filter((plan) => plan.owner === cls.name);
    const base = cls.base ?? (cls.id ? "Handle" : "WorldBase");
    const properties = cls.name === "Mover" ? moverProperties(headers.structs).map(property) : [];
    code += `export declare class ${cls.name} extends ${base} {\n${properties.join("")}${own.map((plan) => member(plan, own)).join("")}}\n\n`;
  }
  for (const plan of plans.filter((p) => !p.owner)) code += docOf(plan.fn.doc) + `export declare function ${plan.name}(${parameters(plan)}): ${resultType(plan)};\n`;
  return code;
}
