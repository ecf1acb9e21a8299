#include <store/store_text.h>

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include <fettle/property/error.h>

namespace fettle::property {

namespace {

using StoreJson = nlohmann::ordered_json;
/// For reading: it finds a key in logarithmic time, while the ordered one compares it with all
/// others.
using ReadJson = nlohmann::json;

constexpr const char* store_version_key = "fettle_store";
constexpr int store_version = 1;

StoreJson number_json(double number) {
    if (std::isfinite(number)) return number;
    return {{"$number", number_text(number)}};
}

StoreJson value_json(const Value& value) {
    switch (value.type()) {
        case Type::boolean:
            return value.boolean();
        case Type::integer:
            return value.integer();
        case Type::number:
            return number_json(value.number());
        case Type::text:
            return value.text();
        case Type::vec2: {
            const Vec2 v = value.vec2();
            return {{"$vec2", StoreJson::array({number_json(v.x), number_json(v.y)})}};
        }
        case Type::color: {
            const Color c = value.color();
            return {{"$color", StoreJson::array({c.r, c.g, c.b, c.a})}};
        }
        default:
            return nullptr;
    }
}

StoreJson entry_json(const Store::Entry& entry);

StoreJson table_json(const Store::Content& content) {
    std::int64_t next = 1;
    bool list = !content.entries.empty(), names = true;
    for (const auto& [key, entry] : content.entries) {
        const auto* const number = std::get_if<std::int64_t>(&key);
        list = list && number != nullptr && *number == next++;
        names = names && number == nullptr && !std::get<std::string>(key).starts_with('$');
    }
    if (list) {
        StoreJson array = StoreJson::array();
        for (const auto& [key, entry] : content.entries) array.push_back(entry_json(entry));
        return array;
    }
    StoreJson pairs = StoreJson::array(), object = StoreJson::object();
    for (const auto& [key, entry] : content.entries) {
        if (names) {
            // Assigning by a key would compare it with all keys before it.
            object.get_ref<StoreJson::object_t&>().emplace_back(std::get<std::string>(key),
                                                                entry_json(entry));
            continue;
        }
        StoreJson name;
        std::visit([&](const auto& k) { name = k; }, key);
        pairs.push_back(StoreJson::array({name, entry_json(entry)}));
    }
    if (names) return object;
    return {{"$table", pairs}};
}

StoreJson entry_json(const Store::Entry& entry) {
    return entry.content ? table_json(*entry.content) : value_json(entry.value);
}

// --- Reading

[[noreturn]] void damaged_store(const std::string& why) {
    throw Error(ErrorKind::damaged, why);
}

double read_number(const ReadJson& json) {
    if (json.is_number()) return json.get<double>();
    if (json.is_object() && json.size() == 1 && json.contains("$number")) {
        const ReadJson& name = json["$number"];
        for (const double number :
             {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::quiet_NaN()})
            if (name.is_string() && name.get<std::string>() == number_text(number)) return number;
    }
    damaged_store("a number was expected, found " + json.dump());
}

/// The numbers in {"$vec2": [1, 2]}.
std::vector<double> read_numbers(const ReadJson& json, std::size_t count) {
    if (!json.is_array() || json.size() != count)
        damaged_store(std::to_string(count) + " numbers were expected, found " + json.dump());
    std::vector<double> numbers;
    numbers.reserve(json.size());
    for (const ReadJson& each : json) numbers.push_back(read_number(each));
    return numbers;
}

Store::Entry read_entry(const ReadJson& json, int depth);

Store::Entry new_table() {
    return {.content = std::make_shared<Store::Content>()};
}

Store::Entry read_pairs(const ReadJson& json, int depth) {
    Store::Entry table = new_table();
    if (!json.is_array()) damaged_store("a table without entries");
    for (const ReadJson& pair : json) {
        if (!pair.is_array() || pair.size() != 2) damaged_store("an entry that is not a pair");
        Store::Key key;
        if (pair[0].is_number_integer())
            key = pair[0].get<std::int64_t>();
        else if (pair[0].is_string())
            key = pair[0].get<std::string>();
        else
            damaged_store("a key that is neither a number nor a text");
        table.content->entries[key] = read_entry(pair[1], depth + 1);
    }
    return table;
}

Store::Entry read_object(const ReadJson& json, int depth) {
    if (json.size() == 1 && json.begin().key().starts_with('$')) {
        const std::string& tag = json.begin().key();
        const ReadJson& inside = json.begin().value();
        if (tag == "$number") return {.value = read_number(json)};
        if (tag == "$table") return read_pairs(inside, depth);
        if (tag == "$vec2") {
            const std::vector<double> v = read_numbers(inside, 2);
            return {.value = Vec2(v[0], v[1])};
        }
        if (tag == "$color") {
            const std::vector<double> c = read_numbers(inside, 4);
            return {.value = Color{static_cast<float>(c[0]), static_cast<float>(c[1]),
                                   static_cast<float>(c[2]), static_cast<float>(c[3])}};
        }
        damaged_store("\"" + tag + "\" is not a kind of value");
    }
    Store::Entry table = new_table();
    for (const auto& [key, value] : json.items())
        table.content->entries[key] = read_entry(value, depth + 1);
    return table;
}

Store::Entry read_entry(const ReadJson& json, int depth) {
    if (depth > Store::depth_limit) damaged_store("its tables are nested too deep");
    if (json.is_boolean()) return {.value = json.get<bool>()};
    if (json.is_number_integer()) return {.value = json.get<std::int64_t>()};
    if (json.is_number()) return {.value = json.get<double>()};
    if (json.is_string()) return {.value = json.get<std::string>()};
    if (json.is_object()) return read_object(json, depth);
    if (!json.is_array()) damaged_store("null is not a value");
    Store::Entry list = new_table();
    std::int64_t place = 0;
    for (const ReadJson& each : json) list.content->entries[++place] = read_entry(each, depth + 1);
    return list;
}

}  // namespace

std::string store_text(const Store::Content& content) {
    const StoreJson whole = {{store_version_key, store_version}, {"values", table_json(content)}};
    return whole.dump(1, '\t') + "\n";
}

Store::Content store_content(const std::string& text) {
    const ReadJson whole = ReadJson::parse(text, nullptr, false);
    if (!whole.is_object() || !whole.contains(store_version_key) || !whole.contains("values"))
        damaged_store("it is damaged");
    const ReadJson& version = whole[store_version_key];
    if (!version.is_number_integer() || version.get<std::int64_t>() != store_version)
        damaged_store("it was written by another version of Fettle");
    Store::Entry root = read_entry(whole["values"], 0);
    if (!root.content) damaged_store("it is damaged");
    return std::move(*root.content);
}

std::size_t store_size(const Store::Key& key, const Store::Entry& entry) {
    std::size_t size = Store::size_of(key, entry.value);
    if (entry.content)
        for (const auto& [inner, each] : entry.content->entries) size += store_size(inner, each);
    return size;
}

Store::Entry store_copy(const Store::Entry& entry) {
    Store::Entry copy{.value = entry.value};
    if (!entry.content) return copy;
    copy.content = std::make_shared<Store::Content>();
    for (const auto& [key, each] : entry.content->entries)
        copy.content->entries[key] = store_copy(each);
    return copy;
}

}  // namespace fettle::property
