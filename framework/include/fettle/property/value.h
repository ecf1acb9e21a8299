#pragma once
// Values of properties: one small tagged union (24 bytes). Numbers, vectors, colors and references
// are stored inside; texts and lists are immutable and shared. So copying any value costs only a
// few instructions.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/vector/vector2.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// A vector in the plane; also a point. Meters unless a property says otherwise.
using Vec2 = Vector2<double>;

/// Red, green and blue as displayed (sRGB) and opacity, each 0 to 1.
struct Color {
    float r = 1, g = 1, b = 1, a = 1;  ///< each 0 to 1
    friend bool operator==(const Color&, const Color&) = default;
};

/// Identifies an instance by index and generation. A handle of a deleted instance is detected and
/// never followed. The default handle refers to nothing.
struct Handle {
    std::uint32_t index = 0;       ///< of a slot
    std::uint32_t generation = 0;  ///< of the instance in the slot; 0: none
    explicit operator bool() const { return generation != 0; }  ///< false: refers to nothing
    /// Both as one number, for tables of instances.
    std::uint64_t key() const { return std::uint64_t{generation} << 32 | index; }
    friend bool operator==(const Handle&, const Handle&) = default;
};

/// The type of a value.
enum class Type : std::uint8_t {
    nil,
    boolean,
    integer,
    number,
    text,
    vec2,
    color,
    reference,
    list
};

/// The name for users: "nil", "boolean", "integer", "number", "text", "vec2", "color", "reference",
/// "list".
std::string_view type_name(Type type);

class Value;
/// Values one after another, of any types.
using List = std::vector<Value>;

/// Same type and same bits: 1 is not 1.0, -0.0 is not 0.0, and a NaN equals itself, so that a NaN
/// never counts as a change.
bool operator==(const Value& a, const Value& b);

/// A value of a property, an argument or a result. Texts and lists are shared by copies.
class Value {
  public:
    Value() = default;  ///< nil
    /// A value of that type.
    Value(bool v) : type_(Type::boolean) { data_.boolean = v; }
    Value(int v) : Value(static_cast<std::int64_t>(v)) {}
    Value(std::int64_t v) : type_(Type::integer) { data_.integer = v; }
    Value(double v) : type_(Type::number) { data_.number = v; }
    Value(float v) : Value(static_cast<double>(v)) {}
    Value(const Vec2& v) : type_(Type::vec2) {
        data_.vec[0] = v.x;
        data_.vec[1] = v.y;
    }
    /// A value of that type.
    Value(Color v) : type_(Type::color) { data_.color = v; }
    /// A value of that type.
    Value(Handle v) : type_(Type::reference) { data_.reference = v; }
    /// Throws Error(wrong_type) for a null pointer.
    Value(const char* v);
    Value(const std::string& v) : Value(std::string_view(v)) {}
    Value(std::string_view v);
    /// Throws Error(out_of_range) for lists nested more than 64 deep.
    Value(List v);
    Value(std::nullptr_t) = delete;
    Value(const void*) = delete;

    /// A copy.
    Value(const Value& other) : data_(other.data_), type_(other.type_) { retain(); }
    /// Takes over the other, which is nil then.
    Value(Value&& other) noexcept : data_(other.data_), type_(other.type_) {
        other.type_ = Type::nil;
    }
    /// A copy.
    Value& operator=(const Value& other) {
        Value copy(other);
        swap(copy);
        return *this;
    }
    /// Takes over the other.
    Value& operator=(Value&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Value() {
        if (shared()) release();
    }
    /// Exchanges two values.
    void swap(Value& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(type_, other.type_);
    }

    Type type() const { return type_; }                 ///< of the value
    bool is_nil() const { return type_ == Type::nil; }  ///< whether there is no value
    bool is(Type type) const { return type_ == type; }  ///< whether it has that type
    /// integer or number
    bool is_numeric() const { return type_ == Type::integer || type_ == Type::number; }

    /// Throws Error(wrong_type), which names both types, if the value has another type.
    bool boolean() const { return as(Type::boolean).boolean; }
    /// Throws Error(wrong_type) if the value has another type.
    std::int64_t integer() const { return as(Type::integer).integer; }
    /// Throws Error(wrong_type) if the value has another type.
    double number() const { return as(Type::number).number; }
    /// Throws Error(wrong_type) if the value has another type.
    Vec2 vec2() const {
        const Data& data = as(Type::vec2);
        return {data.vec[0], data.vec[1]};
    }
    /// Throws Error(wrong_type) if the value has another type.
    Color color() const { return as(Type::color).color; }
    /// Throws Error(wrong_type) if the value has another type.
    Handle reference() const { return as(Type::reference).reference; }
    /// Throws Error(wrong_type) if the value has another type.
    const std::string& text() const;
    /// Throws Error(wrong_type) if the value has another type.
    const List& list() const;
    /// Replaces an element of a list, or adds one (`index` is the number of elements). Other values
    /// that share the list stay as they are: only then the list is copied. Throws as the
    /// constructor does.
    void set_element(std::size_t index, Value element);
    /// Removes the last element, in the same way.
    void remove_last_element();

    /// integer or number, as a double (an integer beyond 2^53 is rounded).
    double as_double() const {
        return type_ == Type::integer ? static_cast<double>(data_.integer)
                                      : as(Type::number).number;
    }

    friend bool operator==(const Value& a, const Value& b);

  private:
    struct FETTLE_PROPERTY_PRIVATE Shared;
    union Data {
        Data() : integer(0) {}
        bool boolean;
        std::int64_t integer;
        double number;
        double vec[2];
        Color color;
        Handle reference;
        Shared* shared;
    };
    const Data& as(Type type) const {
        if (type_ != type) [[unlikely]]
            refuse(type);
        return data_;
    }
    [[noreturn]] void refuse(Type asked) const;
    bool shared() const { return type_ == Type::text || type_ == Type::list; }
    void retain() const;
    void release();
    FETTLE_PROPERTY_PRIVATE Shared& own_list();

    Data data_;
    Type type_ = Type::nil;
};
static_assert(sizeof(Value) == 24);

/// What a property of this type holds by default: false, 0, "", (0, 0), white, no instance, {}.
Value default_value(Type type);

/// Number of digits of a printed number. A property that is a `float` in memory prints 0.1, not
/// 0.100000001490116.
enum class Precision : std::uint8_t { single_precision, double_precision };

/// `single_precision` if the number is exactly a float and has many digits as a double, so that a
/// value stored as float is printed as 0.1 and not as 0.10000000149011612. Other numbers keep all
/// digits. Of a vector, both coordinates count.
Precision shortest_precision(double number);
Precision shortest_precision(const Vec2& vec);

/// The shortest decimal that reads back as the same number; "inf", "-inf", "nan".
std::string number_text(double number, Precision precision = Precision::double_precision);

/// The text of the console, which Lua reads back: `nil`, `true`, `2`, `0.1`, `"text"`, `vec(1, 2)`,
/// `color("#ff8800")`, `{1, 2}`. A reference prints as `#index:generation`; `Tree::text` prints its
/// path instead.
std::string value_text(const Value& value, Precision precision = Precision::double_precision);

/// A CSS color name ("tomato") or "#rgb", "#rrggbb", "#rrggbbaa". Returns false when `text` is
/// neither.
bool parse_color(std::string_view text, Color& out);
/// "#rrggbb", or "#rrggbbaa" if it is not opaque; each channel is rounded to 8 bits.
std::string color_text(Color color);
/// All color names that `parse_color` accepts, sorted.
const std::vector<std::string>& color_names();

}  // namespace fettle::property

FETTLE_PROPERTY_END
