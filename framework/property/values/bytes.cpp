// Writing and reading of values as bytes, and a checksum.

#include <fettle/property/bytes.h>

#include <bit>

#include <fettle/property/error.h>

namespace fettle::property {
namespace {
// Maximum depth of nested lists; otherwise a few bytes could make the reader overflow the stack.
constexpr int deepest_value = 64;
}  // namespace

void ByteWriter::put(std::string_view text) {
    put(std::uint64_t{text.size()});
    raw(text.data(), text.size());
}

void ByteWriter::put(const Value& value) {
    put(value.type());
    switch (value.type()) {
        case Type::nil:
            return;
        case Type::boolean:
            return put(std::uint8_t{value.boolean()});
        case Type::integer:
            return put(value.integer());
        case Type::number:
            return put(value.number());
        case Type::text:
            return put(std::string_view(value.text()));
        case Type::vec2:
            put(value.vec2().x);
            return put(value.vec2().y);
        case Type::color:
            return put(value.color());
        case Type::reference:
            return put(value.reference());
        case Type::list:
            put(std::uint64_t{value.list().size()});
            for (const Value& element : value.list()) put(element);
            return;
    }
}

std::size_t ByteWriter::begin_block() {
    put(std::uint64_t{0});
    return size();
}

void ByteWriter::end_block(std::size_t begin) {
    if (begin < sizeof(std::uint64_t) || begin > size())
        throw Error(ErrorKind::bad_structure, "end_block: " + std::to_string(begin) +
                                                  " is not a place that begin_block gave");
    const std::uint64_t length = size() - begin;
    std::memcpy(out_->data() + begin - sizeof length, &length, sizeof length);
}

std::size_t ByteReader::count(std::size_t min_size) {
    const auto count = get<std::uint64_t>();
    if (count > in_.size() / min_size) ends_too_early();
    return static_cast<std::size_t>(count);
}

std::string_view ByteReader::text() {
    const std::size_t size = count();
    const std::string_view read(reinterpret_cast<const char*>(in_.data()), size);
    in_ = in_.subspan(size);
    return read;
}

Value ByteReader::value(int depth) {
    switch (get<Type>()) {
        case Type::nil:
            return {};
        case Type::boolean:
            return Value(boolean());
        case Type::integer:
            return Value(get<std::int64_t>());
        case Type::number:
            return Value(get<double>());
        case Type::text:
            return Value(text());
        case Type::vec2: {
            const auto x = get<double>(), y = get<double>();
            return Value(Vec2(x, y));
        }
        case Type::color:
            return Value(get<Color>());
        case Type::reference:
            return Value(get<Handle>());
        case Type::list: {
            require(depth < deepest_value, "a list in lists without end");
            List elements(count());
            for (Value& element : elements) element = value(depth + 1);
            return Value(std::move(elements));
        }
    }
    fail("a value of an unknown type");
}

ByteReader ByteReader::block(std::string what) {
    const std::size_t size = count();
    ByteReader inside(in_.first(size), what.empty() ? what_ : std::move(what));
    in_ = in_.subspan(size);
    return inside;
}

void ByteReader::finish() const {
    require(at_end(), "there are bytes after its end");
}

void ByteReader::fail(const std::string& problem) const {
    throw Error(ErrorKind::damaged, "the " + what_ + " is damaged: " + problem);
}

void ByteReader::ends_too_early() const {
    fail("it ends too early");
}

std::uint64_t checksum(std::span<const std::byte> bytes) {
    // Four lanes multiply and rotate whole words, then one lane mixes them. Every bit of the input
    // influences every bit of the result.
    constexpr std::uint64_t prime = 0x9e3779b97f4a7c15u;
    std::uint64_t lanes[4] = {bytes.size() + 1, prime, ~prime, bytes.size() * prime};
    const auto take = [&](std::uint64_t& lane, std::uint64_t word) {
        lane = std::rotl((lane ^ word) * prime, 29);
    };
    std::size_t at = 0;
    for (; at + 32 <= bytes.size(); at += 32) {
        std::uint64_t words[4];
        std::memcpy(words, bytes.data() + at, sizeof words);
        for (int i = 0; i < 4; ++i) take(lanes[i], words[i]);
    }
    for (; at < bytes.size(); ++at) take(lanes[at % 4], std::to_integer<std::uint64_t>(bytes[at]));
    std::uint64_t mixed = 0;
    for (const std::uint64_t lane : lanes) {
        std::uint64_t z = (mixed ^ lane) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 31)) * 0x94d049bb133111ebu;
        mixed = z ^ (z >> 29);
    }
    return mixed;
}

}  // namespace fettle::property
