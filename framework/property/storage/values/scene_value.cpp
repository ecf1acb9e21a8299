#include <values/scene_value.h>

#include <array>
#include <cmath>
#include <limits>

#include <fettle/property/path.h>

namespace fettle::property {

namespace {

using Node = Document::Node;

constexpr std::size_t widest_line = 100;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Encodes text that is not UTF-8: '%' and all bytes except printable ASCII become %XX.
std::string percent_encoded(std::string_view bytes) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string out;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7F && byte != '%') {
            out += c;
        } else {
            out += {'%', digits[byte >> 4], digits[byte & 15]};
        }
    }
    return out;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return -1;
}

bool percent_decoded(std::string_view text, std::string& out) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        if (text.size() - i < 3) return false;
        const int high = hex_digit(text[i + 1]);
        const int low = hex_digit(text[i + 2]);
        if (high < 0 || low < 0) return false;
        out += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return true;
}

}  // namespace

// --- Writing -------------------------------------------------------------------------------------

void ValueWriter::append(std::string& out, const Property& property, const Value& value,
                         std::size_t column, std::size_t indent) const {
    const Type type = declared_type(property);
    const std::size_t start = out.size();
    append(out, type, property.element, property.precision(), value);
    if (!value.is(Type::list) || column + (out.size() - start) < widest_line) return;
    out.resize(start);
    out += '[';
    const Type element = type == Type::list ? property.element : Type::nil;
    bool first = true;
    for (const Value& item : value.list()) {
        out += first ? "\n" : ",\n";
        out.append(indent + 2, ' ');
        append(out, element, Type::nil, property.precision(), item);
        first = false;
    }
    out += '\n';
    out.append(indent, ' ');
    out += ']';
}

bool ValueWriter::append(std::string& out, const Property& property, const Formula& formula,
                         const Value& value) const {
    const std::size_t start = out.size();
    out += "{\"is\": ";
    if (!append_quoted(out, formula.source)) {
        out.resize(start);
        return false;
    }
    if (!value.is_nil()) {
        out += ", \"value\": ";
        append(out, declared_type(property), property.element, property.precision(), value);
    }
    out += '}';
    return true;
}

void ValueWriter::append(std::string& out, Type type, Type element, Precision precision,
                         const Value& value) const {
    const bool declared = type == value.type();
    switch (value.type()) {
        case Type::nil:
            out += "null";
            return;
        case Type::boolean:
            out += value.boolean() ? "true" : "false";
            return;
        case Type::integer:
            out += std::to_string(value.integer());
            return;
        case Type::number:
            append_number(out, value.number(), precision, declared);
            return;
        case Type::text:
            append_text(out, value.text());
            return;
        case Type::reference:
            append_reference(out, value.reference(), declared);
            return;
        case Type::vec2: {
            out += declared ? "[" : "{\"vec2\": [";
            append_number(out, value.vec2().x, precision, true);
            out += ", ";
            append_number(out, value.vec2().y, precision, true);
            out += declared ? "]" : "]}";
            return;
        }
        case Type::color: {
            if (!declared) out += "{\"color\": ";
            append_color(out, value.color());
            if (!declared) out += "}";
            return;
        }
        case Type::list: {
            out += '[';
            bool first = true;
            for (const Value& item : value.list()) {
                if (!first) out += ", ";
                append(out, declared ? element : Type::nil, Type::nil, precision, item);
                first = false;
            }
            out += ']';
            return;
        }
    }
}

void ValueWriter::append_number(std::string& out, double number, Precision precision,
                                bool declared) const {
    if (std::isnan(number)) throw Error(ErrorKind::not_finite, "a file cannot hold NaN");
    if (std::isinf(number)) {
        const std::string_view word = number > 0 ? "\"inf\"" : "\"-inf\"";
        if (!declared) out += "{\"number\": ";
        out += word;
        if (!declared) out += '}';
        return;
    }
    const std::string digits = number_text(number, precision);
    out += digits;
    if (digits.find_first_of(".e") != std::string::npos) return;
    // 2 is read as an integer. That is correct where a number is declared, as long as doubles can
    // represent all integers of that size. JSON has no integer -0.
    const double all_integers = precision == Precision::single_precision ? 0x1p24 : 0x1p53;
    const bool negative_zero = number == 0 && std::signbit(number);
    if (!declared || negative_zero || std::abs(number) >= all_integers) out += ".0";
}

