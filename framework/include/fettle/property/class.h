#pragma once
// Classes: properties, methods and events of instances. A class is registered once, by a
// descriptor; dispatch in Lua, completion, help, inspector widgets, range checks, scene files and
// reference pages are all derived from it.
//
// The module that computes with a value owns its memory. A property's binding says where it is:
//   column    in an array of the module, at a fixed stride
//   accessor  behind a getter and a setter of the module
//   node      computed from the tree itself (a name, a list of references)
//   stored    in the tree itself, in typed columns of the class
//   ad_hoc    added to one instance by a user; the tree keeps it with the instance

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/lifecycle.h>
#include <fettle/property/painter.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;
class Class;
class FETTLE_PROPERTY_PRIVATE ClassRegistry;
class FETTLE_PROPERTY_PRIVATE Shadows;
class FETTLE_PROPERTY_PRIVATE StoredColumns;
class FETTLE_PROPERTY_PRIVATE TreeImage;

/// An inclusive range.
struct Range {
    double min = -std::numeric_limits<double>::infinity();  ///< the least value
    double max = std::numeric_limits<double>::infinity();   ///< the greatest value
    /// Whether it has an end.
    bool bounded() const {
        return min != -std::numeric_limits<double>::infinity() ||
               max != std::numeric_limits<double>::infinity();
    }
    /// NaN is in no range.
    bool contains(double x) const { return x >= min && x <= max; }
    bool contains(const Vec2& v) const { return contains(v.x) && contains(v.y); }
    /// A range that contains no number.
    static constexpr Range nothing() { return {.min = 1, .max = 0}; }
};

/// The native type of one element of a column. `enumeration` is a byte that indexes the property's
/// enumerators.
enum class Native : std::uint8_t { f32, f64, i32, i64, boolean, vec2f, vec2d, color, enumeration };

/// Where the value of a property is: in the tree, in an array, behind functions, in the structure.
enum class BindingKind : std::uint8_t { stored, column, accessor, node, ad_hoc };

struct Binding;

/// Result of putting a value into a cell. `same`: the cell has it already. `done`: it is written.
/// `declined`: refused; only `Binding::set` can give the reason. `untried`: the fastest path cannot
/// write it (only the tree returns this).
enum class WriteResult : std::uint8_t { same, done, declined, untried };

/// Reads and writes a number or a vector without a Value, for the most frequent accesses by
/// scripts. Made by the functions below. The binding is a parameter because a column needs its
/// stride.
template <class T>
struct Typed {
    /// How a value is given to a function.
    using Passed = std::conditional_t<std::is_floating_point_v<T>, T, const T&>;
    T (*get)(const Binding&, Row) = nullptr;  ///< reads the value
    /// Writes unless the cell has the same bits. May throw as `Binding::set` does.
    WriteResult (*put)(const Binding&, Row, Passed value) = nullptr;
    /// True if `put` only writes memory of the module: it neither throws nor uses the tree. Its
    /// argument may have more digits than the cell.
    bool plain = false;
};

/// The place of a value. Which members are used depends on `kind`.
struct Binding {
    BindingKind kind = BindingKind::stored;  ///< where the value is
    Native native = Native::f64;             ///< of a column: type of an element
    void* context = nullptr;                 ///< is given to the functions

    // column: the element of row r is at base(context) + r * stride. `base` is a function, not a
    // pointer, because the array may move.
    std::byte* (*base)(void* context) = nullptr;  ///< of a column: its first element
    std::size_t stride = 0;                       ///< of a column: bytes from row to row

    // accessor. `get` only reads: it must not delete instances, restore a snapshot or destroy the
    // tree. `set` may throw std::invalid_argument to refuse a value: its text becomes the reason in
    // the error.
    Value (*get)(void* context, Row row) = nullptr;                     ///< of an accessor: reads
    void (*set)(void* context, Row row, const Value& value) = nullptr;  ///< of an accessor: writes

    /// Of a node: as `get` and `set`, for values that are part of the tree's structure.
    Value (*node_get)(void* context, const Tree& tree, Handle self) = nullptr;
    /// Of a node: writes.
    void (*node_set)(void* context, Tree& tree, Handle self, const Value& value) = nullptr;

    /// Optional. Removes the override, instead of writing the default: a mass is computed from the
    /// density again.
    void (*reset)(void* context, Row row) = nullptr;
    /// Optional: whether there is an override.
    bool (*overridden)(void* context, Row row) = nullptr;

