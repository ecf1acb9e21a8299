#include <fettle/property/value.h>

#include <cstring>

#include "weight.h"

namespace fettle::property {

// Texts and lists: immutable, counted. The count is atomic because another thread may hold a copy
// (a journal writer); copies of numbers never touch it.
struct Value::Shared {
    mutable std::atomic<std::uint32_t> count{1};
    std::string text;
    List list;
};

Value::Value(std::string_view v) : type_(Type::text) {
    data_.shared = new Shared{.text = std::string(v), .list = {}};
}

Value::Value(List v) : type_(Type::list) {
    data_.shared = new Shared{.text = {}, .list = std::move(v)};
}

void Value::retain() const {
    if (shared()) data_.shared->count.fetch_add(1, std::memory_order_relaxed);
}

void Value::release() {
    if (data_.shared->count.fetch_sub(1, std::memory_order_acq_rel) == 1) delete data_.shared;
}

const std::string& Value::text() const {
    return data_.shared->text;
}
const List& Value::list() const {
    return data_.shared->list;
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
