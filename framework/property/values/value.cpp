// Texts and lists of values, and their reference counts.

#include <fettle/property/value.h>

#include <algorithm>
#include <cstring>

#include <fettle/property/error.h>

#include "weight.h"

namespace fettle::property {

// Text or list: immutable, with a reference count. The count is atomic because another thread may
// hold a copy (a journal writer). Copies of numbers do not touch it.
struct Value::Shared {
    mutable std::atomic<std::uint32_t> count{1};
    std::string text;
    List list;
    int depth = 1;  // depth of nested lists, this one included, or that of an element before
};

namespace {

// Limit for recursive functions (printing, comparing, saving). Snapshots have the same limit.
constexpr int deepest_list = 64;

void require_depth(int depth) {
    if (depth > deepest_list)
        throw Error(ErrorKind::out_of_range,
                    "lists are in lists more than " + std::to_string(deepest_list) + " deep");
}

}  // namespace

void Value::refuse(Type asked) const {
    std::string shown = is_nil() ? std::string() : value_text(*this);
    if (shown.size() > 40) shown = shown.substr(0, 36) + " ...";
    if (!shown.empty()) shown = " (" + shown + ")";
    throw Error(ErrorKind::wrong_type, "a value of type " + std::string(type_name(type_)) + shown +
                                           " was read as " + std::string(type_name(asked)));
}

Value::Value(const char* v) {
    if (v == nullptr)
        throw Error(ErrorKind::wrong_type, "a text was expected, and a null pointer was given");
    *this = Value(std::string_view(v));
}

Value::Value(std::string_view v) : type_(Type::text) {
    data_.shared = new Shared{.text = std::string(v), .list = {}};
}

Value::Value(List v) {
    int depth = 1;
    for (const Value& element : v)
        if (element.type_ == Type::list) depth = std::max(depth, element.data_.shared->depth + 1);
    require_depth(depth);
    data_.shared = new Shared{.text = {}, .list = std::move(v), .depth = depth};
    type_ = Type::list;
}

void Value::retain() const {
    if (shared()) data_.shared->count.fetch_add(1, std::memory_order_relaxed);
}

void Value::release() {
    if (data_.shared->count.fetch_sub(1, std::memory_order_acq_rel) == 1) delete data_.shared;
}

const std::string& Value::text() const {
    return as(Type::text).shared->text;
}
const List& Value::list() const {
    return as(Type::list).shared->list;
}

/// A list that no other value shares.
Value::Shared& Value::own_list() {
    const Shared& all = *as(Type::list).shared;
    if (all.count.load(std::memory_order_acquire) > 1) {
        Value own{List()};
        own.data_.shared->list.reserve(all.list.size() + all.list.size() / 2 + 1);
        own.data_.shared->list = all.list;
        own.data_.shared->depth = all.depth;
        swap(own);
    }
    return *data_.shared;
}

void Value::set_element(std::size_t index, Value element) {
    const int depth = element.type_ == Type::list ? element.data_.shared->depth + 1 : 1;
    require_depth(depth);
    Shared& all = own_list();
    all.depth = std::max(all.depth, depth);
    if (index == all.list.size())
        all.list.push_back(std::move(element));
    else
        all.list.at(index) = std::move(element);
}

void Value::remove_last_element() {
    own_list().list.pop_back();
}

Value default_value(Type type) {
    switch (type) {
        case Type::nil:
            return {};
        case Type::boolean:
            return false;
        case Type::integer:
            return 0;
        case Type::number:
            return 0.0;
        case Type::text:
            return "";
        case Type::vec2:
            return Vec2(0, 0);
        case Type::color:
            return Color{};
        case Type::reference:
            return Handle{};
        case Type::list:
            return List{};
    }
    return {};
}

std::size_t size_of(const Value& value) {
    std::size_t bytes = sizeof(Value);
    if (value.is(Type::text)) bytes += value.text().size() + 64;
    if (value.is(Type::list))
        for (const Value& element : value.list()) bytes += size_of(element);
    return bytes;
}

bool operator==(const Value& a, const Value& b) {
    if (a.type_ != b.type_) return false;
    switch (a.type_) {
        case Type::nil:
            return true;
        case Type::boolean:
            return a.data_.boolean == b.data_.boolean;
        case Type::integer:
            return a.data_.integer == b.data_.integer;
        case Type::number:
            return std::memcmp(&a.data_.number, &b.data_.number, sizeof(double)) == 0;
        case Type::vec2:
            return std::memcmp(a.data_.vec, b.data_.vec, sizeof a.data_.vec) == 0;
        case Type::color:
            return std::memcmp(&a.data_.color, &b.data_.color, sizeof(Color)) == 0;
        case Type::reference:
            return a.data_.reference == b.data_.reference;
        case Type::text:
            return a.data_.shared == b.data_.shared || a.text() == b.text();
        case Type::list:
            return a.data_.shared == b.data_.shared || a.list() == b.list();
    }
    return false;
}

}  // namespace fettle::property
