// Maps of the Tiled editor, as JSON and as XML.

#include <catch.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <fettle/maps/map.h>
#include <fettle/property/error.h>

#include "temporary_folder.h"

namespace map_test {

namespace fs = std::filesystem;

using namespace fettle::maps;
using fettle::property::Color;
using fettle::property::Value;
using fettle::property::Vec2;

namespace {

using Files = std::map<std::string, std::string>;

Map read(const Files& files, const std::string& name) {
    return read_map(name, [&](const std::string& file) {
        const auto found = files.find(file);
        if (found == files.end()) throw std::runtime_error("no file " + file);
        return found->second;
    });
}

/// A map of two by two cells, of which the last one is flipped.
const std::string json = R"({
 "type":"map", "version":"1.10", "orientation":"orthogonal", "renderorder":"right-down",
 "width":2, "height":2, "tilewidth":16, "tileheight":8, "infinite":false, "backgroundcolor":"#80ff0000",
 "properties":[{"name":"gravity","type":"float","value":-3.5},{"name":"music","type":"file","value":"song.ogg"},
   {"name":"boss","type":"class","propertytype":"Boss","value":{"lives":3,"name":"Ogre"}}],
 "tilesets":[{"firstgid":1,"source":"../tiles/ground.tsj"}],
 "layers":[
  {"type":"tilelayer","id":1,"name":"ground","x":0,"y":0,"width":2,"height":2,"opacity":0.5,"visible":true,
   "parallaxx":0.5,"offsety":4,"data":[1,2,0,3221225473]},
  {"type":"group","id":2,"name":"things","layers":[
   {"type":"objectgroup","id":3,"name":"enemies","objects":[
     {"id":7,"name":"guard","type":"Enemy","x":8,"y":4,"width":16,"height":16,"rotation":90,
      "properties":[{"name":"speed","type":"int","value":4},{"name":"color","type":"color","value":"#ff0000ff"},
        {"name":"target","type":"object","value":9},{"name":"angry","type":"bool","value":true}]},
     {"id":8,"name":"way","class":"Path","x":0,"y":0,"polyline":[{"x":0,"y":0},{"x":16,"y":-8}]},
     {"id":9,"name":"","x":1,"y":2,"point":true},
     {"id":10,"name":"chest","x":0,"y":16,"width":16,"height":8,"gid":2147483650}]}]},
  {"type":"imagelayer","id":4,"name":"sky","image":"sky.png","repeatx":true}]})";

const std::string tileset =
    R"({"type":"tileset","name":"ground","tilewidth":16,"tileheight":8,"tilecount":4,"columns":2,
 "spacing":1,"margin":2,"image":"ground.png","imagewidth":37,"imageheight":21,
 "tiles":[{"id":1,"type":"Grass","animation":[{"tileid":1,"duration":100},{"tileid":2,"duration":250}],
   "objectgroup":{"objects":[{"id":1,"x":0,"y":4,"width":16,"height":4}]},
   "properties":[{"name":"slippery","type":"bool","value":true}]}]})";

const std::string xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" orientation="orthogonal" renderorder="right-down" width="2" height="2" tilewidth="16" tileheight="8"
  infinite="0" backgroundcolor="#80ff0000">
 <properties>
  <property name="gravity" type="float" value="-3.5"/>
  <property name="music" type="file" value="song.ogg"/>
  <property name="boss" type="class" propertytype="Boss">
   <properties><property name="lives" type="int" value="3"/><property name="name" value="Ogre"/></properties>
  </property>
 </properties>
 <tileset firstgid="1" source="../tiles/ground.tsx"/>
 <layer id="1" name="ground" width="2" height="2" opacity="0.5" parallaxx="0.5" offsety="4">
  <data encoding="csv">
