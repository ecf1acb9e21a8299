#include "stored_columns.h"

#include <utility>

#include <fettle/property/error.h>

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

/// The values of a column. Booleans are checked; any bytes are valid for the other types.
template <class T>
std::vector<Value> plain_values(ByteReader& from, std::uint32_t rows) {
    const std::vector<T> saved = from.list<T>();
    from.require(saved.size() == rows, "a column of another length");
    std::vector<Value> all;
    for (std::uint32_t row = 0; row < rows; ++row) {
        if constexpr (std::is_same_v<T, std::uint8_t>)
            from.require(saved[row] <= 1, "neither true nor false");
        all.push_back(read(saved, row));
    }
    return all;
}

std::vector<Value> any_values(ByteReader& from, std::uint8_t kind, std::uint32_t rows) {
    switch (kind) {
        case 0:
            return plain_values<std::uint8_t>(from, rows);
        case 1:
            return plain_values<std::int64_t>(from, rows);
        case 2:
            return plain_values<double>(from, rows);
        case 3:
            return plain_values<Vec2>(from, rows);
        case 4:
            return plain_values<Color>(from, rows);
        case 5: {
            std::vector<Value> all;
            for (std::uint32_t row = 0; row < rows; ++row) all.push_back(from.value());
            return all;
        }
        default:
            from.fail("a column of no kind");
    }
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
    // The memory of texts and lists is freed at once.
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

std::vector<bool> StoredColumns::free_rows() const {
    std::vector<bool> free(rows_);
    for (const std::uint32_t row : free_) free[row] = true;
    return free;
}

// --- Snapshots

void StoredColumns::save(ByteWriter& to) const {
    to.put(rows_);
    to.put(free_);
    to.put(std::uint64_t{class_->stored_.size()});
    for (const Property* property : class_->stored_) {
        const Column& column = columns_[property->stored_index];
        to.put(property->name);
        to.put(static_cast<std::uint8_t>(column.index()));
        const std::size_t block = to.begin_block();
        std::visit(
            [&](const auto& values) {
                if constexpr (std::is_same_v<decltype(values), const std::vector<Value>&>)
                    for (const Value& value : values) to.put(value);
                else
                    to.put(values);
            },
            column);
        to.end_block(block);
    }
}

StoredColumns StoredColumns::load(ByteReader& from, const Class& of, std::size_t max_rows,
                                  UnfitValues& unfit) {
    StoredColumns read(of);
    read.rows_ = from.get<std::uint32_t>();
    from.require(read.rows_ <= max_rows, "more rows than it has instances");
    read.free_ = from.list<std::uint32_t>();
    std::vector<bool> free(read.rows_);
    for (const std::uint32_t row : read.free_) {
        from.require(row < read.rows_ && !free[row],
                     "a row that does not exist, or is listed twice, in the list of free rows");
        free[row] = true;
    }
    std::vector<bool> found(of.stored_.size(), false);
    for (std::size_t n = from.count(9); n > 0; --n) {
        const std::string_view name = from.text();
        const auto kind = from.get<std::uint8_t>();
        ByteReader block = from.block();
        const Property* property = of.property(name);
        if (property == nullptr || property->binding.kind != BindingKind::stored) continue;
        Column& column = read.columns_[property->stored_index];
        std::visit(
            [&](auto& values) {
                using Values = std::remove_reference_t<decltype(values)>;
                constexpr bool any = std::is_same_v<Values, std::vector<Value>>;
                if constexpr (!any) {
                    if (kind == column.index()) {
                        values = block.list<typename Values::value_type>();
                        block.require(values.size() == read.rows_, "a column of another length");
                        if constexpr (std::is_same_v<Values, std::vector<std::uint8_t>>)
                            for (const std::uint8_t flag : values)
                                block.require(flag <= 1, "neither true nor false");
                        return;
                    }
                }
                // The property may have another type now.
                std::vector<Value> saved = any_values(block, kind, read.rows_);
                values.resize(read.rows_);
                for (std::uint32_t row = 0; row < read.rows_; ++row)
                    if (!free[row])
                        write(values, row,
                              fit_saved_value(*property, std::move(saved[row]), unfit));
            },
            column);
        block.finish();
        found[property->stored_index] = true;
    }
    for (const Property* property : of.stored_) {
        if (found[property->stored_index]) continue;
        std::visit([&](auto& values) { values.resize(read.rows_); },
                   read.columns_[property->stored_index]);
        for (std::uint32_t row = 0; row < read.rows_; ++row)
            read.set(*property, row, property->default_value);
    }
    return read;
}

}  // namespace fettle::property
