// Reads the headers in C: enumerations, structures and functions, each with its comment.

import { readFileSync } from "node:fs";
import { join } from "node:path";

/** All that fettle_physics.h declares, in its order. */
export function readHeaders(folder) {
  const umbrella = readFileSync(join(folder, "fettle_physics.h"), "utf8");
  const found = { enums: [], structs: new Map(), functions: [], callbacks: new Map() };
  for (const [, file] of umbrella.matchAll(/#include <(fettle\/physics_c\/\w+\.h)>/g))
    readHeader(inSinglePrecision(readFileSync(join(folder, file), "utf8")), found);
  return found;
}

/** What position.h says of the two types. */
const inSinglePrecision = (text) => text.replace(/\bfettle_position\b/g, "fettle_vec2").replace(/\bfettle_coordinate\b/g, "float");

function readHeader(text, found) {
  text = text.replace(/^\/\*[^]*?\*\/|\/\* ---[^]*?\*\//g, "");  // what the whole header and its sections are about
  text = text.replace(/^#.*$/gm, "").replace(/\bFETTLE_PHYSICS_C_(BEGIN|END)\b/g, "");
  // A declaration ends with the first semicolon outside of braces and comments.
  const declaration = /\s*(?:\/\*((?:[^*]|\*(?!\/))*)\*\/\s*)?((?:\/\*(?:[^*]|\*(?!\/))*\*\/|\{(?:\/\*(?:[^*]|\*(?!\/))*\*\/|[^{}])*\}|[^;{}])*?);/gy;
  for (const [, comment, body] of text.matchAll(declaration)) declare(body, docOf(comment), found);
}

function declare(body, doc, found) {
  const plain = body.replace(/\/\*[^]*?\*\//g, "").replace(/\s+/g, " ").trim();
  let match;
  if ((match = plain.match(/^enum fettle_(\w+) \{(.*)\}$/))) {
    const values = [...match[2].matchAll(/FETTLE_(\w+) = (\d+)/g)].map(([, name, value]) => ({ name, value: Number(value) }));
    found.enums.push({ name: match[1], values, doc });
  } else if ((match = plain.match(/^typedef struct (fettle_\w+) \{(.*)\} \w+$/))) {
    found.structs.set(match[1], { name: match[1], members: membersOf(body), doc });
  } else if ((match = plain.match(/^typedef (.*?) ?\(\*(fettle_\w+)\)\((.*)\)$/))) {
    found.callbacks.set(match[2], { result: match[1], params: match[3] });
  } else if ((match = plain.match(/^(?!typedef)(.*?)\b(fettle_\w+)\((.*)\)$/))) {
    const params = match[3] === "void" ? [] : match[3].split(",").map(typed);
    found.functions.push({ name: match[2], result: match[1].replace(/\s/g, ""), params, doc });
  }
}

/** The members of a structure; those on one line have the same comment. */
function membersOf(body) {
  const inside = body.slice(body.indexOf("{") + 1, body.lastIndexOf("}"));
  const members = [];
  for (const [, code, comment] of inside.matchAll(/\s*(?:\/\*(?:[^*]|\*(?!\/))*\*\/\s*)?([^;/]+);[ \t]*(?:\/\*((?:[^*]|\*(?!\/))*)\*\/)?/g)) {
    const plain = code.replace(/\/\*[^]*?\*\//g, "").replace(/\s+/g, " ").trim();
    const doc = docOf(comment);
    const call = plain.match(/^(.*?) ?\(\*(\w+)\)\((.*)\)$/);
    if (call) {
      members.push({ name: call[2], type: "callback", pointer: 1, count: 1, doc, result: call[1], params: call[3] });
      continue;
    }
    const [first, ...others] = plain.split(",");
    const { name, ...type } = typed(first);
    for (const one of [name, ...others.map((other) => other.trim())]) {
      const [, base, count] = one.match(/^(\w+)(?:\[(\d+)\])?$/);
      members.push({ ...type, name: base, count: Number(count ?? 1), doc });
    }
  }
  return members;
}

/** "const fettle_vec2* points" as { type, pointer, constant, name }. */
function typed(text) {
  const parts = text.trim().match(/^(const )?(\w+)((?: ?\*(?: const)?)*) ?(\w+(?:\[\d+\])?)$/);
  if (!parts) throw new Error(`not understood in the headers: ${text.trim()}`);
  const [, constant, type, stars, name] = parts;
  return { name, type, pointer: (stars.match(/\*/g) ?? []).length, constant: Boolean(constant) };
}

function docOf(comment) {
  return (comment ?? "").replace(/^[*!]/, "").replace(/\n\s*\*? ?/g, " ").replace(/\s+/g, " ").trim();
}
