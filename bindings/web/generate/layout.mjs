// Where the members of the structures are in the memory of WebAssembly: pointers and size_t have 4 bytes.

const sizes = { fettle_accept: 4, callback: 4, float: 4, bool: 1, int32_t: 4, uint32_t: 4, uint64_t: 8, size_t: 4, fettle_id: 8 };

/** Adds `size`, `align`, and the `offset` of each member. */
export function layOut(structs) {
  for (const struct of structs.values()) {
    let at = 0, most = 1;
    for (const member of struct.members) {
      const { size, align } = sizeOf(member, structs);
      at = roundedUp(at, align);
      member.offset = at;
      member.stride = size;
      at += size * member.count;
      most = Math.max(most, align);
    }
    struct.size = roundedUp(at, most);
    struct.align = most;
  }
}

export function sizeOf({ type, pointer }, structs) {
  if (pointer) return { size: 4, align: 4 };
  if (sizes[type]) return { size: sizes[type], align: sizes[type] };
  const struct = structs.get(type);
  if (!struct) throw new Error(`the size of ${type} is not known`);
  return { size: struct.size, align: struct.align };
}

/** The member with the number of elements: `point_count` for `points`. */
function countOf(member, names) {
  if (!member.pointer && member.count === 1) return undefined;
  return names.get(member.name + "_count") ?? (member.name.endsWith("s") ? names.get(member.name.replace(/s$/, "_count")) : undefined);
}

const roundedUp = (at, align) => Math.ceil(at / align) * align;

/** The members that a program in JavaScript sees; `has` and `counted` name members that others stand for. */
export function visibleMembers(struct) {
  const names = new Map(struct.members.map((member) => [member.name, member]));
  const counts = new Set(struct.members.filter((member) => member.pointer || member.count > 1).map((member) => countOf(member, names)));
  const seen = [];
  for (const member of struct.members) {
    if (member.type === "callback" || member.type === "void") continue;
    if (member.name === "size" && struct.members[0] === member) continue;
    if (names.has(member.name.replace(/^has_/, "")) && member.name.startsWith("has_")) continue;
    if (counts.has(member)) continue;
    seen.push({ ...member, has: names.get("has_" + member.name), counted: countOf(member, names) });
  }
  return seen;
}