void ValueWriter::append_text(std::string& out, const std::string& text) const {
    if (append_quoted(out, text)) return;
    out += "{\"bytes\": ";
    append_quoted(out, percent_encoded(text));
    out += '}';
}

void ValueWriter::append_color(std::string& out, Color color) const {
    const std::string hex = color_text(color);
    Color back;
    if (parse_color(hex, back) && Value(back) == Value(color)) {
        append_quoted(out, hex);
        return;
    }
    out += '[';
    bool first = true;
    for (const float channel : {color.r, color.g, color.b, color.a}) {
        if (!first) out += ", ";
        append_number(out, static_cast<double>(channel), Precision::single_precision, true);
        first = false;
    }
    out += ']';
}

void ValueWriter::append_reference(std::string& out, Handle target, bool declared) const {
    if (!declared) out += "{\"reference\": ";
    // A reference to a deleted instance is written as null.
    if (!target || !tree_.alive(target)) {
        out += "null";
    } else if (const std::string path = reference(target); !append_quoted(out, path)) {
        throw Error(ErrorKind::bad_name, "the path of what it refers to is not UTF-8");
    }
    if (!declared) out += '}';
}

std::string ValueWriter::reference(Handle target) const {
    if (target == top_) return ".";
    if (tree_.is_below(target, top_)) {
        std::string path;
        for (Handle at = target; at != top_; at = tree_.parent(at)) {
            path.insert(0, path_suffix(tree_.name(at)));
        }
        return path;
    }
    if (target != tree_.root() && !tree_.is_below(target, tree_.root())) {
        throw Error(ErrorKind::bad_structure,
                    "refers to " + tree_.path(target) +
                        ", which is neither in the scene nor anywhere else that a path leads to");
    }
    return tree_.path(target);
}

// --- Reading -------------------------------------------------------------------------------------

namespace {

class ValueReader {
  public:
    ValueReader(const Document& document, const ReferenceResolver& resolve)
        : document_(document), resolve_(resolve) {}

    Value read(const Node& node, Type type, Type element) const {
        switch (node.kind) {
            case Document::Kind::null:
                return {};
            case Document::Kind::boolean:
                return node.boolean;
            case Document::Kind::integer:
                return node.integer;
            case Document::Kind::number:
                return node.number;
            case Document::Kind::text:
                return text(node, type);
            case Document::Kind::array:
                return array(node, type, element);
            case Document::Kind::object:
                return tagged(node);
        }
        return {};
    }

  private:
    [[noreturn]] void fail(const Node& node, const std::string& reason) const {
        document_.fail(ErrorKind::wrong_type, node.begin, reason);
    }

    Value text(const Node& node, Type type) const {
        const std::string& text = document_.text(node);
        if (type == Type::number && text == "inf") return infinity;
        if (type == Type::number && text == "-inf") return -infinity;
        if (type == Type::reference) return resolve_(text, node);
        return text;
    }

    bool component(const Node& node, double& out) const {
        switch (node.kind) {
            case Document::Kind::integer:
                out = static_cast<double>(node.integer);
                if (out >= 0x1p63 || static_cast<std::int64_t>(out) != node.integer) {
                    fail(node, "the integer " + std::to_string(node.integer) +
                                   " has no exact value as a number");
                }
                return true;
            case Document::Kind::number:
                out = node.number;
                return true;
            case Document::Kind::text:
                if (document_.text(node) != "inf" && document_.text(node) != "-inf") return false;
                out = document_.text(node) == "inf" ? infinity : -infinity;
                return true;
            default:
                return false;
        }
    }

    /// The numbers of an array with at most four numbers; 0 for anything else.
    std::size_t components(const Node& node, std::array<double, 4>& out) const {
        std::size_t count = 0;
        for (const Node* item = document_.first(node); item; item = document_.next(*item)) {
            if (count == out.size() || !component(*item, out[count])) return 0;
            ++count;
        }
        return count;
    }

    Value array(const Node& node, Type type, Type element) const {
        std::array<double, 4> numbers{0, 0, 0, 1};
        if (type == Type::vec2 && components(node, numbers) == 2) {
            return Vec2(numbers[0], numbers[1]);
        }
        if (type == Type::color && components(node, numbers) >= 3) {
            for (const double channel : numbers)
                if (!(channel >= 0 && channel <= 1))
                    fail(node, "a color's channels are from 0 to 1, and " + number_text(channel) +
                                   " is not");
            return Color{static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
                         static_cast<float>(numbers[2]), static_cast<float>(numbers[3])};
        }
        List list;
        for (const Node* item = document_.first(node); item; item = document_.next(*item)) {
            list.push_back(read(*item, type == Type::list ? element : Type::nil, Type::nil));
        }
        return list;
    }

