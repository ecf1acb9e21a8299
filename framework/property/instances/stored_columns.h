#pragma once
// Stored properties: values the tree keeps for instances of a class, one typed column a property.

#include <cstdint>
#include <variant>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/class.h>

#include <classes/misfits.h>

namespace fettle::property {

/// The columns of one class, a row an instance.
class StoredColumns {
  public:
    explicit StoredColumns(const Class& of);

    /// A row with every default.
    std::uint32_t add();
    void remove(std::uint32_t row);
    Value get(const Property& property, std::uint32_t row) const;
    void set(const Property& property, std::uint32_t row, const Value& value);
    /// The cell of a property that is kept as a `T` (double, Vec2).
    template <class T>
    T& cell(const Property& property, std::uint32_t row) {
        return (*std::get_if<std::vector<T>>(&columns_[property.stored_index]))[row];
    }

    /// As many rows as that are in use or free.
    std::uint32_t rows() const { return rows_; }
    /// By row.
    std::vector<bool> free_rows() const;

    // Snapshots: columns by the names of their properties, so that a class may have changed since.
    // What it did not have then starts with its default; a value of another type becomes one of the
    // type by now, or that default.
    void save(ByteWriter& to) const;
    static StoredColumns load(ByteReader& from, const Class& of, std::size_t most_rows,
                              Misfits& misfits);
    /// A saved value as a property that may have another type by now would hold it; its default
    /// where that cannot be, and then it is one of the misfits.
    static Value fitted(const Property& property, Value saved, Misfits& misfits);

  private:
    // A nullable or untyped property needs room for nil: it lives in a column of values.
    using Column =
        std::variant<std::vector<std::uint8_t>, std::vector<std::int64_t>, std::vector<double>,
                     std::vector<Vec2>, std::vector<Color>, std::vector<Value>>;
    static Column column_for(const Property& property);

    const Class* class_;
    std::vector<Column> columns_;
    std::vector<std::uint32_t> free_;
    std::uint32_t rows_ = 0;
};

}  // namespace fettle::property
