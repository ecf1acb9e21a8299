#include <scenes/image.h>

#include <fettle/property/path.h>
#include <fettle/property/utf8.h>

#include <json/document.h>
#include <scenes/scene_names.h>
#include <values/scene_reference.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

/// A copy of the property without a declared type, so that its values contain their type.
Property undeclared(const Property& property) {
    Property any;
    any.any_type = true;
    any.type = Type::nil;
    any.single_precision = property.precision() == Precision::single_precision;
    return any;
}

std::string value_json(const Tree& tree, const Property& property, const Value& value) {
    std::string out;
    // On one line, because it goes into a table.
    const Property any = undeclared(property);
    if (!value.is(Type::list)) {
        ValueWriter(tree, {}).append(out, any, value, 0, 0);
        return out;
    }
    for (const Value& element : value.list()) {
        out += out.empty() ? "[" : ", ";
        out += value_json(tree, property, element);
    }
    return out.empty() ? "[]" : out + "]";
}

std::string shown(const Tree& tree, const Property& property, const Value& value) {
    constexpr std::size_t longest = 60;
    std::string text = tree.text(value, property.precision());
    if (text.size() > longest)
        text = text.substr(0, code_point_boundary(text, longest - 3)) + "...";
    if (value.is(Type::text) && text.back() != '"') text += '"';
    return text;
}

std::string on_one_line(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c != '\n' && c != '\r' && c != '\t')
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    return out;
}

ReferenceResolver resolver(const Tree& tree, const Document& document) {
    return [&tree, &document](const std::string& path, const Document::Node& node) {
        return find_reference({tree, document, {}, {}, {}}, path, node);
    };
}

}  // namespace

Image image_of(const Tree& tree, const Property& property, const CellState& state) {
    Image image;
    if (!state.present) {
        image.text = "nothing";
        return image;
    }
    image.text = shown(tree, property, state.value);
    if (!property.unit.empty()) image.unit = " " + property.unit;
    try {
        image.value = value_json(tree, property, state.value);
    } catch (const Error& error) {  // NaN, or a reference to a detached instance
        image.value = "null";
        image.not_saved = error.what();
    }
    if (state.formula) {
        image.kind = Image::Kind::formula;
        image.source = state.formula->source;
        if (!state.formula->not_saved.empty()) image.not_saved = state.formula->not_saved;
        if (image.source.empty() && image.not_saved.empty()) image.not_saved = "has no text";
        image.unit.clear();
        image.text = image.source.empty() ? "a formula" : "is " + on_one_line(image.source);
    } else {
        image.kind = state.overridden ? Image::Kind::value : Image::Kind::by_default;
    }
    return image;
}

Image image_now(const Tree& tree, Handle instance, Symbol name, bool settle) {
    const Property* property = tree.find(instance, name);
    if (property == nullptr) return {.text = "nothing"};
    CellState now{.present = true, .overridden = tree.overridden(instance, *property)};
    if (const Formula* formula = tree.formula(instance, *property)) {
        if (settle) (void)tree.problem(instance, *property);
        now.formula = *formula;
    }
    now.value = tree.peek(instance, *property);
    return image_of(tree, *property, now);
}

std::pair<std::string, std::string> change_text(const Image& was, const Image& now) {
    return {now.unit.empty() ? was.text + was.unit : was.text, now.text + now.unit};
}

std::string image_json(const Image& image) {
    switch (image.kind) {
        case Image::Kind::absent:
            return {};
        case Image::Kind::by_default:
            return "{\"default\": " + image.value + "}";
        case Image::Kind::value:
        case Image::Kind::formula:
            break;
    }
    std::string out = "{";
    if (image.kind == Image::Kind::formula) {
        out += "\"is\": ";
        if (!append_quoted(out, image.source)) out += "\"\"";
        out += ", ";
    }
    out += "\"value\": " + image.value;
    if (!image.not_saved.empty()) {
        out += ", \"not_saved\": ";
        if (!append_quoted(out, image.not_saved)) out += "\"is not UTF-8\"";
    }
    return out + "}";
}

Image read_image(const std::string& json) {
    Image image;
    if (json.empty()) return image;
    const Document document(json, "journal");
    const Document::Node& root = document.root();
    const Document::Node* by_default = document.member(root, "default");
    const Document::Node* value = document.member(root, "value");
    const Document::Node* is = document.member(root, "is");
    const Document::Node* not_saved = document.member(root, "not_saved");
    if ((by_default == nullptr) == (value == nullptr) ||
        (is != nullptr && is->kind != Document::Kind::text))
        document.fail(ErrorKind::bad_structure, 0, "not the state of a property");
    image.value = document.raw(by_default != nullptr ? *by_default : *value);
    image.kind = by_default != nullptr ? Image::Kind::by_default
                 : is != nullptr       ? Image::Kind::formula
                                       : Image::Kind::value;
    if (is != nullptr) image.source = document.text(*is);
    if (not_saved != nullptr && not_saved->kind == Document::Kind::text)
        image.not_saved = document.text(*not_saved);
    return image;
}

Value image_value(const Tree& tree, const Image& image) {
    const Document document(image.value.empty() ? "null" : image.value, "journal");
    return read_value(document, document.root(), Type::nil, Type::nil, resolver(tree, document));
}

std::string image_in_file(const Tree& tree, const Property* declared, const Image& image,
                          const NewPath& written) {
    static const Property ad_hoc = undeclared({});
    const Property& property = declared != nullptr ? *declared : ad_hoc;
    const ValueWriter writer(tree, {});
    const Value value = image_value(tree, image);
    std::string out;
    const bool formula =
        image.kind == Image::Kind::formula && image.not_saved.empty() &&
        writer.append(out, property, {.function = {}, .source = image.source}, value);
    // An integer is converted if the property is a number.
    if (!formula && declared != nullptr && value.is(Type::integer) &&
        declared->type == Type::number)
        writer.append(out, property, Value(value.as_double()), 0, 0);
    else if (!formula)
        writer.append(out, property, value, 0, 0);
    if (!written) return out;
    if (declared == nullptr) return value_with_paths(out, written);
    return value_with_paths(out, written, declared_type(*declared), declared->element);
}

void apply_image(Tree& tree, Handle instance, const std::string& property, const Image& image) {
    const Property* found = tree.find(instance, property);
    if (image.kind == Image::Kind::absent) {
        if (found != nullptr) tree.remove_ad_hoc(instance, property);
        return;
    }
    if (image.kind == Image::Kind::by_default && found != nullptr)
        return tree.reset(instance, *found);
    const Value value = image_value(tree, image);
    if (image.kind == Image::Kind::formula && image.not_saved.empty())
        return tree.set_formula(instance, property, make_formula(tree, image.source, value));
    tree.set_or_add(instance, property, value);
}

}  // namespace fettle::property
