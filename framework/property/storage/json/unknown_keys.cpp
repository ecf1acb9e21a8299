#include <json/unknown_keys.h>

#include <fettle/property/storage/scene.h>

namespace fettle::property {

void UnknownKeys::add(Place place, const Document& document, const Document::Node& member) {
    std::string& keys = keys_[static_cast<std::size_t>(place)];
    if (!keys.empty()) keys += ", ";
    append_quoted(keys, document.key(member));
    keys += ": ";
    keys += document.raw(member);
}

std::string UnknownKeys::text() const {
    std::string inside = keys_[0];
    for (const Place place : {Place::properties, Place::ad_hoc}) {
        const std::string& keys = keys_[static_cast<std::size_t>(place)];
        if (keys.empty()) continue;
        if (!inside.empty()) inside += ", ";
        inside += place == Place::properties ? "\"properties\": {" : "\"ad_hoc\": {";
        inside += keys + "}";
    }
    return "{" + inside + "}";
}

std::optional<Document> unknown_keys(const Tree& tree, Handle instance) {
    const Property* property = tree.find(instance, unknown_keys_property);
    if (property == nullptr) return std::nullopt;
    const Value value = tree.get(instance, *property);
    if (!value.is(Type::text)) return std::nullopt;
    try {
        Document document(value.text(), std::string(unknown_keys_property));
        if (document.root().kind == Document::Kind::object) return document;
    } catch (const SceneError&) {  // the text is an ordinary property of the user
    }
    return std::nullopt;
}

}  // namespace fettle::property