    /// Optional, called after a write: may only set dirty flags and wake bodies. Derived data are
    /// computed when they are read.
    void (*invalidate)(void* context, Row row) = nullptr;

    Typed<double> number{};  ///< optional: typed functions for a number
    Typed<Vec2> vec2{};      ///< optional: typed functions for a vector
};

/// Describes one property. An aggregate: set the fields you need.
struct Property {
    std::string name;          ///< as users write it
    Type type = Type::number;  ///< of the value
    Value default_value{};     ///< nil: zero of the type
    std::string unit{};        // "kg", "m/s", "rad"; "" without a unit
    Range range{};             // for numbers; for a vec2 or a color, of each component
    std::string doc{};         // one or two sentences, shown by help
    Binding binding{};         ///< where the value is

    bool read_only = false;  // derived, or written by the simulation only
    bool transient = false;  // not saved
    bool simulated = false;  // the simulation writes it without reporting changes
    bool clamp = false;      // true: values out of range are clamped, not refused
    bool infinity = false;   // plus or minus infinity is allowed
    bool nullable = false;   // nil is a value; otherwise assigning nil restores the default
    bool any_type = false;   // takes any type (ad-hoc properties)
    bool hidden = false;     // not listed by inspectors
    bool sparse = false;     // stored number: only values that differ from the default take memory
    bool bits = false;       // an integer whose bits have a meaning each

    /// Of a list: bytes that its module needs for each element, beside the value itself. An
    /// estimate, for `Tree::weight`.
    std::uint32_t element_weight = 0;

    std::vector<std::string> enumerators{};  // a text property takes only these
    Type element = Type::nil;                // type of a list's elements; nil: any
    std::string reference_class{};  // a reference takes only this class and those derived from it
    std::vector<std::string>
        derives_from{};  // read-only: paths of its sources, relative, "shapes.*.density"

    // Filled in by registration.
    Symbol symbol{};                         ///< its name, by registration
    const Class* owner = nullptr;            ///< the class that declares it, by registration
    std::vector<Value> enumerator_values{};  ///< the enumerators as values, by registration
    std::uint32_t stored_index = 0;          ///< of its column in the tree, by registration
    /// Which typed functions of `Tree` may read and write the property.
    struct Shortcut {
        /// A typed function.
        enum class Access : std::uint8_t { none, number, vec2, stored_number, stored_vec2 };
        Access read = Access::none;   ///< for reading
        Access write = Access::none;  ///< for writing
        Access plain = Access::none;  // like `write`, but only if calling a plain `put` is enough
        bool narrow = false;          // rounded to float
        // Values that may be written: in range, also after rounding, and so small that integers are
        // exact.
        Range writable_range = Range::nothing();  ///< values that may be written
        /// Number of broad watchers (class, pattern) that may match this property. Set by
        /// `set_interest`.
        mutable std::uint32_t interest = 0;
        /// Values that can be written by calling a plain `put` and nothing else. Empty while there
        /// is a watcher, or if the type does not fit, because then there may be no `put`.
        mutable Range numbers_at_once = Range::nothing();
        mutable Range vec2s_at_once = Range::nothing();  ///< as `numbers_at_once`
        /// Sets `interest` and the members that depend on it.
        void set_interest(std::uint32_t watchers) const {
            interest = watchers;
            const auto taken = [&](Access access) {
                return watchers == 0 && plain == access ? writable_range : Range::nothing();
            };
            numbers_at_once = taken(Access::number);
            vec2s_at_once = taken(Access::vec2);
        }
    } shortcut{};  ///< by registration

    /// With how many digits its numbers are printed.
    Precision precision() const {
        return binding.kind == BindingKind::column &&
                       (binding.native == Native::f32 || binding.native == Native::vec2f)
                   ? Precision::single_precision
               : single_precision ? Precision::single_precision
                                  : Precision::double_precision;
    }
    bool single_precision = false;  // accessor of a float: range checks and printing round to float
    /// Index of `text` in the enumerators, or -1.
    int enumerator_index(std::string_view text) const;
};