1,2,
0,3221225473
</data>
 </layer>
 <group id="2" name="things">
  <objectgroup id="3" name="enemies">
   <object id="7" name="guard" type="Enemy" x="8" y="4" width="16" height="16" rotation="90">
    <properties>
     <property name="speed" type="int" value="4"/>
     <property name="color" type="color" value="#ff0000ff"/>
     <property name="target" type="object" value="9"/>
     <property name="angry" type="bool" value="true"/>
    </properties>
   </object>
   <object id="8" name="way" class="Path" x="0" y="0"><polyline points="0,0 16,-8"/></object>
   <object id="9" x="1" y="2"><point/></object>
   <object id="10" name="chest" gid="2147483650" x="0" y="16" width="16" height="8"/>
  </objectgroup>
 </group>
 <imagelayer id="4" name="sky" repeatx="1"><image source="sky.png" width="64" height="64"/></imagelayer>
</map>)";

const std::string xml_tileset =
    R"(<tileset version="1.10" name="ground" tilewidth="16" tileheight="8" spacing="1" margin="2"
  tilecount="4" columns="2">
 <image source="ground.png" width="37" height="21"/>
 <tile id="1" type="Grass">
  <properties><property name="slippery" type="bool" value="true"/></properties>
  <objectgroup draworder="index"><object id="1" x="0" y="4" width="16" height="4"/></objectgroup>
  <animation><frame tileid="1" duration="100"/><frame tileid="2" duration="250"/></animation>
 </tile>
</tileset>)";

const Files files = {{"maps/a.tmj", json},
                     {"maps/a.tmx", xml},
                     {"tiles/ground.tsj", tileset},
                     {"tiles/ground.tsx", xml_tileset}};

/// A map with one layer of the given members.
std::string map_of(const std::string& members) {
    return R"({"width":2,"height":2,"tilewidth":16,"tileheight":16,"layers":[{"type":"tilelayer","name":"g","width":2,"height":2,)" +
           members + "}]}";
}

std::vector<std::uint32_t> gids(const Map& map) {
    std::vector<std::uint32_t> all;
    for (const Cells& cells : map.layers.at(0).cells)
        for (const Cell& cell : cells.cells) all.push_back(cell.gid);
    return all;
}

}  // namespace

TEST_CASE("a map has layers and tilesets and objects with their properties") {
    for (const std::string name : {"maps/a.tmj", "maps/a.tmx"}) {
        CAPTURE(name);
        const Map map = read(files, name);
        CHECK(map.width == 2);
        CHECK(map.tile_height == 8);
        CHECK(map.background.a == Approx(128 / 255.0));
        CHECK(map.properties.at("gravity") == Value(-3.5));
        CHECK(map.properties.at("music") == Value("song.ogg"));
        CHECK(map.properties.at("boss.lives") == Value(3));
        CHECK(map.properties.at("boss.name") == Value("Ogre"));

        REQUIRE(map.tilesets.size() == 1);
        const Tileset& ground = map.tilesets[0];
        CHECK(ground.image == "tiles/ground.png");
        CHECK(ground.columns == 2);
        CHECK(ground.margin == 2);
        CHECK(map.tileset_of(4) == &ground);
        CHECK(map.tileset_of(5) == nullptr);
        const Tile* const grass = map.tile(2);
        REQUIRE(grass != nullptr);
        CHECK(map.tile(1) == nullptr);
        CHECK(grass->class_name == "Grass");
        CHECK(grass->animation.at(1).seconds == Approx(0.25));
        CHECK(grass->collision.at(0).size == Vec2(16, 4));
        CHECK(grass->properties.at("slippery") == Value(true));

        REQUIRE(map.layers.size() == 3);
        const Layer& layer = map.layers[0];
        CHECK(layer.kind == LayerKind::tiles);
        CHECK(layer.opacity == 0.5);
        CHECK(layer.parallax == Vec2(0.5, 1));
        CHECK(layer.offset == Vec2(0, 4));
        CHECK(gids(map) == std::vector<std::uint32_t>{1, 2, 0, 1});
        CHECK(layer.cells[0].cells[3] ==
              Cell{.gid = 1, .flip_x = true, .flip_y = true, .flip_diagonal = false});

        REQUIRE(map.layers[1].layers.size() == 1);
        const std::vector<Object>& objects = map.layers[1].layers[0].objects;
        REQUIRE(objects.size() == 4);
        CHECK(objects[0].class_name == "Enemy");
        CHECK(objects[0].rotation == 90);
        CHECK(objects[0].properties.at("speed") == Value(4));
        CHECK(objects[0].properties.at("color") == Value(Color{0, 0, 1, 1}));
        CHECK(objects[0].properties.at("target") == Value(9));
        CHECK(objects[0].properties.at("angry") == Value(true));
        CHECK(objects[1].class_name == "Path");
        CHECK(objects[1].kind == ObjectKind::polyline);
        CHECK(objects[1].points == std::vector<Vec2>{{0, 0}, {16, -8}});
        CHECK(objects[2].kind == ObjectKind::point);
        CHECK(objects[3].kind == ObjectKind::tile);
        CHECK(objects[3].tile ==
              Cell{.gid = 2, .flip_x = true, .flip_y = false, .flip_diagonal = false});
        CHECK(map.layers[2].image == "maps/sky.png");
        CHECK(map.layers[2].repeat_x);
    }
}

