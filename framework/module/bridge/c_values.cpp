#include "c_values.h"

namespace fettle::module {

using property::ErrorKind;
using property::List;
using property::Record;
using property::Result;
using property::Type;
using property::Value;

static_assert(static_cast<int>(Type::list) == FETTLE_LIST, "types are numbered alike");
static_assert(static_cast<int>(ErrorKind::no_barrier_end) + 1 == FETTLE_ERR_NO_BARRIER_END,
              "kinds of errors are numbered alike, OK being 0");
static_assert(sizeof(fettle_value) == 24);

std::uint32_t flags_of(const property::Property& property) {
    std::uint32_t flags = 0;
    const auto add = [&](bool is_set, std::uint32_t flag) { flags |= is_set ? flag : 0; };
    add(property.read_only, FETTLE_READ_ONLY);
    add(property.transient, FETTLE_TRANSIENT);
    add(property.simulated, FETTLE_SIMULATED);
    add(property.clamp, FETTLE_CLAMP);
    add(property.infinity, FETTLE_INFINITY);
    add(property.nullable, FETTLE_NULLABLE);
    add(property.any_type, FETTLE_ANY_TYPE);
    add(property.hidden, FETTLE_HIDDEN);
    add(property.single_precision, FETTLE_SINGLE_PRECISION);
    return flags;
}

fettle_value Outgoing::put(const Value& value) {
    fettle_value sent{};
    sent.type = static_cast<std::uint32_t>(value.type());
    switch (value.type()) {
        case Type::nil:
            break;
        case Type::boolean:
            sent.as.boolean = value.boolean() ? 1 : 0;
            break;
        case Type::integer:
            sent.as.integer = value.integer();
            break;
        case Type::number:
            sent.as.number = value.number();
            break;
        case Type::text: {
            const Value& kept = kept_.emplace_back(value);
            sent.as.text = kept.text().c_str();
            sent.count = static_cast<std::uint32_t>(kept.text().size());
            break;
        }
        case Type::vec2:
            sent.as.vec2[0] = value.vec2().x;
            sent.as.vec2[1] = value.vec2().y;
            break;
        case Type::color: {
            const property::Color color = value.color();
            std::copy_n(&color.r, 4, sent.as.color);
            break;
        }
        case Type::reference:
            sent.as.reference = module::sent(value.reference());
            break;
        case Type::list:
            sent.count = static_cast<std::uint32_t>(value.list().size());
            sent.as.list = put(std::span<const Value>(value.list()));
            break;
    }
    return sent;
}

const fettle_value* Outgoing::put(std::span<const Value> values) {
    std::vector<fettle_value> sent;
    sent.reserve(values.size());
    for (const Value& value : values) sent.push_back(put(value));
    return arrays_.emplace_back(std::move(sent)).data();
}

fettle_result Outgoing::put(const Result& result) {
    fettle_result sent{};
    if (const auto* value = std::get_if<Value>(&result)) {
        sent.value = put(*value);
        return sent;
    }
    std::vector<Value> values;
    const auto add = [&](const Record& record) {
        sent.fields = static_cast<std::uint32_t>(record.values.size());
        values.insert(values.end(), record.values.begin(), record.values.end());
    };
    if (const auto* only = std::get_if<Record>(&result)) {
        sent.kind = FETTLE_RECORD;
        sent.count = 1;
        add(*only);
    } else {
        const auto& records = std::get<std::vector<Record>>(result);
        sent.kind = FETTLE_RECORDS;
        sent.count = static_cast<std::uint32_t>(records.size());
        for (const Record& record : records) add(record);
    }
    sent.values = put(std::span<const Value>(values));
    return sent;
}

namespace {

// The tree has the same limit for nested lists.
constexpr int deepest_list = 64;

[[noreturn]] void refuse(const std::string& why) {
    throw property::Error(ErrorKind::wrong_type, "a value of a module: " + why);
}

[[noreturn]] void refuse_without_memory(const char* what, std::size_t count) {
    refuse(std::string(what) + " of length " + std::to_string(count) + " has no memory");
}

List received_list(const fettle_value* values, std::size_t count, int depth);

Value received_value(const fettle_value& value, int depth) {
    switch (value.type) {
        case FETTLE_NIL:
            return {};
        case FETTLE_BOOLEAN:
            return value.as.boolean != 0;
        case FETTLE_INTEGER:
            return value.as.integer;
        case FETTLE_NUMBER:
            return value.as.number;
        case FETTLE_TEXT:
            if (value.as.text != nullptr)
                return Value(std::string_view(value.as.text, value.count));
            if (value.count != 0) refuse_without_memory("a text", value.count);
            return Value("");
        case FETTLE_VEC2:
            return property::Vec2(value.as.vec2[0], value.as.vec2[1]);
        case FETTLE_COLOR:
            return property::Color{value.as.color[0], value.as.color[1], value.as.color[2],
                                   value.as.color[3]};
        case FETTLE_REFERENCE:
            return received(value.as.reference);
        case FETTLE_LIST:
            if (depth == deepest_list)
                refuse("lists are in lists more than " + std::to_string(deepest_list) + " deep");
            return received_list(value.as.list, value.count, depth + 1);
        default:
            refuse("there is no type number " + std::to_string(value.type));
    }
}

List received_list(const fettle_value* values, std::size_t count, int depth) {
    if (values == nullptr && count != 0) refuse_without_memory("a list", count);
    List list;
    list.reserve(count);
    for (std::size_t i = 0; i < count; ++i) list.push_back(received_value(values[i], depth));
    return list;
}

}  // namespace

Value received(const fettle_value& value) {
    return received_value(value, 0);
}

List received(const fettle_value* values, std::size_t count) {
    return received_list(values, count, 0);
}

Result received(const fettle_result& result, const std::vector<property::Field>& fields) {
    if (result.kind == FETTLE_ONE_VALUE) return received(result.value);
    if (result.kind > FETTLE_RECORDS)
        refuse("there is no kind of result number " + std::to_string(result.kind));
    if (result.fields == 0 && result.count != 0)
        refuse(std::to_string(result.count) + " records without fields");
    if (result.values == nullptr && result.count != 0)
        refuse_without_memory("a list of records", result.count);
    std::vector<Record> records;
    for (std::size_t i = 0; i < result.count; ++i) {
        Record record{.fields = &fields,
                      .values = received(result.values + i * result.fields, result.fields)};
        record.values.resize(fields.size());  // each field needs a value
        records.push_back(std::move(record));
    }
    if (result.kind == FETTLE_RECORDS) return records;
    return records.empty() ? Result(Value()) : Result(std::move(records.front()));
}

fettle_status status_of(ErrorKind kind) {
    return static_cast<fettle_status>(static_cast<int>(kind) + 1);
}

ErrorKind kind_of(fettle_status status) {
    return status > FETTLE_OK && status <= FETTLE_ERR_NO_BARRIER_END
               ? static_cast<ErrorKind>(static_cast<int>(status) - 1)
               : ErrorKind::rejected;
}

}  // namespace fettle::module