/// A parameter of a method, or a named field of a result or an event.
struct Field {
    std::string name;               ///< as users write it
    Type type = Type::number;       ///< of the value
    std::string unit{};             ///< "kg"; "" without one
    std::string doc{};              ///< what it is, shown by help
    std::string reference_class{};  // class of a reference, or of the references in a list
    Type element = Type::nil;       // type of a list's elements; nil: any
    bool nullable = false;          // in a result or event: may be nil
    Range range{};                  // of an argument or an answer, for each component
};

/// Values by the names of their fields: the data of an event, the result of a query.
struct Record {
    /// Not owned. Fields of events, and all `record_fields`, live as long as the program.
    const std::vector<Field>* fields = nullptr;
    std::vector<Value> values;  ///< one for each field
    /// nil if there is no such field.
    Value get(std::string_view name) const;
};

/// Result of a method: nothing (nil), a value, a record or a list of records.
using Result = std::variant<Value, Record, std::vector<Record>>;

/// The data that a method changes. `nothing`: it only reads, and a formula may call it. `tree`:
/// properties and instances, through members of the tree. `memory`: memory of its module, without
/// reporting changes. Formulas, and functions that are called in the middle of a step or of a
/// query, may not call methods of the last two kinds.
enum class Effect : std::uint8_t { nothing, tree, memory };

/// A method. An aggregate: set the fields that you need.
struct Method {
    std::string name;                 ///< as users write it
    std::vector<Field> parameters{};  ///< in their order
    std::size_t required = 0;         // number of required parameters
    std::vector<Field> returns{};     // fields of the record(s), or one entry for a single value
    bool many = false;                // the result is a list of such records
    std::string doc{};                ///< what it is, shown by help
    void* context = nullptr;          ///< is given to the functions
    /// Arguments are coerced to the parameters' types before the call; missing optional ones are
    /// nil. May throw property::Error or std::invalid_argument.
    Result (*call)(void* context, Tree& tree, Handle self, Row row,
                   std::span<const Value> arguments) = nullptr;
    Effect effect = Effect::memory;  ///< what it changes
    // Filled in by registration.
    Symbol symbol{};               ///< its name, by registration
    const Class* owner = nullptr;  ///< the class that declares it, by registration
    const std::vector<Field>* record_fields = nullptr;  // copy of `returns`, never freed
};

/// An event is delivered only while all instances in it live; another handler may have deleted one.
/// There is an exception: if a class has an event `..._begin` and an event `..._end` with the same
/// first fields, the end is delivered to the handlers that received the beginning.
struct Event {
    std::string name;             ///< as users write it
    std::vector<Field> fields{};  ///< its data
    std::string doc{};            ///< what it is, shown by help
    // Filled in by registration.
    Symbol symbol{};               ///< its name, by registration
    const Class* owner = nullptr;  ///< the class that declares it, by registration
    const std::vector<Field>* record_fields = nullptr;  // copy of `fields`, never freed
    const Event* begin = nullptr;                       // for an end
    const Event* end = nullptr;                         // for a beginning
    mutable std::uint32_t listeners = 0;                ///< number of its handlers
};

/// The data in a snapshot for the instances of a class, in addition to those of the tree. A class
/// that derives from one that is saved natively is so too. One whose rows are made by the lifecycle
/// of its base class can be saved natively only if that class is.
enum class Snapshots : std::uint8_t {
    by_value,  // each property that can be written and is not transient, by its name
    natively,  // no values: a part of the snapshot saves the rows of the module
    never      // no data, and none of the tree's own columns: it belongs to the present (a console)
};

/// The description of a class, for `Tree::define`.
struct ClassDescriptor {
    std::string name;             ///< as users write it
    std::string base = "Object";  // "" only for Object itself
    std::string doc{};            ///< what it is, shown by help
    bool creatable = true;        // users may create instances; not of services like `time`
    Snapshots snapshots = Snapshots::by_value;  ///< what snapshots have of its instances
    std::vector<Property> properties{};         ///< its own
    std::vector<Method> methods{};              ///< its own
    std::vector<Event> events{};                ///< its own
    /// Without any function: the class has the lifecycle of the base class. A class with a
    /// lifecycle of its own does not use that of the base class, so inherited bindings and methods
    /// get rows of this class. `Tree::define` therefore refuses a lifecycle if columns, accessors
    /// or methods of the base class use rows that a lifecycle made: derive without a lifecycle, or
    /// set `makes_base_rows`.
    Lifecycle lifecycle{};
    /// True if its rows are rows of the base class as well, for a module that defines both: its
    /// row of a shape serves the classes `Shape` and `Circle`.
    bool makes_base_rows = false;
    /// Stem of the names of unnamed instances: "body" gives body_1, body_2 ... Default: the class
    /// name in lower case.
    std::string stem{};
    /// Bytes that its module needs for each instance, beside those of the tree. An estimate, for
    /// `Tree::weight`. 0: that of the base class.
    std::uint32_t weight = 0;
};

