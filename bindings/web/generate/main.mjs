// Makes the files of the package that follow from the headers in C.
//
//   node main.mjs INCLUDE PACKAGE EXPORTS    EXPORTS: the file that gets the names that the linker exports

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { interfaceCode } from "./code.mjs";
import { readHeaders } from "./headers.mjs";
import { layOut } from "./layout.mjs";
import { plansOf } from "./shape.mjs";
import { typesCode } from "./types.mjs";

const [include, folder, exportsFile] = process.argv.slice(2);
const headers = readHeaders(include);
layOut(headers.structs);
const { plans, without } = plansOf(headers);
const byHand = readFileSync(new URL("by_hand.d.ts", import.meta.url), "utf8");
writeFileSync(join(folder, "interface.js"), interfaceCode(headers, plans));
writeFileSync(join(folder, "index.d.ts"), typesCode(headers, plans, byHand));
const called = headers.functions.map((fn) => fn.name).filter((name) => !without.includes(name));
writeFileSync(exportsFile, ["malloc", "free", ...called].map((name) => "_" + name).join("\n") + "\n");
console.log(`${headers.functions.length} functions, of which ${without.length} take functions and are left out`);