    Value tagged(const Node& node) const {
        const Node* item = document_.first(node);
        if (item == nullptr || document_.next(*item) != nullptr) fail(node, no_value());
        const std::string& tag = document_.key(*item);
        if (tag == "bytes" && item->kind == Document::Kind::text) {
            std::string bytes;
            if (percent_decoded(document_.text(*item), bytes)) return bytes;
            fail(*item, "expected a text in which % is followed by two hexadecimal digits");
        }
        const auto check = [&](Type type, std::string_view form) {
            Value value = read(*item, type, Type::nil);
            if (!value.is(type)) fail(*item, "expected " + std::string(form));
            return value;
        };
        if (tag == "number") return number(*item);
        if (tag == "vec2") return check(Type::vec2, "a vec2 as [x, y]");
        if (tag == "color") return color(*item);
        if (tag == "reference") {
            if (item->kind == Document::Kind::null) return Handle{};
            return check(Type::reference, "the path of an instance");
        }
        fail(node, no_value());
    }

    Value number(const Node& node) const {
        double number = 0;
        if (component(node, number)) return number;
        fail(node, "expected a number, \"inf\" or \"-inf\"");
    }

    Value color(const Node& node) const {
        Color color;
        if (node.kind == Document::Kind::text && parse_color(document_.text(node), color))
            return color;
        Value value = read(node, Type::color, Type::nil);
        if (value.is(Type::color)) return value;
        fail(node, "expected a color as \"#rrggbb\", [r, g, b] or [r, g, b, a]");
    }

    static std::string no_value() {
        return "expected a value; an object is one only as {\"vec2\": [x, y]}, {\"color\": "
               "\"#rrggbb\"}, {\"reference\": \"path\"}, {\"number\": \"inf\"}, {\"bytes\": "
               "\"%00\"} or {\"is\": \"formula\"}";
    }

    const Document& document_;
    const ReferenceResolver& resolve_;
};

}  // namespace

FormulaText formula_text(const Document& document, const Node& node) {
    FormulaText found;
    if (node.kind != Document::Kind::object || document.member(node, "is") == nullptr) return found;
    for (const Node* member = document.first(node); member; member = document.next(*member)) {
        const std::string& key = document.key(*member);
        if (key == "is" && member->kind == Document::Kind::text) {
            found.is = member;
        } else if (key == "value" && !document.member(*member, "is")) {
            found.value = member;
        } else {
            document.fail(
                ErrorKind::wrong_type, member->key_begin,
                "expected a formula as {\"is\": \"its text\", \"value\": its last value}");
        }
    }
    return found;
}

Formula make_formula(const Tree& tree, const std::string& source, const Value& value) {
    if (tree.formula_compiler()) return tree.formula_compiler()(source);
    return {.function = [value](const Tree&) { return value; }, .source = source};
}

Formula made_formula(const Tree& tree, const Document& document, const FormulaText& formula,
                     const Value& value) {
    try {
        return make_formula(tree, document.text(*formula.is), value);
    } catch (const Error& e) {
        document.fail(e.kind(), formula.is->begin, e.what());
    }
}

void require_settable_in_scene(const Property& property) {
    if (property.binding.kind == BindingKind::node && property.transient)
        throw Error(ErrorKind::read_only,
                    "is set by the keys and the place of the instance, not as a property");
}

Value read_value(const Document& document, const Node& node, Type type, Type element,
                 const ReferenceResolver& resolve) {
    return ValueReader(document, resolve).read(node, type, element);
}

bool names_instance(const Document& document, const Node& node, Type type, Type element) {
    if (node.kind == Document::Kind::text) return type == Type::reference;
    if (node.kind == Document::Kind::object) {
        if (document.member(node, "is") == nullptr)
            return document.member(node, "reference") != nullptr;
        const Node* value = document.member(node, "value");
        return value != nullptr && names_instance(document, *value, type, element);
    }
    if (node.kind != Document::Kind::array) return false;
    for (const Node* item = document.first(node); item; item = document.next(*item)) {
        const Type of_item = type == Type::list ? element : Type::nil;
        if (names_instance(document, *item, of_item, Type::nil)) return true;
    }
    return false;
}

}  // namespace fettle::property