/// A registered class. Lives as long as its tree; addresses of properties, methods and events are
/// stable.
class Class {
  public:
    const std::string& name() const { return descriptor_.name; }  ///< as users write it
    const std::string& doc() const { return descriptor_.doc; }    ///< what it is
    const Class* base() const { return base_; }                   ///< null for Object
    /// Whether users may create instances.
    bool creatable() const { return descriptor_.creatable; }
    /// From the nearest native base class: a script's class is saved like its base.
    Snapshots snapshots() const { return snapshots_; }
    bool is_a(const Class& other) const;  ///< whether it is that class or derives from it
    /// Stem of the names of unnamed instances.
    const std::string& stem() const { return descriptor_.stem; }
    /// Bytes that its module needs for each instance; its own, or that of the nearest base class
    /// that has one.
    std::uint32_t weight() const { return descriptor_.weight; }
    /// Its own, or that of the nearest base class that has one.
    const Lifecycle& lifecycle() const { return *lifecycle_; }

    /// All properties, also inherited ones; those of base classes come first.
    const std::vector<const Property*>& properties() const { return properties_; }
    /// All methods, in the same order.
    const std::vector<const Method*>& methods() const { return methods_; }
    /// All events, in the same order.
    const std::vector<const Event*>& events() const { return events_; }

    /// The property of that name, also an inherited one; null if there is none.
    const Property* property(Symbol name) const;
    const Property* property(std::string_view name) const { return property(Symbol::find(name)); }
    /// The method of that name, also an inherited one; null if there is none.
    const Method* method(Symbol name) const;
    const Method* method(std::string_view name) const { return method(Symbol::find(name)); }
    /// The event of that name, also an inherited one; null if there is none.
    const Event* event(Symbol name) const;
    const Event* event(std::string_view name) const { return event(Symbol::find(name)); }

    /// Index in the order of definition.
    std::uint32_t id() const { return id_; }
    /// Names of properties and methods, for nearest spellings.
    std::vector<std::string> member_names() const;

    Class(const Class&) = delete;
    Class& operator=(const Class&) = delete;

  private:
    friend class Tree;
    friend class ClassRegistry;
    friend class Shadows;
    friend class StoredColumns;
    friend class TreeImage;
    Class() = default;

    ClassDescriptor descriptor_;
    std::deque<Property> own_properties_;
    const Class* base_ = nullptr;
    Snapshots snapshots_ = Snapshots::by_value;
    const Lifecycle* lifecycle_ = nullptr;
    std::vector<const Property*> properties_;
    std::vector<const Method*> methods_;
    std::vector<const Event*> events_;
    std::unordered_map<Symbol, const Property*> property_index_;
    std::unordered_map<Symbol, const Method*> method_index_;
    std::unordered_map<Symbol, const Event*> event_index_;
    std::vector<const Property*> stored_;  // properties the tree keeps, own and inherited
    std::vector<const Property*>
        observed_;  // simulated or derived properties; they have shadows while watched
    std::vector<const Property*>
        initial_;  // inherited from a native class, with another default in this class
    std::uint32_t id_ = 0;
    mutable bool columns_found_ = false;  // every `base` has returned memory for the first row
};

// --- Binding makers

/// Compares bits: a NaN equals itself, and -0.0 is not 0.0.
inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
/// Whether two values are the same, so that writing one over the other changes nothing.
inline bool same_bits(const Vec2& a, const Vec2& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y);
}

