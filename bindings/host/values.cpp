#include "values.h"

namespace fettle::host {

using property::List;
using property::Result;
using property::Type;
using property::Value;

fettle_hosted_value ReturnedData::list(const List& list) {
    std::vector<fettle_hosted_value> elements;
    elements.reserve(list.size());
    for (const Value& element : list) elements.push_back(value(element));
    const auto& kept = lists_.emplace_back(std::move(elements));
    fettle_hosted_value made{};
    made.type = FETTLE_VALUE_LIST;
    made.count = static_cast<std::uint32_t>(kept.size());
    made.as.list = kept.data();
    return made;
}

fettle_hosted_value ReturnedData::value(const Value& value) {
    fettle_hosted_value made{};
    made.type = static_cast<std::int32_t>(value.type());
    switch (value.type()) {
        case Type::nil:
            break;
        case Type::boolean:
            made.as.boolean = value.boolean() ? 1 : 0;
            break;
        case Type::integer:
            made.as.integer = value.integer();
            break;
        case Type::number:
            made.as.number = value.number();
            break;
        case Type::text:
            made.as.text = text(value.text());
            made.count = static_cast<std::uint32_t>(value.text().size());
            break;
        case Type::vec2:
            made.as.vec2[0] = value.vec2().x;
            made.as.vec2[1] = value.vec2().y;
            break;
        case Type::color: {
            const property::Color color = value.color();
            made.as.color[0] = color.r;
            made.as.color[1] = color.g;
            made.as.color[2] = color.b;
            made.as.color[3] = color.a;
            break;
        }
        case Type::reference:
            made.as.instance = converted(value.reference());
            break;
        case Type::list:
            return list(value.list());
    }
    return made;
}

fettle_hosted_value ReturnedData::result(const Result& result) {
    if (const auto* const plain = std::get_if<Value>(&result)) return value(*plain);
    if (const auto* const record = std::get_if<property::Record>(&result))
        return list(record->values);
    List all;
    for (const property::Record& record : std::get<std::vector<property::Record>>(result))
        all.push_back(Value(List(record.values)));
    return list(all);
}

namespace {

constexpr int deepest = 64;
constexpr std::size_t most = 1'000'000;  // elements, so that a list that contains itself ends

class Reader {
  public:
    explicit Reader(const char* name) : name_(name) {}

    Value read(const fettle_hosted_value& value, int depth = 0) {
        switch (value.type) {
            case FETTLE_VALUE_NIL:
                return {};
            case FETTLE_VALUE_BOOLEAN:
                return Value(value.as.boolean != 0);
            case FETTLE_VALUE_INTEGER:
                return Value(std::int64_t{value.as.integer});
            case FETTLE_VALUE_NUMBER:
                return Value(value.as.number);
            case FETTLE_VALUE_TEXT:
                if (value.as.text == nullptr && value.count > 0) refuse("a null text");
                return Value(
                    std::string_view(value.as.text == nullptr ? "" : value.as.text, value.count));
            case FETTLE_VALUE_VEC2:
                return Value(property::Vec2(value.as.vec2[0], value.as.vec2[1]));
            case FETTLE_VALUE_COLOR:
                return Value(property::Color{value.as.color[0], value.as.color[1],
                                             value.as.color[2], value.as.color[3]});
            case FETTLE_VALUE_INSTANCE:
                return Value(handle_of(value.as.instance));
            case FETTLE_VALUE_LIST:
                return list(value, depth);
            default:
                refuse("a value of type " + std::to_string(value.type) +
                       ": expected one of fettle_value_type");
        }
    }

  private:
    Value list(const fettle_hosted_value& value, int depth) {
        if (value.as.list == nullptr && value.count > 0) refuse("a null list");
        if (depth >= deepest) refuse("lists nested more than 64 deep");
        read_ += value.count;
        if (read_ > most) refuse("more than a million elements");
        List elements;
        elements.reserve(value.count);
        for (std::uint32_t i = 0; i < value.count; ++i)
            elements.push_back(read(value.as.list[i], depth + 1));
        return Value(std::move(elements));
    }
    [[noreturn]] void refuse(const std::string& what) const {
        throw Failure{FETTLE_INVALID, std::string(name_) + ": got " + what};
    }

    const char* name_;
    std::size_t read_ = 0;
};

}  // namespace

Value value_of(const char* name, const fettle_hosted_value& value) {
    return Reader(name).read(value);
}

std::vector<Value> values_of(const char* name, const fettle_hosted_value* values,
                             std::uint32_t count) {
    fettle_hosted_value all{};
    all.type = FETTLE_VALUE_LIST;
    all.count = count;
    all.as.list = values;
    return value_of(name, all).list();
}

}  // namespace fettle::host
