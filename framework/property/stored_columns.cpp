#include "stored_columns.h"

namespace fettle::property {
namespace {

Value read(const std::vector<std::uint8_t>& column, std::uint32_t row) {
    return Value(column[row] != 0);
}
Value read(const auto& column, std::uint32_t row) {
    return Value(column[row]);
}

void write(std::vector<std::uint8_t>& column, std::uint32_t row, const Value& v) {
    column[row] = v.boolean();
}
void write(std::vector<std::int64_t>& column, std::uint32_t row, const Value& v) {
    column[row] = v.integer();
}
void write(std::vector<double>& column, std::uint32_t row, const Value& v) {
    column[row] = v.number();
}
void write(std::vector<Vec2>& column, std::uint32_t row, const Value& v) {
    column[row] = v.vec2();
}
void write(std::vector<Color>& column, std::uint32_t row, const Value& v) {
    column[row] = v.color();
}
void write(std::vector<Value>& column, std::uint32_t row, const Value& v) {
    column[row] = v;
}

}  // namespace

StoredColumns::Column StoredColumns::column_for(const Property& property) {
    if (property.nullable || property.any_type) return std::vector<Value>();
    switch (property.type) {
        case Type::boolean:
            return std::vector<std::uint8_t>();
        case Type::integer:
            return std::vector<std::int64_t>();
        case Type::number:
            return std::vector<double>();
        case Type::vec2:
            return std::vector<Vec2>();
        case Type::color:
            return std::vector<Color>();
        default:
            return std::vector<Value>();
    }
}

StoredColumns::StoredColumns(const Class& of) : class_(&of) {
    for (const Property* property : of.stored_) columns_.push_back(column_for(*property));
}

std::uint32_t StoredColumns::add() {
    std::uint32_t row;
    if (free_.empty()) {
        row = rows_++;
        for (Column& column : columns_) std::visit([](auto& c) { c.emplace_back(); }, column);
    } else {
        row = free_.back();
        free_.pop_back();
    }
    for (const Property* property : class_->stored_) set(*property, row, property->default_value);
    return row;
}

void StoredColumns::remove(std::uint32_t row) {
    // Texts and lists are let go of at once.
    for (Column& column : columns_)
        if (auto* values = std::get_if<std::vector<Value>>(&column)) (*values)[row] = Value();
    free_.push_back(row);
}

Value StoredColumns::get(const Property& property, std::uint32_t row) const {
    return std::visit([row](const auto& column) { return read(column, row); },
                      columns_[property.stored_index]);
}

void StoredColumns::set(const Property& property, std::uint32_t row, const Value& value) {
    std::visit([row, &value](auto& column) { write(column, row, value); },
               columns_[property.stored_index]);
}

}  // namespace fettle::property
