// Types and sizes of the elements of columns.

#include <fettle/property/native.h>

namespace fettle::property {

Type type_of(Native native) {
    switch (native) {
        case Native::f32:
        case Native::f64:
            return Type::number;
        case Native::i32:
        case Native::i64:
            return Type::integer;
        case Native::boolean:
            return Type::boolean;
        case Native::vec2f:
        case Native::vec2d:
            return Type::vec2;
        case Native::color:
            return Type::color;
        case Native::enumeration:
            return Type::text;
    }
    return Type::nil;
}

std::size_t size_of(Native native) {
    switch (native) {
        case Native::f32:
        case Native::i32:
            return 4;
        case Native::f64:
        case Native::i64:
        case Native::vec2f:
            return 8;
        case Native::vec2d:
        case Native::color:
            return 16;
        case Native::boolean:
        case Native::enumeration:
            return 1;
    }
    return 0;
}

}  // namespace fettle::property