TEST_CASE("layers of a map without ids can be told apart") {
    std::string text = json;
    for (const char* id : {R"("id":1,"name":"ground")", R"("id":3,"name":"enemies")"})
        text.erase(text.find(id), 7);
    text.replace(text.find(R"("id":4,"name":"sky")"), 6, R"("id":2)");  // that of another layer
    const Map map =
        read({{"levels/one.tmj", text}, {"tiles/ground.tsj", tileset}}, "levels/one.tmj");
    REQUIRE(map.layers.size() == 3);
    CHECK(map.layers[0].id == 1);
    CHECK(map.layers[1].id == 2);
    CHECK(map.layers[1].layers.at(0).id == 3);
    CHECK(map.layers[2].id == 4);
}

TEST_CASE("cells may be compressed and in chunks") {
    // The cells 1 2 3 4, plain and compressed.
    const std::string plain = R"("encoding":"base64","data":" AQAAAAIAAAADAAAABAAAAA==\n ")";
    CHECK(gids(read({{"m", map_of(plain)}}, "m")) == std::vector<std::uint32_t>{1, 2, 3, 4});
    for (const auto& [kind, data] : std::map<std::string, std::string>{
             {"zlib", "eJxjZGBgYAJiZiBmAWIAAGAACw=="},
             {"gzip", "H4sIAAAAAAACA2NkYGBgAmJmIGYBYgDv1AWvEAAAAA=="},
             {"zstd", "KLUv/QRYgQAAAQAAAAIAAAADAAAABAAAAKYUxW4="}}) {
        CAPTURE(kind);
        const std::string members =
            R"("encoding":"base64","compression":")" + kind + R"(","data":")" + data + "\"";
        CHECK(gids(read({{"m", map_of(members)}}, "m")) == std::vector<std::uint32_t>{1, 2, 3, 4});
    }
    const Map infinite =
        read({{"m", map_of(R"("chunks":[{"x":-2,"y":0,"width":2,"height":1,"data":[5,6]},)"
                           R"({"x":0,"y":4,"width":1,"height":1,"data":[7]}])")}},
             "m");
    CHECK(gids(infinite) == std::vector<std::uint32_t>{5, 6, 7});
    CHECK(infinite.layers[0].cells[0].x == -2);
    CHECK(infinite.layers[0].cells[1].y == 4);
}

TEST_CASE("an object has what its template says unless it says otherwise") {
    const std::string object_template =
        R"({"type":"template","tileset":{"firstgid":1,"source":"t.tsj"},
            "object":{"name":"coin","type":"Coin","gid":3,"width":16,"height":16,
                      "properties":[{"name":"value","type":"int","value":10},{"name":"kind","value":"gold"}]}})";
    const std::string map =
        R"({"width":1,"height":1,"tilewidth":16,"tileheight":16,
            "tilesets":[{"firstgid":1,"name":"a","tilecount":100},{"firstgid":101,"source":"t.tsj"}],
            "layers":[{"type":"objectgroup","name":"o","objects":[
              {"id":1,"template":"coin.tj","x":3,"y":4,
               "properties":[{"name":"value","type":"int","value":50}]}]}]})";
    const Map read_one = read({{"m", map},
                               {"coin.tj", object_template},
                               {"t.tsj", R"({"name":"t","tilecount":9,"columns":3})"}},
                              "m");
    const Object& coin = read_one.layers.at(0).objects.at(0);
    CHECK(coin.name == "coin");
    CHECK(coin.class_name == "Coin");
    CHECK(coin.position == Vec2(3, 4));
    CHECK(coin.tile.gid == 103);
    CHECK(coin.properties.at("value") == Value(50));
    CHECK(coin.properties.at("kind") == Value("gold"));
}

