// Converts the XML of the Tiled editor to the form of its JSON.

#include <algorithm>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "document.h"

namespace fettle::maps {
namespace {

/// Groups may be nested, and so may properties; deeper files are refused.
constexpr int max_depth = 64;

class Converter {
  public:
    explicit Converter(const std::string& file) : file_(file) {}

    Json convert(const pugi::xml_node& root) {
        const std::string_view name = root.name();
        if (name == "map" || name == "tileset" || name == "template") {
            Json all = element(root, 0);
            all["type"] = name;  // as in the other format
            return all;
        }
        fail(file_, "expected a map, a tileset or a template, got <" + std::string(name) + ">");
    }

  private:
    Json element(const pugi::xml_node& node, int depth) {
        if (depth > max_depth) fail(file_, "elements are nested too deep");
        Json all = Json::object();
        for (const pugi::xml_attribute& attribute : node.attributes())
            all[attribute.name()] = attribute.value();
        for (const pugi::xml_node& child : node.children())
            if (child.type() == pugi::node_element) add(all, child, depth + 1);
        return all;
    }

    void add(Json& all, const pugi::xml_node& child, int depth) {
        const std::string_view name = child.name();
        if (name == "properties") {
            all["properties"] = properties(child, depth);
        } else if (name == "tileset") {
            if (std::string_view(child.parent().name()) == "template")
                all["tileset"] = element(child, depth);
            else
                all["tilesets"].push_back(element(child, depth));
        } else if (name == "layer" || name == "objectgroup" || name == "imagelayer" ||
                   name == "group") {
            add_layer(all, child, depth);
        } else if (name == "object") {
            add_object(all, child, depth);
        } else if (name == "data") {
            add_data(all, child);
        } else if (name == "image") {
            all["image"] = child.attribute("source").value();
            if (const pugi::xml_attribute color = child.attribute("trans"))
                all["transparentcolor"] = color.value();
            for (const char* const side : {"width", "height"})
                if (const pugi::xml_attribute length = child.attribute(side))
                    all[std::string("image") + side] = length.value();
        } else if (name == "tile") {
            all["tiles"].push_back(element(child, depth));
        } else if (name == "animation") {
            all["animation"] = Json::array();
            for (const pugi::xml_node& frame : child.children("frame"))
                all["animation"].push_back(element(frame, depth));
        } else if (name == "point" || name == "ellipse") {
            all[std::string(name)] = true;
        } else if (name == "polygon" || name == "polyline") {
            all[std::string(name)] = points(child.attribute("points").value());
        } else if (name == "text") {
            all["text"] = element(child, depth);
            all["text"]["text"] = child.text().get();
        } else if (name == "tileoffset") {
            all["tileoffset"] = element(child, depth);
        }
    }

    void add_layer(Json& all, const pugi::xml_node& child, int depth) {
        const std::string_view name = child.name();
        Json layer = element(child, depth);
        layer["type"] = name == "layer" ? "tilelayer" : std::string(name);
        if (name == "objectgroup" && !layer.contains("objects")) layer["objects"] = Json::array();
        // The collision shapes of a tile are not a layer.
        if (std::string_view(child.parent().name()) == "tile")
            all["objectgroup"] = std::move(layer);
        else
            all["layers"].push_back(std::move(layer));
    }

    void add_object(Json& all, const pugi::xml_node& child, int depth) {
        if (std::string_view(child.parent().name()) == "template")
            all["object"] = element(child, depth);
        else
            all["objects"].push_back(element(child, depth));
    }

    Json properties(const pugi::xml_node& node, int depth) {
        if (depth > max_depth) fail(file_, "properties are nested too deep");
        Json list = Json::array();
        for (const pugi::xml_node& property : node.children("property")) {
            Json one = {{"name", property.attribute("name").value()},
                        {"type", property.attribute("type").as_string("string")}};
            if (const pugi::xml_node members = property.child("properties"))
                one["value"] = {{"properties", properties(members, depth + 1)}};
            else if (const pugi::xml_attribute value = property.attribute("value"))
                one["value"] = value.value();
            else
                one["value"] = property.text().get();  // a text of several lines
            list.push_back(std::move(one));
        }
        return list;
    }

    static void add_data(Json& all, const pugi::xml_node& data) {
        const std::string encoding = data.attribute("encoding").value();
        if (!encoding.empty()) all["encoding"] = encoding;
        if (const pugi::xml_attribute compression = data.attribute("compression"))
            all["compression"] = compression.value();
        if (!data.child("chunk")) {
            all["data"] = cells(data, encoding);
            return;
        }
        all["chunks"] = Json::array();
        for (const pugi::xml_node& chunk : data.children("chunk")) {
            Json one = Json::object();
            for (const pugi::xml_attribute& attribute : chunk.attributes())
                one[attribute.name()] = attribute.value();
            one["data"] = cells(chunk, encoding);
            all["chunks"].push_back(std::move(one));
        }
    }

    static Json cells(const pugi::xml_node& node, const std::string& encoding) {
        if (!encoding.empty()) return node.text().get();
        Json list = Json::array();
        for (const pugi::xml_node& tile : node.children("tile"))
            list.push_back(tile.attribute("gid").as_uint());
        return list;
    }

    /// "0,0 16,0 16,8"
    Json points(std::string_view text) const {
        Json list = Json::array();
        while (!text.empty()) {
            const std::size_t end = std::min(text.find(' '), text.size());
            const std::string_view point = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            if (point.empty()) continue;
            const std::size_t comma = point.find(',');
            if (comma == std::string_view::npos)
                fail(file_, "expected a point such as 16,8, got \"" + std::string(point) + "\"");
            list.push_back({{"x", point.substr(0, comma)}, {"y", point.substr(comma + 1)}});
        }
        return list;
    }

    const std::string& file_;
};

}  // namespace

Json parse_xml(const std::string& file, std::string_view text) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (!result)
        fail(file,
             "line " +
                 std::to_string(line_of(
                     text, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset)))) +
                 ": " + result.description());
    return Converter(file).convert(document.document_element());
}

}  // namespace fettle::maps