/// The typed functions for a `T` at a fixed place in a row, stored as `Kept`s.
template <class T, class Kept, class Context, class Base>
Typed<T> typed_column() {
    constexpr std::size_t count = std::is_same_v<T, double> ? 1 : 2;
    static constexpr auto at = [](const Binding& b, Row row) {
        return reinterpret_cast<std::byte*>(Base{}(*static_cast<Context*>(b.context))) +
               std::size_t{row} * b.stride;
    };
    static constexpr auto load = [](const std::byte* from) {
        Kept kept[count];
        std::memcpy(kept, from, sizeof kept);
        if constexpr (count == 1)
            return static_cast<double>(kept[0]);
        else
            return T(static_cast<double>(kept[0]), static_cast<double>(kept[1]));
    };
    Typed<T> typed;
    typed.get = [](const Binding& b, Row row) -> T { return load(at(b, row)); };
    typed.plain = std::is_nothrow_invocable_v<Base, Context&>;
    typed.put = [](const Binding& b, Row row, typename Typed<T>::Passed value) {
        std::byte* const cell = at(b, row);
        Kept kept[count];
        if constexpr (count == 1) {
            kept[0] = static_cast<Kept>(value);
        } else {
            kept[0] = static_cast<Kept>(value.x);
            kept[1] = static_cast<Kept>(value.y);
        }
        if (std::memcmp(cell, kept, sizeof kept) == 0) return WriteResult::same;
        std::memcpy(cell, kept, sizeof kept);
        return WriteResult::done;
    };
    return typed;
}

/// A column of `Element`s with a distance of `stride` bytes. `base` is a captureless lambda:
/// (Context&) -> pointer to the first element. If it is `noexcept`, scripts write numbers and
/// vectors faster.
template <class Context, class Base>
Binding column(Context& context, Native native, std::size_t stride, Base) {
    static_assert(std::is_empty_v<Base>, "a lambda without captures, not a function's address");
    Binding b;
    b.kind = BindingKind::column;
    b.native = native;
    b.context = &context;
    b.stride = stride;
    b.base = [](void* c) -> std::byte* {
        return reinterpret_cast<std::byte*>(Base{}(*static_cast<Context*>(c)));
    };
    if (native == Native::f32) b.number = typed_column<double, float, Context, Base>();
    if (native == Native::f64) b.number = typed_column<double, double, Context, Base>();
    if (native == Native::vec2f) b.vec2 = typed_column<Vec2, float, Context, Base>();
    if (native == Native::vec2d) b.vec2 = typed_column<Vec2, double, Context, Base>();
    return b;
}

/// The result type of a getter if there are typed functions for it (double or Vec2); otherwise
/// void.
template <class Context, class Get>
using TypedResult = std::conditional_t<
    std::is_floating_point_v<std::invoke_result_t<Get, Context&, Row>>, double,
    std::conditional_t<
        std::is_same_v<std::remove_cvref_t<std::invoke_result_t<Get, Context&, Row>>, Vec2>, Vec2,
        void>>;

/// The typed functions of a binding for T.
template <class T>
Typed<T>& typed(Binding& binding) {
    if constexpr (std::is_same_v<T, double>)
        return binding.number;
    else
        return binding.vec2;
}

/// `get`: captureless lambda (Context&, Row) -> any type that converts to Value.
template <class Context, class Get>
Binding accessor(Context& context, Get) {
    static_assert(std::is_empty_v<Get>, "a lambda without captures, not a function's address");
    Binding b;
    b.kind = BindingKind::accessor;
    b.context = &context;
    b.get = [](void* c, Row row) -> Value { return Value(Get{}(*static_cast<Context*>(c), row)); };
    using T = TypedResult<Context, Get>;
    if constexpr (!std::is_void_v<T>)
        typed<T>(b).get = [](const Binding& binding, Row row) -> T {
            return Get{}(*static_cast<Context*>(binding.context), row);
        };
    return b;
}

/// `set`: captureless lambda (Context&, Row, const Value&).
template <class Context, class Get, class Set>
Binding accessor(Context& context, Get get, Set) {
    static_assert(std::is_empty_v<Set>, "a lambda without captures, not a function's address");
    Binding b = accessor(context, get);
    b.set = [](void* c, Row row, const Value& value) {
        Set{}(*static_cast<Context*>(c), row, value);
    };
    using T = TypedResult<Context, Get>;
    if constexpr (!std::is_void_v<T>)
        typed<T>(b).put = [](const Binding& binding, Row row, typename Typed<T>::Passed value) {
            Context& in = *static_cast<Context*>(binding.context);
            if (same_bits(T(Get{}(in, row)), value)) return WriteResult::same;
            Set{}(in, row, Value(value));
            return WriteResult::done;
        };
    return b;
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