/// The editor writes such maps when it exports them with embedded tilesets.
TEST_CASE("the tileset of a template need not be one of the map") {
    const std::string map =
        R"({"width":1,"height":1,"tilewidth":16,"tileheight":16,
            "tilesets":[{"firstgid":1,"name":"t","tilecount":9}],
            "layers":[{"type":"objectgroup","name":"o","objects":[
              {"id":1,"template":"things/coin.tj"},{"id":2,"template":"things/gem.tj"}]}]})";
    const auto thing = [](const char* gid) {
        return R"({"tileset":{"firstgid":1,"source":"../t.tsj"},"object":{"gid":)" +
               std::string(gid) + "}}";
    };
    const Map with = read({{"m", map},
                           {"things/coin.tj", thing("3")},
                           {"things/gem.tj", thing("2147483652")},  // mirrored
                           {"t.tsj", R"({"name":"t","tilecount":9,"columns":3,
                             "tilewidth":8,"tileheight":8,"image":"t.png"})"}},
                          "m");
    REQUIRE(with.tilesets.size() == 2);
    CHECK(with.tilesets[1].image == "t.png");
    const std::vector<Object>& objects = with.layers.at(0).objects;
    CHECK(objects.at(0).tile.gid == 12);
    CHECK(objects.at(1).tile.gid == 13);
    CHECK(objects.at(1).tile.flip_x);
    CHECK(with.tileset_of(12) == &with.tilesets[1]);
}

