#pragma once
// Stored properties: values that the tree keeps for the instances of a class, one typed column per
// property.

#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/class.h>

#include <classes/fit_saved_value.h>

#include "places.h"

namespace fettle::property {

/// The columns of one class, one row per instance.
class StoredColumns {
  public:
    explicit StoredColumns(const Class& of);

    /// Adds columns of default values for properties that the class got after it was made.
    void extend();
    /// Adds a row of default values and returns its index.
    std::uint32_t add();
    void remove(std::uint32_t row);
    Value get(const Property& property, std::uint32_t row) const;
    void set(const Property& property, std::uint32_t row, const Value& value);
    /// The cell of a property that is stored as a `T` (double, Vec2).
    template <class T>
    T& cell(const Property& property, std::uint32_t row) {
        return (*std::get_if<std::vector<T>>(&columns_[property.stored_index]))[row];
    }

    /// Null if the property is not stored as a `T`.
    template <class T>
    const T* find(const Property& property, std::uint32_t row) const {
        const auto* const column = std::get_if<std::vector<T>>(&columns_[property.stored_index]);
        return column == nullptr ? nullptr : &(*column)[row];
    }

    template <class T>
    T* find(const Property& property, std::uint32_t row) {
        return const_cast<T*>(std::as_const(*this).find<T>(property, row));
    }

    /// A sparse property. `any_sparse`: whether some row may have another value than 0.
    double sparse(std::uint32_t index, std::uint32_t row) const;
    bool any_sparse(std::uint32_t index) const;

    /// Where the instances are and are drawn.
    Places places;

    /// Number of rows, free ones included.
    std::uint32_t rows() const { return rows_; }
    /// One flag per row.
    std::vector<bool> free_rows() const;

    // Snapshots store columns by property name, so that the class may have changed since. A
    // property that is new gets its default. Values of another type: see `fit_saved_value`.
    void save(ByteWriter& to) const;
    static StoredColumns load(ByteReader& from, const Class& of, std::size_t max_rows,
                              UnfitValues& unfit);

  private:
    /// The values of rows that do not have the default.
    using Sparse = std::unordered_map<std::uint32_t, double>;
    // A nullable or untyped property needs a representation of nil, so it has a column of Values.
    using Column =
        std::variant<std::vector<std::uint8_t>, std::vector<std::int64_t>, std::vector<double>,
                     std::vector<Vec2>, std::vector<Color>, std::vector<Value>, Sparse>;
    double default_of(std::uint32_t index) const;
    template <class Values>
    static constexpr bool is_sparse = std::is_same_v<std::remove_cvref_t<Values>, Sparse>;
    static Column column_for(const Property& property);
    /// `kind`: the type of the saved values, as the index in `Column` or `sparse_kind`. Values of
    /// free rows are not read into the column.
    void load_column(ByteReader& from, std::uint8_t kind, const Property& property,
                     const std::vector<bool>& free, UnfitValues& unfit);
    void fill_with_default(const Property& property);

    const Class* class_;
    std::vector<Column> columns_;
    std::vector<std::uint32_t> free_;
    std::uint32_t rows_ = 0;
};

}  // namespace fettle::property
