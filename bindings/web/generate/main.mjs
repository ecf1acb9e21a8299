// Makes the files of the package that follow from the headers in C.
//
//   node main.mjs INCLUDE PACKAGE EXPORTS CALLED KNOWN    EXPORTS: the file that gets the names that the linker exports; CALLED:
//                                            the source of the functions that the library calls; KNOWN: their names for the linker

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { calledCode, interfaceCode, knownCode } from "./code.mjs";
import { readHeaders } from "./headers.mjs";
import { layOut } from "./layout.mjs";
import { plansOf } from "./shape.mjs";
import { typesCode } from "./types.mjs";

const [include, folder, exportsFile, calledFile, knownFile] = process.argv.slice(2);
const headers = readHeaders(include);
layOut(headers.structs);
const { plans, without } = plansOf(headers);
const byHand = readFileSync(new URL("by_hand.d.ts", import.meta.url), "utf8");
writeFileSync(join(folder, "interface.js"), interfaceCode(headers, plans));
writeFileSync(join(folder, "index.d.ts"), typesCode(headers, plans, byHand));
const called = headers.functions.map((fn) => fn.name).filter((name) => !without.includes(name));
writeFileSync(exportsFile, ["malloc", "free", "fettle_called", ...called].map((name) => "_" + name).join("\n") + "\n");
writeFileSync(calledFile, calledCode(headers));
writeFileSync(knownFile, knownCode(headers));
console.log(`${headers.functions.length} functions, of which ${without.length} are left out`);
