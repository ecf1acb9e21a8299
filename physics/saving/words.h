#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

// Numbers as bytes: the lowest byte first, whatever the byte order of the machine is. Compilers
// make one load or store of such a loop.

namespace fettle::physics::detail {

template <class Word>
void store_word(std::byte* to, Word word) {
    static_assert(std::is_unsigned_v<Word>);
    for (std::size_t i = 0; i < sizeof word; ++i)
        to[i] = static_cast<std::byte>(static_cast<uint64_t>(word) >> (8 * i));
}
template <class Word>
Word load_word(const std::byte* from) {
    static_assert(std::is_unsigned_v<Word>);
    uint64_t word = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i)
        word |= static_cast<uint64_t>(from[i]) << (8 * i);
    return static_cast<Word>(word);
}

/// The unsigned number that has the bits of a number, enumerator or flag.
template <class T>
using WordOf =
    std::conditional_t<sizeof(T) == 1, uint8_t,
                       std::conditional_t<sizeof(T) == 2, uint16_t,
                                          std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>>;

/// Passes values to `Io::word`, one number after the other. A record has a function `fields(io,
/// record)`, which may be a static one of its own.
template <class Io>
class FieldIo {
  public:
    template <class... T>
    void operator()(T&... values) {
        (pass(values), ...);
    }
    [[noreturn]] void refuse(const char* what) const { throw std::invalid_argument(what); }

  private:
    template <class T>
    void pass(T& value) {
        using Plain = std::remove_const_t<T>;
        Io& io = static_cast<Io&>(*this);
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
            WordOf<Plain> word;
            std::memcpy(&word, &value, sizeof word);
            io.word(word);
            if constexpr (!std::is_const_v<T>) {
                if (std::is_same_v<Plain, bool> && word > 1) refuse("a flag is neither 0 nor 1");
                std::memcpy(&value, &word, sizeof word);
            }
        } else if constexpr (requires { Plain::fields(io, value); }) {
            Plain::fields(io, value);
        } else {
            fields(io, value);
        }
    }
};

/// Writes values to bytes, for which there is room.
class Encoder : public FieldIo<Encoder> {
  public:
    explicit Encoder(std::byte* to) : to_(to) {}
    template <class Word>
    void word(Word word) {
        store_word(to_, word);
        to_ += sizeof word;
    }

  private:
    std::byte* to_;
};
/// Reads values from bytes, of which there are enough.
class Decoder : public FieldIo<Decoder> {
  public:
    explicit Decoder(const std::byte* from) : from_(from) {}
    template <class Word>
    void word(Word& word) {
        word = load_word<Word>(from_);
        from_ += sizeof word;
    }

  private:
    const std::byte* from_;
};

class Measure : public FieldIo<Measure> {
  public:
    template <class Word>
    void word(Word) {
        size_ += sizeof(Word);
    }
    std::size_t size() const { return size_; }

  private:
    std::size_t size_ = 0;
};
/// The number of bytes of an encoded value, which is the same for all values of a type.
/// Optimizing compilers make a constant of it.
template <class T>
std::size_t encoded_size() {
    Measure measure;
    const T value{};
    measure(value);
    return measure.size();
}

}  // namespace fettle::physics::detail