TEST_CASE("a damaged map is an error with file and place") {
    const auto reason = [](const std::string& text) {
        try {
            read({{"m.tmj", text}}, "m.tmj");
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    CHECK(reason("") == "m.tmj: the file is empty");
    CHECK(reason("[1]") == "m.tmj: this is not a map");
    CHECK(reason(std::string(5'000'000, '[')) == "m.tmj: nested deeper than 256 levels");
    CHECK(reason(R"({"name": ")" + std::string(1000, '[') + R"(\")" + std::string(1000, '{') +
                 "\"}") == "m.tmj: this is not a map: it has no \"tilewidth\" and \"tileheight\"");
    CHECK(reason("{}") == "m.tmj: this is not a map: it has no \"tilewidth\" and \"tileheight\"");
    CHECK(reason(R"({"type":"tileset","tilewidth":8,"tileheight":8})") ==
          "m.tmj: expected a map, got a tileset");
    CHECK(reason("<tileset tilewidth=\"8\" tileheight=\"8\"/>") ==
          "m.tmj: expected a map, got a tileset");
    CHECK_THAT(reason("{\n\"width\":\n]"), contains("m.tmj: line 3, column 1: "));
    CHECK_THAT(reason("<map>\n<layer>\n</map>"), contains("m.tmj: line "));
    CHECK(reason("<html/>") == "m.tmj: expected a map, a tileset or a template, got <html>");
    CHECK(reason(map_of(R"("data":[1,2,3])")) == "m.tmj: layer \"g\": expected 4 cells, got 3");
    CHECK(reason(map_of(R"("data":[1,2,3,-4])")) ==
          "m.tmj: layer \"g\": a cell is not a number of a tile: -4");
    CHECK(reason(map_of(R"("encoding":"base64","data":"!!")")) ==
          "m.tmj: layer \"g\": the data are not base64");
    CHECK(reason(map_of(R"("encoding":"base64","compression":"lzma","data":"AQAA")")) ==
          "m.tmj: layer \"g\": unknown compression \"lzma\": expected zlib, gzip or zstd");
    CHECK(reason(map_of(R"("encoding":"base64","compression":"zlib","data":"eJxjZA==")")) ==
          "m.tmj: layer \"g\": the compressed data are damaged, or not as large as the layer");
    CHECK(reason(map_of(R"("opacity":"loud","data":[1,2,3,4])")) ==
          "m.tmj: layer \"g\": \"opacity\": expected a number, got \"loud\"");
    CHECK(
        reason(
            R"({"width":1,"height":1,"tilewidth":1,"tileheight":1,"layers":[{"type":"tilelayer","name":"g",)"
            R"("width":65536,"height":65536,"data":[]}]})") ==
        "m.tmj: layer \"g\": more than 16777216 cells");
    CHECK(
        reason(
            R"({"width":1,"height":1,"tilewidth":1,"tileheight":1,"layers":[{"type":"sound"}]})") ==
        "m.tmj: layer \"\": unknown type \"sound\"");
    CHECK(reason(R"({"width":1e99,"tilewidth":1,"tileheight":1})") ==
          "m.tmj: \"width\": expected an integer from 0 to 65536, got 1e+99");
}

TEST_CASE("a tileset of an early version has the tiles that its image has room for") {
    const std::string old =
        R"(<map width="1" height="1" tilewidth="8" tileheight="8"><tileset firstgid="1" name="old" tilewidth="8" tileheight="8"
           spacing="2" margin="1"><image source="a.png" width="40" height="22"/></tileset></map>)";
    const Map map = read({{"m.tmx", old}}, "m.tmx");
    CHECK(map.tilesets.at(0).columns == 4);
    CHECK(map.tilesets.at(0).count == 8);
    CHECK(map.tileset_of(8) != nullptr);
    CHECK(map.tileset_of(9) == nullptr);
}

Map read_from_disk(const std::string& file) {
    return read_map(file, [](const std::string& name) {
        std::ifstream in(name, std::ios::binary);
        if (!in) throw std::runtime_error("no file " + name);
        return std::string(std::istreambuf_iterator<char>(in), {});
    });
}

/// The maps in a folder and in those below it.
std::vector<std::string> maps_below(const fs::path& folder) {
    std::vector<std::string> maps;
    std::error_code none;
    for (fs::recursive_directory_iterator it(folder, none), end; !none && it != end; ++it)
        if (it->path().extension() == ".tmx" || it->path().extension() == ".tmj")
            maps.push_back(it->path().string());
    std::sort(maps.begin(), maps.end());
    return maps;
}

/// Name and tile of a tileset: the editor counts the tiles of a map anew when it writes it.
void write(std::ostream& out, const Map& map, const Cell& cell) {
    if (cell.empty()) return;
    const Tileset* const set = map.tileset_of(cell.gid);
    REQUIRE(set != nullptr);
    out << set->name << ' ' << cell.gid - set->first_gid << cell.flip_x << cell.flip_y
        << cell.flip_diagonal;
}

void write(std::ostream& out, const Map& map, const std::vector<Layer>& layers) {
    for (const Layer& layer : layers) {
        out << "\nlayer " << layer.name << ' ' << layer.visible << layer.opacity << layer.offset.x
            << ' ' << layer.offset.y << layer.properties.size();
        for (const Cells& cells : layer.cells) {
            out << "\n" << cells.x << ' ' << cells.y << ' ' << cells.width << ": ";
            for (const Cell& cell : cells.cells) {
                write(out, map, cell);
                out << ',';
            }
        }
        for (const Object& object : layer.objects) {
            out << "\nobject " << object.name << object.class_name << ' ' << object.position.x
                << ' ' << object.position.y << ' ' << object.size.x << ' ' << object.size.y
                << object.points.size() << object.properties.size() << ' ';
            write(out, map, object.tile);
        }
        write(out, map, layer.layers);
    }
}

/// All that a game sees of a map, as text.
std::string content(const Map& map) {
    std::ostringstream out;
    out << map.width << 'x' << map.height << map.infinite << map.properties.size();
    write(out, map, map.layers);
    return out.str();
}

const fs::path examples = "/usr/share/doc/tiled/examples";

/// The editor's own examples, where its package is installed.
TEST_CASE("the maps that come with the editor are read") {
    const std::vector<std::string> maps = maps_below(examples);
    if (maps.empty()) WARN("skipped: Tiled is not installed, or its examples are not");
    for (const std::string& file : maps) {
        CAPTURE(file);
        const Map map = read_from_disk(file);
        CHECK(map.width > 0);
        CHECK_FALSE(map.layers.empty());
        CHECK_FALSE(content(map).empty());
    }
}

TEST_CASE("a map that the command line of the editor converts has the same content") {
    if (std::system("command -v tiled >/dev/null") != 0) {
        WARN("skipped: Tiled is not installed");
        return;
    }
    std::vector<std::string> maps = maps_below("scripts");
    const std::vector<std::string> of_editor = maps_below(examples);
    REQUIRE(maps.size() > 1);
    maps.insert(maps.end(), of_editor.begin(), of_editor.end());
    const TemporaryFolder folder;
    for (const std::string& file : maps) {
        const std::string before = content(read_from_disk(file));
        for (const std::string options :
             {"json", "tmx", "--embed-tilesets json", "--embed-tilesets --detach-templates tmx"}) {
            CAPTURE(file, options);
            const std::string as = options.ends_with("json") ? "map.tmj" : "map.tmx";
            const std::string converted = (folder.path / as).string();
            const std::size_t format = options.rfind(' ') + 1;
            const std::string command =
                "QT_QPA_PLATFORM=offscreen tiled " + options.substr(0, format) + "--export-map " +
                options.substr(format) + " '" + file + "' '" + converted + "' 2>/dev/null";
            REQUIRE(std::system(command.c_str()) == 0);
            CHECK(content(read_from_disk(converted)) == before);
        }
    }
}

TEST_CASE("random damage to a map never does more than raise an error") {
    std::uint32_t seed = 1;
    const auto next = [&seed] { return seed = seed * 1664525u + 1013904223u; };
    int errors = 0;
    for (int round = 0; round < 3000; ++round) {
        Files damaged = files;
        for (auto& [name, text] : damaged) {
            for (std::uint32_t i = next() >> 30; i-- > 0;)
                text[next() % text.size()] = static_cast<char>(next() >> 24);
            if (next() % 8 == 0) text.resize(next() % text.size());
        }
        try {
            read(damaged, round % 2 == 0 ? "maps/a.tmj" : "maps/a.tmx");
        } catch (const std::exception&) {
            ++errors;
        }
    }
    CHECK(errors > 300);
}

TEST_CASE("an error of a file that a map names says where it is named") {
    const std::string file = GENERATE("ground.tsj", "coin.tx");
    const std::string part = file == "coin.tx"
                                 ? R"("layers": [{"type": "objectgroup", "name": "o",
        "objects": [{"id": 1, "template": "coin.tx"}]}])"
                                 : R"("tilesets": [{"firstgid": 1, "source": "ground.tsj"}])";
    const auto missing = [](const std::string& name) -> std::string {
        throw fettle::property::Error(fettle::property::ErrorKind::unknown_name,
                                      "there is no file " + name);
    };
    CHECK_THROWS_WITH(read_map("maps/cave.tmj",
                               [&](const std::string& name) {
                                   return name == "maps/cave.tmj"
                                              ? R"({"tilewidth": 8, "tileheight": 8, )" + part + "}"
                                              : missing(name);
                               }),
                      "there is no file maps/" + file + " (named in maps/cave.tmj)");
}

TEST_CASE("a map in the place of a tileset is an error that says so") {
    for (const std::string& other :
         {std::string(R"({"type": "map", "tilewidth": 8, "tileheight": 8, "layers": []})"),
          std::string("<map tilewidth=\"8\" tileheight=\"8\"/>"),
          std::string(R"({"type": "template", "object": {}})")}) {
        const Files wrong = {{"m.tmj", R"({"tilewidth": 8, "tileheight": 8,
            "tilesets": [{"firstgid": 1, "source": "other"}]})"},
                             {"other", other}};
        CHECK_THROWS_WITH(read(wrong, "m.tmj"), contains("other: expected a tileset, got a "));
    }
}

}  // namespace map_test
