#include <utility>

#include "cells.h"
#include "reader.h"

namespace fettle::maps {

using property::Vec2;

namespace {

std::vector<Vec2> points_of(const Place& place, const char* key) {
    std::vector<Vec2> points;
    for (const Json& one : place.list(key)) {
        const Place point = place.at(one);
        if (!one.is_object()) place.fail("a point is not an object");
        points.emplace_back(point.number("x", 0), point.number("y", 0));
    }
    return points;
}

void read_kind(const Place& place, Object& object) {
    if (place.has("gid")) {
        object.kind = ObjectKind::tile;
        object.tile = cell_of(static_cast<std::uint32_t>(place.integer("gid", 0, 0, UINT32_MAX)));
    } else if (place.boolean("point", false)) {
        object.kind = ObjectKind::point;
    } else if (place.boolean("ellipse", false)) {
        object.kind = ObjectKind::ellipse;
    } else if (place.has("polygon")) {
        object.kind = ObjectKind::polygon;
        object.points = points_of(place, "polygon");
    } else if (place.has("polyline")) {
        object.kind = ObjectKind::polyline;
        object.points = points_of(place, "polyline");
    } else if (place.has("text")) {
        object.kind = ObjectKind::text;
        object.text = place.at(place.json["text"]).text("text");
    }
}

}  // namespace

/// An object takes all fields that it does not have itself from its template.
Object Reader::object(const Place& outer) {
    if (!outer.json.is_object()) outer.fail("an object is not an object of JSON");
    Json json = outer.json;
    Properties inherited;
    if (const std::string file = outer.text("template"); !file.empty()) {
        const Json& base = object_template(outer, beside(file_, file));
        inherited = Place{outer.file, base, outer.what}.properties();
        Json whole = base;
        whole.update(json);
        json = std::move(whole);
    }
    Object object;
    object.name = outer.at(json).text("name");
    object.id = outer.at(json).integer("id", 0, 0, INT64_MAX);
    const Place place{
        outer.file, json,
        outer.what + (outer.what.empty() ? "object " : ", object ") + std::to_string(object.id)};
    object.class_name = place.text("class", place.text("type"));
    object.position = Vec2(place.number("x", 0), place.number("y", 0));
    object.size = Vec2(place.number("width", 0), place.number("height", 0));
    object.rotation = place.number("rotation", 0);
    object.visible = place.boolean("visible", true);
    object.properties = place.properties();
    object.properties.merge(inherited);  // those of the object itself stay
    read_kind(place, object);
    return object;
}

const Json& Reader::object_template(const Place& place, const std::string& file) {
    const auto known = templates_.find(file);
    if (known != templates_.end()) return known->second;
    const Json document = read_part(place.file, file);
    if (!document.is_object() || !document.contains("object") || !document["object"].is_object())
        fail(file, "this is not a template of an object");
    Json object = document["object"];
    if (object.contains("template")) fail(file, "a template may not use another one");
    if (object.contains("gid") && document.contains("tileset")) {
        // The number of the tile counts from the first one of the template's own tileset.
        const Place tileset{file, document["tileset"], "tileset"};
        const std::uint32_t flips_and_gid = static_cast<std::uint32_t>(
            Place{file, object, "object"}.integer("gid", 0, 0, UINT32_MAX));
        const std::int64_t first = tileset.integer("firstgid", 1, 1, 0x0fffffff);
        const std::uint32_t in_map = first_gid_of(place, tileset.json, file);
        const std::int64_t gid = (flips_and_gid & 0x0fffffffu) - first + in_map;
        if (gid < 0 || gid > 0x0fffffff) fail(file, "\"gid\" is not a tile of the tileset");
        object["gid"] = (flips_and_gid & 0xf0000000u) | static_cast<std::uint32_t>(gid);
    }
    return templates_[file] = std::move(object);
}

/// The first number in the map of the tileset of a template. The editor adds such a tileset to the
/// map, but not to a map that it exports with embedded tilesets.
std::uint32_t Reader::first_gid_of(const Place& place, const Json& tileset, const std::string& in) {
    const std::string source = Place{in, tileset, "tileset"}.text("source");
    const auto found = first_gids_.find(beside(in, source));
    if (found != first_gids_.end()) return found->second;
    if (next_gid_ == 0)
        place.fail("the map has no tileset \"" + source + "\", which " + in + " uses");
    Json added = tileset;
    added["firstgid"] = std::exchange(next_gid_, 0);
    map_.tilesets.push_back(this->tileset(Place{in, added, "tileset"}, in));
    end_of_tilesets();
    return map_.tilesets.back().first_gid;
}

}  // namespace fettle::maps
