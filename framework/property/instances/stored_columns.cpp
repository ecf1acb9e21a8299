#include "stored_columns.h"

#include <algorithm>
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

constexpr std::uint8_t sparse_kind = 6;  // index of `Sparse` in `Column`

/// Reads the rows that have a value, in ascending order, and calls `put_value(row, value)`.
template <class PutValue>
void read_sparse(ByteReader& from, std::uint32_t rows, PutValue put_value) {
    std::uint64_t next = 0;
    for (std::size_t n = from.count(12); n > 0; --n) {
        const auto row = from.get<std::uint32_t>();
        from.require(row < rows && row >= next, "a value of a row that does not exist");
        next = std::uint64_t{row} + 1;
        put_value(row, from.get<double>());
    }
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

/// `otherwise`: the value of rows that a sparse column does not contain.
std::vector<Value> any_values(ByteReader& from, std::uint8_t kind, std::uint32_t rows,
                              const Value& otherwise) {
    switch (kind) {
        case sparse_kind: {
            std::vector<Value> all(rows, otherwise);
            read_sparse(from, rows, [&](std::uint32_t row, double x) { all[row] = Value(x); });
            return all;
        }
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
            from.fail("a column of an unknown kind");
    }
}

}  // namespace

StoredColumns::Column StoredColumns::column_for(const Property& property) {
    if (property.sparse) return Sparse();
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
    places.look_up(of);
}

void StoredColumns::extend() {
    places.look_up(*class_);
    while (columns_.size() < class_->stored_.size()) {
        const Property& property = *class_->stored_[columns_.size()];
        Column& column = columns_.emplace_back(column_for(property));
        std::visit(
            [this](auto& values) {
                if constexpr (!is_sparse<decltype(values)>) values.resize(rows_);
            },
            column);
        for (std::uint32_t row = 0; row < rows_; ++row) set(property, row, property.default_value);
    }
}

std::uint32_t StoredColumns::add() {
    std::uint32_t row;
    if (free_.empty()) {
        row = rows_++;
        for (Column& column : columns_)
            std::visit(
                [](auto& values) {
                    if constexpr (!is_sparse<decltype(values)>) values.emplace_back();
                },
                column);
    } else {
        row = free_.back();
        free_.pop_back();
        places.forget(row);
    }
    for (const Property* property : class_->stored_) set(*property, row, property->default_value);
    return row;
}

void StoredColumns::remove(std::uint32_t row) {
    // The memory of texts and lists is freed at once.
    for (Column& column : columns_) {
        if (auto* values = std::get_if<std::vector<Value>>(&column)) (*values)[row] = Value();
        if (auto* sparse_values = std::get_if<Sparse>(&column)) sparse_values->erase(row);
    }
    free_.push_back(row);
}

Value StoredColumns::get(const Property& property, std::uint32_t row) const {
    return std::visit(
        [&](const auto& column) {
            if constexpr (is_sparse<decltype(column)>)
                return Value(sparse(property.stored_index, row));
            else
                return read(column, row);
        },
        columns_[property.stored_index]);
}

void StoredColumns::set(const Property& property, std::uint32_t row, const Value& value) {
    const std::uint32_t index = property.stored_index;
    std::visit(
        [&](auto& column) {
            if constexpr (!is_sparse<decltype(column)>)
                write(column, row, value);
            else if (same_bits(value.number(), default_of(index)))
                column.erase(row);
            else
                column[row] = value.number();
        },
        columns_[index]);
}

// A caller may pass the property of a base class, which may have another default.
double StoredColumns::default_of(std::uint32_t index) const {
    return class_->stored_[index]->default_value.number();
}

double StoredColumns::sparse(std::uint32_t index, std::uint32_t row) const {
    const auto& sparse_values = std::get<Sparse>(columns_[index]);
    if (!sparse_values.empty())
        if (const auto found = sparse_values.find(row); found != sparse_values.end())
            return found->second;
    return default_of(index);
}

bool StoredColumns::any_sparse(std::uint32_t index) const {
    return !std::get<Sparse>(columns_[index]).empty() || default_of(index) != 0;
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
                if constexpr (std::is_same_v<decltype(values), const std::vector<Value>&>) {
                    for (const Value& value : values) to.put(value);
                } else if constexpr (is_sparse<decltype(values)>) {
                    // In order: equal states give equal bytes.
                    std::vector<std::pair<std::uint32_t, double>> all(values.begin(), values.end());
                    std::sort(all.begin(), all.end());
                    to.put(std::uint64_t{all.size()});
                    for (const auto& [row, value] : all) {
                        to.put(row);
                        to.put(value);
                    }
                } else {
                    to.put(values);
                }
            },
            column);
        to.end_block(block);
    }
}

void StoredColumns::load_column(ByteReader& from, std::uint8_t kind, const Property& property,
                                const std::vector<bool>& free, UnfitValues& unfit) {
    Column& column = columns_[property.stored_index];
    if (kind == sparse_kind && property.sparse) {
        read_sparse(from, rows_, [&](std::uint32_t row, double x) {
            if (!free[row]) std::get<Sparse>(column)[row] = x;
        });
        return;
    }
    std::visit(
        [&](auto& values) {
            using Values = std::remove_reference_t<decltype(values)>;
            constexpr bool any = std::is_same_v<Values, std::vector<Value>>;
            if constexpr (!any && !is_sparse<Values>) {
                if (kind == column.index()) {
                    values = from.list<typename Values::value_type>();
                    from.require(values.size() == rows_, "a column of another length");
                    if constexpr (std::is_same_v<Values, std::vector<std::uint8_t>>)
                        for (const std::uint8_t flag : values)
                            from.require(flag <= 1, "neither true nor false");
                    return;
                }
            }
            // The property may have another type now.
            std::vector<Value> saved = any_values(from, kind, rows_, property.default_value);
            if constexpr (!is_sparse<Values>) values.resize(rows_);
            for (std::uint32_t row = 0; row < rows_; ++row)
                if (!free[row])
                    set(property, row, fit_saved_value(property, std::move(saved[row]), unfit));
        },
        column);
}

void StoredColumns::fill_with_default(const Property& property) {
    std::visit(
        [&](auto& values) {
            if constexpr (!is_sparse<decltype(values)>) values.resize(rows_);
        },
        columns_[property.stored_index]);
    for (std::uint32_t row = 0; row < rows_; ++row) set(property, row, property.default_value);
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
        if (property == nullptr) {
            const std::vector<Value> saved = any_values(block, kind, read.rows_, {});
            const Value* first = nullptr;
            std::size_t count = 0;
            for (std::uint32_t row = 0; row < read.rows_; ++row)
                if (!free[row] && !saved[row].is_nil() && count++ == 0) first = &saved[row];
            if (first != nullptr) unfit.add_removed(of, name, *first, count);
            continue;
        }
        if (property->binding.kind != BindingKind::stored) continue;
        found[property->stored_index] = true;
        read.load_column(block, kind, *property, free, unfit);
        block.finish();
    }
    for (const Property* property : of.stored_)
        if (!found[property->stored_index]) read.fill_with_default(*property);
    return read;
}

}  // namespace fettle::property
